// READ FIRST. The stages of a compilation, in order; each is a free function from value to value.
//
//   text -> Json -> Graph -> Material (resolved, checked) -> Lowered (IR functions) -> stages (linked) -> tidied
//        -> legalized and printed per target, and the reflection beside them
//
// Beside it, with keep_programs, the same material is lowered once more without any folding: what the CPU reference
// runs.
#include <algorithm>
#include <functional>

#include "compiler/assemble/canonical_hash.h"
#include "compiler/assemble/check_reads.h"
#include "compiler/assemble/functions.h"
#include "compiler/assemble/identifiers.h"
#include "compiler/assemble/program.h"
#include "compiler/assemble/reflect.h"
#include "compiler/assemble/shader_file.h"
#include "compiler/base/text.h"
#include "compiler/dumps.h"
#include "compiler/graph/json.h"
#include "compiler/graph/lower.h"
#include "compiler/graph/part.h"
#include "compiler/graph/read_graph.h"
#include "compiler/graph/words.h"
#include "compiler/impl.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/verify.h"
#include "compiler/report.h"
#include "compiler/targets/plan.h"

namespace patina {
namespace {

using assemble::LinkedPass;

std::shared_ptr<graph::Graph> read(graph::Session& session, std::uint32_t base, const std::string& path) {
    const std::unique_ptr<graph::Json> json = graph::parse_json(session.sources, base, session.diagnostics);
    if (!json) return nullptr;
    const bool any_kind = session.options.accept_parts;
    auto graph = graph::read_graph(*json, path, session.sources, session.ast, session.diagnostics,
                                   any_kind ? std::nullopt : std::optional(graph::GraphKind::Material));
    return graph && any_kind ? graph::material_around(session, std::move(graph)) : graph;
}

void verified(const ir::Module& module, std::string_view stage) {
    if (ir::is_verifying()) ir::check(module, stage);
}

// Vertex inputs get the locations 0, 1, 2...: an HLSL compiler counts them so, and cannot be told otherwise.
void number_inputs(ir::Module& stage) {
    std::uint32_t location = 0;
    for (ir::StageVariable& input : stage.stage.inputs) {
        if (input.builtin == ir::Builtin::None) input.location = location++;
    }
}

// Direct3D hands 32 vectors from vertices to pixels, the position among them.
constexpr std::size_t kMostVaryings = 31;

void check_varyings(const ir::Module& vertex, const graph::Graph& graph, std::string_view pass,
                    Diagnostics& diagnostics) {
    const auto& outputs = vertex.stage.outputs;
    const auto count = static_cast<std::size_t>(std::count_if(outputs.begin(), outputs.end(), [](const auto& output) {
        return output.builtin == ir::Builtin::None && output.spelling.empty();
    }));
    if (count <= kMostVaryings) return;
    const Span start{graph.span.begin, graph.span.begin + 1};
    diagnostics.report(Code::TooMany, start, count, "values from vertices to pixels", kMostVaryings)
        .note(fmt::format("in the pass '{}'; nodes with \"stage\": \"vertex\", what they read of the mesh and what the "
                          "surface reads of it take one each",
                          pass));
}

// The two stages of a pass. The fragment stage is finished first: the vertex stage computes what is left of its inputs.
// Those that turn out to be constants are none, and leave less of both stages.
LinkedPass link_pass(const graph::Material& material, const assemble::Linked& linked, const graph::LoweredPass& pass,
                     bool optimise, Result& result, const CompileOptions& options) {
    const std::string& name = pass.name;
    const ir::BuildOptions build{.fold = optimise};
    LinkedPass made{.pass = &pass, .material = &material, .lowered = &linked.lowered};
    made.fragment = assemble::link_fragment(linked, pass, build);
    if (optimise) {
        verified(made.fragment, "linked fragment");
        dump_stage(result, options, "linked", name + ".fragment.linked", made.fragment);
        made.fragment = ir::tidy(std::move(made.fragment));
    }
    made.vertex = assemble::link_vertex(linked, pass, made.fragment, build);
    if (optimise) {
        verified(made.vertex, "linked vertex");
        dump_stage(result, options, "linked", name + ".vertex.linked", made.vertex);
        made.vertex = ir::tidy(std::move(made.vertex));
        if (assemble::take_constants(made.fragment, made.vertex)) {
            made.fragment = ir::tidy(std::move(made.fragment));
            made.vertex = ir::tidy(assemble::link_vertex(linked, pass, made.fragment, build));
        }
        number_inputs(made.vertex);
        dump_stage(result, options, "tidy", name + ".vertex.tidy", made.vertex);
        dump_stage(result, options, "tidy", name + ".fragment.tidy", made.fragment);
        dump_rates(result, options, name + ".fragment.rates", made.fragment);
    }
    verified(made.vertex, "vertex");
    verified(made.fragment, "fragment");
    return made;
}

// A graph may stand on one line, which no message shows whole: each printed line would carry the graph.
constexpr std::size_t kMaxSourceText = 1000;

std::vector<LineOrigin> line_map(const targets::Printed& printed, const ir::Module& module, const SourceMap& sources) {
    std::vector<LineOrigin> map;
    map.reserve(printed.lines.size());
    for (const targets::PrintedLine& line : printed.lines) {
        LineOrigin& made = map.emplace_back();
        made.line = line.line;
        if (!line.origin) continue;
        const ir::Origin& origin = module.origins[line.origin.index];
        made.node = origin.id;
        const Position position = sources.resolve(origin.span.begin);
        const Position end = sources.resolve(origin.span.end);
        made.file = position.file;
        made.source_line = position.line;
        made.source_column = position.column;
        made.source_end_column = end.line == position.line ? end.column : 0;
        if (position.line_text.size() <= kMaxSourceText) made.source_text = position.line_text;
    }
    return map;
}

// What is printed, in every language that is asked for: one stage of a pass, or functions.
struct Text {
    const ir::Module& tidied;
    std::string pass;
    Stage stage = Stage::Vertex;
    std::string what;       // in the header
    std::string file_name;  // without its extension
    std::optional<targets::Pasting> pasting = {};
    std::string hash = {};
};

class TextPrinter {
public:
    explicit TextPrinter(Text text) : text_(std::move(text)) {}

    Shader print(Target target, const Reflection& reflection, const SourceMap& sources) {
        const targets::TargetInfo& info = *targets::find_target(to_string(target));
        const std::optional<ir::Module> rewritten = info.legalize(text_.tidied);
        if (rewritten) verified(*rewritten, "legalized");
        if (!rewritten && plans_.empty()) plans_ = targets::make_plans(text_.tidied);
        const ir::Module& module = rewritten ? *rewritten : text_.tidied;
        const targets::PrintOptions options{
            .header = fmt::format("{}, {}\nGenerated by Patina {}", reflection.name, text_.what, version()),
            .shifts = assemble::binding_shifts(module),
            .plans = rewritten ? nullptr : &plans_,
            .pasting = text_.pasting};
        targets::Printed printed = info.print(module, options);
        return {.pass = text_.pass,
                .stage = text_.stage,
                .target = target,
                .file_name = fmt::format("{}.{}", text_.file_name, info.extension),
                .text = std::move(printed.text),
                .line_map = line_map(printed, module, sources),
                .hlsl_shifts = reflection.hlsl_shifts,
                .has_main = !text_.pasting,
                .hash = text_.hash};
    }

private:
    Text text_;
    std::vector<targets::Plan> plans_;  // shared by the languages that print the module as it is
};

TextPrinter stage_printer(const ir::Module& tidied, Stage stage, const std::string& pass, const std::string& name,
                          bool with_hash) {
    return TextPrinter({.tidied = tidied,
                        .pass = pass,
                        .stage = stage,
                        .what = fmt::format("pass '{}', {} stage", pass, to_string(stage)),
                        .file_name = fmt::format("{}.{}.{}", name, pass, stage == Stage::Vertex ? "vert" : "frag"),
                        .hash = with_hash ? assemble::hash_stage(tidied).text() : ""});
}

// --- functions instead of passes

bool is_good_prefix(graph::Session& session) {
    const std::string& prefix = session.options.functions;
    if (!is_identifier(prefix)) {
        session.diagnostics.report(Code::BadIdentifier, {}, prefix);
    } else if (const std::string name = prefix + "x"; targets::safe_identifier(name) != name) {
        session.diagnostics.report(Code::UnknownWord, {}, prefix, "a prefix that every shading language takes");
    }
    return !session.diagnostics.has_errors();
}

void print_functions(const graph::Session& session, const graph::Material& material, graph::Lowered lowered,
                     const std::string& name, Result& result) {
    const std::string& prefix = session.options.functions;
    assemble::prefix_interface(lowered.module, prefix);
    assemble::name_interface(lowered.module);
    const assemble::Linked linked = assemble::link(std::move(lowered));
    result.reflection = assemble::reflect(material, linked.lowered, {});
    for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
        const ir::Module module = assemble::link_functions(linked, stage, prefix);
        if (module.functions.empty()) continue;
        const std::string pass = stage == Stage::Vertex ? "vertex-functions" : "functions";
        dump_stage(result, session.options, "tidy", pass + ".tidy", module);
        for (ShaderFunction& each : assemble::describe_functions(module, stage))
            result.reflection.functions.push_back(std::move(each));
        TextPrinter printer(
            {.tidied = module,
             .pass = pass,
             .stage = stage,
             .what = fmt::format("functions of its {} stage, to be pasted into shaders", to_string(stage)),
             .file_name = fmt::format("{}.{}", name, pass),
             .pasting = targets::Pasting{.prefix = prefix, .set = graph::kMaterialSet}});
        for (const Target& target : session.options.targets)
            result.shaders.push_back(printer.print(target, result.reflection, session.sources));
    }
}

// The sources are gone when a program runs.
void add_places(Program& program, const ir::Module& stage, const SourceMap& sources) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Probe& probe : function.probes) {
            const Position at = sources.resolve(probe.span.begin);
            program.places[probe.span.begin] = {.file = std::string(at.file), .line = at.line, .column = at.column};
        }
    }
}

// The material itself, and the passes that it adds.
using Materials = std::vector<const graph::Material*>;

// The interpreter's stages: lowered and linked without folding, and never tidied.
std::shared_ptr<const Program> keep_program(graph::Session& session, const Materials& materials) {
    auto program = std::make_shared<Program>();
    Result unused;
    for (const graph::Material* material : materials) {
        graph::Lowered lowered = graph::lower(session, *material, {.fold = false});
        if (session.diagnostics.has_errors()) return nullptr;
        const assemble::Linked linked = assemble::link(std::move(lowered));
        for (const graph::LoweredPass& pass : linked.lowered.passes) {
            LinkedPass made = link_pass(*material, linked, pass, false, unused, session.options);
            add_places(*program, made.vertex, session.sources);
            add_places(*program, made.fragment, session.sources);
            program->stages.push_back({.pass = pass.name, .stage = Stage::Vertex, .module = std::move(made.vertex)});
            program->stages.push_back(
                {.pass = pass.name, .stage = Stage::Fragment, .module = std::move(made.fragment)});
        }
    }
    return program;
}

// Those of the passes that a material adds which are wanted and can be seen. The material has been lowered.
Materials drawn_beside(graph::Session& session, const graph::Lowered& lowered,
                       const std::vector<std::unique_ptr<graph::Material>>& passes) {
    Materials drawn;
    const std::vector<std::string>& wanted = session.options.passes;
    for (const std::unique_ptr<graph::Material>& each : passes) {
        const graph::ExtraPass& pass = *each->pass;
        const bool is_named = std::find(wanted.begin(), wanted.end(), pass.name) != wanted.end();
        if (!session.options.functions.empty()) {
            session.diagnostics.report(Code::PassLeftOut, pass.name_span, pass.name,
                                       "the functions are those of the material itself");
        } else if (wanted.empty() ? graph::draws_extra(session, lowered) : is_named) {
            drawn.push_back(each.get());
        }
    }
    return drawn;
}

// A macro of the tool declares a texture's sampler under the name that the texture has got.
void name_samplers(graph::Lowered& lowered) {
    for (const graph::PropertyGlobals& globals : lowered.property_globals) {
        if (globals.texture)
            lowered.module.globals[globals.sampler.index].name =
                "sampler" + lowered.module.globals[globals.texture.index].name;
    }
}

// Passes of which a tool's files hold all.
Shader print_file(const graph::Session& session, const graph::Material& material, const graph::Lowered& lowered,
                  std::span<const LinkedPass> passes, const std::string& name, const Reflection& reflection) {
    const targets::Printed printed =
        assemble::shader_file({.material = material,
                               .lowered = lowered,
                               .passes = passes,
                               .reflection = reflection,
                               .include = graph::tool_of(session)->include,
                               .header = fmt::format("Generated by Patina {} from {}.graph.json", version(), name)});
    return {.pass = {},
            .stage = Stage::Fragment,
            .target = session.options.targets[0],
            .file_name = name + ".shader",
            .text = printed.text,
            .line_map = line_map(printed, lowered.module, session.sources),
            .hlsl_shifts = {},
            .has_main = false};
}

void compile_graph(graph::Session& session, std::uint32_t base, const std::string& path, Result& result) {
    const CompileOptions& options = session.options;
    if (graph::tool_of(session) && !options.functions.empty()) {
        const std::string_view target = to_string(options.targets[0]);
        session.diagnostics.report(Code::NotYet, {}, fmt::format("functions for the target '{}'", target));
        return;
    }
    if (options.functions.empty()) {
        graph::find_path(session);
    } else if (!is_good_prefix(session)) {
        return;
    }
    const std::shared_ptr<graph::Graph> graph = read(session, base, path);
    if (!graph) return;
    const std::unique_ptr<graph::Material> material = graph::resolve_material(session, graph, options.preview);
    if (!material) return;
    dump_graph(result, session, *material);
    graph::check_surface_members(session, *material);
    const std::vector<std::unique_ptr<graph::Material>> added = graph::resolve_passes(session, *material);
    // Types are checked by lowering: do it even after errors, to report as many as there are.
    graph::Lowered lowered = graph::lower(session, *material, {.fold = true});
    if (session.diagnostics.has_errors()) return;
    graph::warn_unused(session, *material);
    verified(lowered.module, "lowered");
    dump_stage(result, options, "ir", "ir", lowered.module);

    const std::string name = graph::file_stem(path);
    Materials materials = drawn_beside(session, lowered, added);
    if (!options.functions.empty()) return print_functions(session, *material, std::move(lowered), name, result);
    std::vector<assemble::Linked> linked;
    linked.reserve(materials.size() + 1);
    const auto link = [&](graph::Lowered made) {
        assemble::name_interface(made.module);
        if (graph::tool_of(session)) name_samplers(made);
        linked.push_back(assemble::link(std::move(made)));
    };
    link(std::move(lowered));
    for (const graph::Material* each : materials) link(graph::lower(session, *each, {.fold = true}));
    if (session.diagnostics.has_errors()) return;
    materials.insert(materials.begin(), material.get());
    std::vector<LinkedPass> passes;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        for (const graph::LoweredPass& pass : linked[i].lowered.passes) {
            passes.push_back(link_pass(*materials[i], linked[i], pass, true, result, options));
            check_varyings(passes.back().vertex, *graph, pass.name, session.diagnostics);
        }
    }
    assemble::check_reads(session, linked.front().lowered, passes);
    if (session.diagnostics.has_errors()) return;
    result.reflection = assemble::reflect(*material, linked.front().lowered, passes);
    for (std::size_t i = 0; options.hashes && i < passes.size(); ++i)
        result.reflection.passes[i].hash = assemble::hash_pass(passes[i].vertex, passes[i].fragment).text();
    if (graph::tool_of(session)) {
        assemble::check_shader_properties(*material, linked.front().lowered, session.diagnostics);
        result.shaders.push_back(
            print_file(session, *material, linked.front().lowered, passes, name, result.reflection));
        return;
    }
    for (const LinkedPass& pass : passes) {
        const std::string& pass_name = pass.pass->name;
        TextPrinter vertex = stage_printer(pass.vertex, Stage::Vertex, pass_name, name, options.hashes);
        TextPrinter fragment = stage_printer(pass.fragment, Stage::Fragment, pass_name, name, options.hashes);
        for (const Target& target : options.targets) {
            result.shaders.push_back(vertex.print(target, result.reflection, session.sources));
            result.shaders.push_back(fragment.print(target, result.reflection, session.sources));
        }
    }
    if (options.keep_programs) result.program = keep_program(session, materials);
}

Result finish(graph::Session& session, Result result) {
    result.diagnostics = to_public(session.diagnostics, session.sources);
    result.dependencies = std::move(session.dependencies);
    result.ok = !session.diagnostics.has_errors();
    if (!result.ok) {
        result.shaders.clear();
        result.program = nullptr;
    }
    return result;
}

bool is_tool(const graph::Library& library, Target target) {
    return library.tools.contains(to_string(target));
}

void join(Result& into, Result from) {
    into.ok = into.ok && from.ok;
    const auto is_new = [&](const Diagnostic& d) {
        const std::string text = to_json(d);
        return std::none_of(into.diagnostics.begin(), into.diagnostics.end(),
                            [&](const Diagnostic& other) { return to_json(other) == text; });
    };
    for (Diagnostic& d : from.diagnostics)
        if (is_new(d)) into.diagnostics.push_back(std::move(d));
    for (Shader& shader : from.shaders) into.shaders.push_back(std::move(shader));
    for (std::string& file : from.dependencies)
        if (std::find(into.dependencies.begin(), into.dependencies.end(), file) == into.dependencies.end())
            into.dependencies.push_back(std::move(file));
    for (Dump& dump : from.dumps) into.dumps.push_back(std::move(dump));
    if (!into.ok) into.shaders.clear();
}

// A target that has passes of its own is compiled by itself. Where there are others, the reflection is theirs.
Result compile_targets(const graph::Library& library, const CompileOptions& options,
                       const std::function<Result(const CompileOptions&)>& compile) {
    std::vector<CompileOptions> runs(1, options);
    std::erase_if(runs[0].targets, [&](Target target) { return is_tool(library, target); });
    for (const Target target : options.targets) {
        if (!is_tool(library, target)) continue;
        CompileOptions& own = runs.emplace_back(options);
        own.targets = {target};
        own.keep_programs = false;
        own.keep_variants = true;
        own.passes.clear();
        own.switches.clear();
    }
    if (runs.size() == 1) return compile(options);
    if (runs[0].targets.empty() && !options.keep_programs) runs.erase(runs.begin());
    Result result = compile(runs[0]);
    for (std::size_t i = 1; i < runs.size(); ++i) join(result, compile(runs[i]));
    return result;
}

}  // namespace

Result Compiler::compile_file(const std::string& path, const CompileOptions& options) const {
    return compile_targets(*impl_->library, options, [&](const CompileOptions& some) {
        graph::Session session(*impl_->library, some);
        Result result;
        if (const std::optional<std::uint32_t> base = graph::load_source(session, path, {}))
            compile_graph(session, *base, path, result);
        return finish(session, std::move(result));
    });
}

Result Compiler::compile_text(const std::string& path, std::string text, const CompileOptions& options) const {
    return compile_targets(*impl_->library, options, [&](const CompileOptions& some) {
        graph::Session session(*impl_->library, some);
        Result result;
        session.dependencies.push_back(path);
        compile_graph(session, session.sources.add(path, text), path, result);
        return finish(session, std::move(result));
    });
}

}  // namespace patina

// READ FIRST. The stages of a compilation, in order; each is a free function from value to value.
//
//   text -> Json -> Graph -> Material (resolved, checked) -> Lowered (IR functions) -> stages (linked) -> tidied
//        -> legalized and printed per target, and the reflection beside them
//
// Beside it, with keep_programs, the same material is lowered once more without any folding: what the CPU reference
// runs.
#include <algorithm>
#include <functional>

#include "compiler/api/compiler_impl.h"
#include "compiler/api/dumps.h"
#include "compiler/api/report.h"
#include "compiler/engines/shaderlab/shader_file.h"
#include "compiler/ir/verify.h"
#include "compiler/link/check_reads.h"
#include "compiler/link/identifiers.h"
#include "compiler/link/link_pass.h"
#include "compiler/output/canonical_hash.h"
#include "compiler/output/print_shaders.h"
#include "compiler/output/reflect.h"

namespace patina {
namespace {

using assemble::LinkedPass;

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

void compile_graph(graph::Session& session, std::uint32_t base, const std::string& path, Result& result) {
    const CompileOptions& options = session.options;
    const bool is_tool = graph::tool_of(session) != nullptr;
    if (options.functions.empty()) {
        graph::find_path(session);
    } else if (is_tool) {
        const std::string_view target = to_string(options.targets[0]);
        session.diagnostics.report(Code::NotYet, {}, fmt::format("functions for the target '{}'", target));
        return;
    } else if (!is_good_prefix(session)) {
        return;
    }
    const graph::MaterialFile file = graph::read_material(session, base, path);
    if (!file.material) return;
    const graph::Material& material = *file.material;
    dump_graph(result, session, material);
    // Types are checked by lowering: do it even after errors, to report as many as there are.
    graph::Lowered lowered = graph::lower(session, material, {.fold = true});
    if (session.diagnostics.has_errors()) return;
    graph::warn_unused(session, material);
    ir::check_if_verifying(lowered.module, "lowered");
    dump_stage(result, options, "ir", "ir", lowered.module);

    const std::string name = graph::file_stem(path);
    Materials materials = drawn_beside(session, lowered, file.passes);
    if (!options.functions.empty()) return print_functions(session, material, std::move(lowered), name, result);
    std::vector<assemble::Linked> linked;
    linked.reserve(materials.size() + 1);
    const auto link = [&](graph::Lowered made) {
        assemble::name_interface(made.module);
        if (is_tool) name_samplers(made);
        linked.push_back(assemble::link(std::move(made)));
    };
    link(std::move(lowered));
    for (const graph::Material* each : materials) link(graph::lower(session, *each, {.fold = true}));
    if (session.diagnostics.has_errors()) return;

    materials.insert(materials.begin(), &material);
    std::vector<LinkedPass> passes;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        for (const graph::LoweredPass& pass : linked[i].lowered.passes) {
            passes.push_back(link_pass(*materials[i], linked[i], pass, true, result, options));
            if (is_tool && !assemble::has_all(session, linked[i], passes.back()))
                passes.pop_back();
            else
                check_varyings(passes.back(), session);
            if (session.diagnostics.has_errors()) return;
        }
    }
    const graph::Lowered& own = linked.front().lowered;
    assemble::check_reads(session, own, passes);
    if (session.diagnostics.has_errors()) return;

    if (is_tool) assemble::order_passes(passes);
    result.reflection = assemble::reflect(material, own, passes);
    for (std::size_t i = 0; options.hashes && i < passes.size(); ++i)
        result.reflection.passes[i].hash = assemble::hash_pass(passes[i].vertex, passes[i].fragment).text();
    if (is_tool) {
        assemble::check_shader_name(material, session.diagnostics);
        assemble::check_shader_properties(material, own, session.diagnostics);
        assemble::check_keywords(material, result.reflection, session.diagnostics);
        assemble::check_samplers(material, result.reflection, session.diagnostics);
        assemble::check_queues(material, passes, result.reflection, session.diagnostics);
        return print_file(session, material, own, passes, name, result);
    }
    for (const LinkedPass& pass : passes) print_pass(session, pass, name, result);
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

}  // namespace

void without_switches(std::vector<std::pair<std::string, std::string>>& given, const Reflection& of_path) {
    std::erase_if(given, [&](const auto& each) {
        return std::any_of(of_path.switches.begin(), of_path.switches.end(),
                           [&](const Switch& s) { return s.name == each.first; });
    });
}

// A target that has passes of its own is compiled by itself. Where there are others, the reflection is theirs, and so
// are the switches of passes.
Result Compiler::Impl::compile_targets(const CompileOptions& options,
                                       const std::function<Result(const CompileOptions&)>& compile) const {
    CompileOptions others = options;
    std::erase_if(others.targets, [&](Target target) { return is_tool(target); });
    if (others.targets.size() == options.targets.size()) return compile(options);
    std::optional<Result> result;
    if (!others.targets.empty() || options.keep_programs) result = compile(others);
    for (const Target target : options.targets) {
        if (!is_tool(target)) continue;
        CompileOptions own = options;
        own.targets = {target};
        own.keep_programs = false;
        own.keep_variants = true;
        own.passes.clear();
        if (result) {
            without_switches(own.switches, result->reflection);
            join(*result, compile(own));
        } else {
            result = compile(own);
        }
    }
    return std::move(*result);
}

Result Compiler::compile_file(const std::string& path, const CompileOptions& options) const {
    return impl_->compile_targets(options, [&](const CompileOptions& some) {
        graph::Session session(*impl_->library, some);
        Result result;
        if (const std::optional<std::uint32_t> base = graph::load_source(session, path, {}))
            compile_graph(session, *base, path, result);
        return finish(session, std::move(result));
    });
}

Result Compiler::compile_text(const std::string& path, std::string text, const CompileOptions& options) const {
    return impl_->compile_targets(options, [&](const CompileOptions& some) {
        graph::Session session(*impl_->library, some);
        Result result;
        session.dependencies.push_back(path);
        compile_graph(session, session.sources.add(path, text), path, result);
        return finish(session, std::move(result));
    });
}

}  // namespace patina

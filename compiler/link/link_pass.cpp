#include "compiler/link/link_pass.h"

#include <algorithm>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/verify.h"
#include "compiler/link/check_reads.h"
#include "compiler/link/dumps.h"
#include "compiler/link/pinned_inputs.h"
#include "compiler/link/target_reads.h"

namespace patina::link {
namespace {

// Numbers the vertex inputs 0, 1, 2... if the engine does not number them. An HLSL compiler counts them so, and HLSL
// cannot state another number.
void number_inputs(ir::Module& stage, const engines::Engine& engine) {
    std::uint32_t location = 0;
    for (ir::StageVariable& input : stage.stage.inputs) {
        if (input.builtin != ir::Builtin::None) continue;
        const engines::VertexInput* known = engine.vertex_input(input.name);
        input.location = known && known->location ? *known->location : location++;
    }
}

// The vertex stage computes these inputs in their order.
void number_varyings(ir::Module& fragment) {
    std::uint32_t location = 0;
    for (ir::StageVariable& input : fragment.stage.inputs) {
        if (input.builtin == ir::Builtin::None) input.location = location++;
    }
}

// Copies the places out of the sources, which do not exist any more when a program runs.
void add_places(Program& program, const ir::Module& stage, const SourceMap& sources) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Probe& probe : function.probes) {
            const Position at = sources.resolve(probe.span.begin);
            program.places[probe.span.begin] = {.file = std::string(at.file), .line = at.line, .column = at.column};
        }
    }
}

// Finishes the fragment stage first, because the vertex stage computes only the inputs that remain. Constant inputs are
// dropped, and so is the second of two equal inputs; then both stages are tidied again. The order of the inputs comes
// last, when it is known what each of them computes.
LinkedPass link_tidied(const resolve::Material& material, const Linked& linked, const lower::LoweredPass& pass,
                       const resolve::Session& session, Result& result, std::uint32_t left_out) {
    const CompileOptions& options = session.options;
    const ir::BuildOptions build{.fold = true};
    LinkedPass made{.pass = &pass, .material = &material, .lowered = &linked.lowered, .left_out = left_out};
    made.fragment = link_fragment(linked, pass, build, left_out);
    ir::check_if_verifying(made.fragment, "linked fragment");
    dump_stage(result, options, "linked", pass.name + ".fragment.linked", made.fragment);
    made.fragment = ir::tidy(std::move(made.fragment));
    // Shared functions may compute members for other passes from values that this pass lacks.
    if (linked.lowered.keeps_functions && missing_in(made.fragment)) {
        const ir::FunctionId entry = made.fragment.stage.entry;
        made.fragment = ir::tidy(ir::drop_members(std::move(made.fragment), std::span(&entry, 1), {}));
    }
    number_varyings(made.fragment);
    const auto link_again = [&](const char* dumped) {
        made.vertex = link_vertex(linked, pass, made.fragment, build);
        ir::check_if_verifying(made.vertex, "linked vertex");
        if (dumped) dump_stage(result, options, "linked", pass.name + dumped, made.vertex);
        made.vertex = ir::tidy(std::move(made.vertex));
    };
    link_again(".vertex.linked");
    const bool takes = take_constants(made.fragment, made.vertex);
    if (share_pinned(linked, made.fragment, made.vertex) || takes) {
        made.fragment = ir::tidy(std::move(made.fragment));
        number_varyings(made.fragment);
        link_again(nullptr);
    }
    if (order_pinned(linked, made.fragment, made.vertex)) {
        number_varyings(made.fragment);
        link_again(nullptr);
    }
    number_inputs(made.vertex, session.engine);
    made.reads_elsewhere = reads_elsewhere(linked, pass, made.fragment, made.vertex);
    dump_stage(result, options, "tidy", pass.name + ".vertex.tidy", made.vertex);
    dump_stage(result, options, "tidy", pass.name + ".fragment.tidy", made.fragment);
    dump_rates(result, options, pass.name + ".fragment.rates", made.fragment);
    return made;
}

// Links the stages without folding, as lowering made them.
LinkedPass link_plainly(const resolve::Material& material, const Linked& linked, const lower::LoweredPass& pass) {
    const ir::BuildOptions build{.fold = false};
    LinkedPass made{.pass = &pass, .material = &material, .lowered = &linked.lowered};
    made.fragment = link_fragment(linked, pass, build);
    number_varyings(made.fragment);
    made.vertex = link_vertex(linked, pass, made.fragment, build);
    return made;
}

void check(const LinkedPass& pass) {
    ir::check_if_verifying(pass.vertex, "vertex");
    ir::check_if_verifying(pass.fragment, "fragment");
}

void add_texts(const std::vector<ir::StageText>& from, std::vector<ir::StageText>& into) {
    for (const ir::StageText& text : from) {
        const bool is_there = std::any_of(into.begin(), into.end(), [&](const ir::StageText& other) {
            return other.place == text.place && other.line == text.line;
        });
        if (!is_there) into.push_back(text);
    }
}

// Adds the lines that the functions of a stage need, and the files that declare its values.
void add_texts_of(const ir::Module& stage, std::vector<ir::StageText>& into) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == ir::Op::Call) add_texts(stage.functions[inst.data].texts, into);
        }
    }
    for (const ir::UniformBlock& block : stage.blocks) {
        for (const ir::BlockMember& member : block.members) {
            if (!member.declared_in.empty()) add_texts({{.place = "include", .line = member.declared_in}}, into);
        }
    }
}

}  // namespace

LinkedPass link_pass(const resolve::Material& material, const Linked& linked, const lower::LoweredPass& pass,
                     const resolve::Session& session, Result& result, std::uint32_t left_out) {
    LinkedPass made = link_tidied(material, linked, pass, session, result, left_out);
    check(made);
    return made;
}

std::vector<ir::StageText> texts_of(const LinkedPass& pass) {
    std::vector<ir::StageText> made;
    add_texts_of(pass.vertex, made);
    add_texts_of(pass.fragment, made);
    add_texts(pass.vertex.stage.texts, made);
    return made;
}

Varyings varyings_of(const LinkedPass& pass) {
    Varyings made;
    for (const ir::StageVariable& output : pass.vertex.stage.outputs)
        made.numbered += output.builtin == ir::Builtin::None && output.spelling.empty() ? 1 : 0;
    for (const ir::StageText& text : texts_of(pass)) {
        if (text.place == "first interpolator") ++made.numbered;
        if (text.place != "interpolators") continue;
        std::size_t numbers = 0;
        for (std::size_t at = text.line.find("{}"); at != text.line.npos; at = text.line.find("{}", at + 2)) ++numbers;
        (numbers == 0 ? made.others : made.numbered) += std::max<std::size_t>(numbers, 1);
    }
    return made;
}

void check_varyings(const LinkedPass& pass, resolve::Session& session) {
    const Varyings vectors = varyings_of(pass);
    const std::size_t count = vectors.numbered + vectors.others;
    const engines::Engine& engine = session.engine;
    if (count <= engine.most_varyings) return;
    const Span graph = pass.material->graph->graph->span;
    DiagnosticRecord& report = session.diagnostics.report(Code::TooMany, {graph.begin, graph.begin + 1}, count,
                                                          "interpolated values", engine.most_varyings);
    report.note(
        fmt::format("in the pass '{}', each node with \"stage\": \"vertex\" is one, and so is each mesh value that "
                    "it or the surface reads",
                    pass.pass->name));
    if (!engine.varyings_note.empty()) report.note(engine.varyings_note);
}

std::shared_ptr<const Program> keep_program(resolve::Session& session, const Materials& materials) {
    auto program = std::make_shared<Program>();
    for (const resolve::Material* material : materials) {
        lower::Lowered lowered = lower::lower(session, *material, {.fold = false});
        if (session.diagnostics.has_errors()) return nullptr;
        const Span graph = material->graph->graph->span;
        const Linked linked = link(std::move(lowered));
        for (const lower::LoweredPass& pass : linked.lowered.passes) {
            LinkedPass made = link_plainly(*material, linked, pass);
            check(made);
            for (const ir::Module* stage : {&made.fragment, &made.vertex})
                if (!has_no_foreign(session.diagnostics, *stage, "the interpreter", {graph.begin, graph.begin + 1}))
                    return nullptr;
            add_places(*program, made.vertex, session.sources);
            add_places(*program, made.fragment, session.sources);
            program->stages.push_back({.pass = pass.name, .stage = Stage::Vertex, .module = std::move(made.vertex)});
            program->stages.push_back(
                {.pass = pass.name, .stage = Stage::Fragment, .module = std::move(made.fragment)});
        }
    }
    return program;
}

}  // namespace patina::link

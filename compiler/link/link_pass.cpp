#include "compiler/link/link_pass.h"

#include <algorithm>

#include "compiler/api/dumps.h"
#include "compiler/engines/shaderlab/shader_file.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/verify.h"
#include "compiler/link/check_reads.h"
#include "compiler/link/pinned_inputs.h"

namespace patina {

using assemble::LinkedPass;

namespace {

// Vertex inputs get the locations 0, 1, 2...: an HLSL compiler counts them so, and cannot be told otherwise.
void number_inputs(ir::Module& stage) {
    std::uint32_t location = 0;
    for (ir::StageVariable& input : stage.stage.inputs) {
        if (input.builtin == ir::Builtin::None) input.location = location++;
    }
}

// Direct3D hands 32 vectors from vertices to pixels, the position among them.
constexpr std::size_t kMostVaryings = 31;

// The sources are gone when a program runs.
void add_places(Program& program, const ir::Module& stage, const SourceMap& sources) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Probe& probe : function.probes) {
            const Position at = sources.resolve(probe.span.begin);
            program.places[probe.span.begin] = {.file = std::string(at.file), .line = at.line, .column = at.column};
        }
    }
}

}  // namespace

// The two stages of a pass. The fragment stage is finished first: the vertex stage computes what is left of its inputs.
// Those that turn out to be constants are none, and leave less of both stages, as one of two that are equal does. Their
// order comes last, when it is known what each is.
LinkedPass link_pass(const graph::Material& material, const assemble::Linked& linked, const graph::LoweredPass& pass,
                     bool optimise, Result& result, const CompileOptions& options) {
    const std::string& name = pass.name;
    const ir::BuildOptions build{.fold = optimise};
    LinkedPass made{.pass = &pass, .material = &material, .lowered = &linked.lowered};
    made.fragment = assemble::link_fragment(linked, pass, build);
    if (optimise) {
        ir::check_if_verifying(made.fragment, "linked fragment");
        dump_stage(result, options, "linked", name + ".fragment.linked", made.fragment);
        made.fragment = ir::tidy(std::move(made.fragment));
        // What others read of functions that passes share may be what this one has not got.
        if (linked.lowered.keeps_functions && assemble::missing_in(made.fragment)) {
            const ir::FunctionId entry = made.fragment.stage.entry;
            made.fragment = ir::tidy(ir::drop_members(std::move(made.fragment), std::span(&entry, 1), {}));
        }
    }
    made.vertex = assemble::link_vertex(linked, pass, made.fragment, build);
    if (optimise) {
        ir::check_if_verifying(made.vertex, "linked vertex");
        dump_stage(result, options, "linked", name + ".vertex.linked", made.vertex);
        made.vertex = ir::tidy(std::move(made.vertex));
        const auto link_again = [&] {
            made.vertex = ir::tidy(assemble::link_vertex(linked, pass, made.fragment, build));
        };
        const bool takes = assemble::take_constants(made.fragment, made.vertex);
        if (assemble::share_pinned(linked, made.fragment, made.vertex) || takes) {
            made.fragment = ir::tidy(ir::settle_params(std::move(made.fragment)));
            link_again();
        }
        if (assemble::order_pinned(linked, made.fragment, made.vertex)) link_again();
        number_inputs(made.vertex);
        dump_stage(result, options, "tidy", name + ".vertex.tidy", made.vertex);
        dump_stage(result, options, "tidy", name + ".fragment.tidy", made.fragment);
        dump_rates(result, options, name + ".fragment.rates", made.fragment);
    }
    ir::check_if_verifying(made.vertex, "vertex");
    ir::check_if_verifying(made.fragment, "fragment");
    return made;
}

void check_varyings(const LinkedPass& pass, graph::Session& session) {
    const assemble::Handed vectors = assemble::handed(pass);
    const std::size_t count = vectors.numbered + vectors.others;
    if (count <= kMostVaryings) return;
    const Span graph = pass.material->graph->graph->span;
    DiagnosticRecord& told = session.diagnostics.report(Code::TooMany, {graph.begin, graph.begin + 1}, count,
                                                        "values from vertices to pixels", kMostVaryings);
    told.note(
        fmt::format("in the pass '{}'; nodes with \"stage\": \"vertex\", what they read of the mesh and what the "
                    "surface reads of it take one each",
                    pass.pass->name));
    if (graph::tool_of(session)) told.note("so do light, fog, instances and stereo rendering in Unity");
}

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

}  // namespace patina

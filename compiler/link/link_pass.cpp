#include "compiler/link/link_pass.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "compiler/ir/dump.h"
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

// Copies the places out of the sources, which do not exist any more when a program runs.
void add_places(Program& program, const ir::Module& stage, const SourceMap& sources) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Probe& probe : function.probes) {
            const Position at = sources.resolve(probe.span.begin);
            program.places[probe.span.begin] = {.file = std::string(at.file), .line = at.line, .column = at.column};
        }
    }
}

struct Made {
    ir::Module vertex{}, fragment{};
    bool reads_elsewhere = false;
};

void forget_places(ir::Module& stage) {
    for (ir::Origin& origin : stage.origins) origin.span = {};
    for (ir::Global& global : stage.globals) global.span = {};
}

Stages finished(Made made) {
    for (ir::Module* stage : {&made.vertex, &made.fragment}) forget_places(*stage);
    ir::check_if_verifying(made.vertex, "vertex");
    ir::check_if_verifying(made.fragment, "fragment");
    return {.vertex = std::make_shared<const ir::Module>(std::move(made.vertex)),
            .fragment = std::make_shared<const ir::Module>(std::move(made.fragment)),
            .reads_elsewhere = made.reads_elsewhere};
}

// Finishes the fragment stage first, because the vertex stage computes only the inputs that remain. Constant inputs are
// dropped, and so is the second of two equal inputs; then both stages are tidied again. The order of the inputs comes
// last, when it is known what each of them computes.
Stages link_tidied(const Linked& linked, const graph::LoweredPass& pass, const graph::Session& session,
                   Result& result) {
    const CompileOptions& options = session.options;
    const ir::BuildOptions build{.fold = true};
    Made made;
    made.fragment = link_fragment(linked, pass, build);
    ir::check_if_verifying(made.fragment, "linked fragment");
    dump_stage(result, options, "linked", pass.name + ".fragment.linked", made.fragment);
    made.fragment = ir::tidy(std::move(made.fragment));
    // Shared functions may compute members for other passes from values that this pass lacks.
    if (linked.lowered.keeps_functions && missing_in(made.fragment)) {
        const ir::FunctionId entry = made.fragment.stage.entry;
        made.fragment = ir::tidy(ir::drop_members(std::move(made.fragment), std::span(&entry, 1), {}));
    }
    made.vertex = link_vertex(linked, pass, made.fragment, build);
    ir::check_if_verifying(made.vertex, "linked vertex");
    dump_stage(result, options, "linked", pass.name + ".vertex.linked", made.vertex);
    made.vertex = ir::tidy(std::move(made.vertex));
    const auto link_again = [&] { made.vertex = ir::tidy(link_vertex(linked, pass, made.fragment, build)); };
    const bool takes = take_constants(made.fragment, made.vertex);
    if (share_pinned(linked, made.fragment, made.vertex) || takes) {
        made.fragment = ir::tidy(ir::settle_params(std::move(made.fragment)));
        link_again();
    }
    if (order_pinned(linked, made.fragment, made.vertex)) link_again();
    number_inputs(made.vertex, session.engine);
    made.reads_elsewhere = reads_elsewhere(linked, pass, made.fragment, made.vertex);
    dump_stage(result, options, "tidy", pass.name + ".vertex.tidy", made.vertex);
    dump_stage(result, options, "tidy", pass.name + ".fragment.tidy", made.fragment);
    dump_rates(result, options, pass.name + ".fragment.rates", made.fragment);
    return finished(std::move(made));
}

// Links the stages without folding, as lowering made them.
Made link_plainly(const Linked& linked, const graph::LoweredPass& pass) {
    const ir::BuildOptions build{.fold = false};
    Made made;
    made.fragment = link_fragment(linked, pass, build);
    made.vertex = link_vertex(linked, pass, made.fragment, build);
    ir::check_if_verifying(made.vertex, "vertex");
    ir::check_if_verifying(made.fragment, "fragment");
    return made;
}

// Builds that check the IR also check that known stages are those that would be made now.
void check_same(const Stages& known, const Stages& made) {
    if (ir::dump(*known.vertex) == ir::dump(*made.vertex) && ir::dump(*known.fragment) == ir::dump(*made.fragment) &&
        known.reads_elsewhere == made.reads_elsewhere)
        return;
    std::fprintf(stderr, "a key of known_passes.h lacks something: stages were linked before as\n%s\nand now as\n%s\n",
                 ir::dump(*known.fragment).c_str(), ir::dump(*made.fragment).c_str());
    std::abort();
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

bool is_long(const Linked& linked) {
    constexpr std::size_t kMost = 20'000;  // instructions: more would push out everything else
    std::size_t count = 0;
    for (const ir::Function& function : linked.functions) count += function.insts.size();
    return count > kMost;
}

}  // namespace

// A user's pass file and the stages of a dump are not for the next compilation.
PassLinker::PassLinker(const graph::Material& material, const Linked& linked, const graph::Session& session,
                       KnownPasses* known)
    : material_(material), linked_(linked), session_(session), known_(known) {
    if (session.pass_file || !session.options.dump.empty() || is_long(linked)) known_ = nullptr;
    if (known_) key_ = key_of(linked, session.engine);
}

LinkedPass PassLinker::link(const graph::LoweredPass& pass, Result& result) const {
    LinkedPass linked;
    linked.pass = &pass;
    linked.material = &material_;
    linked.lowered = &linked_.lowered;
    linked.is_kept = known_ != nullptr;
    Stages& stages = linked;
    if (!known_) {
        stages = link_tidied(linked_, pass, session_, result);
        return linked;
    }
    std::string key = key_of(key_, pass);
    const std::size_t bytes = bytes_of(key);
    std::shared_ptr<const Stages> known = known_->find(key);
    if (known && ir::is_verifying()) check_same(*known, link_tidied(linked_, pass, session_, result));
    if (!known)
        known = known_->keep(std::move(key),
                             std::make_shared<const Stages>(link_tidied(linked_, pass, session_, result)), bytes);
    stages = *known;
    return linked;
}

std::vector<ir::StageText> texts_of(const LinkedPass& pass) {
    std::vector<ir::StageText> made;
    add_texts_of(*pass.vertex, made);
    add_texts_of(*pass.fragment, made);
    add_texts(pass.vertex->stage.texts, made);
    return made;
}

Varyings varyings_of(const LinkedPass& pass) {
    Varyings made;
    for (const ir::StageVariable& output : pass.vertex->stage.outputs)
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

void check_varyings(const LinkedPass& pass, graph::Session& session) {
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

std::shared_ptr<const Program> keep_program(graph::Session& session, const Materials& materials) {
    auto program = std::make_shared<Program>();
    for (const graph::Material* material : materials) {
        graph::Lowered lowered = graph::lower(session, *material, {.fold = false});
        if (session.diagnostics.has_errors()) return nullptr;
        const Linked linked = link(std::move(lowered));
        for (const graph::LoweredPass& pass : linked.lowered.passes) {
            Made made = link_plainly(linked, pass);
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

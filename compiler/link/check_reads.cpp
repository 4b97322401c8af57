#include "compiler/link/check_reads.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace patina::link {
namespace {

using nodelang::FunctionDecl;

bool is_per_object(const paths::PathDeclarations& paths, const ir::Global& global) {
    return std::any_of(paths.externs.begin(), paths.externs.end(), [&](const paths::ExternDecl& each) {
        return each.variable->span == global.span && each.is_per_object;
    });
}

std::set<std::uint32_t> globals_of(const ir::Module& stage) {
    std::set<std::uint32_t> read;
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == ir::Op::Global) read.insert(inst.data);
        }
    }
    return read;
}

// The render targets of the path, and of passes that switches add.
std::set<std::string_view> drawn_targets(const paths::PathDeclarations& paths, const std::string& path) {
    std::vector<const paths::PassDecl*> passes = paths.passes_of(path);
    for (const paths::SwitchDecl& each : paths.switches) {
        if (const paths::PassDecl* brought = paths.pass(each.brings)) passes.push_back(brought);
    }
    std::set<std::string_view> names = {"color"};  // every frame has the picture
    for (const paths::PassDecl* each : passes) {
        names.insert(each->state.depth_target);
        for (const RenderTarget& target : each->state.targets) names.insert(target.name);
    }
    return names;
}

class ReadSearch {
public:
    explicit ReadSearch(const ir::Module& stage) : stage_(stage), seen_(stage.functions.size()) {}

    // `origin`: that of the innermost node on the way.
    std::optional<Missing> visit(ir::FunctionId function, ir::OriginId origin) {
        if (seen_[function.index]) return {};
        seen_[function.index] = true;
        for (const ir::Inst& inst : stage_[function].insts) {
            const ir::OriginId here = inst.origin ? inst.origin : origin;
            if (inst.op == ir::Op::Global && is_missing(stage_.globals[inst.data]))
                return Missing{stage_.globals[inst.data].name, here ? stage_.origins[here.index] : ir::Origin{}};
            if (inst.op != ir::Op::Call) continue;
            if (std::optional<Missing> found = visit({inst.data}, here)) return found;
        }
        return {};
    }

private:
    static bool is_missing(const ir::Global& global) {
        return !global.is_foreign() && global.group != ir::Group::Material && global.type.kind != ir::Kind::Sampler;
    }

    const ir::Module& stage_;
    std::vector<bool> seen_;
};

}  // namespace

std::optional<Missing> missing_in(const ir::Module& stage) {
    return ReadSearch(stage).visit(stage.stage.entry, {});
}

namespace {

// Finds what a function reads, directly or through the recipes of semantics.
class Reads {
public:
    Reads(const Linked& linked, std::string_view global)
        : linked_(linked), global_(global), seen_(linked.functions.size()) {}

    // The name under which a graph reads the value: a semantic ("@light"), with its location in the graph, or else a
    // function of the library.
    Missing named() {
        const auto& semantics = linked_.lowered.semantics;
        for (std::size_t i = 0; i < semantics.size(); ++i) {
            seen_.assign(seen_.size(), false);
            if (linked_.readers[i] && semantics[i].recipe && in(semantics[i].recipe))
                return {"@" + linked_.lowered.module.semantics[i].name,
                        linked_.lowered.module.origins[linked_.readers[i].index]};
        }
        for (const ir::Function& function : linked_.functions) {
            if (reads(function)) return {function.name, {}};
        }
        return {std::string(global_), {}};
    }

private:
    bool in(ir::FunctionId function) {
        if (!function || seen_[function.index]) return false;
        seen_[function.index] = true;
        if (reads(linked_.functions[function.index])) return true;
        for (const ir::Inst& inst : linked_.functions[function.index].insts) {
            if (inst.op == ir::Op::Call && in({inst.data})) return true;
        }
        const std::vector<ir::SemanticId>& needs = linked_.needs[function.index];
        return std::any_of(needs.begin(), needs.end(), [&](ir::SemanticId semantic) {
            return in(linked_.lowered.semantics[semantic.index].recipe);
        });
    }

    bool reads(const ir::Function& function) const {
        return std::any_of(function.insts.begin(), function.insts.end(), [&](const ir::Inst& inst) {
            return inst.op == ir::Op::Global && linked_.lowered.module.globals[inst.data].name == global_;
        });
    }

    const Linked& linked_;
    std::string_view global_;
    std::vector<bool> seen_;
};

}  // namespace

bool has_all(resolve::Session& session, const Linked& linked, const LinkedPass& pass) {
    for (const ir::Module* stage : {&pass.vertex, &pass.fragment}) {
        std::optional<Missing> missing = missing_in(*stage);
        if (!missing) continue;
        const Span graph = pass.material->graph->graph->span;
        const Missing named = Reads(linked, missing->name).named();
        if (!missing->where.span.end) missing->where = named.where;
        const bool is_at_node = missing->where.span.begin != missing->where.span.end;
        const paths::PassDecl& declaration = *pass.pass->declaration;
        DiagnosticRecord& record = session.diagnostics.report(
            declaration.is_optional ? Code::PassLeftOut : Code::PassRefused,
            is_at_node ? missing->where.span : Span{graph.begin, graph.begin + 1}, lower::known_as(declaration),
            fmt::format("its {} reads '{}', which '{}' does not provide there",
                        stage == &pass.vertex ? "vertex stage" : "fragment stage", named.name,
                        session.options.targets[0].name()));
        record.at(missing->where.id);
        if (declaration.is_optional && !declaration.otherwise.empty()) record.note(std::string(declaration.otherwise));
        return false;
    }
    return true;
}

void check_reads(resolve::Session& session, const lower::Lowered& lowered, std::span<const LinkedPass> passes) {
    if (!session.pass_file || session.engine.has_own_passes() || lowered.path != session.path) return;
    const paths::PathDeclarations& paths = *session.paths;
    const std::set<std::string_view> drawn = drawn_targets(paths, lowered.path);
    const auto check = [&](const paths::PassDecl& pass, const ir::Module& stage, const FunctionDecl& function) {
        for (const std::uint32_t read : globals_of(stage)) {
            const ir::Global& global = lowered.module.globals[read];
            if (const auto target = lowered.reads.find(read); target != lowered.reads.end()) {
                if (!drawn.contains(target->second))
                    session.diagnostics.report(
                        Code::PassRefused, function.name_span, pass.name,
                        fmt::format("it reads the target '{}', which no pass of the path draws", target->second));
            }
            if (pass.state.draws == PassDraws::Fullscreen && is_per_object(paths, global))
                session.diagnostics
                    .report(Code::PassRefused, function.name_span, pass.name,
                            fmt::format("it draws the screen and reads '{}', which belongs to an object", global.name))
                    .note(
                        "read the corners of the screen from positionOS, and the depth behind a pixel from "
                        "depthTexture");
        }
    };
    for (const LinkedPass& each : passes) {
        const paths::PassDecl& pass = *each.pass->declaration;
        if (pass.path != session.path || each.material->pass) continue;
        check(pass, each.vertex, *pass.vertex);
        check(pass, each.fragment, *pass.fragment);
    }
}

}  // namespace patina::link

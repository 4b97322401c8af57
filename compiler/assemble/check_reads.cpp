#include "compiler/assemble/check_reads.h"

#include <algorithm>
#include <set>

namespace patina::assemble {
namespace {

using nodelang::FunctionDecl;

bool is_per_object(const graph::Stages& stages, const ir::Global& global) {
    return std::any_of(stages.externs.begin(), stages.externs.end(), [&](const nodelang::VariableDecl* each) {
        return each->span == global.span && each->attribute("per_object");
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

// Of the path, and of what switches bring.
std::set<std::string_view> drawn_targets(const graph::Stages& stages, const std::string& path) {
    std::vector<const graph::PassDecl*> passes = stages.passes_of(path);
    for (const graph::SwitchDecl& each : stages.switches) {
        if (const graph::PassDecl* brought = stages.pass(each.brings)) passes.push_back(brought);
    }
    std::set<std::string_view> names = {"color"};  // the picture is always there
    for (const graph::PassDecl* each : passes) {
        names.insert(each->state.depth_target);
        for (const RenderTarget& target : each->state.targets) names.insert(target.name);
    }
    return names;
}

}  // namespace

void check_reads(graph::Session& session, const graph::Lowered& lowered, std::span<const LinkedPass> passes) {
    if (!session.pass_file || graph::tool_of(session) || lowered.path != session.path) return;
    const graph::Stages& stages = *session.stages;
    const std::set<std::string_view> drawn = drawn_targets(stages, lowered.path);
    const auto check = [&](const graph::PassDecl& pass, const ir::Module& stage, const FunctionDecl& function) {
        for (const std::uint32_t read : globals_of(stage)) {
            const ir::Global& global = lowered.module.globals[read];
            if (const auto target = lowered.reads.find(read); target != lowered.reads.end()) {
                if (!drawn.contains(target->second))
                    session.diagnostics.report(
                        Code::PassRefused, function.name_span, pass.name,
                        fmt::format("it reads the target '{}', which no pass of the path draws", target->second));
            }
            if (pass.state.draws == "fullscreen" && is_per_object(stages, global))
                session.diagnostics
                    .report(Code::PassRefused, function.name_span, pass.name,
                            fmt::format("it draws the screen and reads '{}', which belongs to an object", global.name))
                    .note(
                        "the corners of the screen are position_os, and what is behind a pixel is what depth_texture "
                        "says");
        }
    };
    for (const LinkedPass& each : passes) {
        const graph::PassDecl& pass = *each.pass->declaration;
        if (pass.path != session.path || each.material->pass) continue;
        check(pass, each.vertex, *pass.vertex);
        check(pass, each.fragment, *pass.fragment);
    }
}

}  // namespace patina::assemble

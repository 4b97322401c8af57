#include "compiler/validate/inlined.h"

#include <fmt/format.h>

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>

#include "compiler/validate/compile.h"

namespace patina {
namespace {

struct CalledAt {
    std::uint32_t function = 0;
    int line = 0;
};

struct FunctionSize {
    CodeSize own{};
    std::optional<CodeSize> all{};  // with what it calls; none: not known yet
    bool is_called = false;
    int line = 0;  // of the last branch
    std::vector<CalledAt> calls{};
};

using Functions = std::map<std::uint32_t, FunctionSize>;  // by id

Functions functions_of(const SpirvModule& module) {
    Functions functions;
    FunctionSize* open = nullptr;
    int line = 0;
    for (const SpirvInst& inst : module.insts) {
        if (inst.op == spv::OpLine) {
            line = static_cast<int>(inst.word(2));
        } else if (inst.op == spv::OpFunction) {
            open = &functions[inst.result];
        } else if (inst.op == spv::OpFunctionEnd) {
            open = nullptr;
        } else if (open) {
            ++open->own.instructions;
            if (inst.op == spv::OpLabel) {
                ++open->own.blocks;
                open->line = line;
            }
            if (inst.op == spv::OpFunctionCall) open->calls.push_back({.function = inst.word(3), .line = line});
        }
    }
    for (auto& [id, function] : functions) {
        for (const CalledAt& call : function.calls) functions[call.function].is_called = true;
    }
    return functions;
}

// SPIR-V has no recursion, and calls are as deep as functions of the node language may be.
CodeSize size_of(Functions& functions, std::uint32_t id) {
    FunctionSize& function = functions[id];
    if (function.all) return *function.all;
    function.all = function.own;  // what recursion, which is not allowed, would find
    CodeSize all = function.own;
    for (const CalledAt& call : function.calls) {
        const CodeSize called = size_of(functions, call.function);
        all.instructions += called.instructions;
        all.blocks += called.blocks;
    }
    function.all = all;
    return all;
}

}  // namespace

bool exceeds(const CodeSize& size, const CodeSize& most) {
    return size.instructions > most.instructions || size.blocks > most.blocks;
}

Inlined inlined(const SpirvModule& module, const CodeSize& most) {
    Functions functions = functions_of(module);
    Inlined made;
    const auto entry =
        std::find_if(functions.begin(), functions.end(), [](const auto& each) { return !each.second.is_called; });
    if (entry == functions.end()) return made;
    made.size = size_of(functions, entry->first);
    const auto is_too_much = [&](const CalledAt& call) { return exceeds(*functions[call.function].all, most); };
    for (const FunctionSize* at = &entry->second; at;) {
        const auto call = std::find_if(at->calls.begin(), at->calls.end(), is_too_much);
        if (call == at->calls.end()) break;
        made.line = call->line;
        at = &functions[call->function];
    }
    return made;
}

Branching most_branching(const std::vector<std::uint32_t>& spirv) {
    const std::optional<SpirvModule> module = read_module(spirv);
    Branching most;
    if (!module) return most;
    const Functions functions = functions_of(*module);
    std::uint32_t at = 0;
    for (const auto& [id, function] : functions) {
        const auto blocks = static_cast<std::size_t>(function.own.blocks);
        if (blocks <= most.blocks) continue;
        most = {.blocks = blocks, .lines = {function.line}};
        at = id;
    }
    const auto caller_of = [&](std::uint32_t callee) {
        for (const auto& [id, function] : functions)
            for (const CalledAt& call : function.calls)
                if (call.function == callee) return std::pair(id, call.line);
        return std::pair(std::uint32_t{0}, 0);
    };
    for (std::size_t i = 0; i < functions.size(); ++i) {
        const auto [caller, line] = caller_of(at);
        if (caller == 0) break;
        most.lines.push_back(line);
        at = caller;
    }
    return most;
}

std::optional<Diagnostic> too_large(const Shader& shader, const std::vector<std::uint32_t>& spirv) {
    const std::optional<SpirvModule> module = read_module(spirv);
    Inlined found = module ? inlined(*module) : Inlined{};
    if (!exceeds(found.size, kMostCode)) return std::nullopt;
    // Most SPIR-V does not know the lines of its text.
    if (found.line == 0)
        if (const std::optional<SpirvModule> with_lines = read_module(spirv_with_lines(shader)))
            found.line = inlined(*with_lines).line;
    const bool is_long = found.size.instructions > kMostCode.instructions;
    Diagnostic made;
    made.code = "over-budget";
    made.message = fmt::format(
        "{} of the {} stage of '{}', with all calls written out: {:.0f}, more than the budget of {:.0f}",
        is_long ? "instructions" : "blocks of branches", to_string(shader.stage), shader.pass,
        is_long ? found.size.instructions : found.size.blocks, is_long ? kMostCode.instructions : kMostCode.blocks);
    if (found.line > 0) locate(made, shader, found.line);
    return made;
}

}  // namespace patina

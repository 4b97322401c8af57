#include "compiler/validate/inlined.h"

#include <fmt/format.h>

#include <algorithm>
#include <glslang/SPIRV/spirv.hpp>

#include "compiler/validate/compile.h"

namespace patina {
namespace {

// Materials have some hundreds or thousands; with so many, spirv-opt takes some seconds.
constexpr double kMostInstructions = 200'000;

struct CalledAt {
    std::uint32_t function = 0;
    int line = 0;
};

struct FunctionSize {
    double own = 0, all = -1;  // all: with what it calls; below 0: not known yet
    bool is_called = false;
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
            ++open->own;
            if (inst.op == spv::OpFunctionCall) open->calls.push_back({.function = inst.word(3), .line = line});
        }
    }
    for (auto& [id, function] : functions) {
        for (const CalledAt& call : function.calls) functions[call.function].is_called = true;
    }
    return functions;
}

// SPIR-V has no recursion, and calls are as deep as functions of the node language may be.
double size_of(Functions& functions, std::uint32_t id) {
    FunctionSize& function = functions[id];
    if (function.all >= 0) return function.all;
    function.all = function.own;  // what recursion, which is not allowed, would find
    double all = function.own;
    for (const CalledAt& call : function.calls) all += size_of(functions, call.function);
    return function.all = all;
}

}  // namespace

Inlined inlined(const SpirvModule& module, double most) {
    Functions functions = functions_of(module);
    Inlined made;
    const auto entry =
        std::find_if(functions.begin(), functions.end(), [](const auto& each) { return !each.second.is_called; });
    if (entry == functions.end()) return made;
    made.instructions = size_of(functions, entry->first);
    const auto is_too_much = [&](const CalledAt& call) { return functions[call.function].all > most; };
    for (const FunctionSize* at = &entry->second; at;) {
        const auto call = std::find_if(at->calls.begin(), at->calls.end(), is_too_much);
        if (call == at->calls.end()) break;
        made.line = call->line;
        at = &functions[call->function];
    }
    return made;
}

std::optional<Diagnostic> too_large(const Shader& shader, const std::vector<std::uint32_t>& spirv) {
    const std::optional<SpirvModule> module = read_module(spirv);
    const Inlined size = module ? inlined(*module, kMostInstructions) : Inlined{};
    if (size.instructions <= kMostInstructions) return std::nullopt;
    Diagnostic made;
    made.code = "over-budget";
    made.message = fmt::format(
        "instructions of the {} stage of '{}', with all calls written out: {:.0f}, more than the "
        "budget of {:.0f}",
        to_string(shader.stage), shader.pass, size.instructions, kMostInstructions);
    if (size.line > 0) locate(made, shader, size.line);
    return made;
}

}  // namespace patina

#include "compiler/validate/count.h"

#include <glslang/SPIRV/GLSL.std.450.h>

#include <algorithm>
#include <set>
#include <unordered_map>

namespace patina::spirv {
namespace {

// Ranges of opcodes, as the specification numbers them.
struct Range {
    int first, last;
};
template <std::size_t N>
bool is_in(int op, const Range (&ranges)[N]) {
    return std::ranges::any_of(ranges, [&](const Range& each) { return op >= each.first && op <= each.last; });
}

constexpr Range kNothing[] = {
    {spv::OpNop, spv::OpUndef},         {spv::OpFunction, spv::OpFunctionEnd},
    {spv::OpVariable, spv::OpVariable}, {spv::OpLoopMerge, spv::OpLabel},
    {spv::OpLine, spv::OpLine},         {spv::OpNoLine, spv::OpNoLine},
};
constexpr Range kDivisions[] = {{spv::OpUDiv, spv::OpFMod}};
constexpr Range kArithmetic[] = {
    {spv::OpConvertFToU, spv::OpFConvert},
    {spv::OpSNegate, spv::OpSMulExtended},
    {spv::OpAny, spv::OpFUnordGreaterThanEqual},
    {spv::OpShiftRightLogical, spv::OpBitCount},
};
constexpr Range kTexture[] = {
    {spv::OpImageSampleImplicitLod, spv::OpImageRead},
    {spv::OpImageSparseSampleImplicitLod, spv::OpImageSparseDrefGather},
};
constexpr Range kDerivative[] = {{spv::OpDPdx, spv::OpFwidthCoarse}};
constexpr Range kTranscendental[] = {
    {GLSLstd450Sin, GLSLstd450InverseSqrt},
    {GLSLstd450Length, GLSLstd450Distance},
    {GLSLstd450Normalize, GLSLstd450Normalize},
    {GLSLstd450Refract, GLSLstd450Refract},
};

std::uint32_t& number_for(Instructions& cost, const Instruction& at) {
    if (at.op == spv::OpExtInst)
        return is_in(int(at.operands()[1]), kTranscendental) ? cost.transcendental : cost.arithmetic;
    if (is_in(at.op, kDivisions)) return cost.transcendental;
    if (is_in(at.op, kArithmetic)) return cost.arithmetic;
    if (is_in(at.op, kTexture)) return cost.texture;
    return is_in(at.op, kDerivative) ? cost.derivative : cost.other;
}

class Walk {
public:
    Walk(const Spirv& module, const std::function<bool(const Instruction&)>& is_light_loop,
         const std::function<void(const Instruction&, bool)>& visit)
        : module_(module), is_light_loop_(is_light_loop), visit_(visit) {
        for (Function& function : functions_of(module)) functions_.emplace(function.id, std::move(function));
    }

    // SPIR-V has no recursion.
    void run(std::uint32_t id, bool per_light) const {
        const auto found = functions_.find(id);
        if (found == functions_.end()) return;
        const Function& function = found->second;
        const std::set<std::uint32_t> lit = blocks_of_lights(function);
        for (const Block& block : function.blocks) {
            const bool is_lit = per_light || lit.contains(block.label);
            for (std::size_t i = block.begin; i < block.end; ++i) {
                const Instruction& at = module_.instructions[i];
                visit_(at, is_lit);
                if (at.op == spv::OpFunctionCall) run(at.words[3], is_lit);
            }
        }
    }

private:
    // The labels of all blocks that are reached from the header of a loop over lights before its end.
    std::set<std::uint32_t> blocks_of_lights(const Function& function) const {
        std::set<std::uint32_t> lit;
        for (const Block& header : function.blocks) {
            if (header.loop_end == 0 || lit.contains(header.label) || !is_light_loop_(merge_of(header))) continue;
            std::vector<std::uint32_t> work = {header.label};
            while (!work.empty()) {
                const std::uint32_t label = work.back();
                work.pop_back();
                const auto block = std::ranges::find(function.blocks, label, &Block::label);
                if (label == header.loop_end || block == function.blocks.end() || !lit.insert(label).second) continue;
                work.insert(work.end(), block->successors.begin(), block->successors.end());
            }
        }
        return lit;
    }

    const Instruction& merge_of(const Block& header) const {
        std::size_t at = header.begin;
        while (module_.instructions[at].op != spv::OpLoopMerge) ++at;
        return module_.instructions[at];
    }

    const Spirv& module_;
    const std::function<bool(const Instruction&)>& is_light_loop_;
    const std::function<void(const Instruction&, bool)>& visit_;
    std::unordered_map<std::uint32_t, Function> functions_;
};

}  // namespace

void add(Instructions& cost, const Instruction& at) {
    if (!is_in(at.op, kNothing)) ++number_for(cost, at);
}

void for_each_run(const Spirv& module, const std::function<bool(const Instruction& loop)>& is_light_loop,
                  const std::function<void(const Instruction& at, bool per_light)>& visit) {
    Walk(module, is_light_loop, visit).run(entry_of(module), false);
}

}  // namespace patina::spirv

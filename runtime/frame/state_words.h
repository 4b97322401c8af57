// The words of a pass for fixed-function state, and what they mean: Vulkan's value for the GPU, a formula for the CPU.
// One table each for comparisons, stencils and blend factors, so that both draw by the same words.
//
//   Outcome<PassState> state = pass_state(pass);   // or which word is not known
//   state.value.depth_test->holds(0.25f, 1.0f)
#pragma once

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string_view>
#include <vector>

#include "patina/reflection.h"
#include "runtime/outcome.h"

namespace patina::runtime {

// never | less | equal | lessEqual | greater | notEqual | greaterEqual | always
struct CompareWord {
    std::string_view word;
    VkCompareOp vulkan;
    bool (*holds)(float, float);  // new depth, or reference, to what is there
};

// keep | zero | replace | increment | decrement | invert | incrementWrap | decrementWrap
struct StencilWord {
    std::string_view word;
    VkStencilOp vulkan;
    int (*change)(int there, int reference);  // 0 to 255
};

// zero | one | srcColor | oneMinusSrcColor | dstColor | ... | oneMinusDstAlpha: base + slope * operand
struct BlendWord {
    enum class Operand { SourceColor, SourceAlpha, TargetColor, TargetAlpha };
    std::string_view word;
    VkBlendFactor vulkan;
    float base, slope;
    Operand operand;
};

struct TargetBlend {
    const BlendWord *source = nullptr, *destination = nullptr;              // of the colour
    const BlendWord *source_alpha = nullptr, *destination_alpha = nullptr;  // of alpha

    bool is_on() const {
        const auto overwrites = [](const BlendWord* from, const BlendWord* keep) {
            return from->vulkan == VK_BLEND_FACTOR_ONE && keep->vulkan == VK_BLEND_FACTOR_ZERO;
        };
        return !overwrites(source, destination) || !overwrites(source_alpha, destination_alpha);
    }
    friend bool operator==(const TargetBlend&, const TargetBlend&) = default;
};

// The pass's words, looked up.
struct PassState {
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    const CompareWord* depth_test = nullptr;
    const CompareWord* stencil_test = nullptr;
    const StencilWord *stencil_pass = nullptr, *stencil_fail = nullptr, *stencil_depth_fail = nullptr;
    std::uint8_t stencil_read_mask = 0xff, stencil_write_mask = 0xff;
    std::vector<TargetBlend> blends{};  // by target
};
Outcome<PassState> pass_state(const Pass& pass);

}  // namespace patina::runtime

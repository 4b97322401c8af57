// Tables that are computed when Patina is built (bake.cpp), because computing them takes half a second: the blurred
// levels of the studio's map, and the table of the split sum. Both are 32-bit floats.
#include <span>

#include "runtime/lighting/environment.h"
#include "runtime/lighting/split_sum.h"
#include "runtime/lighting/studio.h"

asm(".section .rodata\n.balign 16\n"
    "patina_baked:\n.incbin \"" PATINA_BAKED_FILE
    "\"\n"
    "patina_baked_end:\n.previous\n");
extern "C" {
extern const float patina_baked[] __attribute__((visibility("hidden")));
extern const float patina_baked_end[] __attribute__((visibility("hidden")));
}

namespace patina::runtime {
namespace {

constexpr std::size_t kSplitSumNumbers = std::size_t(2) * kSplitSumSize * kSplitSumSize;

}  // namespace

std::shared_ptr<const Environment> studio_environment() {
    static const auto kStudio = std::make_shared<const Environment>(project(studio_radiance), [] {
        return map_with_levels(studio_radiance, kStudioSize,
                               std::span<const float>(patina_baked + kSplitSumNumbers, patina_baked_end));
    });
    return kStudio;
}

std::shared_ptr<const TextureData> split_sum_table() {
    static const auto kTable = [] {
        TextureLevel level{.width = kSplitSumSize, .height = kSplitSumSize, .texels = {}};
        for (std::size_t i = 0; i < kSplitSumNumbers; i += 2)
            level.texels.insert(level.texels.end(), {patina_baked[i], patina_baked[i + 1], 0, 1});
        TextureData data{.levels = {std::move(level)}, .sampler = {.wrap = Wrap::Clamp}, .layers = 1};
        return std::make_shared<const TextureData>(std::move(data));
    }();
    return kTable;
}

}  // namespace patina::runtime

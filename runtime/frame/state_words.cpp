#include "runtime/frame/state_words.h"

#include <algorithm>

namespace patina::runtime {
namespace {

using Operand = BlendWord::Operand;

constexpr CompareWord kComparisons[] = {
    {"never", VK_COMPARE_OP_NEVER, [](float, float) { return false; }},
    {"less", VK_COMPARE_OP_LESS, [](float a, float b) { return a < b; }},
    {"equal", VK_COMPARE_OP_EQUAL, [](float a, float b) { return a == b; }},
    {"lessEqual", VK_COMPARE_OP_LESS_OR_EQUAL, [](float a, float b) { return a <= b; }},
    {"greater", VK_COMPARE_OP_GREATER, [](float a, float b) { return a > b; }},
    {"notEqual", VK_COMPARE_OP_NOT_EQUAL, [](float a, float b) { return a != b; }},
    {"greaterEqual", VK_COMPARE_OP_GREATER_OR_EQUAL, [](float a, float b) { return a >= b; }},
    {"always", VK_COMPARE_OP_ALWAYS, [](float, float) { return true; }},
};

constexpr int kMostStencil = 255;
constexpr StencilWord kStencilOps[] = {
    {"keep", VK_STENCIL_OP_KEEP, [](int there, int) { return there; }},
    {"zero", VK_STENCIL_OP_ZERO, [](int, int) { return 0; }},
    {"replace", VK_STENCIL_OP_REPLACE, [](int, int reference) { return reference; }},
    {"increment", VK_STENCIL_OP_INCREMENT_AND_CLAMP, [](int there, int) { return std::min(there + 1, kMostStencil); }},
    {"decrement", VK_STENCIL_OP_DECREMENT_AND_CLAMP, [](int there, int) { return std::max(there - 1, 0); }},
    {"invert", VK_STENCIL_OP_INVERT, [](int there, int) { return ~there & kMostStencil; }},
    {"incrementWrap", VK_STENCIL_OP_INCREMENT_AND_WRAP, [](int there, int) { return (there + 1) & kMostStencil; }},
    {"decrementWrap", VK_STENCIL_OP_DECREMENT_AND_WRAP, [](int there, int) { return (there - 1) & kMostStencil; }},
};

constexpr BlendWord kBlendFactors[] = {
    {"zero", VK_BLEND_FACTOR_ZERO, 0, 0, Operand::SourceAlpha},
    {"one", VK_BLEND_FACTOR_ONE, 1, 0, Operand::SourceAlpha},
    {"srcColor", VK_BLEND_FACTOR_SRC_COLOR, 0, 1, Operand::SourceColor},
    {"oneMinusSrcColor", VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR, 1, -1, Operand::SourceColor},
    {"dstColor", VK_BLEND_FACTOR_DST_COLOR, 0, 1, Operand::TargetColor},
    {"oneMinusDstColor", VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR, 1, -1, Operand::TargetColor},
    {"srcAlpha", VK_BLEND_FACTOR_SRC_ALPHA, 0, 1, Operand::SourceAlpha},
    {"oneMinusSrcAlpha", VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA, 1, -1, Operand::SourceAlpha},
    {"dstAlpha", VK_BLEND_FACTOR_DST_ALPHA, 0, 1, Operand::TargetAlpha},
    {"oneMinusDstAlpha", VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA, 1, -1, Operand::TargetAlpha},
};

struct CullWord {
    std::string_view word;
    VkCullModeFlags vulkan;
};
constexpr CullWord kCullModes[] = {
    {"back", VK_CULL_MODE_BACK_BIT}, {"front", VK_CULL_MODE_FRONT_BIT}, {"off", VK_CULL_MODE_NONE}};

// The tables are short, so they are searched. Null: there is no such word.
template <class Entry, std::size_t count>
const Entry* find_word(const Entry (&table)[count], std::string_view word) {
    auto found = std::find_if(table, table + count, [&](const Entry& entry) { return entry.word == word; });
    return found == table + count ? nullptr : found;
}

}  // namespace

Outcome<PassState> pass_state(const Pass& pass) {
    const auto unknown = [](const std::string& word, const char* what) {
        return Failure{"'" + word + "' is not " + what};
    };
    const CullWord* cull = find_word(kCullModes, pass.cull);
    if (!cull) return unknown(pass.cull, "a way to cull");
    PassState state{.cull = cull->vulkan,
                    .depth_test = find_word(kComparisons, pass.depth_test),
                    .stencil_test = find_word(kComparisons, pass.stencil.test),
                    .stencil_pass = find_word(kStencilOps, pass.stencil.pass),
                    .stencil_fail = find_word(kStencilOps, pass.stencil.fail),
                    .stencil_depth_fail = find_word(kStencilOps, pass.stencil.depth_fail),
                    .stencil_read_mask = std::uint8_t(pass.stencil.read_mask),
                    .stencil_write_mask = std::uint8_t(pass.stencil.write_mask)};
    if (!state.depth_test) return unknown(pass.depth_test, "a depth test");
    if (!state.stencil_test) return unknown(pass.stencil.test, "a stencil test");
    for (const auto& [found, word] :
         {std::pair(state.stencil_pass, &pass.stencil.pass), std::pair(state.stencil_fail, &pass.stencil.fail),
          std::pair(state.stencil_depth_fail, &pass.stencil.depth_fail)})
        if (!found) return unknown(*word, "what becomes of a stencil");
    for (const RenderTarget& target : pass.targets) {
        TargetBlend blend{};
        const std::pair<const BlendWord**, const std::string*> factors[] = {
            {&blend.source, &target.blend.source},
            {&blend.destination, &target.blend.destination},
            {&blend.source_alpha, &target.blend.source_alpha},
            {&blend.destination_alpha, &target.blend.destination_alpha}};
        for (const auto& [word, text] : factors) {
            *word = find_word(kBlendFactors, *text);
            if (!*word) return unknown(*text, "a blend factor");
        }
        state.blends.push_back(blend);
    }
    return state;
}

}  // namespace patina::runtime

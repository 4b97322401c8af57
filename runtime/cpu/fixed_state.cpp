#include "runtime/cpu/fixed_state.h"

#include <algorithm>

namespace patina::runtime {
namespace {

constexpr int kMostStencil = 255;

float factor(BlendFactor factor, const glm::vec4& source, const glm::vec4& target, int channel) {
    switch (factor) {
        case BlendFactor::One: return 1;
        case BlendFactor::Zero: return 0;
        case BlendFactor::SourceAlpha: return source.a;
        case BlendFactor::OneMinusSourceAlpha: return 1 - source.a;
        case BlendFactor::TargetAlpha: return target.a;
        case BlendFactor::OneMinusTargetAlpha: return 1 - target.a;
        case BlendFactor::SourceColor: return source[channel];
        case BlendFactor::OneMinusSourceColor: return 1 - source[channel];
        case BlendFactor::TargetColor: return target[channel];
        case BlendFactor::OneMinusTargetColor: return 1 - target[channel];
    }
    return 1;
}

}  // namespace

bool holds(Compare compare, float value, float there) {
    switch (compare) {
        case Compare::Never: return false;
        case Compare::Less: return value < there;
        case Compare::Equal: return value == there;
        case Compare::LessEqual: return value <= there;
        case Compare::Greater: return value > there;
        case Compare::NotEqual: return value != there;
        case Compare::GreaterEqual: return value >= there;
        case Compare::Always: return true;
    }
    return true;
}

int changed(StencilOp op, int there, int reference) {
    switch (op) {
        case StencilOp::Keep: return there;
        case StencilOp::Zero: return 0;
        case StencilOp::Replace: return reference;
        case StencilOp::Increment: return std::min(there + 1, kMostStencil);
        case StencilOp::Decrement: return std::max(there - 1, 0);
        case StencilOp::Invert: return ~there & kMostStencil;
        case StencilOp::IncrementWrap: return (there + 1) & kMostStencil;
        case StencilOp::DecrementWrap: return (there - 1) & kMostStencil;
    }
    return there;
}

glm::vec4 blended(const Blend& blend, const glm::vec4& source, const glm::vec4& target) {
    glm::vec4 result;
    for (int c = 0; c < 4; c++) {
        const bool is_alpha = c == 3;
        const float from = factor(is_alpha ? blend.source_alpha : blend.source, source, target, c),
                    keep = factor(is_alpha ? blend.destination_alpha : blend.destination, source, target, c);
        // A factor of 0 drops its side even where that is NaN.
        result[c] = (from == 0 ? 0 : source[c] * from) + (keep == 0 ? 0 : target[c] * keep);
    }
    return result;
}

}  // namespace patina::runtime

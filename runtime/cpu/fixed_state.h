// The fixed-function state of a pass as formulas: comparisons, stencil operations, and blending a pixel with the
// target. For the GPU, gpu/vulkan_words.h translates the same words to Vulkan's values.
//
//   holds(Compare::LessEqual, 0.25f, 1.0f)      // true
//   changed(StencilOp::Increment, 255, 0)       // 255
#pragma once

#include <glm/glm.hpp>

#include "patina/reflection.h"

namespace patina::runtime {

// `value`: the new depth, or the reference; `there`: what is in the target.
bool holds(Compare compare, float value, float there);

// 0 to 255.
int changed(StencilOp op, int there, int reference);

// `source`: the pixel; `target`: what is there.
glm::vec4 blended(const Blend& blend, const glm::vec4& source, const glm::vec4& target);

}  // namespace patina::runtime

// Textures as values: a struct of the texture, its sampler and what is known of its size, and the methods that sample
// it. make_texture() is public (emit.h).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

ir::Type texture_type(Emitter& emitter);  // {texture, sampler, texelSize, tiling}
ir::Type cube_type(Emitter& emitter);     // {texture, sampler}
bool is_texture(const Emitter& emitter, ir::Type type);
Typed make_cube(Emitter& emitter, ir::Value texture, ir::Value sampler, Scope& scope);
// texture.Sample(uv), texture.Sample(sampler, uv), texture.Load(texel, level) and so on.
Typed method(Emitter& emitter, const Expr& expr, Scope& scope);

}  // namespace patina::emit

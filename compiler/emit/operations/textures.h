// Textures as values: a struct of the texture, its sampler and its size, if known, and the methods that sample it.
// make_texture() is public (emit.h).
#pragma once

#include "compiler/emit/emit.h"

namespace patina::emit {

// {texture, sampler}, and of Texture2D {texture, sampler, texelSize, tiling}. Each view has a type of its own.
ir::Type texture_type(Emitter& emitter, ir::Kind kind, const TextureView& view = {});
// texture.Sample(uv), texture.Sample(sampler, uv), texture.Load(texel, level) and so on.
Typed method(Emitter& emitter, const Expr& expr, Scope& scope);
// The value of an expression where a sampler is wanted: in a graph, a name alone may be one of patina/reflection.h.
Typed sampler_value(Emitter& emitter, const Expr& expr, Scope& scope);

}  // namespace patina::emit

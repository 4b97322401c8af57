// Makes the public Reflection, which is what a runtime must know of a compiled material, from the material's properties
// and the linked stages. Layout and bindings do not depend on the requested passes and targets.
#pragma once

#include "compiler/link/link.h"
#include "patina/reflection.h"

namespace patina::output {

// `material` and `lowered` are those of the material itself. `passes`: its own and its extra passes.
Reflection reflect(const resolve::Material& material, const lower::Lowered& lowered,
                   std::span<const link::LinkedPass> passes, const resolve::Session& session);

// The material's queue: the one that the material sets, or that of its kind of surface.
int queue_of(const format::RenderState& render);

}  // namespace patina::output

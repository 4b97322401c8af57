// What a runtime must know of a compiled material: the public Reflection, from the material's properties and the linked
// stages. Layout and bindings are the same whatever passes and targets were asked for.
#pragma once

#include "compiler/link/link.h"
#include "patina/reflection.h"

namespace patina::output {

// `material`, `lowered`: of the material itself. `passes`: its own, and those that it adds.
Reflection reflect(const graph::Material& material, const graph::Lowered& lowered,
                   std::span<const assemble::LinkedPass> passes, bool with_hashes);

// The material's queue: its own, or that of its kind of surface.
int queue_of(const graph::RenderState& render);

}  // namespace patina::output

// What a runtime must know of a compiled material: the public Reflection, from the material's properties and the linked
// stages. Layout and bindings are the same whatever passes and targets were asked for.
#pragma once

#include "compiler/languages/print.h"
#include "compiler/link/link.h"
#include "patina/reflection.h"

namespace patina::assemble {

struct LinkedPass {
    const graph::LoweredPass* pass = nullptr;
    const graph::Material* material = nullptr;  // another one for each pass that a material adds
    const graph::Lowered* lowered = nullptr;
    ir::Module vertex{}, fragment{};
};

// `material`, `lowered`: of the material itself. `passes`: its own, and those that it adds.
Reflection reflect(const graph::Material& material, const graph::Lowered& lowered, std::span<const LinkedPass> passes);

// The material's queue: its own, or that of its kind of surface.
int queue_of(const graph::RenderState& render);

// Vulkan bindings of a set are buffers, then textures, then samplers; HLSL counts each from 0.
std::vector<targets::SetShifts> binding_shifts(const ir::Module& module);

}  // namespace patina::assemble

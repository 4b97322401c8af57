// The globals of a module: the engine's uniform blocks (from the [extern] variables), and the material's block,
// textures and samplers (from its properties), laid out so that GLSL's std140 and an HLSL cbuffer agree on every byte.
#pragma once

#include <map>
#include <set>
#include <span>

#include "compiler/emit/emit.h"
#include "compiler/ir/ir.h"
#include "compiler/resolve/material.h"

namespace patina::graph {

struct PropertyGlobals {
    ir::GlobalId value;    // numeric properties
    ir::GlobalId texture;  // texture properties
    ir::GlobalId sampler;
    ir::GlobalId tiling;      // float4 scale and offset, when the property has "tiling"
    ir::GlobalId texel_size;  // float4, where the engine fills it beside the texture (keep_values.cpp)
    // A keyword: its global; or none, and it is a constant, where texts are made for one value of it.
    ir::GlobalId keyword;
};

// The type of a numeric property's value in its block.
ir::Type property_type(PropertyType type);

// Declares every [extern] and [reads] variable: numbers in one block per name, textures each with a sampler behind it,
// all in order of appearance. Those that are there [with] switches or paths come last, so that they move no other, and
// only if one of these is in `on`.
struct EngineGlobals {
    std::set<std::uint32_t> per_object;          // of the object that is drawn
    std::map<std::uint32_t, std::string> reads;  // textures that are targets of other passes
};
EngineGlobals declare_engine(const engines::Engine& engine, const PathDeclarations& paths,
                             const nodelang::Declarations& declarations, emit::Emitter& emitter,
                             std::span<const std::string_view> on = {});
// One entry per Material::properties. `keep_variants`: those that nobody has chosen a value for are globals too, and
// not constants. `instances`: the block of the properties that each instance has; nothing: the material's.
std::vector<PropertyGlobals> declare_material(const engines::Engine& engine, const Material& material,
                                              ir::Module& module, bool keep_variants,
                                              std::optional<std::uint32_t> instances = {});

// Appends a member at the next offset that both layouts accept.
void add_member(ir::UniformBlock& block, const ir::Module& module, std::string name, ir::Type type);
// Bytes that a member of this type takes, and its alignment in std140.
struct Extent {
    std::uint32_t size = 0, alignment = 0, stride = 0;  // stride: of an array's elements
};
Extent extent(const ir::Module& module, ir::Type type);

}  // namespace patina::graph

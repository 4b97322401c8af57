// Declares the globals of a module: the engine's uniform blocks (from the [extern] variables), and the material's
// block, textures and samplers (from its properties). The layout of a block is the same, to the byte, in GLSL's std140
// and in an HLSL cbuffer.
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>

#include "compiler/emit/emit.h"
#include "compiler/ir/ir.h"
#include "compiler/resolve/material.h"

namespace patina::lower {

struct PropertyGlobals {
    ir::GlobalId value;       // numeric properties
    ir::GlobalId texture;     // texture properties
    ir::GlobalId sampler;     // of a texture: declared behind it, or behind the first of the textures that share it; or
                              // of a property that is a sampler: declared before all textures
    ir::GlobalId tiling;      // float4 scale and offset, when the property has "tiling"
    ir::GlobalId texel_size;  // float4; only if the engine fills it for the texture (keep_values.cpp)
    // For a keyword: its global. None if it is a constant, because the text is made for one value.
    ir::GlobalId keyword;
};

// The kind of a texture property.
ir::Kind texture_kind(PropertyType type);
// The type of a property's value in its block, or of a texture. A matrix of any size is a float4x4 there, because
// languages pad smaller ones differently. A gradient and a curve are arrays of float4.
ir::Type property_type(ir::Module& module, PropertyType type);

// The numbers of the library's blocks and textures, by name, as if all switches and paths were on. A value of a switch
// has a number of its own, so no switch changes any binding.
struct Numbering {
    std::map<std::string, std::uint32_t, std::less<>> blocks;
    std::array<std::map<std::string, std::uint32_t, std::less<>>, 3> textures;  // by ir::Group
};

// Declares every [extern] and [reads] variable: numbers in one block per name, each texture followed by its sampler,
// all in order of appearance. Variables that exist only [with] a switch or path are declared if one of these is in
// `on`. They come last, so that they change neither the offsets nor the numbers of the others.
struct EngineGlobals {
    Numbering numbering;
    std::set<std::uint32_t> per_object;          // those of the drawn object
    std::map<std::uint32_t, std::string> reads;  // textures that are targets of other passes
};
EngineGlobals declare_engine(const engines::Engine& engine, const paths::PathDeclarations& paths,
                             const nodelang::Declarations& declarations, emit::Emitter& emitter,
                             std::span<const std::string_view> on = {});
// One entry per Material::properties. `keep_variants`: variants without a chosen value become globals instead of
// constants. `instances`: the block of the properties that each instance has; nothing: the material's.
std::vector<PropertyGlobals> declare_material(const engines::Engine& engine, const resolve::Material& material,
                                              ir::Module& module, bool keep_variants,
                                              std::optional<std::uint32_t> instances = {});

// Appends a member at the next offset that both layouts allow.
void add_member(ir::UniformBlock& block, const ir::Module& module, std::string name, ir::Type type);
// The size of a member of this type in bytes, and its alignment in std140.
struct Extent {
    std::uint32_t size = 0, alignment = 0, stride = 0;  // stride: of an array's elements
};
Extent extent(const ir::Module& module, ir::Type type);

}  // namespace patina::lower

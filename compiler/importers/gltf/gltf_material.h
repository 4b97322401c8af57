// A material of a glTF file as a graph: the core metallic-roughness material, or the one of
// KHR_materials_pbrSpecularGlossiness or KHR_materials_unlit; alpha modes, sides, vertex colours. gltf_layers.h adds
// the layers of the other extensions.
//
//   ImportedGraph graph = material_graph(context, pictures, 2, {.name = "Paint", .has_colors = true});
#pragma once

#include <array>

#include "compiler/importers/gltf/material_graph.h"

namespace patina::importers::gltf {

// How the file's meshes use a material.
struct MaterialUse {
    std::string name{};                       // of its files
    bool has_colors = false;                  // a mesh has vertex colours
    std::array<bool, 4> lacks_coordinates{};  // by set: a mesh has no such texture coordinates
    bool is_scaled = false;                   // a node has a scale other than 1
    bool is_stretched = false;                // with different factors along its axes
};

// `index` past the end: the material of meshes that name none.
ImportedGraph material_graph(const Context& context, Pictures& pictures, std::size_t index, const MaterialUse& use);

}  // namespace patina::importers::gltf

// The room `bake`: a material's surface as textures of a mesh, and as a glTF model that has them. It draws through the
// room `render`, and contains no formulas of lighting.
//
// The steps:
//   1. the texture coordinates of the mesh are checked (uv_layout.h)
//   2. the pass of nodes/passes/bake.pass.hlsl draws the surface where they are
//   3. what is the same everywhere becomes a factor, the rest a texture (baked_material.h), filled between the charts
//      (padding.h)
//   4. the model is written (runtime/gltf/gltf_writer.h)
//
//   BakeOutcome made = bake(compiler, {.render = {.graph = "rust.graph.json", .size = 1024}}, machine);
//   for (const BakedFile& file : made.files) write(folder + file.name, file.bytes);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/render/render_machine.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {

struct BakeRequest {
    // Of a graph: its mesh, values and size. The time, the camera, and lights or surroundings are fixed where the
    // request says one; a surface that reads them is refused otherwise.
    RenderRequest render{};
    bool is_specular = false;  // KHR_materials_pbrSpecularGlossiness instead of metallic and roughness
    bool is_exr = false;       // the textures next to the model; those in it are PNG, as glTF demands
    std::string name{};        // of the model and the files
};

struct BakedFile {
    std::string name{}, bytes{};
};

struct BakeOutcome {
    bool ok = false;
    std::vector<BakedFile> files{};  // the textures, then the model
    std::vector<Diagnostic> diagnostics{};
    std::string error{};  // as RenderOutcome's
    bool missing_machine = false;
    std::vector<std::string> dependencies{};
    std::string lighting{};  // the graph's lighting model
    bool is_unlit = false;
};

BakeOutcome bake(const Compiler& compiler, const BakeRequest& request, RenderMachine& machine);

}  // namespace patina::runtime

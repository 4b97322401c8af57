// The scene that draws a glTF model: an object for each primitive of each node, the graphs of its materials, one
// camera, and the lights of the file, or the default ones of `patina render`.
//
//   std::string json = scene_text(context, model, {.name = "chair", .graphs = {"Paint", "Glass"}}, materials);
#pragma once

#include "compiler/importers/gltf/gltf_pictures.h"
#include "runtime/gltf/gltf_model.h"

namespace patina::importers::gltf {

struct SceneWish {
    std::string name{};
    std::vector<std::string> graphs{};     // names of the materials' graphs, without ".graph.json"
    std::vector<std::size_t> materials{};  // of each part of the model: index into `graphs`
    const runtime::ModelCamera* camera{};  // null: one that sees the whole model
    bool is_lit = false;                   // as Options::is_lit
};

std::string scene_text(const Context& context, const runtime::GltfModel& model, const SceneWish& wish);

// Why a scene cannot show the model through this camera (null: one that sees all of it); empty: it can.
std::string scene_mistake(const runtime::GltfModel& model, const runtime::ModelCamera* camera);

// Remarks on what scene_text() makes of cameras and lights.
void report_view(const Context& context, const runtime::GltfModel& model, const runtime::ModelCamera* camera);

// The camera of that name, its node's or its own; without a name the first; null: there is none.
const runtime::ModelCamera* find_camera(const runtime::GltfModel& model, const std::string& name);

}  // namespace patina::importers::gltf

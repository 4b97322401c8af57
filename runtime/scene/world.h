// Several objects, each with a material: the contents of a scene file (patina/scene.h), with meshes created and
// transforms converted to matrices. frame_plan.h decides which shaders draw it, and in which order.
//
//   World world{.view = default_scene(""), .materials = {{.name = "rust", .graph = "rust.graph.json"}},
//               .objects = {{.name = "ball", .mesh = sphere, .material = 0}}};
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "patina/scene.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

struct WorldMaterial {
    std::string name{};
    std::string graph{};                             // a file
    std::map<std::string, std::string> overrides{};  // property -> its value in words, as material_values() takes them
    FileLocation place{};                            // where a scene file says so; its file is empty if none does
    std::vector<SceneValue> set{};                   // the overrides as in its file, with their locations
    // How it is drawn, if not as the others are.
    std::string preview{};  // a port that it shows instead, unlit, as RenderOptions::preview
    std::string path{};     // a rendering path
};

// One of an object's places. A material with properties of instances draws all of an object's in one draw.
struct WorldInstance {
    glm::mat4 object_to_world{1};
    std::map<std::string, std::string> overrides{};  // of properties that each instance has, as WorldMaterial's
    std::vector<SceneValue> set{};                   // the same with their places
};

struct WorldObject {
    std::string name{};
    std::shared_ptr<const Mesh> mesh{};
    glm::mat4 object_to_world{1};
    std::vector<WorldInstance> instances{};  // none: one at `object_to_world`, which else is not used
    std::size_t material = 0;                // index into World::materials
    std::string lightmap{};  // a file: baked light, looked up by the mesh's second texture coordinates; empty: none
    LightmapEncoding lightmap_encoding = LightmapEncoding::Hdr;
    std::string shadow_mask{};  // a file: baked shadow of each of four lights; empty: none
    FileLocation lightmap_place{}, shadow_mask_place{};
};

struct World {
    Scene view{};  // camera, lights, surroundings, fog, time, size; its mesh and its object_to_world are unused
    std::vector<WorldMaterial> materials{};
    std::vector<WorldObject> objects{};
    int pixel_light_count = 4;  // per pixel where a path splits lights (light_split.h), the main one among them
};

}  // namespace patina::runtime

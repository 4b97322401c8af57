// A scene (`"kind": "scene"`) as its file states it: camera, lights, surroundings, materials and objects. Words and
// numbers are checked, and files are found but not read; a mesh is only a name. It is plain data;
// runtime/scene/world_file.h makes a world of it that can be drawn.
//
//   patina::SceneResult read = compiler.read_scene("shelf.scene.json");
//   for (const patina::SceneMaterial& material : read.scene.materials) compiler.compile_file(material.graph.path);
//
// Lengths are metres, angles degrees, colours linear. World space is right-handed with y up.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "patina/diagnostic.h"
#include "patina/words.h"

namespace patina {

struct SceneFileName {
    std::string path;  // a path that can be opened; empty: none
    FilePlace place;
};

using SceneVector = std::array<double, 3>;

inline constexpr std::size_t kMostSceneLights = 16;
inline constexpr std::size_t kMostSceneShadows = 4;

struct SceneCamera {
    SceneVector position{0, 0, 4}, target{};  // they must differ
    SceneVector up{0, 1, 0};                  // what is up in the picture; across the view; [0, 1, 0] may be along it
    double fov = 30;                          // vertical, 1 to 170
    std::optional<double> orthographic{};     // height of the picture in metres; if set, the projection is parallel
    double near_plane = 0.05, far_plane = 100;
};

struct SceneShadow {
    double strength = 1;       // 0 to 1: how dark
    double bias = 0.05;        // metres along the light's direction
    double normal_bias = 0.4;  // texels of the shadow map that a surface is shrunk by, along its normal
};

struct SceneLight {
    LightKind type = LightKind::Directional;
    SceneVector position{};          // point and spot
    SceneVector direction{0, 0, 1};  // directional: towards the light. Spot: where it points. Any length but 0
    SceneVector color{1, 1, 1};
    double intensity = 1;
    double range = 10;                       // point and spot: no light beyond
    std::optional<double> inner{}, outer{};  // spot: from the axis, full light within, none outside; inner <= outer
    LightImportance render_mode = LightImportance::Auto;
    std::optional<SceneShadow> shadow{};  // directional and spot
    SceneFileName cookie{};               // directional and spot: a picture that colours the light
    double cookie_size = 10;              // directional: its size in metres
    FilePlace place{};
};

// Radiance from above, from the sides and from below. At least one is given; the others follow from it.
struct SceneAmbient {
    std::optional<SceneVector> sky{}, horizon{}, ground{};
};

// A picture of the surroundings.
struct ScenePicture {
    SceneFileName file;
    double rotation = 0;  // degrees about y, counter-clockwise seen from above
    double intensity = 1;
};

// What objects near it reflect, instead of the environment.
struct SceneProbe {
    ScenePicture picture{};
    SceneVector position{};                             // where the picture was taken, inside the box
    SceneVector box_min{-1, -1, -1}, box_max{1, 1, 1};  // along the axes of the world
    double blend = 0;                                   // metres outside of the box over which it fades
    bool box_projection = true;  // what is seen in the picture is as far away as the walls of the box
    int importance = 1;          // 0 to 1000: more important ones hide others
};
inline constexpr std::size_t kMostSceneProbes = 32;

struct SceneFog {
    FogMode mode = FogMode::Linear;
    SceneVector color{0.5, 0.5, 0.5};
    double density = 0.05;       // exponential: per metre
    double start = 5, end = 50;  // linear
};

struct SceneMixedLighting {
    LightMixing mode = LightMixing::ShadowMask;
    SceneVector shadow_color{};               // subtractive
    std::optional<double> shadow_distance{};  // metres; nothing: real-time shadows do not end
    std::optional<double> shadow_fade{};      // metres, at most the distance
};

// A property of a material's graph and its value in words: "0.2", "1,0,0", "true", "Wet", a file that can be opened.
struct SceneValue {
    std::string property;
    std::string words;
    FilePlace property_place, value_place;
};

struct SceneMaterial {
    std::string name;
    SceneFileName graph;
    std::vector<SceneValue> set;
    FilePlace place;  // that of its name
};

// One of the places of an object, relative to it.
struct SceneInstance {
    SceneVector position{}, rotation{}, scale{1, 1, 1};  // as an object's
    std::vector<SceneValue> set{};                       // properties with a value for each instance
};
inline constexpr std::size_t kMostSceneInstances = 100'000;

struct SceneObject {
    std::string id;
    std::string mesh;  // "sphere", "model.glb#Node"; not checked
    FilePlace mesh_place;
    std::optional<int> segments{};  // 3 to 512: how fine the mesh is
    std::size_t material = 0;       // index into SceneFile::materials
    SceneVector position{};
    SceneVector rotation{};  // turned about z, then about x, then about y, counter-clockwise seen from the axis's tip
    SceneVector scale{1, 1, 1};  // greater than 0; before the turn
    SceneFileName lightmap{}, shadow_mask{};
    LightmapEncoding lightmap_encoding = LightmapEncoding::Hdr;
    std::vector<SceneInstance> instances{};  // at most kMostSceneInstances; none: it is drawn once
};

struct SceneFile {
    std::string path;
    std::string name;  // "name", or the file's stem
    SceneCamera camera{};
    std::vector<SceneLight> lights{};       // at most kMostSceneLights, kMostSceneShadows of them with a shadow
    std::optional<SceneAmbient> ambient{};  // nothing: the picture's, or the studio's
    bool has_studio_ambient = false;        // although there is a picture
    SceneEnvironment environment = SceneEnvironment::Studio;
    std::optional<ScenePicture> picture{};  // the environment, instead of `environment`
    std::vector<SceneProbe> probes{};       // at most kMostSceneProbes
    std::optional<SceneFog> fog{};
    SceneMixedLighting mixed_lighting{};
    std::optional<std::array<double, 4>> background{};  // linear, with alpha; nothing: the runtime's own
    SceneBackdrop backdrop = SceneBackdrop::Color;      // else `background` is nothing
    double time = 0;                                    // seconds
    int pixel_light_count = 4;                          // 0 to kMostSceneLights
    std::vector<SceneMaterial> materials{};
    std::vector<SceneObject> objects{};
};

}  // namespace patina

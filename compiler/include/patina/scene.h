// A scene (`"kind": "scene"`) as its file has it: camera, lights, surroundings, materials and objects. Words and
// numbers are checked. Files are found but not read; a mesh is only a name. It is plain data;
// runtime/scene/world_file.h turns it into a world, which can be drawn.
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

// A file that a scene names.
struct SceneFileName {
    std::string path;    // a path that can be opened; empty: none
    FileLocation place;  // of the name in the scene
};

// x, y and z; or red, green and blue.
using SceneVector = std::array<double, 3>;

inline constexpr std::size_t kMostSceneLights = 16;  // the highest number of lights
inline constexpr std::size_t kMostSceneShadows = 4;  // the highest number of lights with a shadow

// How finely a built-in mesh may be divided: one limit for scenes, snapshots and the command line.
inline constexpr int kLeastSegments = 3;   // the lowest number of segments
inline constexpr int kMostSegments = 512;  // the highest number of segments

// The camera of a scene.
struct SceneCamera {
    SceneVector position{0, 0, 4}, target{};    // where it is, and the point that it looks at; they must differ
    SceneVector up{0, 1, 0};                    // up in the picture; not along the view, except [0, 1, 0]
    double fov = 30;                            // vertical, 1 to 170 degrees
    std::optional<double> orthographic{};       // height of the picture in metres; if set, the projection is parallel
    double near_plane = 0.05, far_plane = 100;  // metres, 0 < near < far: only what is between them is drawn
};

// The shadow of a light.
struct SceneShadow {
    double strength = 1;       // 0 to 1: how dark
    double bias = 0.05;        // metres along the light's direction
    double normal_bias = 0.4;  // texels of the shadow map: surfaces shrink by so much along their normal
};

// A light of a scene.
struct SceneLight {
    LightKind type = LightKind::Directional;  // where it is
    SceneVector position{};                   // point and spot
    SceneVector direction{0, 0, 1};           // directional: towards the light. Spot: where it points. Any length but 0
    SceneVector color{1, 1, 1};  // times `intensity`: the radiance of a white diffuse surface that faces it
    double intensity = 1;        // 0 or more
    double range = 10;           // point and spot: metres, no light beyond
    // Spot: degrees from its axis. There is full light within `inner`, and none outside `outer`; inner <= outer.
    // Nothing: the format's defaults.
    std::optional<double> inner{}, outer{};
    LightImportance render_mode = LightImportance::Auto;  // for paths that cannot compute every light per pixel
    std::optional<SceneShadow> shadow{};                  // directional and spot
    SceneFileName cookie{};                               // directional and spot: a picture whose red filters the light
    double cookie_size = 10;                              // directional: its size in metres
    FileLocation place{};                                 // of the light in the scene
};

// Radiance from above, from the sides and from below. At least one is set; the others follow from it.
struct SceneAmbient {
    std::optional<SceneVector> sky{}, horizon{}, ground{};  // from above, from the sides, from below
};

// A picture of the surroundings.
struct ScenePicture {
    SceneFileName file;    // the picture
    double rotation = 0;   // degrees about y, counter-clockwise seen from above
    double intensity = 1;  // factor of its light, 0 or more
};

// A probe: objects near it reflect its picture instead of the environment.
struct SceneProbe {
    ScenePicture picture{};                             // the surroundings of the position
    SceneVector position{};                             // where the picture was taken, inside the box
    SceneVector box_min{-1, -1, -1}, box_max{1, 1, 1};  // along the axes of the world
    double blend = 0;                                   // metres outside of the box, over which its effect fades
    bool box_projection = true;                         // the picture is on the walls of the box; false: far away
    int importance = 1;                                 // 0 to 1000: more important ones hide others
};
inline constexpr std::size_t kMostSceneProbes = 32;  // the highest number of probes

// The fog of a scene.
struct SceneFog {
    FogMode mode = FogMode::Linear;    // how it grows with the distance
    SceneVector color{0.5, 0.5, 0.5};  // of objects that are far away
    double density = 0.05;             // exponential: per metre, 0 or more
    double start = 5, end = 50;        // linear: metres at which fog begins, and from which only fog is seen
};

// How baked light and real-time shadows go together.
struct SceneMixedLighting {
    LightMixing mode = LightMixing::ShadowMask;  // the combination
    SceneVector shadow_color{};                  // subtractive: the darkest colour of shadows
    std::optional<double> shadow_distance{};     // metres; nothing: real-time shadows do not end
    std::optional<double> shadow_fade{};         // metres, at most the distance
};

// A property of a material's graph and its value in words: "0.2", "1,0,0", "true", "Wet", a file that can be opened.
struct SceneValue {
    std::string property;                            // its name
    std::string words;                               // its value
    FileLocation property_location, value_location;  // of both in the scene
};

// A material of a scene: a graph with values.
struct SceneMaterial {
    std::string name;             // as objects name it
    SceneFileName graph;          // of a material; the file is not read
    std::vector<SceneValue> set;  // the values that replace defaults
    FileLocation place;           // of its name
};

// An instance of an object: a position and other values, relative to the object.
struct SceneInstance {
    SceneVector position{}, rotation{}, scale{1, 1, 1};  // as of an object, in the space of the object
    std::vector<SceneValue> set{};                       // properties with a value for each instance
};
inline constexpr std::size_t kMostSceneInstances = 100'000;  // the highest number of instances of an object

// An object of a scene.
struct SceneObject {
    std::string id;                 // its name, unique in the scene
    std::string mesh;               // "sphere", "model.glb#Node"; not checked
    FileLocation mesh_location;     // of the mesh in the scene
    std::optional<int> segments{};  // kLeastSegments to kMostSegments: how fine the mesh is
    std::size_t material = 0;       // index into SceneFile::materials
    SceneVector position{};         // of the mesh's origin
    SceneVector rotation{};  // turned about z, then about x, then about y, counter-clockwise seen from the axis's tip
    SceneVector scale{1, 1, 1};                                  // greater than 0; before the turn
    SceneFileName lightmap{}, shadow_mask{};                     // pictures of its baked light and shadows
    LightmapEncoding lightmap_encoding = LightmapEncoding::Hdr;  // how the lightmap holds light
    std::vector<SceneInstance> instances{};                      // at most kMostSceneInstances; none: it is drawn once
};

// All of a scene.
struct SceneFile {
    std::string path;                       // the argument of read_scene()
    std::string name;                       // "name", or the file's stem
    SceneCamera camera{};                   // the file's, or the default one
    std::vector<SceneLight> lights{};       // at most kMostSceneLights, kMostSceneShadows of them with a shadow
    std::optional<SceneAmbient> ambient{};  // nothing: the light of the picture, or of the studio
    bool has_studio_ambient = false;        // also if there is a picture
    SceneEnvironment environment = SceneEnvironment::Studio;  // what mirrors reflect
    std::optional<ScenePicture> picture{};                    // the environment, instead of `environment`
    std::vector<SceneProbe> probes{};                         // at most kMostSceneProbes
    std::optional<SceneFog> fog{};                            // nothing: there is no fog
    SceneMixedLighting mixed_lighting{};                      // of lightmaps and shadow masks
    std::optional<std::array<double, 4>> background{};        // linear, with alpha; nothing: the runtime's own
    SceneBackdrop backdrop = SceneBackdrop::Color;            // if it is not Color, `background` is nothing
    double time = 0;                                          // seconds: "@time"
    int pixel_light_count = 4;                                // 0 to kMostSceneLights
    std::vector<SceneMaterial> materials{};                   // in the order of the file
    std::vector<SceneObject> objects{};                       // in the order of the file
};

}  // namespace patina

// The value that a scene gives to each engine value of nodes/stage/, by its name there: camera, object, frame, lights
// and ambient light. It holds only numbers and names; material_values.h writes them to the places of the reflection.
//
//   engine_values(scene).at("lightColor").numbers   // four for each light
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "runtime/lights/probe_choice.h"
#include "runtime/lights/shadow_view.h"
#include "runtime/scene/scene.h"
#include "runtime/scene/view.h"

namespace patina::runtime {

// Vectors of `per_vector` numbers one after the other: columns of a matrix, elements of an array, or a single one.
struct EngineValue {
    unsigned per_vector = 1;
    std::vector<double> numbers;
};

// A light for a draw: its slot is its index in EngineScene::lights.
struct SeenLight {
    const Light* light = nullptr;
    std::size_t index = 0;  // in the scene
    int shadow_map = -1;    // index into EngineScene::shadow_maps; -1: it throws no shadow here
};

struct MaterialValues;  // material_values.h

// An object of those that one draw draws.
struct SeenInstance {
    glm::mat4 object_to_world{1};
    const MaterialValues* values = nullptr;  // null: the material's
};

// The scene as one draw sees it.
struct EngineScene {
    const Scene* scene = nullptr;  // time, size and fog are its
    View view{};
    glm::mat4 object_to_world{1};
    std::vector<SeenInstance> instances{};   // of a material that has some; empty: one at `objectToWorld`
    std::vector<SeenLight> lights{};         // at most kMostLights count
    std::vector<SeenLight> vertex_lights{};  // at most kMostVertexLights count
    SphericalHarmonics ambient{};
    ProbeChoice probes{};                       // of the object
    std::span<const ShadowView> shadow_maps{};  // at most kMostShadowMaps count
    int shadow_atlas_size = 1;                  // texels along a side
    glm::vec4 lightmap_decode{1, 1, 0, 0};      // of Unity's DecodeHDR; these leave texels as they are
};

// Camera: worldToClip, clipToWorld, worldToView, cameraPositionWS, cameraForwardWS, viewIsOrthographic,
// clipPlanes (near, far), shadowBias, shadowNormalBias. Object: objectToWorld, worldToObject,
// lightmapDecode. Frame: time, screenSize (pixels, samples included), tile, tileClip (of the whole picture), fogColor,
// fogSettings (mode 0 none, 1 linear, 2 exponential, 3 its square; density; start; end). Lights: lightCount,
// lightPosition, lightColor, lightAxis, lightCone (in the order given, those that count at vertices behind the others;
// slots without a light have no shadow map), vertexLightCount, worldToShadow, shadowTile, shadowStrength, shadowTexel,
// worldToCookie (of cookie_light()), lightMask (1 in the channel of shadow masks that is the light's: lights that
// cast shadows have one each, in the scene's order), mainLight (slot of the light that subtractive lightmaps hold,
// or -1), shadowColor, shadowFade (scale and offset of ShadowFade). Ambient: ambientSH,
// probeCenter, probeBoxMin, probeBoxMax (of what is around: all 0), probeShare.
std::map<std::string, EngineValue> engine_values(const EngineScene& seen);

// What an object's place says: objectToWorld, worldToObject.
std::map<std::string, EngineValue> object_values(const glm::mat4& object_to_world);

// Of a single draw: all lights, the main one first, then the other directional ones; no shadow map.
std::map<std::string, EngineValue> engine_values(const Scene& scene);

// Of every value that there is.
std::vector<std::string> engine_value_names();

// The light whose cookie a draw binds: the first light that has one; null: none has.
const Light* cookie_light(std::span<const SeenLight> lights);

}  // namespace patina::runtime

// Converts a world and its compiled materials to a frame. It decides which pass of which material draws which object,
// in which order, with which lights and into which targets. It knows rendering paths only from the passes of the
// reflection, and contains no names of passes or paths. It reads no files: materials are compiled and textures loaded
// before.
//
// The order:
//   0. the background, if it is a picture
//   1. shadow maps: passes that draw from lights, over all objects that have such a pass
//   2. passes that materials add with a lower queue than their own, by queue
//   3. opaque objects of the requested path: pass by pass in the order of the reflection; in each, objects by queue,
//      then in scene order; full-screen passes and light volumes once for each lighting group (lighting_groups.h)
//   4. opaque objects of other paths: materials that the requested path does not support
//   5. the other passes that materials add, by queue
//   6. opaque objects that read what they draw into (scene colour or depth)
//   7. blended objects and passes (queue 2500 or more), by queue, then the farthest first; all passes of one, then the
//      next
// A full-screen pass whose pixels no stencil chooses is drawn once in a frame for each shader that it has.
//
//   Outcome<Frame> frame = plan_frame(world, materials, {.path = "deferred"});
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/frame/frame.h"
#include "runtime/outcome.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct DrawnPass {
    StagePair stages{};
    std::string_view fragment{};  // the fragment shader's text: equal ones light alike. Empty: SPIR-V or program tells
};

// A compiled material. It, and all that it points to, must outlive the frame.
struct DrawnMaterial {
    const Reflection* reflection = nullptr;
    std::map<std::string, DrawnPass> passes{};  // by name, each of the reflection
    MaterialValues values{};
    std::span<const LoadedTexture> textures{};  // its own, and the environment's where it reads them
};

struct FrameOptions {
    std::string path{};            // the wanted one: Reflection::path. Empty: materials of all paths are alike
    int shadow_atlas_size = 2048;  // texels along a side; even
    bool exact = false;            // every colour target in rgba32f
    std::optional<TargetFormat> shown_format = TargetFormat::Rgba32F;  // of "color"; nothing: as the passes say
    std::optional<std::size_t> background{};  // a material of the world whose passes are drawn behind everything
    // For each object of the world its textures of the engine ("lightmapTexture", "shadowMaskTexture"); may be
    // shorter. Missing ones are white, and an object without a lightmap has no baked light.
    std::span<const std::vector<LoadedTexture>> object_textures{};
    // For each object of the world the values of its instances; may be shorter. Those that are not there have the
    // material's.
    std::span<const std::vector<MaterialValues>> instance_values{};
};

// `materials`: one for each of the world, in its order. An error names the material and its pass.
Outcome<Frame> plan_frame(const World& world, std::span<const DrawnMaterial> materials,
                          const FrameOptions& options = {});

// The path for which a material must be compiled, so that this camera can draw it: its own path, or the fallback of a
// pass that needs another camera. Empty: there is none.
std::string path_for(const Camera& camera, const Reflection& reflection);

}  // namespace patina::runtime

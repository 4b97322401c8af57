// The whole way from a graph file to a picture, as one call: what `patina render` and snapshots use. The words in it
// are the user's own (scene_text.h, material_values.h); everything wrong with them comes back as text or diagnostics.
//
//   RenderMachine machine;                      // keeps the GPU between calls; opened when first needed
//   RenderOutcome outcome = render(compiler, {.graph = "rust.graph.json", .overrides = {{"_Roughness", "0.2"}}},
//   machine); if (outcome.ok) save_png("rust.png", outcome.image);
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/gpu/renderer.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct RenderRequest {
    std::string graph{};                             // a file: a material's graph, or a scene (x.scene.json)
    std::string preview{};                           // a port to look at: "mask", "rust.amount"; empty: the material
    std::string path = "forward";                    // a rendering path, or a file x.pass.hlsl
    std::vector<std::string> defines{};              // parts of the path: "shadows", "fog=false"
    std::string mesh = "sphere";                     // mesh_names()
    int size = 512;                                  // pixels, width
    int height = 0;                                  // 0: as the width
    int samples = 4;                                 // along each axis of a pixel: 4 averages 16
    std::map<std::string, std::string> overrides{};  // property -> "0.2", "1,0,0", "#ff8800", "true", "Wet", "rust.png"
    double time = 0;                                 // seconds
    std::vector<std::string> lights{};               // empty: the default three; {"none"}: none
    std::string ambient{};                           // empty: the default sky
    std::string camera{};                            // empty: frames the mesh
    std::string via = "glsl";                        // glsl | hlsl | cpu
    std::string device{};                            // part of a GPU's name; empty: the software renderer
    bool validation = false;                         // Khronos validation layer; its messages become errors
    bool exact_textures = false;                     // float texels on the GPU, to compare it with the CPU
    bool exact_targets = false;                      // colour targets in 32-bit floats, whatever the passes say
    std::vector<std::string> include_dirs{};
    std::function<void(double)> progress{};  // via cpu: told which share is done, 0 to 1
};

struct RenderOutcome {
    bool ok = false;
    Image image;                          // linear
    std::vector<Diagnostic> diagnostics;  // of the compiler and of glslang; warnings too
    std::string error;                    // what else went wrong: a word of the request, a file, the device
    std::size_t draws = 0;                // calls that drew the image, shadow maps among them
    bool missing_machine = false;         // `error` is about this machine: no Vulkan device, or one with too low limits
};

// The GPU that renders share. Reopened when a request asks for another device.
struct RenderMachine {
    std::unique_ptr<Renderer> renderer;
    DeviceOptions options;
};

// Opens the device that is wanted, unless it is open already. Empty: done; else what is wrong.
std::string open_machine(const std::string& device, bool validation, RenderMachine& machine);

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine);

struct TraceOutcome {
    bool ok = false;
    PixelTrace trace{};
    std::string pass{};  // the one that was run
    std::vector<Diagnostic> diagnostics{};
    std::string error{};  // as a RenderOutcome's
};

// What the pixel at `x`, `y` (inside the picture, from the top left) of that picture is made of, from the CPU
// reference.
TraceOutcome trace(const Compiler& compiler, RenderRequest request, int x, int y, Precision precision);

}  // namespace patina::runtime

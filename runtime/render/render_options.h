// The options and the results of a render and of a trace: shared by requests for one material and for a world.
//
//   RenderOptions options{.path = "deferred", .via = "cpu"};
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "patina/patina.h"
#include "runtime/cpu/cpu_trace.h"
#include "runtime/frame/tiles.h"
#include "runtime/picture/data_picture.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct RenderOptions {
    std::string path = "forward";  // a rendering path, or a file x.pass.hlsl
    // As CompileOptions::switches; a world asks for more of them by what it holds.
    std::vector<std::pair<std::string, std::string>> switches{};
    std::string lighting{};       // as CompileOptions::lighting, of all materials; empty: their own
    bool accept_parts = false;    // as CompileOptions::accept_parts
    std::string preview{};        // a port to look at, unlit: "mask", "rust.amount"; empty: the material
    std::string via = "glsl";     // glsl | hlsl | cpu
    std::string engine{};         // whose shaders are drawn; empty: the default one. It takes GLSL or HLSL for Vulkan
    std::string device{};         // part of a GPU's name; empty: the software renderer
    bool validation = false;      // Khronos validation layer; its messages become errors
    bool exact_textures = false;  // float texels on the GPU, to compare it with the CPU
    bool exact_targets = false;   // every colour target in 32-bit floats, for all passes
    std::vector<std::string> also_shown{};  // further targets of the path that the outcome has
    bool stated_formats = false;  // the picture too is drawn in the format that the passes state, not in 32-bit floats
    int shadow_atlas_size = 2048;
    // If render targets need more bytes, the picture is drawn in tiles (frame/tiles.h). If it cannot be drawn in tiles
    // and needs more than the second number, it is refused.
    std::size_t most_target_bytes = kMostTargetBytes, most_whole_bytes = kMostWholeBytes;
    int largest_viewport = 0;  // of a tile, in samples; 0: the device's limit says
    std::vector<std::string> include_dirs{};
    // Files that exist in memory alone, by their normal paths: graphs, scenes and pictures of an imported model. They
    // are found before those of the file system.
    std::shared_ptr<const MemoryFiles> files{};
    // Called with the share that is done, 0 to 1, and the file that is prefiltered, or nothing while the picture is
    // drawn (on the GPU: in tiles).
    std::function<void(double, std::string_view)> progress{};
};

// A shader that a picture was drawn with.
struct DrawnShader {
    std::string file_name{}, text{};
    std::size_t spirv_bytes = 0;  // of the instructions, without names; 0: the CPU ran it
};

struct RenderOutcome {
    bool ok = false;
    Image image;                              // linear
    double exposure = 0;                      // stops to show it with: the request's, or what suits it (exposure_for())
    std::vector<Image> also_shown{};          // as RenderOptions::also_shown; of a failure: none
    Reflection reflection{};                  // of the only material; of several: of the first
    DataSummary values{};                     // of the picture; of a preview: of what the object covers
    std::vector<Diagnostic> diagnostics;      // of the compiler and of glslang; warnings too
    std::string error;                        // what else went wrong: a word of the request, a file, the device
    std::vector<std::string> dependencies{};  // files that were read, or searched for and not found
    std::vector<DrawnShader> shaders{};       // each text once, in the order of the materials and their passes
    std::string device{}, driver{};           // what drew the picture
    std::size_t draws = 0;                    // steps that drew the image, shadow maps among them
    std::size_t tiles = 0;                    // how often they were drawn, each time for another part of the picture
    bool missing_machine = false;  // `error` is about this machine: no Vulkan device, or one with too low limits
};

// The values behind a pixel. Names are empty where a graph is traced alone.
struct TraceOutcome {
    bool ok = false;
    PixelTrace trace{};
    std::string pass{};  // the one that was run
    std::string object{}, material{}, graph{};
    std::size_t instances = 0;        // of the object; 0: it is drawn once
    std::vector<std::string> seen{};  // PixelTrace::seen by their names
    std::vector<Diagnostic> diagnostics{};
    std::string error{};  // as a RenderOutcome's
};

}  // namespace patina::runtime

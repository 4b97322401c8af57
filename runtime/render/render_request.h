// The room `render`: compiles materials, prepares them, plans the frame and has it drawn. It contains no formulas of
// lighting or drawing.
//
// Renders a graph file to a picture in one call, for `patina render` and snapshots. The request holds the user's own
// words (scene_text.h, material_values.h); all errors in them are returned as text or diagnostics.
//
//   RenderMachine machine;                      // keeps the GPU between calls; opened when first needed
//   RenderRequest request{.graph = "rust.graph.json", .overrides = {{"_Roughness", "0.2"}}, .options = {.via = "cpu"}};
//   RenderOutcome outcome = render(compiler, request, machine);
//   if (outcome.ok) save_png("rust.png", outcome.image);
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/picture/data_picture.h"
#include "runtime/render/render_machine.h"
#include "runtime/render/render_options.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct RenderRequest {
    std::string graph{};          // a file: a material's graph, or a scene (x.scene.json)
    std::string mesh = "sphere";  // mesh_named()
    int segments = 0;             // of the mesh (make_mesh()); 0: as usual
    int size = 512;               // pixels, width
    int height = 0;               // 0: as the width
    int samples = 4;              // along each axis of a pixel: 4 averages 16
    // Of a scene: the object that is traced, or that shows a preview; or the material whose objects show it. Empty:
    // what the pixel shows; all materials that have the node.
    std::string object{}, material{};
    std::map<std::string, std::string> overrides{};  // property -> "0.2", "1,0,0", "#ff8800", "true", "Wet", "rust.png"
    std::optional<double> time{};                    // seconds; nothing: the scene's own, or 0
    std::vector<std::string>
        lights{};               // empty: the default three, none if the environment is a picture; {"none"}: none
    std::string ambient{};      // empty: the default sky
    std::string environment{};  // "sunset.hdr", "sunset.hdr rotation=90 intensity=2", "studio"; empty: the studio
    std::string camera{};       // empty: frames the mesh
    std::string background{};   // "#203040", "0.2", "none" (transparent), "env", "blur"; empty: dark grey, but
                                // the environment where a picture of it is seen through a material
    // Stops with which the picture will be shown: a background colour has its value after them. Nothing: those that
    // suit it (RenderOutcome::exposure).
    std::optional<double> exposure{};
    std::optional<int> light{};  // of a preview: the only light that there is, by its number; nothing: all of them
    // Of a preview: its values in this range as colours (data_picture.h); nothing: the values as they are.
    std::optional<DataRange> range{};
    bool keeps_values = false;  // of a preview: values that are not finite stay, as an EXR file can hold them
    RenderOptions options{};
};

// One object of the request's material alone, seen as the request's words say. Fails if one of them is wrong.
Outcome<World> world_of_graph(const RenderRequest& request);

RenderOutcome render(const Compiler& compiler, const RenderRequest& request, RenderMachine& machine);

// What the pixel at `x`, `y` (inside the picture, from the top left) of that picture is made of, from the CPU
// reference. Of a scene: the front-most object there, or the one that the request names.
TraceOutcome trace(const Compiler& compiler, const RenderRequest& request, int x, int y, Precision precision);

}  // namespace patina::runtime

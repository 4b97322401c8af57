// A preview in a scene: finds the objects that show a node's value, and makes the world of this picture. In that world
// the other opaque objects only hide things behind them, with their cutouts and moved vertices. Blended ones are left
// out. It draws nothing.
//
//   ScenePreview preview = preview_world(compiler, world, {.port = "albedo", .object = "wall", .scene = path},
//   options); if (preview.ok) draw_world(compiler, preview.world, preview.options, machine);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/outcome.h"
#include "runtime/render/render_options.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct PreviewWish {
    std::string port{};      // as CompileOptions::Preview::port
    std::string object{};    // that shows it; empty: all objects of the material
    std::string material{};  // empty: all that have the port
    std::string scene{};     // the file, for messages
};

struct ScenePreview {
    bool ok = false;
    World world{};                         // transparent where the objects are not seen
    std::vector<std::string> materials{};  // that show it
    RenderOptions options{};
    // The node reads the picture behind its object, or shadows, which `world` lacks. The node reads the picture behind
    // its object, or shadows, which `world` lacks. `with_picture` has them, and every opaque object unchanged.
    bool reads_picture = false;
    World with_picture{};
    std::vector<Diagnostic> diagnostics{};
};

ScenePreview preview_world(const Compiler& compiler, const World& world, const PreviewWish& wish,
                           const RenderOptions& options);

// The object of this name, or an error that suggests others.
Outcome<std::size_t> find_object(const World& world, const std::string& name);
Diagnostic unknown_object(const World& world, const std::string& name, const std::string& scene);

}  // namespace patina::runtime

// Converts a scene file to a world that can be drawn: creates meshes, converts transforms to matrices, loads cookies of
// lights. It reports errors that the compiler cannot find (unknown meshes, unreadable pictures) at their location in
// the file. It does not compile the materials.
//
//   WorldFile file = read_world(compiler, "shelf.scene.json", {});
//   if (file.ok) draw(file.world);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/lighting/environment_file.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct WorldFile {
    bool ok = false;
    World world{};
    std::vector<Diagnostic> diagnostics{};
    std::vector<std::string> dependencies{};  // read, or not found; pictures of objects and materials are not yet
};

WorldFile read_world(const Compiler& compiler, const std::string& path, const CompileOptions& options,
                     const EnvironmentProgress& progress = {});
// Of a scene that was read without errors.
WorldFile make_world(const SceneFile& scene, const EnvironmentProgress& progress = {});

}  // namespace patina::runtime

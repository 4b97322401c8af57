// A scene file -> a world that can be drawn: meshes are made, transforms become matrices, pictures of lights are
// loaded. What the compiler could not know (which meshes there are, whether a picture can be read) is found out here
// and said at its place in the file. Compiling the materials is not its work.
//
//   WorldFile file = read_world(compiler, "shelf.scene.json", {});
//   if (file.ok) draw(file.world);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct WorldFile {
    bool ok = false;
    World world{};
    std::vector<Diagnostic> diagnostics{};
    std::vector<std::string> dependencies{};  // files that were read; pictures of objects and materials are not yet
};

WorldFile read_world(const Compiler& compiler, const std::string& path, const CompileOptions& options);
// Of a scene that was read without errors.
WorldFile make_world(const SceneFile& scene);

}  // namespace patina::runtime

// Meshes by the names that users write: a built-in one, or a glTF file with a node or without.
//
//   Outcome<Mesh> mesh = mesh_named("sphere");
//   Outcome<Mesh> seat = mesh_named("chair.glb#Seat");
#pragma once

#include <string>

#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

// Fails if there is neither a mesh nor a file of that name, if the file is broken, and if a file's mesh is to be
// divided into segments. `segments`: 0 for the usual number (make_mesh()).
Outcome<Mesh> mesh_named(const std::string& name, int segments = 0);

// A camera that frames the mesh. Built-in meshes are framed as by default_camera(); others a little from above and from
// the right, around the middle of their bounds.
Camera camera_for(const std::string& name, const Mesh& mesh);

}  // namespace patina::runtime

// Gives passes that draw the mesh alike one vertex stage, so that the file holds one vertex function and one struct of
// interpolated values for them.
#pragma once

#include <vector>

#include "compiler/link/link_pass.h"

namespace patina::writers::shaderlab {

// A pass gets the vertex stage of another one if that computes everything that the pass reads, and at most one vector
// that it does not read.
void share_vertex_stages(std::vector<link::LinkedPass>& passes);

}  // namespace patina::writers::shaderlab

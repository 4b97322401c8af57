// Nodes of noise.
#pragma once

#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {

bool is_noise(std::string_view category);  // noise2d, fractal3d, worleynoise2d, ...
Term make_noise(GraphMaker& maker, Scope& scope, const Element& node);

}  // namespace patina::importers::mtlx

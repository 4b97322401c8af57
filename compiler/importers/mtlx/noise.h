// Nodes of noise.
#pragma once

#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {

Term make_noise(GraphMaker& maker, Scope& scope, const Element& node);  // noise2d, fractal3d, worleynoise2d, ...

}  // namespace patina::importers::mtlx

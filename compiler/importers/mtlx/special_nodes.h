// What nodes with functions of their own share with the surface.
#pragma once

#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {

// The coordinates of a tiled picture, in its order of operations.
Term tiled_coordinates(GraphMaker& maker, Scope& scope, const Element& node);
// If an input reads a picture that nothing else reads: its texture as a normal map, "$_Wood" and where it is sampled.
std::optional<Term> normal_map_of(GraphMaker& maker, Scope& scope, const Element& node, std::string_view input);

}  // namespace patina::importers::mtlx

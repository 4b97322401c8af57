// What values are: a colour, data, the texel of a normal map, a direction or a position in a space. Names say it
// (normalTS, positionWS), and so do the attributes [is("normalTS")] of nodes. Warns where a port gets another thing
// than it wants, because the types are the same and nothing else would say so.
//
//   check_meanings(session, material);
#pragma once

#include "compiler/resolve/material.h"

namespace patina::resolve {

// Carries the meanings of values through the material's nodes, as far as they are plain. Warns of
// - a texel where a direction is wanted, a direction where a position is wanted, and another space than the wanted one;
// - a sum or a difference of vectors in two spaces;
// - a normal map that is decoded as a colour;
// - a texture that is decoded as a colour although all that reads it wants data, unless its "usage" is stated.
void check_meanings(Session& session, const Material& material);

}  // namespace patina::resolve

// The effect of a change of a graph on its shaders, as lines of text: which files differ and where, and the cost of the
// passes.
//
//   for (const std::string& line : changes_of(before, after)) say(console, line);
//
//   out/rust.forward.frag.glsl  +1 -1, 212 -> 215 instructions
//      41  -    float rough = 0.5;
//      41  +    float rough = 0.25 * mask;
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/compile/compiled.h"

namespace patina::cli {

// Empty if the files are the same. `shown`: the target whose lines are shown; others say the same in other words.
std::vector<std::string> changes_of(const Compiled& before, const Compiled& after, const Target& shown);

}  // namespace patina::cli

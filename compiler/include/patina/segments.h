// How finely a built-in mesh may be divided: one limit for scenes, snapshots and the command line.
#pragma once

namespace patina {

inline constexpr int kLeastSegments = 3;
inline constexpr int kMostSegments = 512;

}  // namespace patina

// How finely a built-in mesh may be divided: one limit for scenes, snapshots and the command line.
#pragma once

namespace patina {

inline constexpr int kLeastSegments = 3;   // the lowest number of segments
inline constexpr int kMostSegments = 512;  // the highest number of segments

}  // namespace patina

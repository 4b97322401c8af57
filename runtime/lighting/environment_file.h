// Environments from pictures, for `--env`, scenes and `patina env`.
//
// Prefiltering a picture takes some seconds. So its result is cached below $XDG_CACHE_HOME/patina (or ~/.cache/patina),
// under a name that is made from the picture's bytes and the rotation. A file there may be removed at any time. Without
// a folder that can be written, nothing is kept.
//
//   Outcome<std::shared_ptr<const Environment>> sunset = load_environment({.path = "sunset.hdr", .rotation = 90});
//   if (sunset) scene.environment = sunset.value;
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/lighting/environment.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct EnvironmentChoice {
    std::string path{};   // a picture (panorama.h), of 8 bits in sRGB, or linear with more
    double rotation = 0;  // degrees about y, counter-clockwise seen from above
    double intensity = 1;
};

// Given the share that is done and what is done, from the second second on.
using EnvironmentProgress = std::function<void(double, std::string_view)>;

// An error names the file. The map is prefiltered, or read, when it is first asked for.
Outcome<std::shared_ptr<const Environment>> load_environment(const EnvironmentChoice& choice,
                                                             EnvironmentProgress progress = {});

}  // namespace patina::runtime

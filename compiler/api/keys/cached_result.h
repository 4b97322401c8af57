// If a request comes again, and the files are unchanged, it gets the cached result.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/resolve/files.h"
#include "patina/patina.h"

namespace patina {

// A result, and all that the file system was asked for it.
struct CachedResult {
    static constexpr std::size_t kMostBytes = std::size_t{32} << 20;  // of all that a compiler keeps

    Result result;
    std::map<std::string, resolve::Files::Answer> answers;
    std::vector<resolve::Files::Resolved> resolved;
};

}  // namespace patina

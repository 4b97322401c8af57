// Tells two builds of the compiler apart that have the same version.
#pragma once

#include <string_view>

namespace patina {

// The hash of the compiler's own sources; scripts/hash_sources.cmake makes it.
std::string_view source_hash();

}  // namespace patina

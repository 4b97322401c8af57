// Recognises files of other formats that are passed as graphs, and says what to do with them. Private to json.cpp.
//
//   rust.shader     ->  'rust.shader' must be a graph or a scene, which are JSON, not a shader
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/base/diagnostics.h"

namespace patina::json {

// By the ending of its name: false if the file may be JSON, else an error.
bool report_other_file(std::string_view file, std::uint32_t base, Diagnostics& diagnostics);

// A note on a file that is no text, by its first bytes; empty: they are unknown.
std::string_view binary_kind(std::string_view bytes);

}  // namespace patina::json

// Reads nodes/engines/NAME/engine.json into an Engine.
#pragma once

#include <functional>

#include "compiler/base/diagnostics.h"
#include "compiler/engines/engine.h"

namespace patina::engines {

// Finds a file of the engine's folder among the sources, such as "unity.pass.hlsl"; nothing if there is none.
using FindFile = std::function<std::optional<std::uint32_t>(std::string_view name)>;

// `base`: the start of engine.json in the sources. `folder`: the engine's name. Reports errors in the file, and returns
// what could be read.
Engine read_engine(const SourceMap& sources, std::uint32_t base, std::string folder, const FindFile& find_file,
                   const Printable& printable, Diagnostics& diagnostics);

}  // namespace patina::engines

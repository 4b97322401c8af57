// nodes/engines/NAME/engine.json -> Engine.
#pragma once

#include <functional>

#include "compiler/base/diagnostics.h"
#include "compiler/engines/engine.h"

namespace patina::engines {

// A file of the engine's folder, among the sources: the place of "unity.pass.hlsl", or nothing if there is none.
using FindFile = std::function<std::optional<std::uint32_t>(std::string_view name)>;

// `base`: of engine.json in the sources. `folder`: the engine's name. Reports what is wrong with the file; what could
// be read is returned.
Engine read_engine(const SourceMap& sources, std::uint32_t base, std::string folder, const FindFile& find_file,
                   Diagnostics& diagnostics);

}  // namespace patina::engines

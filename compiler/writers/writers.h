// Lists the writers, which turn finished stages into files.
#pragma once

#include "compiler/engines/engine.h"
#include "compiler/output/writer.h"

namespace patina::engines {

// The writer that the options and the engine require.
const output::Writer& writer_of(const resolve::Session& session);

// All languages and formats.
Printable printable();

}  // namespace patina::engines

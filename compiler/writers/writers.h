// The room `writers` lists the writers, which turn finished stages into files, and chooses one. A writer of files that
// hold all passes is a folder of its own, writers/FORMAT/; engine.json names the format. Only these folders know an
// engine by name. A writer changes no value that a shader computes.
#pragma once

#include "compiler/engines/engine.h"
#include "compiler/output/writer.h"

namespace patina::writers {

// The writer that the options and the engine require.
const output::Writer& writer_of(const resolve::Session& session);

// All languages and formats.
engines::Printable printable();

}  // namespace patina::writers

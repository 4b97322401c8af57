// The list of writers: how finished stages become files.
#pragma once

#include "compiler/output/writer.h"

namespace patina::engines {

// The writer for what the options and the engine ask for.
const output::Writer& writer_of(const graph::Session& session);

}  // namespace patina::engines

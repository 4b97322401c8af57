// What the library has, as JSON: for programs in C, and for what `patina nodes --json` and its like print. Every field
// is written, unless it is empty.
#pragma once

#include "compiler/json/json_writer.h"
#include "patina/patina.h"

namespace patina {

// `example`: the node as a graph has it, if that is wanted.
void write_json(JsonWriter& json, const NodeInfo& node, const std::string& example = {});
void write_json(JsonWriter& json, const PathInfo& path);
void write_json(JsonWriter& json, const EngineInfo& engine);

}  // namespace patina

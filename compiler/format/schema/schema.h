// The room `format/schema` writes the JSON Schema of the format. It reads nothing.
//
// Makes the JSON Schema (draft 2020-12) of the graph format, with which an editor completes and explains keys, nodes,
// ports and words. It is made from the tables that the reader uses and from the content of the library. It knows no
// links and no types, which only compiling checks.
//
//   std::string text = make_schema({.nodes = compiler.nodes(), .semantics = compiler.semantics(), ...});
#pragma once

#include <span>
#include <string>

#include "patina/patina.h"

namespace patina::format {

struct SchemaInput {
    std::span<const NodeInfo> nodes;
    std::span<const SemanticInfo> semantics;
    std::span<const ModelInfo> workflows;
    std::span<const ModelInfo> lighting_models;
};

std::string make_schema(const SchemaInput& input);

}  // namespace patina::format

// Builds JSON text from parts: enough to write a schema in reading order. Private to schema.cpp and schema_library.cpp.
//
//   object({{"type", quoted("string")}, {"minLength", "1"}})   ->   {"type":"string","minLength":"1"}
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compiler/format/schema/schema.h"
#include "compiler/json/json_text.h"

namespace patina::format {

using Members = std::vector<std::pair<std::string, std::string>>;  // key, JSON text

inline std::string quoted(std::string_view text) {
    std::string out;
    json::append_quoted(out, text);
    return out;
}

inline std::string list(const std::vector<std::string>& items) {
    std::string out = "[";
    for (const std::string& item : items) out += (out.size() > 1 ? "," : "") + item;
    return out + "]";
}

inline std::string object(const Members& members) {
    std::string out = "{";
    for (const auto& [key, value] : members) {
        if (out.size() > 1) out += ',';
        json::append_quoted(out, key);
        out += ':' + value;
    }
    return out + "}";
}

inline std::string reference(std::string_view definition) {
    return object({{"$ref", quoted("#/$defs/" + std::string(definition))}});
}

// A word with its description.
inline std::string described_word(std::string_view word, std::string_view description) {
    Members members = {{"const", quoted(word)}};
    if (!description.empty()) members.emplace_back("description", quoted(description));
    return object(members);
}

// --- schema_library.cpp: the parts that depend on the library
std::string value_schema(std::span<const SemanticInfo> semantics);
// The name of a node, with its description; or a file.
std::string node_name_schema(std::span<const NodeInfo> nodes);
// An if and a then for each node, with the ports that its "in" may hold.
std::string node_ports_schema(std::span<const NodeInfo> nodes);
// The "$defs" of these ports: "ports.Lerp": { ... }.
void add_port_definitions(Members& definitions, std::span<const NodeInfo> nodes);
std::string model_name_schema(std::span<const ModelInfo> models);
// An if and a then for each workflow, with its surface inputs.
std::string surface_schema(std::span<const ModelInfo> workflows, std::span<const ModelInfo> models);

}  // namespace patina::format

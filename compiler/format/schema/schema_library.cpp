#include "compiler/base/text.h"
#include "compiler/format/schema/schema_parts.h"

namespace patina::format {
namespace {

constexpr std::string_view kProperty = "^\\$[A-Za-z_][A-Za-z0-9_]*$";
constexpr std::string_view kFilePattern = "^(\\.\\.?)?/";

// If `key` is `word`, the object must also be `schema`.
std::string when(std::string_view key, std::string_view word, const std::string& schema) {
    const std::string condition =
        object({{"properties", object({{std::string(key), object({{"const", quoted(word)}})}})},
                {"required", list({quoted(key)})}});
    return object({{"if", condition}, {"then", schema}});
}

std::string pattern(std::string_view expression, std::string_view description) {
    return object({{"type", quoted("string")}, {"pattern", quoted(expression)}, {"description", quoted(description)}});
}

// "cosine of normal and half vector (float, 0 to 1, default 0.5)"
std::string describe_port(const PortInfo& port) {
    std::string facts = port.type;
    if (port.range) facts += ", " + shortest((*port.range)[0]) + " to " + shortest((*port.range)[1]);
    if (!port.unit.empty()) facts += " " + port.unit;
    if (!port.default_value.empty()) facts += ", default " + port.default_value;
    return port.doc.empty() ? facts : port.doc + " (" + facts + ")";
}

std::string port_schema(const PortInfo& port) {
    if (port.enumerators.empty()) {
        return object({{"$ref", quoted("#/$defs/value")}, {"description", quoted(describe_port(port))}});
    }
    std::vector<std::string> words;
    for (const EnumeratorInfo& enumerator : port.enumerators) words.push_back(quoted(enumerator.name));
    return object(
        {{"anyOf", list({object({{"enum", list(words)}}), pattern(kProperty, "a property with these values")})},
         {"description", quoted(describe_port(port))}});
}

// The first paragraph says what a node is for. An editor's box has no room for more.
std::string_view first_paragraph(std::string_view doc) {
    return doc.substr(0, doc.find("\n\n"));
}

}  // namespace

std::string value_schema(std::span<const SemanticInfo> semantics) {
    std::vector<std::string> names;
    for (const SemanticInfo& semantic : semantics) {
        std::string description = semantic.type;
        if (!semantic.doc.empty()) description += ": " + semantic.doc;
        names.push_back(described_word("@" + semantic.name, description));
    }
    const std::string number_list = object({{"type", quoted("array")},
                                            {"items", object({{"type", quoted("number")}})},
                                            {"minItems", "2"},
                                            {"maxItems", "4"},
                                            {"description", quoted("a vector; as a colour, linear")}});
    std::vector<std::string> forms = {
        object({{"type", quoted("number")}}),
        object({{"type", quoted("boolean")}}),
        number_list,
        object({{"type", quoted("array")},
                {"items", number_list},
                {"minItems", "2"},
                {"maxItems", "4"},
                {"description", quoted("a matrix: its rows")}}),
        reference("gradient"),
        reference("curve"),
        pattern("^=", "an expression over nodes, $properties and @semantics"),
        pattern("^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$", "an sRGB colour"),
        pattern("^[A-Za-z_][A-Za-z0-9_]*(\\.[A-Za-z_][A-Za-z0-9_]*)*$", "a link: node.port.swizzle, or an enumerator"),
        pattern("^\\$[A-Za-z_][A-Za-z0-9_]*(\\.[A-Za-z_][A-Za-z0-9_]*)*$", "a property"),
        pattern("^@[A-Za-z_][A-Za-z0-9_]*(\\.[A-Za-z_][A-Za-z0-9_]*)*$",
                "a semantic: a value of mesh, camera or light"),
        pattern(kFilePattern, "a texture file, relative to the graph"),
    };
    forms.insert(forms.end(), names.begin(), names.end());
    return object({{"anyOf", list(forms)}});
}

std::string node_name_schema(std::span<const NodeInfo> nodes) {
    std::vector<std::string> forms;
    for (const NodeInfo& node : nodes) {
        std::string description(first_paragraph(node.doc));
        if (!node.category.empty()) description = node.category + ": " + description;
        forms.push_back(described_word(node.name, description));
    }
    forms.push_back(pattern(kFilePattern, "a sub-graph or a node file of your own"));
    return object({{"anyOf", list(forms)}});
}

std::string node_ports_schema(std::span<const NodeInfo> nodes) {
    std::vector<std::string> cases;
    for (const NodeInfo& node : nodes) {
        const std::string in = object({{"in", reference("ports." + node.name)}});
        cases.push_back(when("node", node.name, object({{"properties", in}})));
    }
    return list(cases);
}

void add_port_definitions(Members& definitions, std::span<const NodeInfo> nodes) {
    for (const NodeInfo& node : nodes) {
        Members ports;
        for (const PortInfo& port : node.ports) {
            if (!port.is_output) ports.emplace_back(port.name, port_schema(port));
        }
        definitions.emplace_back(
            "ports." + node.name,
            object({{"type", quoted("object")}, {"properties", object(ports)}, {"additionalProperties", "false"}}));
    }
}

std::string model_name_schema(std::span<const ModelInfo> models) {
    if (models.empty()) return R"({"type":"string"})";
    std::vector<std::string> names;
    for (const ModelInfo& model : models) names.push_back(described_word(model.name, first_paragraph(model.doc)));
    return object({{"anyOf", list(names)}});
}

std::string surface_schema(std::span<const ModelInfo> workflows, std::span<const ModelInfo> models) {
    // A lighting graph in the material's own file may declare inputs; only those of the library are known here.
    constexpr std::string_view kOfLibrary =
        R"({"anyOf":[{"not":{"required":["lighting"]}},{"properties":{"lighting":{"type":"string","pattern":"^[^./]"}}}]})";
    std::vector<std::string> of_models;
    for (const ModelInfo& model : models) {
        for (const ModelInputInfo& input : model.inputs) of_models.push_back(quoted(input.name));
    }
    std::vector<std::string> cases;
    for (const ModelInfo& workflow : workflows) {
        Members inputs;
        for (const ModelInputInfo& input : workflow.inputs) {
            std::string description = input.type;
            if (!input.doc.empty()) description += ": " + input.doc;
            if (!input.default_value.empty()) description += " (default " + input.default_value + ")";
            inputs.emplace_back(input.name,
                                object({{"$ref", quoted("#/$defs/value")}, {"description", quoted(description)}}));
        }
        std::vector<std::string> names = of_models;
        for (const auto& [name, schema] : inputs) names.push_back(quoted(name));
        const std::string known = object({{"surface", object({{"propertyNames", object({{"enum", list(names)}})}})}});
        const std::string surface = object({{"surface", object({{"properties", object(inputs)}})}});
        cases.push_back(when("workflow", workflow.name,
                             object({{"properties", surface},
                                     {"if", std::string(kOfLibrary)},
                                     {"then", object({{"properties", known}})}})));
    }
    return list(cases);
}

}  // namespace patina::format

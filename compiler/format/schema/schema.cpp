#include "compiler/format/schema/schema.h"

#include <cassert>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/format/canonical_form.h"
#include "compiler/format/keys.h"
#include "compiler/format/schema/schema_parts.h"

namespace patina::format {
namespace {

constexpr std::string_view kIdentifier = R"({"type":"string","pattern":"^[A-Za-z_][A-Za-z0-9_]*$"})";
constexpr std::string_view kColorSchema =
    R"({"anyOf":[{"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"},{"type":"number","minimum":0},)"
    R"({"type":"array","items":{"type":"number","minimum":0},"minItems":3,"maxItems":3}]})";
constexpr std::string_view kColorWithAlpha =
    R"({"anyOf":[{"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})$"},)"
    R"({"type":"number","minimum":0},)"
    R"({"type":"array","items":{"type":"number","minimum":0},"minItems":3,"maxItems":4}]})";

std::string any_of(const std::vector<std::string>& schemas) {
    return object({{"anyOf", list(schemas)}});
}

std::string number_schema(std::string_view type, const Form& form) {
    Members members = {{"type", quoted(type)}};
    if (std::isfinite(form.low)) members.emplace_back("minimum", shortest(form.low));
    if (std::isfinite(form.high)) members.emplace_back("maximum", shortest(form.high));
    return object(members);
}

std::string library_schema(std::string_view what, const SchemaInput& input) {
    if (what == "node") return node_name_schema(input.nodes);
    if (what == "workflow") return model_name_schema(input.workflows);
    return any_of({model_name_schema(input.lighting_models), R"({"type":"string","pattern":"^(\\.\\.?)?/"})"});
}

std::string form_schema(const Form& form, const SchemaInput& input) {
    const std::string count = std::to_string(form.count);
    switch (form.of) {
        case Form::Of::Anything: return "{}";
        case Form::Of::Text: return R"({"type":"string"})";
        case Form::Of::Pattern: return object({{"type", quoted("string")}, {"pattern", quoted(form.text)}});
        case Form::Of::Words: {
            std::vector<std::string> texts;
            for (const std::string_view word : form.words) texts.push_back(quoted(word));
            return object({{"enum", list(texts)}});
        }
        case Form::Of::Identifier: return std::string(kIdentifier);
        case Form::Of::Boolean: return R"({"type":"boolean"})";
        case Form::Of::Integer: return number_schema("integer", form);
        case Form::Of::Number: return number_schema("number", form);
        case Form::Of::Numbers:
            return object({{"type", quoted("array")},
                           {"items", number_schema("number", form)},
                           {"minItems", count},
                           {"maxItems", count}});
        case Form::Of::Color: return std::string(kColorSchema);
        case Form::Of::ColorWithAlpha: return std::string(kColorWithAlpha);
        case Form::Of::Object: return reference(definition_of(form.kind));
        case Form::Of::Objects: {
            Members members = {{"type", quoted("array")}};
            if (form.count > 0) members.emplace_back("maxItems", count);
            members.emplace_back("items", reference(definition_of(form.kind)));
            return object(members);
        }
        case Form::Of::Definition: return reference(form.text);
        case Form::Of::Library: return library_schema(form.text, input);
        case Form::Of::Schema: return std::string(form.text);
    }
    return {};
}

std::string forms_schema(const Forms& forms, const SchemaInput& input) {
    std::vector<std::string> schemas;
    for (const Form& form : std::span(forms.all).first(forms.count)) schemas.push_back(form_schema(form, input));
    return schemas.empty() ? "{}" : schemas.size() == 1 ? schemas.front() : any_of(schemas);
}

// Adds the key's help to its schema, for editors to show.
std::string with_description(const std::string& schema, std::string_view help) {
    const std::string description = "\"description\":" + quoted(help);
    return schema == "{}" ? "{" + description + "}" : schema.substr(0, schema.size() - 1) + "," + description + "}";
}

Members object_schema(ObjectKind kind, const SchemaInput& input) {
    Members properties;
    std::vector<std::string> required;
    for (const KeyInfo& key : keys_of(kind)) {
        properties.emplace_back(key.name, with_description(forms_schema(key.value, input), key.help));
        if (key.required) required.push_back(quoted(key.name));
    }
    Members schema = {
        {"type", quoted("object")}, {"properties", object(properties)}, {"additionalProperties", "false"}};
    if (!required.empty()) schema.emplace_back("required", list(required));
    return schema;
}

// The "kind" of a file decides its schema; a file without one is a material.
std::string choose_by_kind() {
    std::string choice = reference("material");
    using enum ObjectKind;
    for (const ObjectKind kind : {Scene, Workflow, Lighting, Subgraph}) {
        const std::string word(definition_of(kind));
        const std::string condition = object(
            {{"properties", object({{"kind", object({{"const", quoted(word)}})}})}, {"required", R"(["kind"])"}});
        choice = object({{"if", condition}, {"then", reference(word)}, {"else", choice}});
    }
    return choice;
}

Members make_definitions(const SchemaInput& input) {
    Members definitions = {{"identifier", std::string(kIdentifier)}, {"value", value_schema(input.semantics)}};
    for (int i = 0; i <= static_cast<int>(ObjectKind::OptionsLimits); ++i) {
        const auto kind = static_cast<ObjectKind>(i);
        if (definition_of(kind).empty()) continue;
        Members schema = object_schema(kind, input);
        if (kind == ObjectKind::Material && !input.workflows.empty())
            schema.emplace_back("allOf", surface_schema(input.workflows, input.lighting_models));
        if (kind == ObjectKind::Node) {
            schema.emplace_back("oneOf", R"([{"required":["node"]},{"required":["expr"],"not":{"required":["in"]}}])");
            if (!input.nodes.empty()) schema.emplace_back("allOf", node_ports_schema(input.nodes));
        }
        definitions.emplace_back(definition_of(kind), object(schema));
    }
    add_port_definitions(definitions, input.nodes);
    return definitions;
}

}  // namespace

std::string make_schema(const SchemaInput& input) {
    const std::string text = object({{"$schema", quoted("https://json-schema.org/draft/2020-12/schema")},
                                     {"title", quoted("Patina graph, version 1")},
                                     {"type", quoted("object")},
                                     {"required", R"(["patina"])"},
                                     {"allOf", list({choose_by_kind()})},
                                     {"$defs", object(make_definitions(input))}});
    // The schema has no white space yet; lay it out as `fmt` does.
    SourceMap sources;
    Diagnostics diagnostics;
    const std::unique_ptr<json::Json> json = json::parse_json(sources, sources.add("schema", text), diagnostics);
    assert(json);
    return layout_json(*json, sources);
}

}  // namespace patina::format

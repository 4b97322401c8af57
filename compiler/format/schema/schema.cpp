#include "compiler/format/schema/schema.h"

#include <fmt/format.h>

#include <cassert>

#include "compiler/format/canonical_form.h"
#include "compiler/format/keys.h"
#include "compiler/format/schema/schema_parts.h"

namespace patina::graph {
namespace {

constexpr std::string_view kAnything = "{}";
constexpr std::string_view kText = R"({"type":"string"})";
constexpr std::string_view kBoolean = R"({"type":"boolean"})";
constexpr std::string_view kIdentifier = R"({"type":"string","pattern":"^[A-Za-z_][A-Za-z0-9_]*$"})";
constexpr std::string_view kIdentifiers =
    R"({"type":"array","minItems":1,"uniqueItems":true,"items":{"$ref":"#/$defs/identifier"}})";
constexpr std::string_view kValues = R"({"type":"object","additionalProperties":{"$ref":"#/$defs/value"}})";
constexpr std::string_view kNamedValues = R"({"type":"object","propertyNames":{"$ref":"#/$defs/identifier"},)"
                                          R"("additionalProperties":{"$ref":"#/$defs/value"}})";
constexpr std::string_view kRange = R"({"type":"array","items":{"type":"number"},"minItems":2,"maxItems":2})";
constexpr std::string_view kByte = R"({"type":"integer","minimum":0,"maximum":255})";
constexpr std::string_view kBox =
    R"({"type":"array","items":{"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3},)"
    R"("minItems":2,"maxItems":2})";

constexpr std::string_view kColor = R"({"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"})";
constexpr std::string_view kLinearColor = R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3})";

// Keys [time, value].
std::string key_list_schema(int most, std::string_view value) {
    constexpr std::string_view kTime = R"({"type":"number","minimum":0,"maximum":1})";
    const std::string key = object({{"type", quoted("array")},
                                    {"prefixItems", fmt::format("[{},{}]", kTime, value)},
                                    {"minItems", "2"},
                                    {"maxItems", "2"}});
    return object({{"type", quoted("array")}, {"items", key}, {"minItems", "1"}, {"maxItems", std::to_string(most)}});
}

template <std::size_t N>
std::string texts_schema(const std::array<std::string_view, N>& words) {
    std::vector<std::string> texts;
    for (const std::string_view word : words) texts.push_back(quoted(word));
    return object({{"enum", list(texts)}});
}

std::vector<SchemaRow> make_rows(const SchemaInput& input) {
    using enum ObjectKind;
    const std::string model =
        any_of({model_name_schema(input.lighting_models), R"({"type":"string","pattern":"^(\\.\\.?)?/"})"});
    const auto text = [](std::string_view schema) { return std::string(schema); };
    std::vector<SchemaRow> rows = scene_rows();
    const std::vector<SchemaRow> graph_rows = {
        {Free, "$schema", text(kText)},
        {Free, "patina", R"({"const":1})"},
        {Free, "kind", words_schema<ObjectKind>()},
        {Property, "name", text(kIdentifier)},
        {Input, "name", text(kIdentifier)},
        {Free, "name", text(kText)},
        {Free, "help", text(kText)},
        {Free, "label", text(kText)},
        {Free, "group", text(kText)},
        {Free, "note", text(kText)},
        {Free, "precision", words_schema<Precision>()},
        {Free, "properties", list_of("property")},
        {Free, "nodes", list_of("node")},
        {Free, "inputs", list_of("input")},
        {Free, "meta", text(kAnything)},
        {Free, "ui", text(kAnything)},
        {Free, "workflow", model_name_schema(input.workflows)},
        {Free, "lighting", any_of({model, reference("lightingUse"), reference("lighting")})},
        {Free, "vertex", text(kValues)},
        {Lighting, "surface", list_of("input")},
        {Render, "surface", words_schema<SurfaceKind>()},
        {Free, "surface", text(kValues)},
        {Free, "render", reference("render")},
        {Free, "passes", list_of("pass")},
        {ExtraPass, "name", text(kIdentifier)},
        {Free, "variants",
         R"({"type":"array","items":{"type":"object","additionalProperties":{"anyOf":[{"type":"boolean"},{"type":"string"}]}}})"},
        {Free, "budget", reference("budget")},
        {Free, "maxInstructions", R"({"type":"integer","minimum":0})"},
        {Free, "maxTextures", R"({"type":"integer","minimum":0})"},
        {Free, "outputs", text(kNamedValues)},
        {Free, "direct", reference("value")},
        {Free, "indirect", reference("value")},
        {Free, "final", reference("value")},
        {Free, "preview", text(kIdentifier)},
        {Input, "type", texts_schema(kInputTypes)},
        {Property, "type", words_schema<PropertyType>()},
        {Free, "usage", words_schema<TextureUsage>()},
        {Free, "handedness", words_schema<Handedness>()},
        {Free, "swizzle", R"({"type":"string","pattern":"^[rgba01]{1,4}$"})"},
        {Free, "values", text(kIdentifiers)},
        {Property, "default",
         any_of({texts_schema(kDefaultTextures), texts_schema(sampler_names()), reference("value")})},
        {Free, "default", reference("value")},
        {Free, "range", text(kRange)},
        {Free, "hard", text(kBoolean)},
        {Input, "as", R"({"type":"string","pattern":"^="})"},
        {Free, "as", words_schema<Binding>()},
        {Free, "gives", text(kIdentifier)},
        {Free, "tiling", text(kBoolean)},
        {Free, "grid",
         R"json({"type": "array", "items": {"type": "integer", "minimum": 1, "maximum": 256}, "minItems": 2, "maxItems": 2})json"},
        {Free, "sampler", any_of({texts_schema(sampler_names()), reference("sampler")})},
        {Free, "colors", key_list_schema(8, any_of({text(kColor), text(kLinearColor)}))},
        {Free, "alphas", key_list_schema(8, R"({"type":"number","minimum":0,"maximum":1})")},
        {Free, "blend", words_schema<GradientBlend>()},
        {Free, "keys",
         R"({"type":"array","minItems":1,"maxItems":16,"items":{"type":"array","items":{"type":"number"},"minItems":2,"maxItems":4}})"},
        {Free, "id", text(kIdentifier)},
        {Free, "node", node_name_schema(input.nodes)},
        {Free, "in", text(kValues)},
        {Free, "expr", R"({"type":"string","pattern":"^[^=]"})"},
        {Free, "stage", words_schema<NodeStage>()},
        {Free, "wrap", words_schema<Wrap>()},
        {Free, "filter", words_schema<Filter>()},
        {Free, "anisotropy", R"({"type":"integer","minimum":1,"maximum":16})"},
        {Free, "cull", words_schema<Cull>()},
        {Free, "depthWrite", text(kBoolean)},
        {Free, "depthTest", words_schema<Compare>()},
        {Free, "depthOffset", text(kRange)},
        {Free, "stencil", reference("stencil")},
        {Free, "reference", text(kByte)},
        {Free, "readMask", text(kByte)},
        {Free, "writeMask", text(kByte)},
        {Free, "test", words_schema<Compare>()},
        {Free, "pass", words_schema<StencilOp>()},
        {Free, "fail", words_schema<StencilOp>()},
        {Free, "depthFail", words_schema<StencilOp>()},
        {Free, "queue", R"({"type":"integer","minimum":0,"maximum":5000})"},
        {Free, "bounds", any_of({R"({"type":"number","minimum":0})", text(kBox)})},
        {Free, "materialOverride", text(kBoolean)},
        {Free, "use", model},
    };
    rows.insert(rows.end(), graph_rows.begin(), graph_rows.end());
    return rows;
}

const std::string& find_schema(const std::vector<SchemaRow>& rows, ObjectKind kind, std::string_view key) {
    const SchemaRow* general = nullptr;
    for (const SchemaRow& row : rows) {
        if (row.key != key) continue;
        if (row.kind == kind) return row.schema;
        if (row.kind == ObjectKind::Free) general = &row;
    }
    assert(general && "a key of the format without a schema");
    return general->schema;
}

// Adds the key's help to its schema, for editors to show.
std::string with_description(const std::string& schema, std::string_view help) {
    const std::string description = "\"description\":" + quoted(help);
    return schema == kAnything ? "{" + description + "}"
                               : schema.substr(0, schema.size() - 1) + "," + description + "}";
}

Members object_schema(const std::vector<SchemaRow>& rows, ObjectKind kind) {
    Members properties;
    std::vector<std::string> required;
    for (const KeyInfo& key : keys_of(kind)) {
        properties.emplace_back(key.name, with_description(find_schema(rows, kind, key.name), key.help));
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
        const std::string word(to_string(kind));
        const std::string condition = object(
            {{"properties", object({{"kind", object({{"const", quoted(word)}})}})}, {"required", R"(["kind"])"}});
        choice = object({{"if", condition}, {"then", reference(word)}, {"else", choice}});
    }
    return choice;
}

Members make_definitions(const SchemaInput& input) {
    const std::vector<SchemaRow> rows = make_rows(input);
    Members material = object_schema(rows, ObjectKind::Material);
    if (!input.workflows.empty())
        material.emplace_back("allOf", surface_schema(input.workflows, input.lighting_models));
    Members node = object_schema(rows, ObjectKind::Node);
    node.emplace_back("oneOf", R"([{"required":["node"]},{"required":["expr"],"not":{"required":["in"]}}])");
    if (!input.nodes.empty()) node.emplace_back("allOf", node_ports_schema(input.nodes));

    Members definitions = {
        {"identifier", std::string(kIdentifier)},
        {"value", value_schema(input.semantics)},
        {"material", object(material)},
        {"subgraph", object(object_schema(rows, ObjectKind::Subgraph))},
        {"lighting", object(object_schema(rows, ObjectKind::Lighting))},
        {"workflow", object(object_schema(rows, ObjectKind::Workflow))},
        {"property", object(object_schema(rows, ObjectKind::Property))},
        {"node", object(node)},
        {"input", object(object_schema(rows, ObjectKind::Input))},
        {"sampler", object(object_schema(rows, ObjectKind::Sampler))},
        {"gradient", object(object_schema(rows, ObjectKind::Gradient))},
        {"curve", object(object_schema(rows, ObjectKind::Curve))},
        {"render", object(object_schema(rows, ObjectKind::Render))},
        {"stencil", object(object_schema(rows, ObjectKind::Stencil))},
        {"pass", object(object_schema(rows, ObjectKind::ExtraPass))},
        {"lightingUse", object(object_schema(rows, ObjectKind::LightingUse))},
        {"budget", object(object_schema(rows, ObjectKind::Budget))},
    };
    using enum ObjectKind;
    for (const auto& [name, kind] :
         {std::pair("scene", Scene), std::pair("camera", Camera), std::pair("ambient", Ambient),
          std::pair("environment", Environment), std::pair("probe", Probe), std::pair("probeBox", ProbeBox),
          std::pair("fog", Fog), std::pair("mixedLighting", MixedLighting), std::pair("light", Light),
          std::pair("shadow", Shadow), std::pair("sceneMaterial", SceneMaterial), std::pair("sceneObject", SceneObject),
          std::pair("sceneInstance", SceneInstance)}) {
        definitions.emplace_back(name, object(object_schema(rows, kind)));
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
    const std::unique_ptr<Json> json = parse_json(sources, sources.add("schema", text), diagnostics);
    assert(json);
    return layout_json(*json, sources);
}

}  // namespace patina::graph

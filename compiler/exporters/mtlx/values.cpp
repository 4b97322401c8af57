// Values that are not computed: properties, and what the mesh and the engine give.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {
namespace {

struct Value {
    std::string_view semantic, category, type, space;
};
// A value of the mesh, and the node that has it. The first texture coordinates are turned, see pictures.cpp.
constexpr Value kValues[] = {
    {"geometryNormalWS", "normal", "vector3", "world"}, {"normalWS", "normal", "vector3", "world"},
    {"normalOS", "normal", "vector3", "object"},        {"positionWS", "position", "vector3", "world"},
    {"positionOS", "position", "vector3", "object"},    {"tangentWS", "tangent", "vector3", "world"},
    {"bitangentWS", "bitangent", "vector3", "world"},   {"vertexColor", "geomcolor", "color4", ""},
};

}  // namespace

Ref NodeWriter::coordinates(std::uint32_t index) {
    std::vector<std::pair<std::string, std::string>> words;
    if (index != 0) words.emplace_back("index", std::to_string(index));
    return node("texcoord", "vector2", {}, std::move(words));
}

Ref NodeWriter::semantic_value(ir::Value value) {
    const std::string_view name = semantic(value);
    current_ = {};
    if (name == "uv0") return turned(coordinates(0));
    if (name == "uv1") return turned(coordinates(1));
    if (name == "viewDirWS")
        return combine("multiply", node("viewdirection", "vector3", {}, {{"space", "world"}}), {.numbers = {-1}});
    if (name == "time") return node("time", "float", {});
    for (const Value& each : kValues) {
        if (each.semantic != name) continue;
        std::vector<std::pair<std::string, std::string>> words;
        if (!each.space.empty()) words.emplace_back("space", each.space);
        return node(each.category, std::string(each.type), {}, std::move(words));
    }
    refuse(value, fmt::format("'@{}'", name));
    return {.numbers = std::vector<double>(function_[value].type.components(), 0.0)};
}

Ref NodeWriter::global_value(ir::Value value) {
    const ir::Inst& inst = function_[value];
    const ir::Global& global = module_.globals[inst.data];
    const auto number = [&](double each) { return Ref{.numbers = std::vector<double>(inst.type.components(), each)}; };
    for (std::size_t i = 0; i < lowered_.property_globals.size(); ++i) {
        const lower::PropertyGlobals& each = lowered_.property_globals[i];
        const resolve::MaterialProperty& property = material_.properties[i];
        if (each.value && each.value.index == inst.data) return property_value(*property.property);
        if (each.keyword && each.keyword.index == inst.data) {
            differs(property.property->name_span,
                    fmt::format("'{}' is decided: a document has no variants", property.property->name));
            return number(property.chosen);
        }
    }
    refuse(value, fmt::format("'{}'", global.name));
    return number(0);
}

void NodeWriter::describe(Element& input, const format::Property& property) const {
    if (!property.label.empty()) input.add("uiname", property.label);
    if (!property.group.empty()) input.add("uifolder", property.group);
    if (!property.help.empty()) input.add("doc", property.help);
    if (property.range && (property.type == PropertyType::Float || property.type == PropertyType::Int)) {
        input.add(property.hard ? "uimin" : "uisoftmin", numbers_text({(*property.range)[0]}));
        input.add(property.hard ? "uimax" : "uisoftmax", numbers_text({(*property.range)[1]}));
    }
}

Ref NodeWriter::property_value(const format::Property& property) {
    if (const auto made = inputs_.find(property.name); made != inputs_.end()) return made->second;
    Ref& known = inputs_[property.name];
    const bool is_color = property.type == PropertyType::Color;
    unsigned width = 1;
    if (property.type == PropertyType::Float2) width = 2;
    if (property.type == PropertyType::Float3) width = 3;
    if (property.type == PropertyType::Float4 || is_color) width = 4;
    if (!property.numbers.empty()) {
        session_.diagnostics.report(
            Code::NoCounterpart, property.name_span,
            fmt::format("the property '{}', which holds a matrix, a gradient or a curve", property.name));
        return known = {.kind = Ref::Kind::Input, .name = property.name, .type = "float"};
    }
    std::string type = type_word(width, is_color);
    if (property.type == PropertyType::Int || property.type == PropertyType::Enum) type = "integer";
    if (property.type == PropertyType::Bool) type = "boolean";
    known = {.kind = Ref::Kind::Input, .name = names_.unique(property.name), .type = type};
    Element input{.category = "input"};
    input.add("name", known.name).add("type", known.type);
    const std::string number = numbers_text({property.value.begin(), property.value.begin() + width});
    input.add("value", type == "boolean" ? (property.value[0] != 0 ? "true" : "false") : number);
    if (property.type == PropertyType::Enum) {
        std::string words, values;
        for (std::size_t i = 0; i < property.values.size(); ++i) {
            words += (i == 0 ? "" : ", ") + property.values[i];
            values += fmt::format("{}{}", i == 0 ? "" : ", ", i);
        }
        input.add("enum", words).add("enumvalues", values);
    }
    describe(input, property);
    const auto first_node = std::find_if(graph_.children.begin(), graph_.children.end(),
                                         [](const Element& each) { return each.category != "input"; });
    graph_.children.insert(first_node, std::move(input));
    // Arithmetic takes floats.
    if (type == "integer" || type == "boolean") {
        const Ref whole = known;
        known = as(whole, "float");
        whole_[known.name] = whole;
    }
    return known;
}

}  // namespace patina::exporters::mtlx

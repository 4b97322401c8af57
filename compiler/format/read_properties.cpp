#include <algorithm>
#include <climits>
#include <set>
#include <span>
#include <string>

#include "compiler/base/file_names.h"
#include "compiler/base/text.h"
#include "compiler/format/color.h"
#include "compiler/format/read_fields.h"

namespace patina::format {
namespace {

// Each read of a property searches all of them for its name, and for the value of an enum.
constexpr std::size_t kMostProperties = 16384;
constexpr std::size_t kMostValues = 1024;

// The number of components that a range limits. Alpha is coverage and has no range.
std::size_t ranged_count(PropertyType type) {
    switch (type) {
        case PropertyType::Float:
        case PropertyType::Float2:
        case PropertyType::Float3:
        case PropertyType::Float4:
        case PropertyType::Int: return component_count(type);
        case PropertyType::Color: return 3;
        case PropertyType::Bool:
        case PropertyType::Enum:
        case PropertyType::Float2x2:
        case PropertyType::Float3x3:
        case PropertyType::Float4x4:
        case PropertyType::Gradient:
        case PropertyType::Curve:
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D:
        case PropertyType::Sampler: return 0;
    }
    return 0;
}

// Reports keys of the format that this type of property cannot use.
void check_keys_of_type(Reading& reading, const json::Json& json, const Property& property) {
    const std::string what = fmt::format("a property of type {}", to_string(property.type));
    if (!is_texture(property.type)) {
        for (const std::string_view key : {"usage", "swizzle", "sampler"})
            refuse_key(reading, json, key, what, "a texture");
        refuse_key(reading, json, "handedness", what, "a texture2d of the usage normal");
    }
    if (property.type != PropertyType::Texture2D) refuse_key(reading, json, "tiling", what, "a texture2d");
    const bool has_layers = property.type == PropertyType::Texture2DArray || property.type == PropertyType::Texture3D;
    if (!has_layers) refuse_key(reading, json, "grid", what, "a texture2dArray and a texture3d");
    if (property.type != PropertyType::Enum) refuse_key(reading, json, "values", what, "an enum");
    if (ranged_count(property.type) == 0) {
        for (const std::string_view key : {"range", "hard"}) {
            refuse_key(reading, json, key, what, "float, float2, float3, float4, color and int");
        }
    }
}

// --- defaults

void read_vector_default(Reading& reading, const json::Json& json, Property& property) {
    const std::size_t count = component_count(property.type);
    const bool is_color = property.type == PropertyType::Color;
    if (json.kind == json::Json::Kind::Number && !is_color) {  // a scalar splats
        if (const std::optional<double> value = read_float(reading, json, "'default'")) {
            std::fill_n(property.value.begin(), count, *value);
        }
        return;
    }
    const std::size_t given = json.elements.size();
    if (json.kind != json::Json::Kind::Array || !(given == count || (is_color && given == 3))) {
        report_type(
            reading, json, fmt::format("the default of a {}", to_string(property.type)),
            is_color ? "\"#rrggbb\" or an array of 3 or 4 numbers" : fmt::format("an array of {} numbers", count));
        return;
    }
    for (std::size_t i = 0; i < given; ++i) {
        property.value[i] = read_float(reading, json.elements[i], "a component of 'default'").value_or(0);
    }
}

void read_color_default(Reading& reading, const json::Json& json, Property& property) {
    if (json.kind != json::Json::Kind::String) return read_vector_default(reading, json, property);
    if (const std::optional<LinearColor> color = parse_color(json.string)) {
        property.value = color->value;
    } else {
        reading.diagnostics.report(Code::BadColor, inside(json.span), json::shown(json.string));
    }
}

void read_enum_default(Reading& reading, const json::Json& json, Property& property) {
    const std::string* text = read_string(reading, json, "the default of an enum");
    if (!text) return;
    const auto found = std::find(property.values.begin(), property.values.end(), *text);
    if (found != property.values.end()) {
        property.value[0] = static_cast<double>(found - property.values.begin());
        return;
    }
    const std::vector<std::string_view> words(property.values.begin(), property.values.end());
    suggest(reading,
            reading.diagnostics.report(Code::UnknownEnumerator, inside(json.span), json::shown(*text),
                                       fmt::format("'{}'", json::shown(property.name))),
            *text, words);
}

void read_texture_default(Reading& reading, const json::Json& json, Property& property) {
    const std::string* text = read_string(reading, json, fmt::format("the default of a {}", to_string(property.type)));
    if (!text) return;
    const bool is_file = is_file_name(*text);
    const bool is_word = std::find(kDefaultTextures.begin(), kDefaultTextures.end(), *text) != kDefaultTextures.end();
    if (is_file || is_word) {
        property.texture = *text;
        return;
    }
    DiagnosticRecord& record =
        reading.diagnostics.report(Code::UnknownWord, inside(json.span), json::shown(*text), "a default texture");
    if (text->find_first_of("./\\") != std::string::npos) {
        record.note("a file name starts with './'");
    } else {
        suggest(reading, record, *text, kDefaultTextures);
    }
}

void read_default(Reading& reading, const json::Json& json, Property& property) {
    property.default_span = json.span;
    switch (property.type) {
        case PropertyType::Float:
            property.value[0] = read_float(reading, json, "the default of a float").value_or(0);
            return;
        case PropertyType::Float2:
        case PropertyType::Float3:
        case PropertyType::Float4: return read_vector_default(reading, json, property);
        case PropertyType::Color: return read_color_default(reading, json, property);
        case PropertyType::Int:
            property.value[0] = read_int(reading, json, "the default of an int", INT_MIN, INT_MAX).value_or(0);
            return;
        case PropertyType::Bool:
            property.value[0] = read_bool(reading, json, "the default of a bool").value_or(false) ? 1 : 0;
            return;
        case PropertyType::Enum: return read_enum_default(reading, json, property);
        case PropertyType::Float2x2:
        case PropertyType::Float3x3:
        case PropertyType::Float4x4:
        case PropertyType::Gradient:
        case PropertyType::Curve:
            if (std::optional<std::vector<double>> numbers = read_array_value(reading, json, property.type))
                property.numbers = std::move(*numbers);
            return;
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D: return read_texture_default(reading, json, property);
        case PropertyType::Sampler: return read_named_sampler(reading, json, property);
    }
}

// The value before a default is read: 0; the unit matrix; a gradient or curve from 0 to 1; a white colour, or the
// nearest value in the range; a texture that changes nothing.
void set_implied_default(Property& property) {
    if (property.type == PropertyType::Color) property.value = {1, 1, 1, 1};
    if (property.type == PropertyType::Sampler) property.shared_sampler = name_of(property.sampler);
    if (is_array(property.type)) property.numbers = implied_array_value(property.type);
    if (is_texture(property.type)) {
        property.texture = property.usage == TextureUsage::Normal ? "bump" : "white";
    }
    if (property.range) {
        std::fill_n(property.value.begin(), ranged_count(property.type),
                    std::clamp(property.value[0], (*property.range)[0], (*property.range)[1]));
    }
}

void check_default_range(Reading& reading, const Property& property) {
    if (!property.range || !property.default_span) return;
    for (std::size_t i = 0; i < ranged_count(property.type); ++i) {
        const double value = property.value[i];
        check_range(reading, property.default_span, value, *property.range, property.hard, property.name);
    }
}

// --- the other keys

void read_enum_values(Reading& reading, const json::Json& json, Property& property) {
    const json::Json* values = json.find("values");
    const char* const kExample = "\"values\": [\"Dry\", \"Wet\"]";
    if (!values) {
        reading.diagnostics.report(Code::MissingKey, opening(json), "an enum", "values").note(kExample);
        return;
    }
    if (!expect(reading, *values, json::Json::Kind::Array, "'values'")) return;
    if (values->elements.size() > kMostValues) {
        reading.diagnostics.report(Code::TooMany, values->elements[kMostValues].span, values->elements.size(),
                                   "values of an enum", kMostValues);
        return;
    }
    if (values->elements.empty()) reading.diagnostics.report(Code::EmptyList, values->span, "values").note(kExample);
    UniqueNames names;
    for (const json::Json& value : values->elements) {
        property.values.push_back(read_identifier(reading, value, "a value of an enum"));
        property.value_spans.push_back(value.span);
        if (value.kind == json::Json::Kind::String) names.add(reading, value, "value");
    }
}

Property read_property(Reading& reading, const json::Json& json, UniqueNames& names) {
    Property property;
    property.span = json.span;
    check_keys(reading, json, ObjectKind::Property);
    read_name(reading, json, "property", property.name, property.name_span, names);
    if (const json::Json* binding = read_word(reading, json, "as", "a binding time", property.binding))
        property.binding_span = binding->span;
    property.label = read_text(reading, json, "label");
    if (const json::Json* label = json.find("label")) property.label_span = label->span;
    property.group = read_text(reading, json, "group");
    if (const json::Json* group = json.find("group")) property.group_span = group->span;
    property.help = read_text(reading, json, "help");

    const json::Json* type = json.find("type");
    if (!type) return property;
    const std::optional<PropertyType> known = read_word<PropertyType>(reading, *type, "type", "a property type");
    if (!known) return property;  // the type decides what the other keys must hold
    property.type = *known;
    check_keys_of_type(reading, json, property);
    const bool is_choice = property.type == PropertyType::Bool || property.type == PropertyType::Enum;
    if (is_keyword(property.binding) && !is_choice) {
        reading.diagnostics.report(Code::TypeMismatch, property.binding_span,
                                   fmt::format("'{}'", json::shown(property.name)), to_string(property.type),
                                   "a bool or an enum");
    }
    const bool is_number =
        !is_texture(property.type) && !is_array(property.type) && property.type != PropertyType::Sampler;
    if (property.binding == Binding::Instance && !is_number) {
        reading.diagnostics.report(Code::TypeMismatch, property.binding_span,
                                   fmt::format("'{}'", json::shown(property.name)), to_string(property.type),
                                   "a number, a vector, a color, a bool or an enum");
    }
    if (property.type == PropertyType::Enum) read_enum_values(reading, json, property);
    if (is_texture(property.type)) read_texture_keys(reading, json, property);
    if (ranged_count(property.type) > 0) read_limits(reading, json, property.range, property.hard);
    set_implied_default(property);
    const std::size_t errors_before = reading.diagnostics.error_count();
    if (const json::Json* value = json.find("default")) read_default(reading, *value, property);
    if (reading.diagnostics.error_count() == errors_before) check_default_range(reading, property);
    return property;
}

}  // namespace

std::vector<Property> read_properties(Reading& reading, const json::Json& array, UniqueNames& names) {
    std::vector<Property> properties;
    if (!expect(reading, array, json::Json::Kind::Array, "'properties'")) return properties;
    if (array.elements.size() > kMostProperties) {
        reading.diagnostics.report(Code::TooMany, array.elements[kMostProperties].span, array.elements.size(),
                                   "properties", kMostProperties);
    }
    std::set<std::string> known;
    for (const json::Json& element :
         std::span(array.elements).first(std::min(array.elements.size(), kMostProperties))) {
        if (!expect(reading, element, json::Json::Kind::Object, "a property")) continue;
        Property property = read_property(reading, element, names);
        // A second one has been reported, and so has one without a name.
        if (!property.name.empty() && known.insert(property.name).second) properties.push_back(std::move(property));
    }
    return properties;
}

}  // namespace patina::format

#include "compiler/format/scene/read_scene_fields.h"

#include "compiler/base/text.h"

namespace patina::format {
namespace {

std::optional<double> read_within(Reading& reading, const json::Json& json, std::string_view key, std::string_view what,
                                  double low, double high) {
    const std::optional<double> value = read_float(reading, json, what);
    if (!value || (*value >= low && *value <= high)) return value;
    reading.diagnostics.report(Code::OutOfRange, json.span, json::shown(reading.sources.text(json.span)), shortest(low),
                               shortest(high), key);
    return std::nullopt;
}

}  // namespace

bool read_number(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key, double& target) {
    const json::Json* json = object.find(key);
    if (!json) return false;
    const Form& form = form_of(kind, key, Form::Of::Number);
    const std::optional<double> value = read_within(reading, *json, key, fmt::format("'{}'", key), form.low, form.high);
    if (value) target = *value;
    return value.has_value();
}

bool read_vector(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key,
                 SceneVector& target) {
    const json::Json* json = object.find(key);
    if (!json) return false;
    const Form& form = form_of(kind, key, Form::Of::Numbers);
    if (json->kind != json::Json::Kind::Array || json->elements.size() != 3) {
        report_type(reading, *json, fmt::format("'{}'", key), "an array of 3 numbers");
        return false;
    }
    SceneVector vector{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> value =
            read_within(reading, json->elements[i], key, fmt::format("a component of '{}'", key), form.low, form.high);
        if (!value) return false;
        vector[i] = *value;
    }
    target = vector;
    return true;
}

std::optional<std::array<double, 4>> read_scene_color(Reading& reading, const json::Json& json, std::string_view key,
                                                      bool with_alpha) {
    const std::string what = fmt::format("'{}'", key);
    const auto wrong_type = [&] {
        report_type(
            reading, json, what,
            with_alpha ? "\"#rrggbb\", a number or an array of 3 or 4" : "\"#rrggbb\", a number or an array of 3");
        return std::nullopt;
    };
    if (json.kind == json::Json::Kind::String) {
        const std::optional<LinearColor> color = parse_color(json.string);
        if (!color) {
            reading.diagnostics.report(Code::BadColor, inside(json.span), json::shown(json.string));
            return std::nullopt;
        }
        if (color->has_alpha && !with_alpha) {
            reading.diagnostics.report(Code::WrongJsonType, inside(json.span), what, "a colour without alpha",
                                       json::shown(json.string));
            return std::nullopt;
        }
        return color->value;
    }
    if (json.kind == json::Json::Kind::Number) {
        const std::optional<double> grey = read_within(reading, json, key, what, 0, kFarthest);
        if (!grey) return std::nullopt;
        return std::array{*grey, *grey, *grey, 1.0};
    }
    const std::size_t count = json.elements.size();
    if (json.kind != json::Json::Kind::Array || !(count == 3 || (count == 4 && with_alpha))) return wrong_type();
    std::array<double, 4> color{0, 0, 0, 1};
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> value =
            read_within(reading, json.elements[i], key, fmt::format("a component of {}", what), 0, kFarthest);
        if (!value) return std::nullopt;
        color[i] = *value;
    }
    return color;
}

void read_color(Reading& reading, const json::Json& object, std::string_view key, SceneVector& target) {
    const json::Json* json = object.find(key);
    if (!json) return;
    const std::optional<std::array<double, 4>> color = read_scene_color(reading, *json, key);
    if (color) target = {(*color)[0], (*color)[1], (*color)[2]};
}

SceneFileName read_file_name(SceneReading& reading, const json::Json& json, std::string_view what) {
    const std::string* name = read_string(reading, json, what);
    if (!name) return {};
    std::string path = reading.files.require(*name, inside(json.span));
    return {.path = std::move(path), .place = place_of(reading, inside(json.span))};
}

SceneFileName read_graph_name(SceneReading& reading, const json::Json& json, std::string_view what) {
    const std::string* name = read_string(reading, json, what);
    if (!name) return {};
    std::string path = reading.files.require_graph(*name, inside(json.span));
    return {.path = std::move(path), .place = place_of(reading, inside(json.span))};
}

void report_impossible(Reading& reading, const json::Json& object, std::string_view key, std::string_view wanted) {
    const json::JsonMember* member = find_member(object, key);
    reading.diagnostics.report(Code::ImpossibleValue, member ? member->value.span : opening(object), key, wanted);
}

}  // namespace patina::format

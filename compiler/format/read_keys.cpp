// Gradients and curves: lists of keys, each with a time.
#include <algorithm>
#include <functional>

#include "compiler/base/text.h"
#include "compiler/format/color.h"
#include "compiler/format/read_fields.h"

namespace patina::format {
namespace {

constexpr std::size_t kMostGradientKeys = 8;
constexpr std::size_t kMostCurveKeys = 16;
// A row of the array that a struct of keys holds.
using Row = std::array<double, 4>;

struct KeyList {
    std::string_view name;  // "colors"
    std::string_view form;  // "[time, colour]"
    std::size_t most = 0;   // keys
    std::array<double, 2> times{};
};

// Reads the keys of a list: their times, and by `read_rest` what follows the time. Nothing after an error.
std::optional<std::vector<Row>> read_key_list(
    Reading& reading, const json::Json& json, const KeyList& list,
    const std::function<std::optional<Row>(const json::Json&, double)>& read_rest) {
    const std::size_t errors = reading.diagnostics.error_count();
    std::vector<Row> rows;
    if (!expect(reading, json, json::Json::Kind::Array, fmt::format("'{}'", list.name))) return std::nullopt;
    if (json.elements.empty()) reading.diagnostics.report(Code::EmptyList, json.span, list.name);
    if (json.elements.size() > list.most)
        reading.diagnostics.report(Code::TooMany, json.elements[list.most].span, json.elements.size(),
                                   fmt::format("keys of '{}'", list.name), list.most);
    std::optional<double> before;
    for (const json::Json& key : json.elements) {
        if (reading.diagnostics.error_count() > errors + kMostCurveKeys) break;
        if (key.kind != json::Json::Kind::Array || key.elements.size() < 2) {
            report_type(reading, key, fmt::format("a key of '{}'", list.name), list.form);
            continue;
        }
        const std::optional<double> time = read_float(reading, key.elements[0], "the time of a key");
        if (!time) continue;
        if (*time < list.times[0] || *time > list.times[1])
            reading.diagnostics.report(Code::OutOfRange, key.elements[0].span, shortest(*time), shortest(list.times[0]),
                                       shortest(list.times[1]), "time");
        if (before && *time < *before)
            reading.diagnostics.report(Code::KeyOrder, key.elements[0].span, shortest(*time), shortest(*before));
        before = time;
        if (const std::optional<Row> row = read_rest(key, *time)) rows.push_back(*row);
    }
    if (reading.diagnostics.error_count() > errors) return std::nullopt;
    return rows;
}

std::optional<Row> read_color_key(Reading& reading, const json::Json& key, double time) {
    if (key.elements.size() != 2) {
        report_type(reading, key, "a key of 'colors'", "an array [time, colour]");
        return std::nullopt;
    }
    const json::Json& value = key.elements[1];
    if (value.kind == json::Json::Kind::String) {
        const std::optional<LinearColor> color = parse_color(value.string);
        if (!color) {
            reading.diagnostics.report(Code::BadColor, inside(value.span), json::shown(value.string));
            return std::nullopt;
        }
        if (color->has_alpha)
            reading.diagnostics.report(Code::NoEffect, inside(value.span), "alpha", "'alphas' has the keys of alpha");
        return Row{color->value[0], color->value[1], color->value[2], time};
    }
    if (value.kind != json::Json::Kind::Array || value.elements.size() != 3) {
        report_type(reading, value, "the colour of a key", "\"#rrggbb\" or an array of 3 numbers");
        return std::nullopt;
    }
    Row row{0, 0, 0, time};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> component = read_float(reading, value.elements[i], "a component of a colour");
        if (!component) return std::nullopt;
        row[i] = *component;
    }
    return row;
}

std::optional<Row> read_alpha_key(Reading& reading, const json::Json& key, double time) {
    if (key.elements.size() != 2) {
        report_type(reading, key, "a key of 'alphas'", "an array [time, alpha]");
        return std::nullopt;
    }
    const std::optional<double> alpha = read_float(reading, key.elements[1], "the alpha of a key");
    if (!alpha) return std::nullopt;
    if (*alpha < 0 || *alpha > 1)
        reading.diagnostics.report(Code::OutOfRange, key.elements[1].span, shortest(*alpha), "0", "1", "alpha");
    return Row{*alpha, 0, 0, time};
}

// [time, value], or with the slopes before and after the key.
std::optional<Row> read_curve_key(Reading& reading, const json::Json& key, double time) {
    if (key.elements.size() != 2 && key.elements.size() != 4) {
        report_type(reading, key, "a key of 'keys'", "an array of 2 or 4 numbers");
        return std::nullopt;
    }
    Row row{time, 0, 0, 0};
    for (std::size_t i = 1; i < key.elements.size(); ++i) {
        const std::optional<double> number =
            read_float(reading, key.elements[i], i == 1 ? "the value of a key" : "the slope of a key");
        if (!number) return std::nullopt;
        row[i] = *number;
    }
    return row;
}

// Appends the rows, and repeats the last one until there are `most`.
void append(std::vector<double>& numbers, const std::vector<Row>& rows, std::size_t most) {
    for (std::size_t i = 0; i < most; ++i) {
        const Row& row = rows[std::min(i, rows.size() - 1)];
        numbers.insert(numbers.end(), row.begin(), row.end());
    }
}

std::optional<std::vector<double>> read_gradient(Reading& reading, const json::Json& json) {
    if (!expect(reading, json, json::Json::Kind::Object, "a gradient")) return std::nullopt;
    const std::size_t errors = reading.diagnostics.error_count();
    check_keys(reading, json, ObjectKind::Gradient);
    std::optional<std::vector<Row>> colors, alphas = std::vector<Row>{{1, 0, 0, 0}};
    if (const json::Json* list = json.find("colors"))
        colors = read_key_list(
            reading, *list,
            {.name = "colors", .form = "an array [time, colour]", .most = kMostGradientKeys, .times = {0, 1}},
            [&](const json::Json& key, double time) { return read_color_key(reading, key, time); });
    if (const json::Json* list = json.find("alphas"))
        alphas = read_key_list(
            reading, *list,
            {.name = "alphas", .form = "an array [time, alpha]", .most = kMostGradientKeys, .times = {0, 1}},
            [&](const json::Json& key, double time) { return read_alpha_key(reading, key, time); });
    GradientBlend blend = GradientBlend::Linear;
    if (const json::Json* word = json.find("blend"))
        blend = read_word<GradientBlend>(reading, *word, "blend", "a blend of a gradient").value_or(blend);
    if (!colors || !alphas || reading.diagnostics.error_count() > errors) return std::nullopt;
    std::vector<double> numbers = {static_cast<double>(colors->size()), static_cast<double>(alphas->size()),
                                   static_cast<double>(blend), 0};
    append(numbers, *colors, kMostGradientKeys);
    append(numbers, *alphas, kMostGradientKeys);
    return numbers;
}

std::optional<std::vector<double>> read_curve(Reading& reading, const json::Json& json) {
    if (!expect(reading, json, json::Json::Kind::Object, "a curve")) return std::nullopt;
    const std::size_t errors = reading.diagnostics.error_count();
    check_keys(reading, json, ObjectKind::Curve);
    const json::Json* list = json.find("keys");
    if (!list) return std::nullopt;
    constexpr double kAny = std::numeric_limits<double>::infinity();
    const std::optional<std::vector<Row>> keys = read_key_list(
        reading, *list,
        {.name = "keys", .form = "an array [time, value]", .most = kMostCurveKeys, .times = {-kAny, kAny}},
        [&](const json::Json& key, double time) { return read_curve_key(reading, key, time); });
    if (!keys || reading.diagnostics.error_count() > errors) return std::nullopt;
    std::vector<double> numbers = {static_cast<double>(keys->size()), 0, 0, 0};
    append(numbers, *keys, kMostCurveKeys);
    return numbers;
}

std::optional<std::vector<double>> read_matrix(Reading& reading, const json::Json& json, std::size_t size) {
    const auto refuse = [&](const json::Json& at) {
        report_type(reading, at, fmt::format("a float{0}x{0}", size), fmt::format("{0} rows of {0} numbers", size));
        return std::nullopt;
    };
    if (json.kind != json::Json::Kind::Array || json.elements.size() != size) return refuse(json);
    std::vector<double> numbers;
    for (const json::Json& row : json.elements) {
        if (row.kind != json::Json::Kind::Array || row.elements.size() != size) return refuse(row);
        for (const json::Json& element : row.elements) {
            const std::optional<double> number = read_float(reading, element, "an element of a matrix");
            if (!number) return std::nullopt;
            numbers.push_back(*number);
        }
    }
    return numbers;
}

std::size_t rows_of(PropertyType type) {
    return type == PropertyType::Float2x2 ? 2 : type == PropertyType::Float3x3 ? 3 : 4;
}

}  // namespace

std::optional<std::vector<double>> read_array_value(Reading& reading, const json::Json& json, PropertyType type) {
    if (type == PropertyType::Gradient) return read_gradient(reading, json);
    if (type == PropertyType::Curve) return read_curve(reading, json);
    return read_matrix(reading, json, rows_of(type));
}

bool has_rows(const json::Json& json) {
    return std::any_of(json.elements.begin(), json.elements.end(),
                       [](const json::Json& element) { return element.kind == json::Json::Kind::Array; });
}

std::optional<PropertyType> array_type(const json::Json& json) {
    if (json.find("colors")) return PropertyType::Gradient;
    if (json.find("keys")) return PropertyType::Curve;
    constexpr PropertyType kMatrices[] = {PropertyType::Float2x2, PropertyType::Float3x3, PropertyType::Float4x4};
    const std::size_t rows = json.elements.size();
    return has_rows(json) && rows >= 2 && rows <= 4 ? std::optional(kMatrices[rows - 2]) : std::nullopt;
}

std::vector<double> implied_array_value(PropertyType type) {
    std::vector<double> numbers;
    if (type == PropertyType::Gradient) {
        numbers = {2, 1, 0, 0};
        append(numbers, {{0, 0, 0, 0}, {1, 1, 1, 1}}, kMostGradientKeys);
        append(numbers, {{1, 0, 0, 0}}, kMostGradientKeys);
    } else if (type == PropertyType::Curve) {
        numbers = {2, 0, 0, 0};
        append(numbers, {{0, 0, 1, 1}, {1, 1, 1, 1}}, kMostCurveKeys);
    } else {
        const std::size_t rows = rows_of(type);
        for (std::size_t i = 0; i < rows * rows; ++i) numbers.push_back(i % (rows + 1) == 0 ? 1 : 0);
    }
    return numbers;
}

}  // namespace patina::format

// Reads "render": how a surface is drawn, apart from what its shaders compute.
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/format/read_fields.h"

namespace patina::format {
namespace {

// The factor counts the change of depth from pixel to pixel, and no render target is wider than this number of pixels.
// The units count steps of depth, and a buffer of 24 bits has this many. Vulkan and ShaderLab take any floats here,
// Direct3D 11 a float and an int.
constexpr double kMostFactor = 16384, kMostUnits = 16777216;

// Reads `count` numbers; nothing after an error.
template <std::size_t count>
std::optional<std::array<double, count>> read_numbers(Reading& reading, const json::Json& json, std::string_view what,
                                                      std::string_view wanted) {
    if (json.kind != json::Json::Kind::Array || json.elements.size() != count) {
        report_type(reading, json, what, wanted);
        return std::nullopt;
    }
    std::array<double, count> numbers{};
    bool is_good = true;
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> number =
            read_float(reading, json.elements[i], fmt::format("an element of {}", what));
        is_good = is_good && number;
        numbers[i] = number.value_or(0);
    }
    return is_good ? std::optional(numbers) : std::nullopt;
}

StencilState read_stencil(Reading& reading, const json::Json& json) {
    StencilState stencil;
    stencil.span = json.span;
    if (!expect(reading, json, json::Json::Kind::Object, "'stencil'")) return stencil;
    check_keys(reading, json, ObjectKind::Stencil);
    const auto number = [&](std::string_view key, int& value) {
        if (const json::Json* found = json.find(key))
            value = read_int(reading, *found, fmt::format("'stencil.{}'", key),
                             form_of(ObjectKind::Stencil, key, Form::Of::Integer))
                        .value_or(value);
    };
    number("reference", stencil.reference);
    number("readMask", stencil.read_mask);
    number("writeMask", stencil.write_mask);
    read_word(reading, json, "test", "a stencil test", stencil.test);
    read_word(reading, json, "pass", "a stencil operation", stencil.pass);
    read_word(reading, json, "fail", "a stencil operation", stencil.fail);
    read_word(reading, json, "depthFail", "a stencil operation", stencil.depth_fail);
    return stencil;
}

std::optional<Bounds> read_bounds(Reading& reading, const json::Json& json) {
    if (json.kind == json::Json::Kind::Number) {
        if (json.number >= 0 && json.number <= kFarthest) return Bounds{.margin = json.number};
        reading.diagnostics.report(Code::OutOfRange, json.span, reading.sources.text(json.span), 0, kFarthest,
                                   "bounds");
        return std::nullopt;
    }
    if (json.kind != json::Json::Kind::Array || json.elements.size() != 2) {
        report_type(reading, json, "'bounds'", "a number of metres, or the lowest and the highest corner of a box");
        return std::nullopt;
    }
    const auto lowest =
        read_numbers<3>(reading, json.elements[0], "the lowest corner of 'bounds'", "an array of three numbers");
    const auto highest =
        read_numbers<3>(reading, json.elements[1], "the highest corner of 'bounds'", "an array of three numbers");
    if (!lowest || !highest) return std::nullopt;
    const std::size_t errors = reading.diagnostics.error_count();
    for (const json::Json& corner : json.elements) {
        for (const json::Json& number : corner.elements) {
            if (std::fabs(number.number) <= kFarthest) continue;
            reading.diagnostics.report(Code::OutOfRange, number.span, reading.sources.text(number.span), -kFarthest,
                                       kFarthest, "bounds");
        }
    }
    if (reading.diagnostics.error_count() > errors) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((*lowest)[i] <= (*highest)[i]) continue;
        const json::Json& number = json.elements[1].elements[i];
        reading.diagnostics.report(Code::ImpossibleValue, number.span, "bounds",
                                   "a box whose highest corner is not below its lowest on any axis");
        return std::nullopt;
    }
    return Bounds{.box = std::array{*lowest, *highest}};
}

std::optional<std::array<double, 2>> read_depth_offset(Reading& reading, const json::Json& json) {
    const auto numbers = read_numbers<2>(reading, json, "'depthOffset'", "an array of two numbers, factor and units");
    if (!numbers) return std::nullopt;
    const std::size_t errors = reading.diagnostics.error_count();
    const auto check = [&](std::size_t i, double most, std::string_view note) {
        const double number = (*numbers)[i];
        if (std::abs(number) <= most) return;
        reading.diagnostics
            .report(Code::OutOfRange, json.elements[i].span, shortest(number), shortest(-most), shortest(most),
                    "depthOffset")
            .note(std::string(note));
    };
    check(0, kMostFactor, "the first number is the factor, which multiplies the depth slope");
    check(1, kMostUnits, "the second number is the units, which multiply the smallest depth difference");
    return reading.diagnostics.error_count() == errors ? numbers : std::nullopt;
}

}  // namespace

RenderState read_render(Reading& reading, const json::Json& json) {
    RenderState render;
    render.span = json.span;
    if (!expect(reading, json, json::Json::Kind::Object, "'render'")) return render;
    check_keys(reading, json, ObjectKind::Render);
    if (const json::Json* surface = read_word(reading, json, "surface", "a surface kind", render.surface))
        render.surface_span = surface->span;
    read_word(reading, json, "cull", "a cull mode", render.cull);
    if (const json::Json* write = json.find("depthWrite"))
        render.depth_write = read_bool(reading, *write, "'depthWrite'");
    if (const json::Json* test = json.find("depthTest")) {
        render.depth_test = read_word<Compare>(reading, *test, "depthTest", "a depth test");
    }
    if (const json::Json* offset = json.find("depthOffset")) {
        render.depth_offset = read_depth_offset(reading, *offset);
    }
    if (const json::Json* stencil = json.find("stencil")) render.stencil = read_stencil(reading, *stencil);
    if (const json::Json* queue = json.find("queue"))
        render.queue = read_int(reading, *queue, "'queue'", form_of(ObjectKind::Render, "queue", Form::Of::Integer));
    if (const json::Json* bounds = json.find("bounds")) render.bounds = read_bounds(reading, *bounds);
    read_bool(reading, json, "materialOverride", render.allows_override);
    return render;
}

}  // namespace patina::format

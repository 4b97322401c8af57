// The keys of a property that is a texture, and the words of samplers.
#include "compiler/base/text.h"
#include "compiler/format/read_fields.h"
#include "compiler/format/words.h"

namespace patina::format {
namespace {

void read_sampler(Reading& reading, const json::Json& json, Property& property) {
    if (json.kind == json::Json::Kind::String) return read_named_sampler(reading, json, property);
    if (json.kind != json::Json::Kind::Object) {
        report_type(reading, json, "'sampler'", "an object, or the name of a shared sampler: \"trilinearRepeat\"");
        return;
    }
    Sampler& sampler = property.sampler;
    check_keys(reading, json, ObjectKind::Sampler);
    read_word(reading, json, "wrap", "a wrap mode", sampler.wrap);
    read_word(reading, json, "filter", "a filter", sampler.filter);
    read_int(reading, json, ObjectKind::Sampler, "anisotropy", sampler.anisotropy);
}

// "grid": [4, 2]: the picture holds 2 rows of 4 layers.
void read_grid(Reading& reading, const json::Json& json, Property& property) {
    if (json.kind != json::Json::Kind::Array || json.elements.size() != 2) {
        report_type(reading, json, "'grid'", "[columns, rows] of its layers in the picture, such as [4, 2]");
        return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        constexpr int kMost = 256;
        property.grid[i] = read_int(reading, json.elements[i], "'grid'", 1, kMost).value_or(1);
    }
}

// "bgra", or shorter, as a file of fewer channels is read: "r" is a grey, "ra" a grey and alpha, "bgr" has an alpha
// of 1.
void read_swizzle(Reading& reading, const json::Json& json, Property& property) {
    const std::string* const text = read_string(reading, json, "'swizzle'");
    if (!text) return;
    property.swizzle_span = json.span;
    const std::size_t wrong = text->find_first_not_of("rgba01");
    if (wrong != std::string::npos || text->empty() || text->size() > 4) {
        Span at = inside(json.span);
        const bool has_no_escapes = at.end - at.begin == text->size();
        if (wrong != std::string::npos && has_no_escapes) {
            at.begin += static_cast<std::uint32_t>(wrong);
            at.end = at.begin + 1;
        }
        reading.diagnostics.report(Code::ImpossibleValue, at, "swizzle", "one to four of r, g, b, a, 0 and 1");
        return;
    }
    std::string four = *text;
    if (four.size() < 3) four.insert(0, 2, four[0]);
    if (four.size() == 3) four += '1';
    if (four != "rgba") property.swizzle = four;
}

}  // namespace

void report_no_sampler(Diagnostics& diagnostics, Span span, std::string_view word) {
    DiagnosticRecord& record = diagnostics.report(Code::UnknownWord, span, json::shown(word), "a sampler");
    record.note(Diagnostics::suggestion(meant_by(word, kSamplerNames), kSamplerNames));
}

void read_named_sampler(Reading& reading, const json::Json& json, Property& property) {
    const std::string* const text = read_string(reading, json, "a sampler");
    if (!text) return;
    const NamedSampler* const named = find_sampler(*text);
    if (!named) {
        report_no_sampler(reading.diagnostics, inside(json.span), *text);
        return;
    }
    property.sampler = named->sampler;
    property.shared_sampler = named->name;
}

void read_texture_keys(Reading& reading, const json::Json& json, Property& property) {
    if (const json::Json* usage = read_word(reading, json, "usage", "a texture's usage", property.usage))
        property.usage_span = usage->span;
    read_bool(reading, json, "tiling", property.tiling);
    if (property.usage == TextureUsage::Normal && property.type != PropertyType::Texture2D) {
        reading.diagnostics.report(Code::ImpossibleValue, property.usage_span.value_or(json.span), "usage",
                                   fmt::format("color or data: a {} holds no normal map", to_string(property.type)));
    }
    if (const json::Json* handedness = json.find("handedness")) {
        property.handedness_span = handedness->span;
        property.handedness = read_word<Handedness>(reading, *handedness, "handedness", "a handedness of normal maps")
                                  .value_or(Handedness::OpenGL);
        if (property.usage != TextureUsage::Normal)
            refuse_key(reading, json, "handedness", fmt::format("a texture of the usage {}", to_string(property.usage)),
                       "a texture2d of the usage normal");
    }
    if (const json::Json* swizzle = json.find("swizzle")) read_swizzle(reading, *swizzle, property);
    if (const json::Json* grid = json.find("grid")) read_grid(reading, *grid, property);
    if (const json::Json* sampler = json.find("sampler")) {
        property.sampler_span = sampler->span;
        read_sampler(reading, *sampler, property);
    }
}

}  // namespace patina::format

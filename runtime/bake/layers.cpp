#include "runtime/bake/layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/bake/texels.h"

namespace patina::runtime {
namespace {

// Which channel of its texture holds an input. None: glTF has no texture for it.
enum class Channel { None, Red, Green, Alpha, Color };

struct GltfInput {
    std::string_view input, extension, factor, texture;
    Channel channel = Channel::None;
    bool is_share = true;  // from 0 to 1; else a factor may be larger
    bool is_color = false;
};

constexpr std::string_view kClearcoat = "KHR_materials_clearcoat", kSheen = "KHR_materials_sheen",
                           kSpecular = "KHR_materials_specular", kIor = "KHR_materials_ior",
                           kAnisotropy = "KHR_materials_anisotropy", kIridescence = "KHR_materials_iridescence",
                           kTransmission = "KHR_materials_transmission", kVolume = "KHR_materials_volume",
                           kDispersion = "KHR_materials_dispersion", kDiffuse = "KHR_materials_diffuse_transmission";
constexpr std::string_view kAnisotropyStrength = "anisotropy", kDirection = "anisotropyDirection",
                           kThickness = "iridescenceThickness", kDistance = "attenuationDistance";

// The three of anisotropy and of the film's thickness have a function each, below.
constexpr GltfInput kGltfInputs[] = {
    {"clearcoat", kClearcoat, "clearcoatFactor", "clearcoatTexture", Channel::Red},
    {"clearcoatRoughness", kClearcoat, "clearcoatRoughnessFactor", "clearcoatRoughnessTexture", Channel::Green},
    {"sheenColor", kSheen, "sheenColorFactor", "sheenColorTexture", Channel::Color, true, true},
    {"sheenRoughness", kSheen, "sheenRoughnessFactor", "sheenRoughnessTexture", Channel::Alpha},
    {"specularFactor", kSpecular, "specularFactor", "specularTexture", Channel::Alpha},
    {"specularColor", kSpecular, "specularColorFactor", "specularColorTexture", Channel::Color, false, true},
    {"ior", kIor, "ior", "", Channel::None, false},
    {kAnisotropyStrength, kAnisotropy, "", ""},
    {kDirection, kAnisotropy, "", ""},
    {"iridescence", kIridescence, "iridescenceFactor", "iridescenceTexture", Channel::Red},
    {"iridescenceIor", kIridescence, "iridescenceIor", "", Channel::None, false},
    {kThickness, kIridescence, "", ""},
    {"transmission", kTransmission, "transmissionFactor", "transmissionTexture", Channel::Red},
    {"thickness", kVolume, "thicknessFactor", "thicknessTexture", Channel::Green, false},
    {"attenuationColor", kVolume, "attenuationColor", "", Channel::None, true, true},
    {kDistance, kVolume, kDistance, "", Channel::None, false},
    {"dispersion", kDispersion, "dispersion", "", Channel::None, false},
    {"diffuseTransmission", kDiffuse, "diffuseTransmissionFactor", "diffuseTransmissionTexture", Channel::Alpha},
    {"diffuseTransmissionColor", kDiffuse, "diffuseTransmissionColorFactor", "diffuseTransmissionColorTexture",
     Channel::Color, true, true},
};

const GltfInput* gltf_input(std::string_view input) {
    const auto found = std::find_if(std::begin(kGltfInputs), std::end(kGltfInputs),
                                    [&](const GltfInput& row) { return row.input == input; });
    return found == std::end(kGltfInputs) ? nullptr : found;
}

class LayerTextures {
public:
    LayerTextures(const std::vector<LayerValue>& values, const std::vector<std::uint8_t>& covered)
        : values_(values), covered_(covered) {}

    Layers run() {
        for (const LayerValue& each : values_) {
            const GltfInput* row = gltf_input(each.input);
            if (row && !row->factor.empty()) add(*row, each.image);
        }
        add_film_thickness();
        add_anisotropy();
        return std::move(out_);
    }

private:
    const Image* find(std::string_view input) const {
        const auto found =
            std::find_if(values_.begin(), values_.end(), [&](const LayerValue& each) { return each.input == input; });
        return found == values_.end() ? nullptr : &found->image;
    }

    WrittenExtension& extension(std::string_view name) {
        for (WrittenExtension& each : out_.extensions)
            if (each.name == name) return each;
        return out_.extensions.emplace_back(WrittenExtension{.name = std::string(name), .numbers = {}, .textures = {}});
    }

    std::size_t add_map(std::string_view input, bool is_color, Image image) {
        out_.maps.push_back({.name = std::string(input), .is_color = is_color, .image = std::move(image)});
        return out_.maps.size() - 1;
    }

    void lose(std::string what, std::string why) { out_.losses.push_back({std::move(what), std::move(why)}); }

    // One number, or the three of a colour: a factor, and a texture if they vary.
    void add(const GltfInput& row, const Image& image) {
        const int count = row.is_color ? 3 : 1;
        std::vector<Range> ranges;
        for (int c = 0; c < count; c++) ranges.push_back(range_of(image, covered_, c));
        const bool is_constant =
            std::all_of(ranges.begin(), ranges.end(), [](const Range& each) { return each.is_constant(); });
        const auto most = [&](float limit) {
            float high = limit;
            for (const Range& each : ranges) high = std::max(high, each.high);
            return high;
        };
        if (row.is_share && most(0) > 1 + kSame)
            lose(fmt::format("'{}' above 1, up to {:.3g},", row.input, most(0)), "glTF holds 0 to 1");
        if (!is_constant && row.channel == Channel::None)
            lose(fmt::format("that '{}' varies", row.input), "glTF has one value of it for a material");
        // No distance: no absorption, which glTF says by leaving it out.
        if (row.input == kDistance && most(0) <= 0) return;
        WrittenExtension& made = extension(row.extension);
        std::vector<double> factor;
        const bool has_texture = !is_constant && row.channel != Channel::None;
        const float scale = row.is_share || !has_texture ? 1 : most(1);
        for (const Range& each : ranges) {
            const double value = has_texture ? scale : each.middle();
            factor.push_back(row.is_share ? std::clamp(value, 0.0, 1.0) : std::max(value, 0.0));
        }
        made.numbers[std::string(row.factor)] = factor;
        if (has_texture)
            made.textures[std::string(row.texture)] = add_map(row.input, row.is_color, texture(row, image, scale));
    }

    static Image texture(const GltfInput& row, const Image& image, float scale) {
        const bool is_alpha = row.channel == Channel::Alpha;
        Image made = row.is_color ? picked(image, {0, 1, 2, std::nullopt})
                     : is_alpha   ? picked(image, {std::nullopt, std::nullopt, std::nullopt, 0})
                                  : picked(image, {0, 0, 0, std::nullopt});
        for (std::size_t i = 0; i < made.pixels.size(); i++)
            if ((i % 4 == 3) == is_alpha) made.pixels[i] = std::clamp(made.pixels[i] / scale, 0.0f, 1.0f);
        return made;
    }

    // The texture is a place between the two thicknesses of the material; without one, the second counts.
    void add_film_thickness() {
        const Image* image = find(kThickness);
        if (!image) return;
        const Range range = range_of(*image, covered_, 0);
        WrittenExtension& made = extension(kIridescence);
        if (range.is_constant()) {
            made.numbers["iridescenceThicknessMaximum"] = {range.middle()};
            return;
        }
        made.numbers["iridescenceThicknessMinimum"] = {range.low};
        made.numbers["iridescenceThicknessMaximum"] = {range.high};
        Image placed = picked(*image, {0, 0, 0, std::nullopt});
        for (std::size_t i = 0; i < placed.pixels.size(); i++)
            if (i % 4 != 3) placed.pixels[i] = (placed.pixels[i] - range.low) / (range.high - range.low);
        made.textures["iridescenceThicknessTexture"] = add_map(kThickness, false, std::move(placed));
    }

    // Red and green are the direction in the tangent plane, 0.5 is 0; blue is the strength.
    void add_anisotropy() {
        const Image* strength = find(kAnisotropyStrength);
        if (!strength) return;  // a direction alone stretches nothing
        static const Image kAlongTangent = make_image(1, 1, 1, 0);
        const Image* given = find(kDirection);
        const Image& direction = given ? *given : kAlongTangent;
        const Range share = range_of(*strength, covered_, 0), x = range_of(direction, covered_, 0),
                    y = range_of(direction, covered_, 1);
        WrittenExtension& made = extension(kAnisotropy);
        const bool is_even = share.is_constant();
        made.numbers["anisotropyStrength"] = {is_even ? std::clamp(share.middle(), 0.0, 1.0) : 1};
        if (is_even && x.is_constant() && y.is_constant()) {
            made.numbers["anisotropyRotation"] = {std::atan2(y.middle(), x.middle())};
            return;
        }
        const Image& larger = is_even ? direction : *strength;
        Image both = make_image(larger.width, larger.height);
        for (std::size_t i = 0; i < both.pixels.size(); i += 4) {
            const std::size_t at = direction.pixels.size() == 4 ? 0 : i;
            const float length = std::hypot(direction.pixels[at], direction.pixels[at + 1]);
            both.pixels[i] = length > 0 ? 0.5f + 0.5f * direction.pixels[at] / length : 1;
            both.pixels[i + 1] = length > 0 ? 0.5f + 0.5f * direction.pixels[at + 1] / length : 0.5f;
            both.pixels[i + 2] = is_even ? 1 : std::clamp(strength->pixels[i], 0.0f, 1.0f);
        }
        made.textures["anisotropyTexture"] = add_map(kAnisotropyStrength, false, std::move(both));
    }

    const std::vector<LayerValue>& values_;
    const std::vector<std::uint8_t>& covered_;
    Layers out_{};
};

}  // namespace

bool is_layer(std::string_view input) {
    return gltf_input(input) != nullptr;
}

Layers layers_of(const std::vector<LayerValue>& values, const std::vector<std::uint8_t>& covered) {
    return LayerTextures(values, covered).run();
}

}  // namespace patina::runtime

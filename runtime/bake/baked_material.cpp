#include "runtime/bake/baked_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "runtime/bake/layers.h"
#include "runtime/bake/padding.h"
#include "runtime/bake/texels.h"

namespace patina::runtime {
namespace {

// A normal this near to the mesh's own is its own: a quarter of a step of 8 bits.
constexpr float kFlat = 0.25f * 2 / 255;
// How far a value may be outside of 0 to 1 before a warning names it.
constexpr float kSlack = 1e-3f;
// From here on, a difference of colours can be seen: a step of 8 bits.
constexpr float kVisible = 1.0f / 255;
constexpr std::string_view kStrength = "emissiveStrength";

class Making {
public:
    Making(const std::string& name, BakedTargets& drawn, const std::vector<LayerValue>& layers, const BakedState& state)
        : drawn_(drawn), layers_(layers), state_(state), covered_(covered_texels(drawn.normal)) {
        out_.material.name = name;
    }

    BakedMaterial run() {
        std::vector<std::uint8_t> broken(covered_.size());
        for (Image* image : {&drawn_.color, &drawn_.reflection, &drawn_.normal, &drawn_.emission, &drawn_.cutoff})
            make_finite(*image, broken);
        out_.not_finite = not_finite(broken, covered_, drawn_.normal.width);
        out_.material.is_unlit = state_.is_unlit;
        out_.material.is_double_sided = state_.is_double_sided;
        if (state_.is_unlit) show_emission();
        clip_alpha();
        color();
        if (!state_.is_unlit) lit();
        const std::vector<std::uint32_t> from = nearest_covered(covered_, drawn_.color.width, drawn_.color.height);
        for (BakedMap& map : out_.maps)
            if (map.image.pixels.size() == 4 * from.size()) fill(map.image, from);
        return std::move(out_);
    }

private:
    // --- the texels

    Range range(const Image& image, int channel) const { return range_of(image, covered_, channel); }

    // The range of values, which glTF limits to 0 to 1; warnings name the values outside.
    Range share(Image& image, int channel, std::string_view what) {
        const Range found = range(image, channel);
        if (found.low >= 0 && found.high <= 1) return found;
        if (found.low < -kSlack) lose(fmt::format("{} below 0", what), "glTF holds 0 to 1");
        if (found.high > 1 + kSlack)
            lose(fmt::format("{} above 1, up to {:.3g},", what, found.high), "glTF holds 0 to 1");
        for (std::size_t i = 0; i < covered_.size(); i++) {
            float& value = image.pixels[4 * i + std::size_t(channel)];
            value = std::clamp(value, 0.0f, 1.0f);
        }
        return {.low = std::clamp(found.low, 0.0f, 1.0f), .high = std::clamp(found.high, 0.0f, 1.0f)};
    }

    // One message for the three channels of a colour.
    std::array<Range, 3> color_share(Image& image, std::string_view what) {
        return {share(image, 0, what), share(image, 1, what), share(image, 2, what)};
    }

    void lose(std::string what, std::string why) {
        const bool is_known = std::any_of(out_.losses.begin(), out_.losses.end(),
                                          [&](const BakedMaterial::Loss& each) { return each.what == what; });
        if (!is_known) out_.losses.push_back({std::move(what), std::move(why)});
    }

    std::size_t add_map(std::string name, bool is_color, Image image) {
        out_.maps.push_back({.name = std::move(name), .is_color = is_color, .image = std::move(image)});
        return out_.maps.size() - 1;
    }

    static bool is_constant(const std::array<Range, 3>& channels) {
        return std::all_of(channels.begin(), channels.end(), [](const Range& each) { return each.is_constant(); });
    }
    static glm::dvec3 middle(const std::array<Range, 3>& channels) {
        return {channels[0].middle(), channels[1].middle(), channels[2].middle()};
    }

    // --- colour and alpha

    // KHR_materials_unlit shows the base colour: what an unlit surface emits.
    void show_emission() {
        for (std::size_t i = 0; i < covered_.size(); i++) {
            // A transparent unlit surface emits its colour times alpha (nodes/stage/surface.node.hlsl).
            const float alpha = drawn_.color.pixels[4 * i + 3];
            const float part = state_.surface == SurfaceKind::Transparent ? std::max(alpha, 1e-4f) : 1;
            for (std::size_t c = 0; c < 3; c++)
                drawn_.color.pixels[4 * i + c] = drawn_.emission.pixels[4 * i + c] / part;
        }
    }

    void clip_alpha() {
        WrittenMaterial& material = out_.material;
        if (state_.surface == SurfaceKind::Opaque) return;
        if (state_.surface != SurfaceKind::Cutout) {
            material.alpha = WrittenMaterial::Alpha::Blend;
            return;
        }
        material.alpha = WrittenMaterial::Alpha::Mask;
        const Range cutoff = range(drawn_.cutoff, 0);
        if (cutoff.is_constant()) {
            material.cutoff = cutoff.middle();
            return;
        }
        for (std::size_t i = 0; i < covered_.size(); i++) {
            float& alpha = drawn_.color.pixels[4 * i + 3];
            alpha = alpha < drawn_.cutoff.pixels[4 * i] ? 0 : 1;
        }
    }

    void color() {
        const char* name = state_.is_specular ? "diffuse" : "baseColor";
        const auto channels = color_share(drawn_.color, state_.is_specular ? "the diffuse colour" : "the base colour");
        const bool is_opaque = state_.surface == SurfaceKind::Opaque;
        const Range alpha = is_opaque ? Range{1, 1} : share(drawn_.color, 3, "alpha");
        const bool is_even = is_constant(channels), has_alpha = !alpha.is_constant();
        const glm::dvec4 factor(is_even ? middle(channels) : glm::dvec3(1), has_alpha ? 1 : alpha.middle());
        WrittenTexture texture;
        if (!is_even || has_alpha) {
            const auto channel = [&](int c) { return is_even ? std::nullopt : std::optional(c); };
            texture = add_map(name, true,
                              picked(drawn_.color, {channel(0), channel(1), channel(2),
                                                    has_alpha ? std::optional(3) : std::nullopt}));
        }
        out_.material.base_color = factor;
        out_.material.base_color_texture = texture;
        if (state_.is_specular && !state_.is_unlit)
            out_.material.specular_glossiness = {.diffuse = factor, .diffuse_texture = texture};
    }

    // --- everything else

    void lit() {
        if (state_.is_specular)
            specular();
        else
            metallic_roughness();
        normal();
        occlusion();
        strengthen();
        emission();
        add_layers();
    }

    void add_layers() {
        Layers made = layers_of(layers_, covered_);
        const std::size_t before = out_.maps.size();
        for (WrittenExtension& extension : made.extensions) {
            for (auto& [name, texture] : extension.textures) texture += before;
            out_.material.layers.push_back(std::move(extension));
        }
        for (BakedMap& map : made.maps) out_.maps.push_back(std::move(map));
        for (BakedMaterial::Loss& loss : made.losses) lose(std::move(loss.what), std::move(loss.why));
    }

    // How much the nearest base colour and metallic lose of a specular set-up's diffuse colour and f0.
    void say_conversion() {
        std::size_t texels = 0, lossy = 0;
        for (std::size_t i = 0; i < covered_.size(); i++) {
            texels += covered_[i];
            lossy += covered_[i] && drawn_.reflection.pixels[4 * i + 3] > kVisible;
        }
        if (lossy == 0) return;
        lose(fmt::format("the diffuse colour together with the f0 (at {:.1f} % of the texels, by up to {:.2g})",
                         100.0 * double(lossy) / double(texels), range(drawn_.reflection, 3).high),
             "no base colour and metallic have both; '--workflow specular-glossiness' has");
    }

    void metallic_roughness() {
        say_conversion();
        const Range roughness = share(drawn_.reflection, 1, "the roughness");
        const Range metallic = share(drawn_.reflection, 2, "the metallic");
        const bool is_rough = !roughness.is_constant(), is_metallic = !metallic.is_constant();
        out_.material.roughness = is_rough ? 1 : roughness.middle();
        out_.material.metallic = is_metallic ? 1 : metallic.middle();
        if (!is_rough && !is_metallic) return;
        out_.material.metallic_roughness_texture =
            add_map("metallicRoughness", false,
                    picked(drawn_.reflection, {std::nullopt, is_rough ? std::optional(1) : std::nullopt,
                                               is_metallic ? std::optional(2) : std::nullopt, std::nullopt}));
    }

    // Viewers that do not know the extension show a dielectric of the diffuse colour.
    void specular() {
        const auto colors = color_share(drawn_.reflection, "the specular colour");
        const Range glossiness = share(drawn_.reflection, 3, "the glossiness");
        WrittenMaterial::SpecularGlossiness& out = *out_.material.specular_glossiness;
        const bool is_even = is_constant(colors), is_glossy = !glossiness.is_constant();
        if (is_even) out.specular = middle(colors);
        if (!is_glossy) out.glossiness = glossiness.middle();
        out_.material.metallic = 0;
        out_.material.roughness = 1 - glossiness.middle();
        if (is_even && !is_glossy) return;
        const auto channel = [&](int c) { return is_even ? std::nullopt : std::optional(c); };
        out.texture = add_map("specularGlossiness", true,
                              picked(drawn_.reflection, {channel(0), channel(1), channel(2),
                                                         is_glossy ? std::optional(3) : std::nullopt}));
    }

    void normal() {
        const Range x = range(drawn_.normal, 0), y = range(drawn_.normal, 1), z = range(drawn_.normal, 2);
        const float most = std::max({x.high, -x.low, y.high, -y.low});
        if (most <= kFlat && z.low > 0) return;
        Image encoded = picked(drawn_.normal, {0, 1, 2, std::nullopt});
        for (std::size_t i = 0; i < encoded.pixels.size(); i++)
            if (i % 4 != 3) encoded.pixels[i] = 0.5f + 0.5f * encoded.pixels[i];
        out_.material.normal_texture = add_map("normal", false, std::move(encoded));
    }

    // The occlusion is in alpha of the emission, in every workflow.
    void occlusion() {
        const Range open = share(drawn_.emission, 3, "the occlusion");
        if (open.is_constant() && open.middle() > 1 - kSame) return;
        if (!open.is_constant()) {
            out_.material.occlusion_texture =
                add_map("occlusion", false, picked(drawn_.emission, {3, 3, 3, std::nullopt}));
            return;
        }
        // There is no factor: the strength of a black texel is one.
        out_.material.occlusion_texture = add_map("occlusion", false, make_image(1, 1));
        out_.material.occlusion_strength = 1 - open.middle();
    }

    // The lighting model's own factor of the emission.
    void strengthen() {
        for (const LayerValue& layer : layers_) {
            if (layer.input != kStrength) continue;
            const bool is_even = layer.image.pixels.size() == 4;
            for (std::size_t i = 0; i < drawn_.emission.pixels.size(); i++)
                if (i % 4 != 3) drawn_.emission.pixels[i] *= layer.image.pixels[is_even ? 0 : i - i % 4];
        }
    }

    // Textures and factors hold 0 to 1; brighter light needs a strength.
    void emission() {
        std::array<Range, 3> channels{};
        float brightest = 0;
        for (std::size_t c = 0; c < 3; c++) {
            channels[c] = range(drawn_.emission, int(c));
            if (channels[c].low < -kSlack) lose("emission below 0", "glTF emits no negative light");
            brightest = std::max(brightest, channels[c].high);
        }
        if (brightest <= 0) return;
        if (state_.is_specular && brightest > 1 + kSlack)
            lose(fmt::format("emission above 1, up to {:.3g},", brightest),
                 "glTF allows no emissive strength together with specular and glossiness");
        const float strength = state_.is_specular ? 1 : std::max(brightest, 1.0f);
        out_.material.emissive_strength = strength;
        if (is_constant(channels)) {
            out_.material.emission = glm::clamp(middle(channels) / double(strength), 0.0, 1.0);
            return;
        }
        Image scaled = picked(drawn_.emission, {0, 1, 2, std::nullopt});
        for (std::size_t i = 0; i < scaled.pixels.size(); i++)
            if (i % 4 != 3) scaled.pixels[i] = std::clamp(scaled.pixels[i] / strength, 0.0f, 1.0f);
        out_.material.emission = glm::dvec3(1);
        out_.material.emission_texture = add_map("emissive", true, std::move(scaled));
    }

    BakedTargets& drawn_;
    const std::vector<LayerValue>& layers_;
    const BakedState& state_;
    std::vector<std::uint8_t> covered_;
    BakedMaterial out_{};
};

}  // namespace

BakedMaterial baked_material(const std::string& name, BakedTargets drawn, const std::vector<LayerValue>& layers,
                             const BakedState& state) {
    return Making(name, drawn, layers, state).run();
}

Outcome<std::string> encode_map(const BakedMap& map) {
    return map.is_color ? encode_png(map.image) : encode_png_data(map.image);
}

}  // namespace patina::runtime

// Simple Lit, Baked Lit and the Unlit shaders.
#include <fmt/format.h>

#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {
namespace {

constexpr std::array<double, 4> kWhite{1, 1, 1, 1};

struct Main {
    std::string uv{}, node{};
};
Main main_texture(MaterialMaker& maker, const std::string& texture, bool is_tinted = true) {
    Main made{.uv = maker.tiled(texture, "@uv0", "uv")};
    if (maker.has_picture(texture))
        made.node = maker.sample(texture, "main", "color", "white", made.uv);
    else
        maker.taken(texture, is_tinted ? "none: the colour alone" : "none: white");
    return made;
}

// Only if something reads it: a property that nothing reads is none.
std::string alpha_of(MaterialMaker& maker, const RenderState& state, const Main& main, const std::string& color) {
    return state.reads_alpha() ? maker.alpha(main.node, color, kWhite) : std::string();
}

// What alpha does to a colour, if the surface is additive or multiplies.
std::string weighted(const RenderState& state, const std::string& color, const std::string& alpha) {
    if (alpha.empty()) return color;
    if (state.is_weighted) return product({color, alpha});
    return state.is_alpha_modulated ? fmt::format("lerp(float3(1), {}, {})", color, alpha) : color;
}

void normal_map(MaterialMaker& maker, const std::string& uv) {
    const bool is_on = maker.keyword("_NORMALMAP", "the input 'normalTS'", "_BumpMap");
    maker.taken("_BumpScale", "it has no effect: this shader does not read it");
    if (is_on && maker.has_picture("_BumpMap"))
        maker.set("normalTS", maker.sample("_BumpMap", "bumps", "normal", "bump", uv));
    else
        maker.idle({"_BumpMap"}, is_on ? "there is no normal map" : "the keyword _NORMALMAP is off");
}

// Unity's exponent of a smoothness: 2 to 2048.
std::string exponent_of(const std::string& smoothness) {
    return fmt::format("exp2(10 * {} + 1)", smoothness);
}

void highlight(MaterialMaker& maker, const Main& main) {
    const bool has_map = maker.keyword("_SPECGLOSSMAP", "the highlight, from '_SpecGlossMap'", "_SpecGlossMap");
    const bool has_color = maker.keyword("_SPECULAR_COLOR", "the highlight, of '_SpecColor'");
    const bool is_alpha = maker.keyword("_GLOSSINESS_FROM_BASE_ALPHA", "smoothness is the alpha of the surface");
    maker.taken("_Smoothness", "it concerns the inspector alone, which writes it into the alpha of a colour");
    if (!has_map && !has_color) {
        maker.idle({"_SpecColor", "_SpecGlossMap"}, "the keywords _SPECGLOSSMAP and _SPECULAR_COLOR are off");
        maker.set("specularColor", "0");
        return;
    }
    const std::string tint = maker.color_property("_SpecColor", {0.5, 0.5, 0.5, 0.5});
    std::string texel;
    if (has_map)
        texel = maker.sample("_SpecGlossMap", "specGloss", "color", "white", main.uv);
    else
        maker.idle({"_SpecGlossMap"}, "the keyword _SPECGLOSSMAP is off");
    maker.set("specularColor", product({texel.empty() ? texel : texel + ".rgb", tint + ".rgb"}));
    std::string smoothness = product({texel.empty() ? texel : texel + ".a", tint + ".a"});
    if (is_alpha) {
        const std::string alpha = maker.alpha(main.node, "_BaseColor", kWhite);
        smoothness = alpha.empty() ? "1" : alpha;
    }
    maker.set("exponent", exponent_of(smoothness));
}

}  // namespace

void make_simple_lit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "specular-glossiness";
    maker.graph.lighting = "blinn-phong";
    maker.graph.lighting_inputs = {{"_Normalization", text("Classic")}};
    const Main main = main_texture(maker, "_BaseMap");
    const std::string alpha = alpha_of(maker, state, main, "_BaseColor");
    maker.set("baseColor", weighted(state, maker.tinted(main.node, "_BaseColor", kWhite), alpha));
    // The diffuse colour is the base colour, whatever the highlight.
    maker.set("specular", "0");
    highlight(maker, main);
    normal_map(maker, main.uv);
    maker.emission(main.uv, true);
    maker.coverage(state, alpha);
}

void make_baked_lit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "specular-glossiness";
    maker.graph.lighting = "lambert";
    const Main main = main_texture(maker, "_BaseMap");
    const std::string alpha = alpha_of(maker, state, main, "_BaseColor");
    maker.set("baseColor", weighted(state, maker.tinted(main.node, "_BaseColor", kWhite), alpha));
    maker.set("specular", "0");
    normal_map(maker, main.uv);
    maker.coverage(state, alpha);
}

void make_unlit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "unlit";
    const Family family = maker.shader().family;
    if (family == Family::UnlitColor) {
        maker.set("color", maker.color_property("_Color", kWhite) + ".rgb");
        return;
    }
    if (family == Family::Unlit || maker.shader().is_guessed) {
        const bool is_universal = family == Family::Unlit;
        const std::string color = is_universal ? "_BaseColor" : "_Color";
        const Main main = main_texture(maker, is_universal ? "_BaseMap" : "_MainTex");
        const std::string alpha = alpha_of(maker, state, main, color);
        maker.set("color", weighted(state, maker.tinted(main.node, color, kWhite), alpha));
        maker.coverage(state, alpha);
        return;
    }
    const Main main = main_texture(maker, "_MainTex", false);
    maker.set("color", main.node.empty() ? "1" : main.node + ".rgb");
    maker.coverage(state, main.node.empty() ? std::string() : main.node + ".a");
}

}  // namespace patina::importers::unitymaterial

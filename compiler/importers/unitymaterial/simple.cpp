// Simple Lit, Baked Lit and the Unlit shaders.
#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {
namespace {

constexpr std::array<double, 4> kWhite{1, 1, 1, 1};

struct Main {
    Term uv{}, texel = white();
};
Main main_texture(MaterialMaker& maker, const std::string& texture, bool is_tinted = true) {
    Main made{.uv = maker.tiled(texture, link("@uv0", Type::Float2), "uv")};
    if (maker.has_picture(texture))
        made.texel = maker.sample(texture, "main", "color", "white", made.uv);
    else
        maker.taken(texture, is_tinted ? "none: the colour alone" : "none: white");
    return made;
}

// Only if something reads it: a property that nothing reads is none.
Term alpha_of(MaterialMaker& maker, const RenderState& state, const Main& main, const std::string& color) {
    return state.reads_alpha() ? maker.alpha(main.texel, color, kWhite) : number_term(1);
}

void normal_map(MaterialMaker& maker, const Term& uv) {
    const bool is_on = maker.keyword("_NORMALMAP", "the input 'normalTS'", "_BumpMap");
    maker.taken("_BumpScale", "it has no effect: this shader does not read it");
    if (is_on && maker.has_picture("_BumpMap"))
        maker.set("normalTS", maker.sample("_BumpMap", "bumps", "normal", "bump", uv));
    else
        maker.idle({"_BumpMap"}, is_on ? "there is no normal map" : "the keyword _NORMALMAP is off");
}

// Unity's exponent of a smoothness: 2 to 2048.
Term exponent_of(const Term& smoothness) {
    return computed("exp2(a + 1)", {product({number_term(10), smoothness})}, Type::Float);
}

void highlight(MaterialMaker& maker, const Main& main) {
    const bool has_map = maker.keyword("_SPECGLOSSMAP", "the highlight, from '_SpecGlossMap'", "_SpecGlossMap");
    const bool has_color = maker.keyword("_SPECULAR_COLOR", "the highlight, of '_SpecColor'");
    const bool is_alpha = maker.keyword("_GLOSSINESS_FROM_BASE_ALPHA", "smoothness is the alpha of the surface");
    maker.taken("_Smoothness", "it concerns the inspector alone, which writes it into the alpha of a colour");
    if (!has_map && !has_color) {
        maker.idle({"_SpecColor", "_SpecGlossMap"}, "the keywords _SPECGLOSSMAP and _SPECULAR_COLOR are off");
        maker.set("specularColor", number_term(0));
        return;
    }
    const Term tint = maker.color_property("_SpecColor", {0.5, 0.5, 0.5, 0.5});
    Term texel = white();
    if (has_map)
        texel = maker.sample("_SpecGlossMap", "specGloss", "color", "white", main.uv);
    else
        maker.idle({"_SpecGlossMap"}, "the keyword _SPECGLOSSMAP is off");
    maker.set("specularColor", computed("a.rgb * b.rgb", {texel, tint}, Type::Float3));
    const Term smoothness =
        is_alpha ? maker.alpha(main.texel, "_BaseColor", kWhite) : computed("a.a * b.a", {texel, tint}, Type::Float);
    maker.set("exponent", exponent_of(smoothness));
}

}  // namespace

void make_simple_lit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "specular-glossiness";
    maker.graph.lighting = "blinn-phong";
    maker.graph.lighting_inputs = {{"_Normalization", "Classic"}};
    const Main main = main_texture(maker, "_BaseMap");
    const Term alpha = alpha_of(maker, state, main, "_BaseColor");
    maker.set("baseColor", state.weighted(maker.tinted(main.texel, "_BaseColor", kWhite), alpha));
    // The diffuse colour is the base colour, whatever the highlight.
    maker.set("specular", number_term(0));
    highlight(maker, main);
    normal_map(maker, main.uv);
    maker.emission(main.uv, true);
    maker.coverage(state, alpha);
}

void make_baked_lit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "specular-glossiness";
    maker.graph.lighting = "lambert";
    const Main main = main_texture(maker, "_BaseMap");
    const Term alpha = alpha_of(maker, state, main, "_BaseColor");
    maker.set("baseColor", state.weighted(maker.tinted(main.texel, "_BaseColor", kWhite), alpha));
    maker.set("specular", number_term(0));
    normal_map(maker, main.uv);
    maker.coverage(state, alpha);
}

void make_unlit(MaterialMaker& maker, const RenderState& state) {
    maker.graph.workflow = "unlit";
    const Family family = maker.shader().family;
    if (family == Family::UnlitColor) {
        maker.set("color", swizzled(maker.color_property("_Color", kWhite), "rgb"));
        return;
    }
    if (family == Family::Unlit || maker.shader().is_guessed) {
        const bool is_universal = family == Family::Unlit;
        const std::string color = is_universal ? "_BaseColor" : "_Color";
        const Main main = main_texture(maker, is_universal ? "_BaseMap" : "_MainTex");
        const Term alpha = alpha_of(maker, state, main, color);
        maker.set("color", state.weighted(maker.tinted(main.texel, color, kWhite), alpha));
        maker.coverage(state, alpha);
        return;
    }
    const Main main = main_texture(maker, "_MainTex", false);
    maker.set("color", swizzled(main.texel, "rgb"));
    maker.coverage(state, swizzled(main.texel, "a"));
}

}  // namespace patina::importers::unitymaterial

// Standard of the built-in pipeline, and Lit of the universal pipeline: the same maps under other names.
#include <fmt/format.h>

#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {
namespace {

constexpr std::array<double, 4> kWhite{1, 1, 1, 1};
constexpr std::array<double, 4> kSpecular{0.2, 0.2, 0.2, 1};

struct Names {
    std::string texture, color;
    std::string smoothness, map_smoothness;  // without and with a map
    std::string map_keyword;                 // of the metallic or the specular map
};
Names standard_names(bool is_specular) {
    return {.texture = "_MainTex",
            .color = "_Color",
            .smoothness = "_Glossiness",
            .map_smoothness = "_GlossMapScale",
            .map_keyword = is_specular ? "_SPECGLOSSMAP" : "_METALLICGLOSSMAP"};
}
Names universal_names() {
    return {.texture = "_BaseMap",
            .color = "_BaseColor",
            .smoothness = "_Smoothness",
            .map_smoothness = "_Smoothness",
            .map_keyword = "_METALLICSPECGLOSSMAP"};
}

class LitMaker {
public:
    LitMaker(MaterialMaker& maker, const RenderState& state) : maker_(maker), state_(state) {
        is_universal_ = maker.shader().family == Family::UniversalLit;
        is_specular_ = is_universal_ ? maker.keyword("_SPECULAR_SETUP", "the workflow 'specular-glossiness'")
                                     : maker.shader().is_specular;
        names_ = is_universal_ ? universal_names() : standard_names(is_specular_);
    }

    void make() {
        maker_.graph.workflow = is_specular_ ? "specular-glossiness" : "metallic-smoothness";
        maker_.graph.lighting = is_universal_ ? "unity-brdf2" : "unity-brdf1";
        coordinates();
        if (maker_.has_picture(names_.texture))
            main_ = maker_.sample(names_.texture, "main", "color", "white", uv_);
        else
            maker_.taken(names_.texture, "none: the colour alone");
        has_smooth_albedo_ = maker_.keyword("_SMOOTHNESS_TEXTURE_ALBEDO_CHANNEL_A",
                                            fmt::format("smoothness is the alpha of '{}'", names_.texture));
        const Term alpha = state_.reads_alpha()
                               ? maker_.alpha(has_smooth_albedo_ ? white() : main_, names_.color, kWhite)
                               : number_term(1);
        base_color(alpha);
        reflection();
        normal();
        occlusion();
        maker_.emission(uv_, is_universal_);
        maker_.coverage(state_, alpha);
        coat();
    }

private:
    void coordinates() {
        uv_ = maker_.tiled(names_.texture, uv_, "uv");
        const bool is_scaled = maker_.keyword("_DETAIL_SCALED", "detail maps");
        const bool has_detail = maker_.keyword("_DETAIL_MULX2", "detail maps", "_DetailAlbedoMap") || is_scaled;
        const bool is_second = !is_universal_ && maker_.number("_UVSec", 0) == 1;
        if (has_detail) {
            maker_.taken("_UVSec", is_second ? "@uv1" : "@uv0");
        } else {
            maker_.idle({"_DetailAlbedoMap", "_DetailMask", "_DetailNormalMap", "_DetailNormalMapScale",
                         "_DetailAlbedoMapScale", "_UVSec"},
                        "the keyword _DETAIL_MULX2 is off");
        }
        has_detail_ = has_detail;
        bool is_moved = false;
        if (maker_.keyword("_PARALLAXMAP", "the height map moves the texture coordinates", "_ParallaxMap") &&
            maker_.has_picture("_ParallaxMap")) {
            maker_.node({.id = "viewDirTS", .node = "WorldToTangent"});
            const Term height = maker_.sample("_ParallaxMap", "height", "data", "black", uv_);
            const Term depth = maker_.number_property("_Parallax", is_universal_ ? 0.005 : 0.02, 0.005, 0.08);
            maker_.node(
                {.id = "parallax",
                 .node = "ParallaxOffset",
                 .inputs = {
                     {"texel", swizzled(height, "g").value()}, {"height", depth.value()}, {"viewTS", "viewDirTS"}}});
            uv_ = moved(uv_, "moved");
            is_moved = true;
        } else {
            maker_.idle({"_Parallax", "_ParallaxMap"}, "there is no height map");
        }
        if (!has_detail) return;
        // In the universal pipeline, the detail maps lie upon the tiled and moved main maps.
        detail_uv_ = maker_.tiled("_DetailAlbedoMap",
                                  is_universal_ ? uv_ : link(is_second ? "@uv1" : "@uv0", Type::Float2), "detailUV");
        if (!is_universal_ && is_moved) detail_uv_ = moved(detail_uv_, "movedDetail");
    }

    Term moved(const Term& uv, const std::string& id) {
        maker_.node({.id = id, .expression = computed("a + parallax", {uv}, Type::Float2).text()});
        return link(id, Type::Float2);
    }

    void base_color(const Term& alpha) {
        Term color = maker_.tinted(main_, names_.color, kWhite);
        if (has_detail_) color = detailed(color);
        maker_.set("baseColor", state_.weighted(color, alpha));
    }

    Term detailed(const Term& color) {
        if (maker_.has_picture("_DetailMask"))
            mask_ = swizzled(maker_.sample("_DetailMask", "mask", "data", "white", uv_), "a");
        else
            maker_.taken("_DetailMask", "none: the detail maps are everywhere");
        // The grey of a texture that is missing darkens by 2 percent in the built-in pipeline, and not in the other
        // one.
        if (is_universal_ && !maker_.has_picture("_DetailAlbedoMap")) {
            maker_.idle({"_DetailAlbedoMap", "_DetailAlbedoMapScale"}, "there is no detail texture");
            return color;
        }
        Term detail = swizzled(maker_.sample("_DetailAlbedoMap", "detail", "color", "gray", detail_uv_), "rgb");
        if (maker_.keyword("_DETAIL_SCALED", "detail maps"))
            detail = computed("lerp(float3(0.5), a, b)",
                              {detail, maker_.number_property("_DetailAlbedoMapScale", 1, 0, 2)}, Type::Float3);
        else
            maker_.idle({"_DetailAlbedoMapScale"}, "the keyword _DETAIL_SCALED is off");
        ImportedNode made{
            .id = "detailed", .node = "DetailAlbedo", .inputs = {{"base", color.value()}, {"detail", detail.value()}}};
        if (!mask_.is_constant()) made.inputs.push_back({"mask", mask_.value()});
        if (is_universal_) {
            made.inputs.push_back({"space", "Gamma"});
            made.more.push_back({"note", "Unity's universal pipeline doubles the texel in linear colours, too."});
        }
        maker_.node(std::move(made));
        return link("detailed", Type::Float3);
    }

    // Metallic or specular, and smoothness.
    void reflection() {
        const std::string map = is_specular_ ? "_SpecGlossMap" : "_MetallicGlossMap";
        const std::string input = is_specular_ ? "specular" : "metallic";
        const bool has_map = maker_.keyword(names_.map_keyword, fmt::format("the map '{}'", map), map);
        Term texel = white();
        if (has_map) {
            texel = maker_.sample(map, is_specular_ ? "specGloss" : "metallicGloss", is_specular_ ? "color" : "data",
                                  "white", uv_);
            maker_.set(input, swizzled(texel, is_specular_ ? "rgb" : "r"));
            maker_.idle({is_specular_ ? "_SpecColor" : "_Metallic"}, "there is a map");
        } else {
            maker_.set(input,
                       is_specular_ ? swizzled(maker_.color_property("_SpecColor", kSpecular), "rgb") : metallic());
            if (is_specular_)
                maker_.idle({"_SpecGlossMap"}, fmt::format("the keyword {} is off", names_.map_keyword));
            else
                maker_.idle({"_MetallicGlossMap"}, fmt::format("the keyword {} is off", names_.map_keyword));
        }
        const Term from = has_smooth_albedo_ ? main_ : texel;
        const bool is_mapped = has_map || has_smooth_albedo_;
        const std::string& slider = is_mapped ? names_.map_smoothness : names_.smoothness;
        Term smoothness = swizzled(from, "a");
        if (from.is_constant() || maker_.number(slider, is_universal_ ? 0.5 : 1) != 1)
            smoothness =
                product({smoothness, maker_.number_property(slider, is_mapped && !is_universal_ ? 1 : 0.5, 0, 1)});
        maker_.taken(slider, "1: the texture alone");
        if (!is_universal_) {
            if (is_mapped)
                maker_.idle({"_Glossiness"}, "smoothness is in a texture");
            else
                maker_.idle({"_GlossMapScale"}, "smoothness is in no texture");
        }
        maker_.set(is_specular_ ? "glossiness" : "smoothness", smoothness);
    }

    // The built-in pipeline decodes the slider as colours are.
    Term metallic() {
        const double value = maker_.number("_Metallic", 0);
        const Term property = maker_.number_property("_Metallic", 0, 0, 1);
        return is_universal_ || value == 0 || value == 1 ? property
                                                         : computed("SrgbToLinear(a).x", {property}, Type::Float);
    }

    // A normal map; its scale is a property unless it is 1.
    Term bumps(const std::string& map, const std::string& scale, const std::string& id, const Term& uv) {
        Term strength = number_term(1);
        if (maker_.number(scale, 1) == 1)
            maker_.taken(scale, "1: the texture alone");
        else
            strength = maker_.number_property(scale, 1, -2, 2);
        return maker_.sample(map, id, "normal", "bump", uv, strength);
    }

    void normal() {
        const bool has_normal = maker_.keyword("_NORMALMAP", "normal maps", "_BumpMap");
        const bool has_main = has_normal && maker_.has_picture("_BumpMap");
        const bool has_more = has_detail_ && (has_normal || is_universal_) && maker_.has_picture("_DetailNormalMap");
        Term made = constant({0, 0, 1});
        if (has_main)
            made = bumps("_BumpMap", "_BumpScale", "bumps", uv_);
        else
            maker_.idle({"_BumpMap", "_BumpScale"},
                        has_normal ? "there is no normal map" : "the keyword _NORMALMAP is off");
        if (has_more) {
            const Term detail = bumps("_DetailNormalMap", "_DetailNormalMapScale", "detailBumps", detail_uv_);
            ImportedNode node{.id = "detailedBumps", .node = "DetailNormal"};
            if (!made.is_constant()) node.inputs.push_back({"base", made.value()});
            node.inputs.push_back({"detail", detail.value()});
            if (!mask_.is_constant()) node.inputs.push_back({"mask", mask_.value()});
            if (is_universal_) node.inputs.push_back({"mode", "Reoriented"});
            maker_.node(std::move(node));
            made = link("detailedBumps", Type::Float3);
        } else {
            maker_.idle({"_DetailNormalMap", "_DetailNormalMapScale"}, "there is no detail normal map");
        }
        if (!made.is_constant()) maker_.set("normalTS", made);
    }

    void occlusion() {
        const bool is_on = !is_universal_ || maker_.keyword("_OCCLUSIONMAP", "the input 'occlusion'", "_OcclusionMap");
        if (!is_on || !maker_.has_picture("_OcclusionMap")) {
            maker_.idle({"_OcclusionMap", "_OcclusionStrength"},
                        is_on ? "there is no occlusion map" : "the keyword _OCCLUSIONMAP is off");
            return;
        }
        const Term cavity = swizzled(maker_.sample("_OcclusionMap", "cavity", "data", "white", uv_), "g");
        if (maker_.number("_OcclusionStrength", 1) == 1) {
            maker_.taken("_OcclusionStrength", "1: the texture alone");
            maker_.set("occlusion", cavity);
            return;
        }
        maker_.node({.id = "occlusion",
                     .node = "OcclusionStrength",
                     .inputs = {{"occlusion", cavity.value()},
                                {"strength", maker_.number_property("_OcclusionStrength", 1, 0, 1).value()}}});
        maker_.set("occlusion", link("occlusion", Type::Float));
    }

    // Of Complex Lit.
    void coat() {
        for (const char* each : {"_CLEARCOAT", "_CLEARCOATMAP"})
            if (maker_.keyword(each, {})) maker_.change_keyword(each, "the surface has no coat");
        maker_.idle({"_ClearCoatMask", "_ClearCoatSmoothness", "_ClearCoatMap"}, "the surface has no coat");
    }

    MaterialMaker& maker_;
    const RenderState& state_;
    bool is_universal_ = false, is_specular_ = false, has_detail_ = false, has_smooth_albedo_ = false;
    Names names_{};
    Term uv_ = link("@uv0", Type::Float2), detail_uv_{};
    Term main_ = white(), mask_ = number_term(1);
};

}  // namespace

void make_lit(MaterialMaker& maker, const RenderState& state) {
    LitMaker(maker, state).make();
}

}  // namespace patina::importers::unitymaterial

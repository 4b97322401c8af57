// Lit of the high definition pipeline ("HDRP/Lit"): metal, occlusion and smoothness in one map.
#include <fmt/format.h>

#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {
namespace {

constexpr std::array<double, 4> kWhite{1, 1, 1, 1};

// Features that a graph does not have.
struct Feature {
    std::string_view keyword, text;
    std::string_view property = {}, second = {};
};
constexpr Feature kFeatures[] = {
    {"_MATERIAL_FEATURE_SUBSURFACE_SCATTERING", "light does not go below the surface", "_SubsurfaceMask"},
    {"_MATERIAL_FEATURE_TRANSMISSION", "no light shines through it from behind", "_Thickness", "_ThicknessMap"},
    {"_MATERIAL_FEATURE_ANISOTROPY", "highlights have the same width in all directions", "_Anisotropy"},
    {"_MATERIAL_FEATURE_IRIDESCENCE", "highlights have no colours of a thin film", "_IridescenceMask"},
    {"_MATERIAL_FEATURE_CLEAR_COAT", "the surface has no coat", "_CoatMask", "_CoatMaskMap"},
    {"_DETAIL_MAP", "the detail map is left out", "_DetailMap"},
    {"_PIXEL_DISPLACEMENT", "the height map does not move the texture coordinates", "_HeightMap"},
    {"_VERTEX_DISPLACEMENT", "the height map moves no vertices", "_HeightMap"},
    {"_BENTNORMALMAP", "ambient light reads the normal map", "_BentNormalMap"},
    {"_REFRACTION_PLANE", "light goes straight through it"},
    {"_REFRACTION_SPHERE", "light goes straight through it"},
    {"_REFRACTION_THIN", "light goes straight through it"},
    {"_MAPPING_PLANAR", "textures are at @uv0, and not projected from above"},
    {"_MAPPING_TRIPLANAR", "textures are at @uv0, and not projected from three sides"},
    {"_ENABLE_GEOMETRIC_SPECULAR_AA", "highlights are not widened where the mesh is curved"},
};

class HighDefinitionMaker {
public:
    HighDefinitionMaker(MaterialMaker& maker, const RenderState& state) : maker_(maker), state_(state) {
        is_specular_ = maker.keyword("_MATERIAL_FEATURE_SPECULAR_COLOR", "the workflow 'specular-glossiness'");
    }

    void make() {
        maker_.graph.workflow = is_specular_ ? "specular-glossiness" : "metallic-smoothness";
        maker_.graph.lighting = "unity-brdf1";
        uv_ = maker_.tiled("_BaseColorMap", channel("_UVBase"), "uv");
        if (maker_.has_picture("_BaseColorMap"))
            main_ = maker_.sample("_BaseColorMap", "main", "color", "white", uv_);
        else
            maker_.taken("_BaseColorMap", "none: the colour alone");
        if (maker_.keyword("_MASKMAP", "metal, occlusion and smoothness are in '_MaskMap'", "_MaskMap"))
            mask_ = maker_.sample("_MaskMap", "mask", "data", "white", uv_);
        else
            maker_.idle({"_MaskMap"}, "the keyword _MASKMAP is off");
        const Term alpha =
            state_.reads_alpha() ? remapped(maker_.alpha(main_, "_BaseColor", kWhite), "_AlphaRemap") : number_term(1);
        const Term color = base_color(alpha);
        reflection();
        smoothness();
        normal();
        if (!mask_.is_constant()) maker_.set("occlusion", remapped(swizzled(mask_, "g"), "_AORemap"));
        emission(color);
        maker_.coverage(state_, alpha, "_AlphaCutoff");
        features();
    }

private:
    Term channel(const std::string& property) {
        const double number = maker_.number(property, 0);
        if (number == 0 || number == 1) {
            maker_.taken(property, number == 1 ? "@uv1" : "@uv0");
            return link(number == 1 ? "@uv1" : "@uv0", Type::Float2);
        }
        maker_.note(property, Remark::Kind::Changed, "@uv0: the graph reads no other coordinates");
        return link("@uv0", Type::Float2);
    }

    // "lerp(min, max, value)" of the properties NAMEMin and NAMEMax.
    Term remapped(const Term& value, const std::string& name) {
        const std::string low = name + "Min", high = name + "Max";
        if (maker_.number(low, 0) == 0 && maker_.number(high, 1) == 1) {
            maker_.taken(low, "0: the texture alone");
            maker_.taken(high, "1: the texture alone");
            return value;
        }
        const Term from = maker_.number_property(low, 0, 0, 1), to = maker_.number_property(high, 1, 0, 1);
        return computed("lerp(a, b, c)", {from, to, value}, Type::Float);
    }

    Term base_color(const Term& alpha) {
        const Term color = state_.weighted(maker_.tinted(main_, "_BaseColor", kWhite), alpha);
        if (!is_specular_) {
            maker_.set("baseColor", color);
            return color;
        }
        const Term tint = maker_.color_property("_SpecularColor", kWhite);
        Term texel = white();
        if (maker_.keyword("_SPECULARCOLORMAP", "the input 'specular'", "_SpecularColorMap"))
            texel = maker_.sample("_SpecularColorMap", "specular", "color", "white", uv_);
        else
            maker_.idle({"_SpecularColorMap"}, "the keyword _SPECULARCOLORMAP is off");
        const bool is_conserving = maker_.number("_EnergyConservingSpecularColor", 1) > 0;
        maker_.note("_EnergyConservingSpecularColor", is_conserving ? Remark::Kind::Taken : Remark::Kind::Changed,
                    is_conserving ? "a bright highlight darkens the diffuse colour"
                                  : "a bright highlight darkens the diffuse colour, although this is off");
        maker_.set("baseColor", color);
        maker_.set("specular", computed("a.rgb * b.rgb", {texel, tint}, Type::Float3));
        return color;
    }

    void reflection() {
        if (is_specular_) {
            maker_.idle({"_Metallic", "_MetallicRemapMin", "_MetallicRemapMax"},
                        "the highlight has a colour of its own");
            return;
        }
        maker_.idle({"_SpecularColor", "_SpecularColorMap", "_EnergyConservingSpecularColor"},
                    "the keyword _MATERIAL_FEATURE_SPECULAR_COLOR is off");
        if (mask_.is_constant()) {
            maker_.idle({"_MetallicRemapMin", "_MetallicRemapMax"}, "there is no mask map");
            maker_.set("metallic", maker_.number_property("_Metallic", 0, 0, 1));
        } else if (maker_.source().has("_MetallicRemapMax")) {
            maker_.idle({"_Metallic"}, "there is a mask map");
            maker_.set("metallic", remapped(swizzled(mask_, "r"), "_MetallicRemap"));
        } else if (maker_.number("_Metallic", 0) == 1) {
            maker_.taken("_Metallic", "1: the texture alone");
            maker_.set("metallic", swizzled(mask_, "r"));
        } else {
            // Before the remapping of metal, its number was a factor.
            maker_.set("metallic",
                       computed("a.r * b", {mask_, maker_.number_property("_Metallic", 0, 0, 1)}, Type::Float));
        }
    }

    void smoothness() {
        const std::string input = is_specular_ ? "glossiness" : "smoothness";
        if (mask_.is_constant()) {
            maker_.set(input, maker_.number_property("_Smoothness", 0.5, 0, 1));
            maker_.idle({"_SmoothnessRemapMin", "_SmoothnessRemapMax", "_AORemapMin", "_AORemapMax"},
                        "there is no mask map");
            return;
        }
        maker_.set(input, remapped(swizzled(mask_, "a"), "_SmoothnessRemap"));
        maker_.idle({"_Smoothness"}, "there is a mask map");
    }

    void normal() {
        const bool has_normal = maker_.keyword("_NORMALMAP", "normal maps", "_NormalMap");
        const bool is_tangent =
            maker_.keyword("_NORMALMAP_TANGENT_SPACE", "a normal map in tangent space") || maker_.shader().is_guessed;
        if (has_normal && is_tangent && maker_.has_picture("_NormalMap")) {
            Term strength = number_term(1);
            if (maker_.number("_NormalScale", 1) == 1)
                maker_.taken("_NormalScale", "1: the texture alone");
            else
                strength = maker_.number_property("_NormalScale", 1, 0, 8);
            maker_.set("normalTS", maker_.sample("_NormalMap", "bumps", "normal", "bump", uv_, strength));
            return;
        }
        if (has_normal && !is_tangent && maker_.has_picture("_NormalMapOS"))
            maker_.note("_NormalMapOS", Remark::Kind::Changed, "a normal map in object space is left out");
        maker_.idle({"_NormalMap", "_NormalScale"},
                    has_normal ? "there is no normal map in tangent space" : "the keyword _NORMALMAP is off");
    }

    void emission(const Term& color) {
        const std::array<double, 4> light = maker_.color("_EmissiveColor", {0, 0, 0, 1});
        if (light[0] == 0 && light[1] == 0 && light[2] == 0) {
            maker_.idle({"_EmissiveColor", "_EmissiveColorMap", "_AlbedoAffectEmissive", "_EmissiveExposureWeight"},
                        "the colour is black");
            return;
        }
        Term glow = white();
        if (maker_.keyword("_EMISSIVE_COLOR_MAP", "the input 'emission'", "_EmissiveColorMap") &&
            maker_.has_picture("_EmissiveColorMap")) {
            const Term uv = maker_.tiled("_EmissiveColorMap", channel("_UVEmissive"), "emissionUV");
            glow = maker_.sample("_EmissiveColorMap", "glow", "color", "white", uv);
        } else {
            maker_.taken("_EmissiveColorMap", "none: the colour alone");
        }
        const Term tint = maker_.light_property(
            "_EmissiveColor", light, "it is not multiplied by the camera's exposure, which a graph does not have");
        const bool is_tinted = maker_.number("_AlbedoAffectEmissive", 0) != 0;
        maker_.taken("_AlbedoAffectEmissive", is_tinted ? "the base colour tints the light" : "the light alone");
        maker_.taken("_EmissiveExposureWeight", "it concerns the camera's exposure alone");
        for (const char* each :
             {"_EmissiveColorLDR", "_EmissiveIntensity", "_EmissiveIntensityUnit", "_UseEmissiveIntensity"})
            maker_.taken(each, "it concerns the inspector alone, which sets '_EmissiveColor' by it");
        maker_.set("emission",
                   product({swizzled(glow, "rgb"), swizzled(tint, "rgb"), is_tinted ? color : number_term(1)}));
    }

    void features() {
        for (const Feature& each : kFeatures) {
            const std::string keyword(each.keyword), text(each.text);
            if (!maker_.keyword(keyword, {})) continue;
            maker_.change_keyword(keyword, text);
            for (const std::string_view property : {each.property, each.second})
                if (!property.empty()) maker_.note(std::string(property), Remark::Kind::Changed, text);
        }
        maker_.taken("_MaterialID", "it concerns the inspector alone, which sets keywords by it");
    }

    MaterialMaker& maker_;
    const RenderState& state_;
    bool is_specular_ = false;
    Term uv_{};
    Term main_ = white(), mask_ = main_;
};

}  // namespace

void make_high_definition(MaterialMaker& maker, const RenderState& state) {
    HighDefinitionMaker(maker, state).make();
}

}  // namespace patina::importers::unitymaterial

// What Unity's includes declare under names that nodes or artists use, too: a second function with the same parameters
// would not compile, and a macro would take the name's place.
#include <algorithm>
#include <vector>

#include "compiler/targets/shaderlab/shaderlab.h"

namespace patina::targets::shaderlab {
namespace {

constexpr std::string_view kLists[] = {
    // UnityCG.cginc
    R"(DecodeFloatRG DecodeFloatRGBA DecodeHDR DecodeLightmap EncodeFloatRG EncodeFloatRGBA GammaToLinearSpace
    Linear01Depth LinearEyeDepth LinearToGammaSpace Luminance ParallaxOffset ShadeSH9 UnpackNormal WorldSpaceViewDir
    appdata_base appdata_full appdata_tan)",
    // UnityStandardBRDF.cginc, UnityStandardUtils.cginc, UnityImageBasedLighting.cginc
    R"(BlendNormals DisneyDiffuse DotClamped FresnelLerp FresnelLerpFast FresnelTerm GGXTerm LerpOneTo LerpWhiteTo
    OneMinusReflectivityFromMetallic PerceptualRoughnessToRoughness Pow4 Pow5 PreMultiplyAlpha
    RoughnessToPerceptualRoughness SmoothnessToPerceptualRoughness SmoothnessToRoughness SpecularStrength
    UnpackScaleNormal)",
    // Macros, keywords among them.
    R"(DIRECTIONAL DIRECTIONAL_COOKIE FOG_EXP FOG_EXP2 FOG_LINEAR INSTANCING_ON LIGHTMAP_ON POINT POINT_COOKIE
    SHADOWS_CUBE SHADOWS_DEPTH SHADOWS_SCREEN SHADOWS_SOFT SPOT TRANSFORM_TEX VERTEXLIGHT_ON fixed2 fixed3 fixed4)",
    // What UNITY_LIGHT_ATTENUATION and UNITY_APPLY_FOG declare.
    R"(lightCoord shadow unityFogFactor)",
    // The file's own.
    R"(vert frag v2f)",
};

std::vector<std::string_view> words() {
    std::vector<std::string_view> made;
    for (std::string_view list : kLists) {
        while (!list.empty()) {
            const std::size_t end = std::min(list.find_first_of(" \n"), list.size());
            if (end > 0) made.push_back(list.substr(0, end));
            list.remove_prefix(std::min(end + 1, list.size()));
        }
    }
    return made;
}

}  // namespace

std::span<const std::string_view> taken_names() {
    static const std::vector<std::string_view> kTaken = words();
    return kTaken;
}

}  // namespace patina::targets::shaderlab

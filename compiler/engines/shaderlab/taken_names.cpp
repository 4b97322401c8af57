// What Unity's includes declare under names that nodes or artists use, too: a second function with the same parameters
// would not compile, and a macro would take the name's place. The lists hold what any of 2017.4, 2019.4 and 6000 has;
// behind a name may stand what a function of the library that has it is called instead.
#include <algorithm>
#include <vector>

#include "compiler/engines/shaderlab/dialect.h"

namespace patina::targets::shaderlab {
namespace {

constexpr std::string_view kLists[] = {
    // UnityShaderVariables.cginc; with these begin all of its other names
    R"(_CosTime _LightPositionRange _LightProjectionParams _LightShadowData _LightSplitsFar _LightSplitsNear
    _ProjectionParams _ScreenParams _SinTime _Time _WorldSpaceCameraPos _WorldSpaceLightPos0 _ZBufferParams)",
    // UnityCG.cginc
    R"(ComputeGrabScreenPos ComputeNonStereoScreenPos ComputeScreenPos DecodeDepthNormal DecodeDirectionalLightmap
    DecodeFloatRG=FloatFromRG DecodeFloatRGBA DecodeHDR=LightFromRGBM DecodeLightmap=LightFromLightmap
    DecodeLightmapDoubleLDR DecodeLightmapRGBM DecodeRealtimeLightmap DecodeViewNormalStereo EncodeDepthNormal
    EncodeFloatRG=FloatToRG EncodeFloatRGBA EncodeViewNormalStereo GammaToLinearSpace GammaToLinearSpaceExact
    IsGammaSpace Linear01Depth=DepthOfFarPlane LinearEyeDepth=DepthOfEye LinearRgbToLuminance LinearToGammaSpace
    LinearToGammaSpaceExact Luminance=RelativeLuminance MultiplyUV ObjSpaceLightDir ObjSpaceViewDir PackHeightmap
    ParallaxOffset=ParallaxShift SHEvalLinearL0L1 SHEvalLinearL0L1_SampleProbeVolume SHEvalLinearL2
    Shade4PointLights ShadeSH12Order ShadeSH3Order ShadeSH9 ShadeVertexLights ShadeVertexLightsFull
    TransformStereoScreenSpaceTex TransformViewToProjection UnpackHeightmap UnpackNormal=NormalFromTexel
    UnpackNormalDXT5nm UnpackNormalWithScale UnpackNormalmapRGorAG VertexLight WorldSpaceLightDir WorldSpaceViewDir
    appdata_base appdata_full appdata_img appdata_tan v2f_img v2f_vertex_lit vert_img)",
    // AutoLight.cginc, UnityShadowLibrary.cginc, UnityLightingCommon.cginc
    R"(LPPV_SampleProbeOcclusion SampleCubeDistance _LightColor0 _LightTexture0 _LightTextureB0 _ShadowMapTexture
    _CameraDepthTexture _ShadowMapTexture_TexelSize _ShadowOffsets _SpecColor)",
    // UnityStandardBRDF.cginc, UnityStandardUtils.cginc, UnityImageBasedLighting.cginc
    R"(BRDF1_Unity_PBS BRDF2_Unity_PBS BRDF3_Direct BRDF3_Indirect BRDF3_Unity_PBS BRDF_Unity_Indirect BlendNormals
    BlinnTerm BoxProjectedCubemapDirection CalculateSurfaceGradient CalculateSurfaceNormal
    CreateTangentToWorldPerVertex DiffuseAndSpecularFromMetallic DisneyDiffuse=DisneyDiffuseTerm DotClamped
    EnergyConservationBetweenDiffuseAndSpecular FresnelLerp=FresnelToGrazing FresnelLerpFast=FresnelToGrazingFast
    FresnelTerm GGXTerm GetLocalFrame GetSpecPowToMip Hammersley2d ImportanceSampleCosDir ImportanceSampleGGX
    ImportanceSampleGGXDir ImportanceSampleLambert InitRandom IntegrateDFG IntegrateDisneyDiffuseRef IntegrateLD
    IntegrateLambertDiffuseRef LambertTerm LerpOneTo LerpWhiteTo NDFBlinnPhongNormalizedTerm
    OneMinusReflectivityFromMetallic=DiffuseShareFromMetallic ParallaxOffset1Step PerceptualRoughnessToRoughness
    PerceptualRoughnessToSpecPower PerturbNormal Pow4 Pow5 PreMultiplyAlpha ReverseBits32
    RoughnessToPerceptualRoughness RoughnessToSpecPower ShadeSHPerPixel ShadeSHPerVertex
    SmithBeckmannVisibilityTerm SmithGGXVisibilityTerm SmithJointGGXVisibilityTerm SmithVisibilityTerm
    SmoothnessToPerceptualRoughness SmoothnessToRoughness SpecularStrength=BrightestSpecular UnpackScaleNormal
    UnpackScaleNormalDXT5nm UnpackScaleNormalRGorAG mipmapLevelToPerceptualRoughness
    perceptualRoughnessToMipmapLevel)",
    // UnityGlobalIllumination.cginc, UnityPBSLighting.cginc, UnityGBuffer.cginc
    R"(DecodeDirectionalSpecularLightmap LightingStandard LightingStandardSpecular
    LightingStandardSpecular_Deferred LightingStandardSpecular_GI LightingStandard_Deferred LightingStandard_GI
    MixLightmapWithRealtimeAttenuation ResetUnityGI ResetUnityLight
    SubtractMainLightWithRealtimeAttenuationFromLightmap SurfaceOutputStandard SurfaceOutputStandardSpecular)",
    // Macros, keywords among them.
    R"(COMPUTE_DEPTH_01 COMPUTE_EYEDEPTH COMPUTE_LIGHT_COORDS COMPUTE_VIEW_NORMAL DECLARE_LIGHT_COORD
    DECLARE_LIGHT_COORDS DECODE_EYEDEPTH DIRECTIONAL DIRECTIONAL_COOKIE DIRLIGHTMAP_COMBINED DIRLIGHTMAP_OFF
    DIRLIGHTMAP_SEPARATE DYNAMICLIGHTMAP_OFF DYNAMICLIGHTMAP_ON EDITOR_VISUALIZATION EMISSIVE_RGBM_SCALE FACE FOGC
    FOG_EXP FOG_EXP2 FOG_LINEAR HANDLE_SHADOWS_BLENDING_IN_GI INSTANCING_ON LIGHTING_COORDS LIGHTMAP_OFF
    LIGHTMAP_ON LIGHTMAP_RGBM_SCALE LIGHTMAP_SHADOW_MIXING LIGHTPROBE_SH LIGHT_ATTENUATION LOD_FADE_CROSSFADE
    LOD_FADE_PERCENTAGE POINT POINT_COOKIE POINT_NOATT PROCEDURAL_INSTANCING_ON READ_SHADOW_COORDS
    SAMPLE_DEPTH_TEXTURE SAMPLE_DEPTH_TEXTURE_LOD SAMPLE_DEPTH_TEXTURE_PROJ SCALED_NORMAL SHADOWS_CUBE
    SHADOWS_DEPTH SHADOWS_NATIVE SHADOWS_SCREEN SHADOWS_SHADOWMASK SHADOWS_SINGLE_CASCADE SHADOWS_SOFT
    SHADOWS_SPLIT_SPHERES SHADOW_ATTENUATION SHADOW_CASTER_FRAGMENT SHADOW_COORDS SOFTPARTICLES_ON SPOT
    STEREO_CUBEMAP_RENDER_ON STEREO_INSTANCING_ON STEREO_MULTIVIEW_ON SampleCubeReflection TANGENT_SPACE_ROTATION
    TRANSFER_SHADOW TRANSFER_SHADOW_CASTER TRANSFER_SHADOW_CASTER_NOPOS TRANSFER_SHADOW_CASTER_NORMALOFFSET
    TRANSFER_SHADOW_WPOS TRANSFER_VERTEX_TO_FRAGMENT TRANSFORM_TEX TRANSFORM_UV USING_DIRECTIONAL_LIGHT
    USING_LIGHT_MULTI_COMPILE V2F_SCREEN_TYPE V2F_SHADOW_CASTER V2F_SHADOW_CASTER_NOPOS VERTEXLIGHT_ON VFACE VPOS
    WPOS fixed fixed2 fixed2x2 fixed3 fixed3x3 fixed4 fixed4x4 INTERNAL_DATA WorldNormalVector
    WorldReflectionVector CBUFFER_START CBUFFER_END GLOBAL_CBUFFER_START GLOBAL_CBUFFER_END CUBEMAPFACE_POSITIVE_X
    CUBEMAPFACE_NEGATIVE_X CUBEMAPFACE_POSITIVE_Y CUBEMAPFACE_NEGATIVE_Y CUBEMAPFACE_POSITIVE_Z CUBEMAPFACE_NEGATIVE_Z
    sampler2D_float sampler2D_half sampler3D_float sampler3D_half samplerCUBE_float samplerCUBE_half Texture2D_float
    Texture2D_half Texture2DArray_float Texture2DArray_half Texture3D_float Texture3D_half TextureCube_float
    TextureCube_half TextureCubeArray_float TextureCubeArray_half)",
    // What UNITY_LIGHT_ATTENUATION and UNITY_APPLY_FOG declare.
    R"(lightCoord shadow unityFogFactor)",
};

// What the file itself declares.
constexpr std::string_view kOwn =
    R"(AmbientLight AmbientOrLightmapUV BackgroundColor BackgroundDepth BakedShadows GIInput LightType LinearColor
    MixedShadow NormalTexel ProjectColor ReflectedLight ReflectedLightOfBuffer SAMPLE_TEX2D_BIAS SAMPLE_TEX2D_GRAD
    SAMPLE_TEX2D_LOD SAMPLE_TEX2D_SAMPLER_BIAS SAMPLE_TEX2D_SAMPLER_GRAD SAMPLE_TEX2D_SAMPLER_LOD StoredLight
    _BackgroundTexture frag v2f vert)";

// The parameters and locals of `vert` and `frag`, and the buffer of instances: anything but a property may be called
// so, where it does not meet them.
constexpr std::string_view kOwnNearProperties[] = {"Instances", "i", "o", "v"};

// What else begins so is Unity's.
constexpr std::string_view kPrefixes[] = {"unity_",   "Unity",       "UNITY_",        "_Unity",
                                          "glstate_", "SHADER_API_", "SHADER_TARGET", "SHADER_STAGE_"};

struct Taken {
    std::string_view name, instead;
};

void add_words(std::string_view list, std::vector<Taken>& into) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find_first_of(" \n"), list.size());
        const std::string_view word = list.substr(0, end);
        const std::size_t sign = std::min(word.find('='), end);
        if (end > 0) into.push_back({word.substr(0, sign), word.substr(std::min(sign + 1, end))});
        list.remove_prefix(std::min(end + 1, list.size()));
    }
}

// Unity's names, and behind them the file's own.
struct AllTaken {
    std::vector<Taken> names;
    std::size_t unitys = 0;
};

const AllTaken& taken() {
    static const AllTaken kTaken = [] {
        AllTaken made;
        for (const std::string_view list : kLists) add_words(list, made.names);
        made.unitys = made.names.size();
        add_words(kOwn, made.names);
        return made;
    }();
    return kTaken;
}

}  // namespace

std::span<const std::string_view> taken_names() {
    static const std::vector<std::string_view> kNames = [] {
        std::vector<std::string_view> names;
        for (const Taken& each : taken().names) names.push_back(each.name);
        return names;
    }();
    return kNames;
}

std::string_view declarer_of(std::string_view name) {
    const std::span<const std::string_view> names = taken_names();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end() && found - names.begin() >= std::ptrdiff_t(taken().unitys)) return "the file itself";
    if (found != names.end() || std::any_of(std::begin(kPrefixes), std::end(kPrefixes),
                                            [&](std::string_view prefix) { return name.starts_with(prefix); }))
        return "one of Unity's includes";
    const auto* const end = std::end(kOwnNearProperties);
    return std::find(std::begin(kOwnNearProperties), end, name) != end ? "the file itself" : "";
}

std::string_view synonym(std::string_view function) {
    for (const Taken& each : taken().names) {
        if (each.name == function && !each.instead.empty()) return each.instead;
    }
    return function;
}

}  // namespace patina::targets::shaderlab

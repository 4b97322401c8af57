#include "compiler/importers/shadergraph/lost_settings.h"

#include <algorithm>
#include <array>

#include "compiler/importers/shadergraph/values/types.h"

namespace patina::importers::shadergraph {
namespace {

using Needs = LostSetting::Needs;

constexpr std::string_view kNoMotion = "there are no motion vectors", kOnce = "it is drawn once";

constexpr LostSetting kLost[] = {
    {"m_ClearCoat", "Clear Coat", 0, "the surface has no coat", "CoatMask CoatSmoothness"},
    {"m_CastShadows", "Cast Shadows", 1, "it casts shadows"},
    {"m_ReceiveShadows", "Receive Shadows", 1, "it receives shadows"},
    {"m_SupportsLODCrossFade", "LOD Cross Fade", 0, "levels of detail do not fade"},
    {"m_AdditionalMotionVectorMode", "Additional Motion Vectors", 0, kNoMotion, "MotionVector", 2},
    {"m_AlembicMotionVectors", "Alembic Motion Vectors", 0, kNoMotion},
    {"m_SortPriority", "Sorting Priority", 0, "it is drawn in the order of its kind of surface"},
    // Of the high definition pipeline.
    {"m_SupportLodCrossFade", "LOD Cross Fade", 0, "levels of detail do not fade"},
    {"m_AddPrecomputedVelocity", "Add Precomputed Velocity", 0, kNoMotion},
    {"m_CustomVelocity", "Custom Velocity", 0, kNoMotion, "CustomVelocity"},
    {"m_TransparentWritesMotionVec", "Transparent Writes Motion Vectors", 0, kNoMotion, "", -1, Needs::Blending},
    {"m_Tessellation", "Tessellation", 0, "the triangles are those of the mesh",
     "TessellationFactor TessellationDisplacement"},
    {"m_TransparentDepthPrepass", "Transparent Depth Prepass", 0, kOnce, "AlphaClipThresholdDepthPrepass"},
    {"m_TransparentDepthPostpass", "Transparent Depth Postpass", 0, kOnce, "AlphaClipThresholdDepthPostpass"},
    {"m_BackThenFrontRendering", "Back Then Front Rendering", 0, kOnce},
    {"m_Distortion", "Distortion", 0, "what is behind it is not distorted", "Distortion DistortionBlur", -1,
     Needs::Blending},
    {"m_DistortionOnly", "Distortion Only", 0, "its colour is drawn, too", "", -1, Needs::Blending},
    {"m_RefractionModel", "Refraction Model", 0, "light goes straight through it",
     "RefractionIndex RefractionColor RefractionDistance Thickness", -1, Needs::Blending},
    {"m_TransparencyFog", "Receive Fog", 1, "it is in fog as other surfaces are", "", -1, Needs::Blending},
    {"m_DepthOffset", "Depth Offset", 0, "its depth is that of the mesh", "DepthOffset"},
    {"m_AlphaTestShadow", "Use Shadow Threshold", 0, "its shadow is clipped as the surface is",
     "AlphaClipThresholdShadow", -1, Needs::Clipping},
    {"m_AlphaToMask", "Alpha To Mask", 0, "what is clipped has hard edges", "", -1, Needs::Clipping},
    {"m_SpecularAA", "Specular AA", 0, "highlights are not widened where the mesh is curved",
     "SpecularAAScreenSpaceVariance SpecularAAThreshold"},
    {"m_SpecularOcclusionMode", "Specular Occlusion Mode", 0, "highlights are occluded as the lighting model does it",
     "SpecularOcclusion", 3},
    {"m_OverrideBakedGI", "Override Baked GI", 0, "ambient light is that of the scene", "BakedGI BakedBackGI"},
    {"m_ReceiveDecals", "Receive Decals", 1, "decals cover it, too"},
    {"m_ReceiveSSRTransparent", "Receive SSR Transparent", 0, "it mirrors nothing of the screen", "", -1,
     Needs::Blending},
    {"m_EnergyConservingSpecular", "Energy Conserving Specular", 1,
     "a bright highlight darkens the diffuse colour, although this is off", "", -1, Needs::Specular},
    {"m_EnableShadowMatte", "Shadow Matte", 0, "shadows do not tint it", "ShadowTint"},
    {"m_RayTracing", "Recursive Rendering", 0, "rays are not traced"},
};

constexpr std::string_view kThrough = "no light shines through it from behind";
constexpr MaterialType kTypes[] = {
    {"Standard", "", "", true},
    {"Subsurface Scattering", "light does not go below the surface", "SubsurfaceMask DiffusionProfileHash", false},
    {"Anisotropy", "highlights have the same width in all directions", "Anisotropy TangentTS TangentOS TangentWS",
     true},
    {"Iridescence", "highlights have no colours of a thin film", "IridescenceMask IridescenceThickness", true},
    {"Specular Color", "", "", false},
    {"Translucent", kThrough, "DiffusionProfileHash TransmissionMask Thickness", false},
    {"Colored Translucent", kThrough, "TransmissionTint", false},
};

// The defaults of blocks. (Slots of colours have kept another one in their files, black.)
struct Default {
    std::string_view blocks;
    std::array<double, 4> numbers;
};
constexpr Default kDefaults[] = {
    {"BaseColor Specular Smoothness AlphaClipThreshold AlphaClipThresholdDepthPrepass "
     "AlphaClipThresholdDepthPostpass AlphaClipThresholdShadow AbsorptionStrength",
     {0.5, 0.5, 0.5, 1}},
    {"Metallic Emission CoatMask Anisotropy IridescenceMask IridescenceThickness DepthOffset Distortion "
     "DistortionBlur MotionVector CustomVelocity TessellationDisplacement",
     {0, 0, 0, 0}},
    {"Alpha Occlusion AmbientOcclusion CoatSmoothness SpriteMask NormalAlpha MAOSAlpha SubsurfaceMask "
     "TransmissionMask TransmissionTint Thickness SpecularOcclusion RefractionIndex RefractionColor "
     "RefractionDistance TessellationFactor",
     {1, 1, 1, 1}},
    {"ShadowTint", {0, 0, 0, 1}},
};

// Slots whose unconnected value is that of the mesh or the scene.
constexpr std::string_view kBound = "Normal Tangent Bitangent Position ViewDirection UV ScreenPosition Default";

std::vector<double> numbers_of(const Json* json, std::string_view key, Type type) {
    if (width(type) == 1) return {number_of(json, key)};
    return vector_of(json, key, width(type));
}

}  // namespace

std::span<const LostSetting> lost_settings() {
    return kLost;
}

const MaterialType& material_type(Lit type) {
    return kTypes[static_cast<std::size_t>(type)];
}

bool names(std::string_view blocks, std::string_view block) {
    while (!blocks.empty()) {
        const std::size_t end = std::min(blocks.find(' '), blocks.size());
        if (blocks.substr(0, end) == block) return true;
        blocks.remove_prefix(std::min(end + 1, blocks.size()));
    }
    return false;
}

bool has_default(const Slot& slot, std::string_view block) {
    if (names(kBound, slot.kind)) return true;
    const Type type = type_of_slot(slot.kind).type;
    if (!is_vector(type)) return false;
    const std::vector<double> value = numbers_of(slot.json, "m_Value", type);
    const auto row = std::ranges::find_if(kDefaults, [&](const Default& each) { return names(each.blocks, block); });
    if (row == std::end(kDefaults)) return value == numbers_of(slot.json, "m_DefaultValue", type);
    return std::ranges::equal(value, std::span(row->numbers).first(value.size()));
}

}  // namespace patina::importers::shadergraph

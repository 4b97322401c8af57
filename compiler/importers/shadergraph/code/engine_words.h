// Words that the engine declares, in HLSL: this text is read before the code of a custom function. Where the code asks
// for a value of the engine, the node gets a hidden parameter that brings it.
#pragma once

#include <string_view>

namespace patina::importers::shadergraph {

struct EngineValue {
    std::string_view name, parameter;
};
inline constexpr EngineValue kEngineValues[] = {
    {"engineLight", "[hidden] Light engineLight = light"},
    {"engineCamera", "[hidden] float3 engineCamera = cameraPositionWS"},
    {"engineTime", "[hidden] float engineTime = time"},
    {"engineScreen", "[hidden] float2 engineScreen = screenSize"},
};

// A texture read of the engine counts v from the bottom.
inline constexpr std::string_view kEngineWords = R"(#pragma hlsl
#define real float
#define real2 float2
#define real3 float3
#define real4 float4
#define fixed half
#define fixed2 half2
#define fixed3 half3
#define fixed4 half4
#define min16float half
#define dword uint
#define UnityTexture2D Texture2D
#define UnityTextureCube TextureCube
#define UnityTexture2DArray Texture2DArray
#define UnityTexture3D Texture3D
#define UnitySamplerState SamplerState
#define UNITY_BRANCH
#define UNITY_FLATTEN
#define UNITY_LOOP
#define UNITY_UNROLL
#define CBUFFER_START(name)
#define CBUFFER_END

#define GetMainLight(...) engineLight
#define distanceAttenuation attenuation
#define shadowAttenuation shadow
#define TransformWorldToShadowCoord(...) float4(0)
#define SampleSH AmbientIrradiance
#define _WorldSpaceCameraPos engineCamera
#define GetCameraPositionWS() engineCamera
#define _Time (float4(0.05, 1, 2, 3) * engineTime)
#define _SinTime sin(float4(0.125, 0.25, 0.5, 1) * engineTime)
#define _CosTime cos(float4(0.125, 0.25, 0.5, 1) * engineTime)
#define _TimeParameters float4(engineTime, sin(engineTime), cos(engineTime), 0)
#define _ScreenParams float4(engineScreen, 1 + 1 / engineScreen)

#define unity_ObjectToWorld objectToWorld
#define UNITY_MATRIX_M objectToWorld
#define GetObjectToWorldMatrix() objectToWorld
#define unity_WorldToObject worldToObject
#define UNITY_MATRIX_I_M worldToObject
#define GetWorldToObjectMatrix() worldToObject
#define UNITY_MATRIX_V worldToView
#define GetWorldToViewMatrix() worldToView
#define TransformObjectToWorld(position) mul(objectToWorld, float4(position, 1)).xyz
#define TransformWorldToObject(position) mul(worldToObject, float4(position, 1)).xyz
#define TransformWorldToView(position) mul(worldToView, float4(position, 1)).xyz
float3 TransformObjectToWorldDir(float3 direction, bool isUnit = true) {
    float3 changed = mul(objectToWorld, float4(direction, 0)).xyz;
    return isUnit ? SafeNormalize(changed) : changed;
}
float3 TransformWorldToObjectDir(float3 direction, bool isUnit = true) {
    float3 changed = mul(worldToObject, float4(direction, 0)).xyz;
    return isUnit ? normalize(changed) : changed;
}
float3 TransformObjectToWorldNormal(float3 normal, bool isUnit = true) {
    float3 changed = mul(float4(normal, 0), worldToObject).xyz;
    return isUnit ? SafeNormalize(changed) : changed;
}
float3 TransformWorldToObjectNormal(float3 normal, bool isUnit = true) {
    float3 changed = mul(float4(normal, 0), objectToWorld).xyz;
    return isUnit ? SafeNormalize(changed) : changed;
}

#define FROM_BOTTOM(uv) float2(0, 1) + float2(1, -1) * (uv)
#define SAMPLE_TEXTURE2D(t, s, uv) t.Sample(s, FROM_BOTTOM(uv))
#define SAMPLE_TEXTURE2D_BIAS(t, s, uv, bias) t.SampleBias(s, FROM_BOTTOM(uv), bias)
#define SAMPLE_TEXTURE2D_LOD(t, s, uv, level) t.SampleLevel(s, FROM_BOTTOM(uv), level)
#define SAMPLE_TEXTURE2D_GRAD(t, s, uv, dx, dy) t.SampleGrad(s, FROM_BOTTOM(uv), dx, dy)
#define SAMPLE_TEXTURE2D_ARRAY(t, s, uv, layer) t.Sample(s, float3(FROM_BOTTOM(uv), layer))
#define SAMPLE_TEXTURE2D_ARRAY_LOD(t, s, uv, layer, level) t.SampleLevel(s, float3(FROM_BOTTOM(uv), layer), level)
#define SAMPLE_TEXTURECUBE(t, s, direction) t.Sample(s, direction)
#define SAMPLE_TEXTURECUBE_LOD(t, s, direction, level) t.SampleLevel(s, direction, level)
)";

}  // namespace patina::importers::shadergraph

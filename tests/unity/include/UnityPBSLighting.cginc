// A stand-in for Unity's include of this name, written for these tests.
#define UNITY_SHOULD_SAMPLE_SH (!defined(LIGHTMAP_ON) && !defined(DYNAMICLIGHTMAP_ON))

#include "UnityLightingCommon.cginc"
#include "UnityStandardBRDF.cginc"
#include "UnityStandardUtils.cginc"

struct Unity_GlossyEnvironmentData
{
    half roughness;
    half3 reflUVW;
};

// The coefficients of Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", 2001,
// over pi.
half3 stand_in_sh(float3 n)
{
    float3 sum = 0.28209479 * ambientSH[0].rgb;
    sum += 0.32573501 * (ambientSH[1].rgb * n.y + ambientSH[2].rgb * n.z + ambientSH[3].rgb * n.x);
    sum += 0.27313711 * (ambientSH[4].rgb * n.x * n.y + ambientSH[5].rgb * n.y * n.z + ambientSH[7].rgb * n.x * n.z);
    sum += 0.07884789 * ambientSH[6].rgb * (3 * n.z * n.z - 1) + 0.13656855 * ambientSH[8].rgb * (n.x * n.x - n.y * n.y);
    return max(sum, 0);
}
half4 UnityGetRawBakedOcclusions(float2 uv, float3 position)
{
    return half4(uv, position.xy);
}
UnityGI UnityGI_Base(UnityGIInput data, half occlusion, half3 normal)
{
    UnityGI gi;
    UNITY_INITIALIZE_OUTPUT(UnityGI, gi)
    gi.light = data.light;
    gi.light.color *= data.atten;
    gi.indirect.diffuse = handedOver(stand_in_sh(normal) + data.ambient) * occlusion;
    return gi;
}
half3 UnityGI_IndirectSpecular(UnityGIInput data, half occlusion, Unity_GlossyEnvironmentData glossy)
{
    float level = 5 * glossy.roughness * (1.7 - 0.7 * glossy.roughness);
    return handedOver(environmentMap.SampleLevel(environmentMapSampler, glossy.reflUVW, level).rgb) * occlusion;
}

// A stand-in for Unity's include of this name, written for these tests. The test says what the runtime has of it.
#ifdef STAND_IN_REGISTERS
#define _LightColor0 float4(handedOver(lightColor[0].rgb), 1)
#else
fixed4 _LightColor0;
fixed4 _SpecColor;
#endif

struct UnityLight
{
    half3 color;
    half3 dir;
    half ndotl;
};
struct UnityIndirect
{
    half3 diffuse;
    half3 specular;
};
struct UnityGI
{
    UnityLight light;
    UnityIndirect indirect;
};
struct UnityGIInput
{
    UnityLight light;
    float3 worldPos;
    half3 worldViewDir;
    half atten;
    half3 ambient;
    float4 lightmapUV;
#if defined(UNITY_SPECCUBE_BLENDING) || defined(UNITY_SPECCUBE_BOX_PROJECTION) || defined(UNITY_ENABLE_REFLECTION_BUFFERS)
    float4 boxMin[2];
#endif
#ifdef UNITY_SPECCUBE_BOX_PROJECTION
    float4 boxMax[2];
    float4 probePosition[2];
#endif
    float4 probeHDR[2];
};

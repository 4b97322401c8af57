// A stand-in for Unity's include of this name, written for these tests. STAND_IN_2017: without what came in 2018.
#ifdef SHADOWS_SCREEN
sampler2D _ShadowMapTexture;
#define UNITY_SHADOW_COORDS(idx) float4 _ShadowCoord : TEXCOORD##idx;
#define UNITY_TRANSFER_SHADOW(a, coord) a._ShadowCoord = ComputeScreenPos(a.pos) + float4(coord, 0, 0) * 0;
#define UNITY_SHADOW_ATTENUATION(a, position) (a._ShadowCoord.w > -1e30 ? 1 : 0)
#else
#define UNITY_SHADOW_COORDS(idx)
#define UNITY_TRANSFER_SHADOW(a, coord)
#define UNITY_SHADOW_ATTENUATION(a, position) 1
#endif

#ifndef STAND_IN_2017
#ifdef POINT
#define STAND_IN_LIGHT_COORDS(idx) float3 _LightCoord : TEXCOORD##idx;
#define STAND_IN_TRANSFER(a) a._LightCoord = mul(unity_ObjectToWorld, v.vertex).xyz;
#elif defined(USING_LIGHT_MULTI_COMPILE)  // as in Unity, a program without a keyword for its light has no coordinates
#define STAND_IN_LIGHT_COORDS(idx)
#define STAND_IN_TRANSFER(a)
#endif
#define UNITY_LIGHTING_COORDS(idx1, idx2) STAND_IN_LIGHT_COORDS(idx1) UNITY_SHADOW_COORDS(idx2)
#define UNITY_TRANSFER_LIGHTING(a, coord) STAND_IN_TRANSFER(a) UNITY_TRANSFER_SHADOW(a, coord)
#endif

#if defined(POINT) || defined(SPOT)
sampler2D _LightTexture0;
#endif
#ifdef POINT_COOKIE
samplerCUBE _LightTexture0;
#endif
#if defined(SPOT) || defined(POINT_COOKIE)
sampler2D _LightTextureB0;
#endif

// The inverse square with a window that ends at the range, and a cone that fades between two cosines.
float stand_in_attenuation(float3 position)
{
    if (lightPosition[0].w < 0.5) return 1;
    float3 toLight = lightPosition[0].xyz - position;
    float squared = dot(toLight, toLight), ratio = squared / (lightColor[0].w * lightColor[0].w);
    float window = saturate(1 - ratio * ratio);
    float cosine = -dot(lightAxis[0].xyz, normalize(toLight));
    float spot = saturate((cosine - lightCone[0].y) / max(lightCone[0].x - lightCone[0].y, 0.001));
    return window * window / max(squared, 0.0001) * (lightPosition[0].w > 1.5 ? spot * spot : 1);
}
#define UNITY_LIGHT_ATTENUATION(destName, input, worldPos) \
    float3 lightCoord = worldPos;                          \
    fixed shadow = UNITY_SHADOW_ATTENUATION(input, worldPos); \
    fixed destName = stand_in_attenuation(lightCoord) * shadow;

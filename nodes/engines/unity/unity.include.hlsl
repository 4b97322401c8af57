// Declarations that a shader for Unity needs outside its passes. Each piece ends at an empty line.

// Before 2018, Unity lacks the macros for all kinds of lights, and the position alone is enough.
#ifndef UNITY_LIGHTING_COORDS
#define UNITY_LIGHTING_COORDS(first, second) UNITY_SHADOW_COORDS(second)
#define UNITY_TRANSFER_LIGHTING(o, uv) UNITY_TRANSFER_SHADOW(o, uv)
#endif

// Samples a given level of a texture, with a separate or a combined sampler.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_LOD(tex, coord, level) tex.SampleLevel(sampler##tex, coord, level)
#else
#define SAMPLE_TEX2D_LOD(tex, coord, level) tex2Dlod(tex, float4(coord, 0, level))
#endif

// Samples a given level of a texture, with another texture's sampler.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_SAMPLER_LOD(tex, samplertex, coord, level) tex.SampleLevel(sampler##samplertex, coord, level)
#else
#define SAMPLE_TEX2D_SAMPLER_LOD(tex, samplertex, coord, level) tex2Dlod(tex, float4(coord, 0, level))
#endif

// Samples a texture with a bias of the level.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_BIAS(tex, coord, bias) tex.SampleBias(sampler##tex, coord, bias)
#else
#define SAMPLE_TEX2D_BIAS(tex, coord, bias) tex2Dbias(tex, float4(coord, 0, bias))
#endif

// Samples a texture with a bias of the level, with another texture's sampler.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_SAMPLER_BIAS(tex, samplertex, coord, bias) tex.SampleBias(sampler##samplertex, coord, bias)
#else
#define SAMPLE_TEX2D_SAMPLER_BIAS(tex, samplertex, coord, bias) tex2Dbias(tex, float4(coord, 0, bias))
#endif

// Samples a texture with given derivatives.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_GRAD(tex, coord, dx, dy) tex.SampleGrad(sampler##tex, coord, dx, dy)
#else
#define SAMPLE_TEX2D_GRAD(tex, coord, dx, dy) tex2Dgrad(tex, coord, dx, dy)
#endif

// Samples a texture with given derivatives, with another texture's sampler.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define SAMPLE_TEX2D_SAMPLER_GRAD(tex, samplertex, coord, dx, dy) tex.SampleGrad(sampler##samplertex, coord, dx, dy)
#else
#define SAMPLE_TEX2D_SAMPLER_GRAD(tex, samplertex, coord, dx, dy) tex2Dgrad(tex, coord, dx, dy)
#endif

// Declares a sampler that Unity makes by its name. With combined samplers there is none: a texture is read by its own.
#if defined(UNITY_SEPARATE_TEXTURE_SAMPLER) || defined(UNITY_COMPILER_HLSLCC) || defined(SHADER_API_D3D11) || \
    defined(SHADER_API_XBOXONE) || defined(SHADER_API_PSSL)
#define DECLARE_SAMPLER(name) SamplerState sampler##name;
#else
#define DECLARE_SAMPLER(name)
#endif

// In a gamma-space project, colours arrive and leave encoded; lighting is still computed in linear space.
#ifdef UNITY_COLORSPACE_GAMMA
half3 LinearColor(half3 color) { return GammaToLinearSpace(color); }
half4 LinearColor(half4 color) { return half4(GammaToLinearSpace(color.rgb), color.a); }
half3 ProjectColor(half3 color) { return LinearToGammaSpace(color); }
#else
#define LinearColor
#define ProjectColor
#endif

// Unity's lighting functions, of the quality of the graphics tier, with colours of the project's colour space.
half3 LitByTier(half3 diffuse, half3 f0, half oneMinusReflectivity, half smoothness, half3 normal, half3 view,
    half3 direction, half3 radiance, half3 ambient, half3 reflected)
{
    UnityLight light;
    UNITY_INITIALIZE_OUTPUT(UnityLight, light);
    light.color = radiance;
    light.dir = direction;
    UnityIndirect indirect;
    indirect.diffuse = ambient;
    indirect.specular = reflected;
    return UNITY_BRDF_PBS(diffuse, f0, oneMinusReflectivity, smoothness, normal, view, light, indirect).rgb;
}

// The original texel of a normal map, independent of how Unity packs it.
half4 NormalTexel(half4 texel)
{
    return half4(UnpackNormal(texel) * 0.5 + 0.5, 1);
}

// Which instance of a draw is drawn; 0 where Unity draws one object.
int InstanceIndex()
{
#if defined(UNITY_INSTANCING_ENABLED) || defined(UNITY_PROCEDURAL_INSTANCING_ENABLED) || \
    defined(UNITY_STEREO_INSTANCING_ENABLED)
    return unity_InstanceID;
#else
    return 0;
#endif
}

// 0 directional, 1 point, 2 spot
int LightType()
{
#if defined(SPOT)
    return 2;
#elif defined(POINT) || defined(POINT_COOKIE)
    return 1;
#else
    return 0;
#endif
}

// At a vertex: the lightmap coordinates, or the light of four lights and the second order of the probes.
float4 AmbientOrLightmapUV(float2 uv1, float2 uv2, float3 position, half3 normal)
{
    float4 ambient = 0;
#ifdef LIGHTMAP_ON
    ambient.xy = uv1 * unity_LightmapST.xy + unity_LightmapST.zw;
#elif UNITY_SHOULD_SAMPLE_SH
    #ifdef VERTEXLIGHT_ON
    ambient.rgb = Shade4PointLights(unity_4LightPosX0, unity_4LightPosY0, unity_4LightPosZ0, unity_LightColor[0].rgb,
        unity_LightColor[1].rgb, unity_LightColor[2].rgb, unity_LightColor[3].rgb, unity_4LightAtten0, position, normal);
    #endif
    ambient.rgb = ShadeSHPerVertex(normal, ambient.rgb);
#endif
#ifdef DYNAMICLIGHTMAP_ON
    ambient.zw = uv2 * unity_DynamicLightmapST.xy + unity_DynamicLightmapST.zw;
#endif
    return ambient;
}

// Unity's global illumination of a white main light: its result holds the ambient light over pi (probes, lights at
// vertices, lightmaps), and as the light's colour the share that real-time and baked shadows leave.
UnityGI WhiteLight(float3 position, half3 normal, half attenuation, float4 ambient)
{
    UnityGIInput data;
    UNITY_INITIALIZE_OUTPUT(UnityGIInput, data);
    data.light.color = 1;
    data.light.dir = _WorldSpaceLightPos0.xyz;
    data.worldPos = position;
    data.atten = attenuation;
#if defined(LIGHTMAP_ON) || defined(DYNAMICLIGHTMAP_ON)
    data.lightmapUV = ambient;
#else
    data.ambient = ambient.rgb;
#endif
    return UnityGI_Base(data, 1, normal);
}

// Light of the reflection probes from a direction, blurred for a perceptual roughness: encoded in a gamma-space project.
half3 ReflectedLight(half3 direction, half roughness, float3 position, bool readsProbes)
{
    if (!readsProbes) return 0;
    UnityGIInput data;
    UNITY_INITIALIZE_OUTPUT(UnityGIInput, data);
    data.worldPos = position;
    data.probeHDR[0] = unity_SpecCube0_HDR;
    data.probeHDR[1] = unity_SpecCube1_HDR;
#if defined(UNITY_SPECCUBE_BLENDING) || defined(UNITY_SPECCUBE_BOX_PROJECTION)
    data.boxMin[0] = unity_SpecCube0_BoxMin;
#endif
#ifdef UNITY_SPECCUBE_BOX_PROJECTION
    data.boxMax[0] = unity_SpecCube0_BoxMax;
    data.probePosition[0] = unity_SpecCube0_ProbePosition;
    data.boxMin[1] = unity_SpecCube1_BoxMin;
    data.boxMax[1] = unity_SpecCube1_BoxMax;
    data.probePosition[1] = unity_SpecCube1_ProbePosition;
#endif
    Unity_GlossyEnvironmentData environment;
    UNITY_INITIALIZE_OUTPUT(Unity_GlossyEnvironmentData, environment);
    environment.roughness = roughness;
    environment.reflUVW = direction;
    return UnityGI_IndirectSpecular(data, 1, environment);
}

// The G-buffer holds reflections, unless Unity adds them afterwards.
#if UNITY_ENABLE_REFLECTION_BUFFERS
#define BufferReadsProbes() false
#else
#define BufferReadsProbes() true
#endif

// Without high dynamic range, the buffer stores 2^-light.
#ifdef UNITY_HDR_ON
#define StoredLight
#else
#define StoredLight(light) exp2(-(light))
#endif

// The colour drawn before at a place of the screen, counted from the lower left.
sampler2D _BackgroundTexture;
half3 BackgroundColor(float2 uv)
{
#if UNITY_UV_STARTS_AT_TOP
    if (_ProjectionParams.x > 0) uv.y = 1 - uv.y;
#else
    if (_ProjectionParams.x < 0) uv.y = 1 - uv.y;
#endif
    return LinearColor(tex2Dlod(_BackgroundTexture, float4(uv, 0, 0)).rgb);
}

// The distance along the camera's axis of the surface drawn before at a place of the screen.
UNITY_DECLARE_DEPTH_TEXTURE(_CameraDepthTexture);
float BackgroundDepth(float2 uv)
{
    float depth = SAMPLE_DEPTH_TEXTURE_LOD(_CameraDepthTexture, float4(uv, 0, 0));
    float parallel = depth;
#ifdef UNITY_REVERSED_Z
    parallel = 1 - depth;
#endif
    parallel = lerp(_ProjectionParams.y, _ProjectionParams.z, parallel);
    return lerp(LinearEyeDepth(depth), parallel, unity_OrthoParams.w);
}

// Unity's built-in render pipeline: the passes of a ShaderLab file. They use the values, functions and macros that
// Unity's own includes declare. Colours are linear here; in a gamma-space project they arrive and leave encoded
// (unity.include.hlsl).
// All names exist in 2017.4, 2019.4 and 6000.

// --- the mesh and the camera

[foreign("v.vertex.xyz")] [gives("positionOS")] float3 meshPosition;
[foreign("v.normal")] [gives("normalOS")] float3 meshNormal;
[foreign("v.tangent")] [gives("tangentOS")] float4 meshTangent;
[foreign("v.texcoord.xy")] [gives("uv0")] float2 meshUv0;
[foreign("v.texcoord1.xy")] [gives("uv1")] float2 meshUv1;
[foreign("v.texcoord2.xy")] [gives("uv2")] float2 meshUv2;
[foreign("v.texcoord3.xy")] [gives("uv3")] float2 meshUv3;
[foreign("v.color")] [gives("vertexColor")] float4 meshColor;
/// 0 where Unity draws one object, and in passes that do not know instances.
[foreign] int InstanceIndex();
[gives("instanceIndex")]
int unityInstanceIndex() {
    return InstanceIndex();
}

[foreign] [gives("objectToWorld")] float4x4 unity_ObjectToWorld;
[foreign] [gives("worldToObject")] float4x4 unity_WorldToObject;
[foreign] float4 unity_WorldTransformParams;  // w: -1 where the object is mirrored

[foreign("_Time.y")] [gives("time")] float unitySeconds;
[foreign("_ScreenParams.xy")] [gives("screenSize")] float2 unityScreenSize;
[foreign("UNITY_MATRIX_VP")] [gives("worldToClip")] float4x4 unityWorldToClip;
[foreign("UNITY_MATRIX_V")] [gives("worldToView")] float4x4 unityWorldToView;
[foreign] [gives("cameraPositionWS")] float3 _WorldSpaceCameraPos;
[foreign("unity_OrthoParams.w")] [gives("viewIsOrthographic")] float unityIsOrthographic;
[foreign("(-UNITY_MATRIX_V[2].xyz)")] [gives("cameraForwardWS")] float3 unityCameraForward;
[foreign("UNITY_MATRIX_V[2].xyz")] float3 unityCameraBackward;
[foreign("_ProjectionParams.yz")] [gives("clipPlanes")] float2 unityClipPlanes;

[foreign] [perObject] float4 UnityObjectToClipPos(float3 position);
[foreign] [perObject] float3 UnityObjectToWorldNormal(float3 normal);
[foreign] [perObject] float3 UnityObjectToWorldDir(float3 direction);
[foreign] float3 UnityWorldSpaceViewDir(float3 position);

[gives("normalObjectToWorld")]
float3 unityNormal(float3 normal) {
    return UnityObjectToWorldNormal(normal);
}

[gives("vertexTangentWS")]
float4 unityTangent(float4 tangent = tangentOS) {
    return float4(UnityObjectToWorldDir(tangent.xyz), tangent.w * unity_WorldTransformParams.w);
}

[gives("viewDirWS")]
float3 unityViewDir(float3 position = positionWS) {
    float3 toViewer = lerp(UnityWorldSpaceViewDir(position), unityCameraBackward, unityIsOrthographic);
    return normalize(toViewer);
}

// The position of the pixel on the screen. The origin is Unity's, the lower left.
[foreign] float4 ComputeScreenPos(float4 position);

[semantic("vertex")]
float4 screenPos(float3 position = positionOS) {
    return ComputeScreenPos(UnityObjectToClipPos(position));
}

// Coordinates that count from the bottom, as Unity does, as graphs count, and the other way round.
float2 FromBottom(float2 uv) {
    return float2(uv.x, 1 - uv.y);
}

[gives("screenUV")]
float2 unityScreenUV(float4 position = screenPos) {
    return FromBottom(position.xy / position.w);
}

// --- colour

/// Converts colours of textures and properties to linear.
[decodes("color")] [foreign] float3 LinearColor(float3 color);
/// Graphs mostly read the normal of a normal map, which Unity unpacks and scales in one call.
[decodes("normal", "UnpackNormalRedGreen", "UnpackScaleNormal")] [text("include", "UnityPBSLighting.cginc")]
[foreign] float4 NormalTexel(float4 texel);
/// Converts a linear colour to the project's colour space.
[foreign] float3 ProjectColor(float3 color);

// An include declares this property for materials: the shader does not declare it again.
[foreign] [text("include", "UnityPBSLighting.cginc")] float4 _SpecColor;

// --- light

// Unity sets these values only for passes with a light mode.
[foreign("_WorldSpaceLightPos0.xyz")] [text("light mode", "ForwardBase")] float3 LightDirection();
[foreign("LinearColor(_LightColor0.rgb)")] [text("include", "UnityPBSLighting.cginc")]
[text("light mode", "ForwardBase")]
float3 LightColor();
[foreign] [text("light mode", "ForwardBase")] float3 UnityWorldSpaceLightDir(float3 position);
[foreign] int LightType();

/// The fraction of the light that shadow map, distance, cone and cookie leave.
[foreign("UNITY_LIGHT_ATTENUATION({result}, i, {0})")]
[text("include", "AutoLight.cginc")]
[text("sampler", "_LightTexture0", "_LightTextureB0", "_ShadowMapTexture", "unity_ShadowMask", "unity_ProbeVolumeSH")]
[text("interpolators", "UNITY_LIGHTING_COORDS({}, {})")]
[text("vertex end", "UNITY_TRANSFER_LIGHTING(o, v.texcoord1.xy);")]
float Attenuation(float3 position);
[foreign("UNITY_LIGHT_ATTENUATION({result}, i, {0})")]
[text("pragma", "multi_compile_fwdbase")] [text("vertex condition", "defined(USING_LIGHT_MULTI_COMPILE)")]
[text("include", "AutoLight.cginc")] [text("light mode", "ForwardBase")]
[text("sampler", "_ShadowMapTexture", "unity_ShadowMask")]
[text("interpolators", "UNITY_LIGHTING_COORDS({}, {})")]
[text("vertex end", "UNITY_TRANSFER_LIGHTING(o, v.texcoord1.xy);")]
float MainAttenuation(float3 position);

/// Light that is not computed per pixel: the light at the vertices in rgb, or the lightmap coordinates.
[foreign("AmbientOrLightmapUV(v.texcoord1.xy, v.texcoord2.xy, {0}, {1})")]
[text("include", "UnityPBSLighting.cginc")]
[text("light mode", "ForwardBase")]
float4 AmbientOrLightmapUV(float3 position, float3 normal);

// A lightmap excludes a probe volume.
[foreign("LinearColor(WhiteLight({1}, {0}, {2}, {3}).indirect.diffuse)")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_Lightmap", "unity_DynamicLightmap")]
[text("light mode", "ForwardBase")]
float3 AmbientLight(float3 normal, float3 position, float attenuation, float4 ambientOrLightmapUV);
[foreign("WhiteLight({0}, float3(0, 1, 0), {1}, {2}).light.color.r")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_ShadowMask")]
float MixedShadow(float3 position, float attenuation, float4 ambientOrLightmapUV);
[foreign("LinearColor(ReflectedLight({0}, {1}, {2}, {3}))")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_SpecCube0")]
[text("light mode", "ForwardBase")]
float3 ReflectedLight(float3 direction, float roughness, float3 position, bool readsProbes);
[foreign] bool BufferReadsProbes();

[semantic("pixel")]
float attenuation(float3 position = positionWS) {
    return Attenuation(position);
}
[gives("attenuation", "unity-forward-base", "unity-vertex-base", "unity-tiers-base")] [fragment]
float unityMainAttenuation(float3 position = positionWS) {
    return MainAttenuation(position);
}
/// The deferred path adds lights later, with their shadows.
[gives("attenuation", "unity-deferred")] [fragment]
float unityNoAttenuation() {
    return 1;
}

[semantic("vertex")]
float4 ambientOrLightmapUV(float3 position = positionWS, float3 normal = vertexNormalWS) {
    return AmbientOrLightmapUV(position, normal);
}

/// The main light. Its shadow is the real-time one, or mixed with a baked one. In subtractive lighting, the light is
/// zero if a lightmap holds it.
[gives("lightAt", "unity-forward-base", "unity-tiers-base")] [fragment]
Light unityMainLight(int index, float3 position, float left = attenuation, float4 ambient = ambientOrLightmapUV) {
    Light light;
    light.direction = LightDirection();
    light.color = LightColor();
    light.attenuation = 1;
    light.shadow = MixedShadow(position, left, ambient);
    light.index = 0;
    light.type = 0;
    return light;
}

/// Each further light. Unity combines its shadow, distance, cone and cookie into one number.
[gives("lightAt", "unity-forward-add", "unity-tiers-add")] [fragment]
Light unityFurtherLight(int index, float3 position, float left = attenuation) {
    Light light;
    light.direction = normalize(UnityWorldSpaceLightDir(position));
    light.color = LightColor();
    light.attenuation = left;
    light.shadow = 1;
    light.index = 1;
    light.type = LightType();
    return light;
}

[gives("AmbientIrradiance", "unity-forward-base", "unity-vertex-base", "unity-tiers-base", "unity-deferred")] [fragment]
float3 unityAmbient(float3 normal, float3 position = positionWS, float left = attenuation,
                     float4 ambient = ambientOrLightmapUV) {
    return AmbientLight(normal, position, left, ambient);
}

[gives("EnvironmentRadiance", "unity-forward-base", "unity-vertex-base", "unity-tiers-base", "unity-deferred")] [fragment]
float3 unityReflection(float3 direction, float roughness, float3 position = positionWS, bool probes = readsProbes) {
    return ReflectedLight(direction, roughness, position, probes);
}

[semantic("pixel")]
bool readsProbes() {
    return true;
}
/// Whether this pass reads reflections from the probes. Depending on the project, Unity adds them to the G-buffer later.
[gives("readsProbes", "unity-deferred")] [fragment]
bool unityBufferReadsProbes() {
    return BufferReadsProbes();
}

/// Unity has no table of the split sum, so this function fits it with quotients of polynomials: least squares on a grid
/// of 22 by 21 values of sqrt(n.v) and roughness, for GGX with Smith's exact joint visibility. The largest error is
/// 0.04 for the scale and 0.07 for the offset; the root mean square error is within 0.015 for both.
[gives("splitSumShare")]
float2 fittedSplitSum(float roughness, float ndotv) {
    float r = roughness;
    float u = sqrt(ndotv);
    float r2 = r * r;
    float u2 = u * u;
    float scale = -0.0282 + 1.4469 * r + 3.2901 * r2 - 1.0967 * r2 * r + u * (0.1822 - 7.6881 * r + 0.3201 * r2) +
                  u2 * (2.898 + 1.5248 * r - 0.4523 * u);
    scale /= 1 - 0.0725 * r + 3.0333 * r2 + u * (-1.8141 - 4.3312 * r + 3.3887 * u);
    float offset = 0.9667 - 0.5217 * r + 0.2952 * r2 + u * (-1.9407 + 0.2848 * r + 1.0033 * u);
    offset /= 1 + 1.1816 * r + 8.5712 * r2 + u * (-2.2918 - 9.0057 * r + 4.9811 * u);
    return saturate(float2(scale, offset));
}

// --- the picture drawn so far

/// Reads a copy of the picture, which Unity makes before the first object that reads it.
[foreign] [text("grab", "_BackgroundTexture")] [text("queue", "2900")] [text("sampler", "_BackgroundTexture")]
float3 BackgroundColor(float2 uv);
/// Reads the camera's depth texture, which a script or another effect must enable.
[foreign] [text("include", "UnityCG.cginc")] [text("queue", "2900")] [text("sampler", "_CameraDepthTexture")]
float BackgroundDepth(float2 uv);

[gives("SceneColor", "unity-forward-base", "unity-forward-add", "unity-vertex-base", "unity-vertex-add",
       "unity-tiers-base", "unity-tiers-add")] [fragment]
float3 unitySceneColor(float2 uv) {
    return BackgroundColor(FromBottom(uv));
}
[gives("SceneDepth", "unity-forward-base", "unity-forward-add", "unity-vertex-base", "unity-vertex-add",
       "unity-tiers-base", "unity-tiers-add")] [fragment]
float unitySceneDepth(float2 uv) {
    return BackgroundDepth(FromBottom(uv));
}

// --- fog, which Unity blends with encoded colours

[foreign("float4 {result} = {0}; UNITY_APPLY_FOG_COLOR(i.fogCoord, {result}, {1});")]
[text("pragma", "multi_compile_fog")] [text("include", "UnityCG.cginc")]
[text("interpolators", "UNITY_FOG_COORDS({})")] [text("vertex result", "UNITY_TRANSFER_FOG(o, o.pos);")]
float4 InFog(float4 color, float4 fog);

[foreign] float4 unity_FogColor;

/// A pixel in fog, ready for the blend mode of its surface: fog covers as much as the surface does, dims additive
/// surfaces, and weakens multiplying ones.
[inline]
float4 unityProjectPixel(float3 projectColor, float alpha) {
    float4 fog = unity_FogColor;
    if (premultiplied) { fog = float4(unity_FogColor.rgb * alpha, 0); }
    if (adds) { fog = float4(0); }
    if (multiplies) { fog = float4(1); }
    float covered = 1;
    if (fades || premultiplied) { covered = alpha; }
    return InFog(float4(projectColor, covered), fog);
}
[inline]
float4 unityPixel(float3 color, float alpha) {
    return unityProjectPixel(ProjectColor(color), alpha);
}

// --- the passes

[pass("unity-forward-base")] [pass("unity-forward-add")] [pass("unity-vertex-base")] [pass("unity-vertex-add")]
[pass("unity-tiers-base")] [pass("unity-tiers-add")] [pass("unity-deferred")] [vertex]
[text("interpolators", "UNITY_VERTEX_INPUT_INSTANCE_ID", "UNITY_VERTEX_OUTPUT_STEREO")]
[text("vertex begin", "UNITY_SETUP_INSTANCE_ID(v);", "UNITY_INITIALIZE_OUTPUT(v2f, o);",
      "UNITY_TRANSFER_INSTANCE_ID(v, o);", "UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);")]
[text("fragment begin", "UNITY_SETUP_INSTANCE_ID(i);", "UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);")]
float4 unityVertex(float3 position = positionOS) {
    return UnityObjectToClipPos(position);
}

[pass("unity-forward-base")] [along("forward")] [fragment] [lights("main")] [extra("tiers")]
[tag("Name", "FORWARD")] [tag("LightMode", "ForwardBase")]
[text("pragma", "multi_compile_instancing")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 unityForwardBase(float3 position = positionWS) {
    LightingSurface surface = lightingSurface();
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    float3 fromLight = direct(surface, lightAt(0, position));
    float3 fromAround = indirect(surface);
    LightSum sum;
    sum.direct = fromLight;
    sum.indirect = fromAround;
    return unityPixel(final(surface, sum), surface.alpha);
}

[pass("unity-forward-add")] [along("forward")] [fragment] [each("light")] [lights("further")] [needs("added", "direct")]
[tag("Name", "FORWARD_DELTA")] [tag("LightMode", "ForwardAdd")]
[text("pragma", "multi_compile_fwdadd_fullshadows")]
[text("vertex condition", "defined(USING_LIGHT_MULTI_COMPILE)")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "srcAlpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 unityForwardAdd(float3 position = positionWS) {
    LightingSurface surface = lightingSurface();
    if (choosesKind) { discardIf(adds || multiplies); }
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    float3 color = addedByLight(surface, position);
    return InFog(float4(ProjectColor(color), fades ? surface.alpha : 0), float4(0));
}

// --- light at the vertices: --path vertex

/// The light of a pass at a vertex. Each pixel multiplies what the vertices have computed of it by shadow, distance, cone
/// and cookie, which Unity knows there.
[gives("lightAt", "unity-vertex-base")]
Light unityMainLightOfVertex(int index, float3 position) {
    Light light;
    light.direction = LightDirection();
    light.color = LightColor();
    light.attenuation = 1;
    light.shadow = 1;
    light.index = 0;
    light.type = 0;
    return light;
}
[gives("lightAt", "unity-vertex-add")]
Light unityFurtherLightOfVertex(int index, float3 position) {
    Light light;
    light.direction = normalize(UnityWorldSpaceLightDir(position));
    light.color = LightColor();
    light.attenuation = 1;
    light.shadow = 1;
    light.index = 1;
    light.type = LightType();
    return light;
}
[gives("splitLight", "unity-vertex-base", "unity-vertex-add")]
SplitLight unitySplitLight(float3 position = positionWS) {
    return splitOfOne(asLit(lightingSurface()), lightAt(0, position));
}

[static("slot", "direct")] bool isLit;

[pass("unity-vertex-base")] [along("vertex")] [fragment] [lights("main")] [extra]
[tag("Name", "FORWARD")] [tag("LightMode", "ForwardBase")]
[text("pragma", "multi_compile_instancing")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 unityVertexBase(float3 position = positionWS, float3 byDiffuse = lightByDiffuse, float3 byBase = lightByBase,
                       float3 other = otherLight, float left = attenuation, float4 ambient = ambientOrLightmapUV) {
    LightingSurface surface = lightingSurface();
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    float3 fromLight = float3(0);
    if (isLit) { fromLight = directOfVertices(surface, byDiffuse, byBase, other) * MixedShadow(position, left, ambient); }
    float3 fromAround = indirect(surface);
    LightSum sum;
    sum.direct = fromLight;
    sum.indirect = fromAround;
    return unityPixel(final(surface, sum), surface.alpha);
}

[pass("unity-vertex-add")] [along("vertex")] [fragment] [each("light")] [lights("further")] [needs("added", "direct")]
[tag("Name", "FORWARD_DELTA")] [tag("LightMode", "ForwardAdd")]
[text("pragma", "multi_compile_fwdadd_fullshadows")]
[text("vertex condition", "defined(USING_LIGHT_MULTI_COMPILE)")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "srcAlpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 unityVertexAdd(float3 byDiffuse = lightByDiffuse, float3 byBase = lightByBase, float3 other = otherLight,
                      float left = attenuation) {
    LightingSurface surface = lightingSurface();
    if (choosesKind) { discardIf(adds || multiplies); }
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    LightSum one;
    one.direct = directOfVertices(surface, byDiffuse, byBase, other) * left;
    return InFog(float4(ProjectColor(added(surface, one)), fades ? surface.alpha : 0), float4(0));
}

// --- Unity's own lighting, of the quality that a project's graphics tier has: --path tiers

/// A light, ambient light and reflected light, by UNITY_BRDF_PBS: in the project's colour space, as Standard computes
/// and adds them.
[foreign] [text("include", "UnityPBSLighting.cginc")]
float3 LitByTier(float3 diffuse, float3 f0, float oneMinusReflectivity, float smoothness, float3 normal, float3 view,
                 float3 direction, float3 radiance, float3 ambient, float3 reflected);
[foreign("_LightColor0.rgb")] [text("include", "UnityPBSLighting.cginc")] [text("light mode", "ForwardBase")]
float3 ProjectLightColor();
[foreign("WhiteLight({1}, {0}, {2}, {3}).indirect.diffuse")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_Lightmap", "unity_DynamicLightmap")]
[text("light mode", "ForwardBase")]
float3 ProjectAmbientLight(float3 normal, float3 position, float attenuation, float4 ambientOrLightmapUV);
[foreign("ReflectedLight({0}, {1}, {2}, true)")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_SpecCube0")]
[text("light mode", "ForwardBase")]
float3 ProjectReflectedLight(float3 direction, float roughness, float3 position);

[inline]
float3 litByTier(LightingSurface surface, float3 view, float3 direction, float3 radiance, float3 ambient,
                 float3 reflected) {
    float3 diffuse = ProjectColor(surface.diffuseColor);
    float3 specular = ProjectColor(surface.f0);
    return LitByTier(diffuse, specular, surface.oneMinusReflectivity, surface.smoothness, surface.normalWS, view,
                     direction, radiance, ambient, reflected);
}

[pass("unity-tiers-base")] [along("tiers")] [fragment] [lights("main")] [lighting("unity-brdf1")]
[tag("Name", "FORWARD")] [tag("LightMode", "ForwardBase")]
[text("pragma", "multi_compile_instancing")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
[blend("fade", "srcAlpha", "oneMinusSrcAlpha", "one", "oneMinusSrcAlpha")]
[blend("transparent", "one", "oneMinusSrcAlpha")] [blend("additive", "one", "one", "zero", "one")]
[blend("multiply", "dstColor", "zero", "zero", "one")]
float4 unityTiersBase(float3 position = positionWS, float3 view = viewDirWS, float left = attenuation,
                      float4 ambient = ambientOrLightmapUV) {
    LightingSurface surface = lightingSurface();
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    float3 normal = surface.normalWS;
    float3 radiance = ProjectLightColor() * MixedShadow(position, left, ambient);
    float3 diffuseLight = ProjectAmbientLight(normal, position, left, ambient) * surface.occlusion;
    float3 reflection = ProjectReflectedLight(reflect(-view, normal), surface.roughness, position) *
                        surface.occlusion;
    float3 litColor = litByTier(surface, view, LightDirection(), radiance, diffuseLight, reflection);
    return unityProjectPixel(litColor + ProjectColor(surface.emission), surface.alpha);
}

[pass("unity-tiers-add")] [along("tiers")] [fragment] [each("light")] [lights("further")] [lighting("unity-brdf1")]
[tag("Name", "FORWARD_DELTA")] [tag("LightMode", "ForwardAdd")]
[text("pragma", "multi_compile_fwdadd_fullshadows")]
[text("vertex condition", "defined(USING_LIGHT_MULTI_COMPILE)")]
[depth("lessEqual", "keep")]
[blend("opaque", "one", "one", "zero", "one")] [blend("cutout", "one", "one", "zero", "one")]
[blend("fade", "srcAlpha", "one", "zero", "one")] [blend("transparent", "one", "one", "zero", "one")]
float4 unityTiersAdd(float3 position = positionWS, float3 view = viewDirWS, float left = attenuation) {
    LightingSurface surface = lightingSurface();
    if (choosesKind) { discardIf(adds || multiplies); }
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    surface = asLit(surface);
    float3 direction = normalize(UnityWorldSpaceLightDir(position));
    float3 radiance = ProjectLightColor() * left;
    float3 litColor = litByTier(surface, view, direction, radiance, float3(0), float3(0));
    return InFog(float4(litColor, fades ? surface.alpha : 0), float4(0));
}

// --- lightmaps

/// The colours that Unity's lightmapper asks for.
[foreign("UnityMetaVertexPosition(v.vertex, v.texcoord1.xy, v.texcoord2.xy, unity_LightmapST, unity_DynamicLightmapST)")]
float4 MetaPosition();
[foreign("UnityMetaInput meta; UNITY_INITIALIZE_OUTPUT(UnityMetaInput, meta); meta.Albedo = {0}; meta.Emission = {1}; half4 {result} = UnityMetaFragment(meta);")]
float4 MetaColor(float3 albedo, float3 emission);

[pass("unity-meta")] [vertex]
[text("vertex begin", "UNITY_INITIALIZE_OUTPUT(v2f, o);")]
float4 unityMetaVertex() {
    return MetaPosition();
}

/// A lightmap holds what leaves the front of a surface in every direction: there is no camera, and no side of a face.
[gives("frontFacing", "unity-meta")] [fragment]
bool unityMetaFront() {
    return true;
}
[gives("viewDirWS", "unity-meta")] [fragment]
float3 unityMetaViewDir(float3 normal = geometryNormalWS) {
    return normal;
}

[static("reads", "f0")] bool reflects;

/// A rough metal scatters light, too: half of its reflectance counts, times the square of its perceptual roughness.
/// source: UnityLightmappingAlbedo of Unity's Standard shader
[pass("unity-meta")] [fragment] [lights("none")] [optional] [needs("added", "direct")]
[tag("Name", "META")] [tag("LightMode", "Meta")]
[text("own include", "UnityMetaPass.cginc")]
[cull("off")] [depth("lessEqual", "write")] [depthBias(0, 0)] [blend("one", "zero")]
float4 unityMeta() {
    LightingSurface surface = lightingSurface();
    float3 albedo = surface.diffuseColor;
    if (reflects) { albedo += surface.f0 * (0.5 * surface.alphaRoughness); }
    return MetaColor(ProjectColor(albedo), ProjectColor(surface.emission));
}

// --- shadows, depth and the G-buffer

[pass("unity-shadow-caster")] [vertex]
[text("first interpolator", "V2F_SHADOW_CASTER;")]
[text("interpolators", "UNITY_VERTEX_INPUT_INSTANCE_ID", "UNITY_VERTEX_OUTPUT_STEREO")]
[text("vertex begin", "UNITY_SETUP_INSTANCE_ID(v);", "UNITY_INITIALIZE_OUTPUT(v2f, o);",
      "UNITY_TRANSFER_INSTANCE_ID(v, o);", "UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);")]
[text("vertex end", "TRANSFER_SHADOW_CASTER_NORMALOFFSET(o)")]
void unityCasterVertex() {
}

[pass("unity-shadow-caster")] [fragment] [lights("none")] [optional]
[tag("Name", "ShadowCaster")] [tag("LightMode", "ShadowCaster")]
[otherwise("it casts no shadow, and is not in the camera's depth texture")]
[text("pragma", "multi_compile_shadowcaster", "multi_compile_instancing")] [text("include", "UnityCG.cginc")]
[text("fragment begin", "UNITY_SETUP_INSTANCE_ID(i);", "UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(i);")]
[text("fragment end", "SHADOW_CASTER_FRAGMENT(i)")]
[depth("lessEqual", "write")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void unityCaster() {
    if (choosesKind) { discardIf(blends); }
    if (mayClip) {
        LightingSurface surface = lightingSurface();
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
}

// The G-buffer of Unity's deferred path, as UnityStandardDataToGbuffer fills it.
struct UnityTargets {
    [target("gbufferDiffuse", "rgba8")] float4 diffuse;    // diffuse colour, occlusion
    [target("gbufferSpecular", "rgba8")] float4 specular;  // f0, smoothness
    [target("gbufferNormal", "rgb10a2")] float4 normal;    // in the world, 0.5 n + 0.5
    [target("color", "rgba16f")] float4 light;              // emission and ambient light
    [target("gbufferShadowMask", "rgba8")] [onlyIf("defined(SHADOWS_SHADOWMASK) && UNITY_ALLOWED_MRT_COUNT > 4")]
    float4 shadowMask;
};

/// Without high dynamic range, Unity stores the light as 2^-light.
[foreign] float3 StoredLight(float3 color);
[foreign("UnityGetRawBakedOcclusions({0}.xy, {1})")]
[text("include", "UnityPBSLighting.cginc")] [text("sampler", "unity_ShadowMask")]
float4 BakedShadows(float4 ambientOrLightmapUV, float3 position);

/// Only materials with a lighting model that Unity's own lighting passes compute have this pass. If an object has it,
/// the deferred path draws no other pass of the object, and its stencil marks the lit pixels.
[pass("unity-deferred")] [along("forward", "tiers")] [fragment] [lights("none")] [optional] [alone]
[lighting("unity-brdf1", "unity-brdf2", "unity-brdf3")] [stencil("always", "keep")]
[tag("Name", "DEFERRED")] [tag("LightMode", "Deferred")]
[otherwise("where a project's cameras are deferred, Unity draws it forward, after the others")]
[text("pragma", "exclude_renderers nomrt", "multi_compile_prepassfinal", "multi_compile_instancing")]
[text("include", "UnityCG.cginc")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
UnityTargets unityDeferred(float3 position = positionWS, float4 ambient = ambientOrLightmapUV) {
    LightingSurface surface = lightingSurface();
    if (mayClip) {
        discardIf(alphaClip && surface.alpha < surface.alphaClip);
    }
    float3 fromAround = indirect(surface);
    LightSum sum;
    sum.indirect = fromAround;
    UnityTargets made;
    made.diffuse = float4(ProjectColor(surface.diffuseColor), surface.occlusion);
    made.specular = float4(ProjectColor(surface.f0), surface.smoothness);
    made.normal = float4(0.5 + 0.5 * surface.normalWS, 1);
    made.light = float4(StoredLight(ProjectColor(final(surface, sum))), 1);
    made.shadowMask = BakedShadows(ambient, position);
    return made;
}

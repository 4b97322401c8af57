// Baked light: lightmaps and shadow masks of static objects, and how real-time shadows combine with them. Values that
// belong to a switch are read only where the switch is on. In each block, small ones come first, because a value is
// declared wherever one behind it is. A pass that draws objects reads the two textures at the second texture coordinates
// and passes the results on (forward.pass.hlsl).
// source: Unity's built-in shaders, UnityGI_Base, UnityMixRealtimeAndBakedShadows and
// source: SubtractMainLightWithRealtimeAttenuationFromLightmap

/// A lightmap holds the object's ambient light.
[switch] bool lightmap;
/// Lightmaps also hold the main light; its real-time shadow is subtracted from them.
[switch] bool subtractive;
/// A shadow mask of the object holds the shadows of up to four lights.
[switch] bool shadowMask;
/// Baked shadows apply only where real-time ones have faded; otherwise the darker of both applies.
[switch] bool distanceShadowMask;
/// Real-time shadows fade out at a distance.
[switch] bool shadowsFade;

/// The object's lightmap: ambient light, E/pi, encoded as lightmapDecode says.
[extern] [with("lightmap")] Texture2D lightmapTexture;
/// How the lightmap is decoded: the instructions of the node DecodeHDR.
[extern("Object")] [perObject] [with("lightmap")] float4 lightmapDecode;
/// Scale and offset of the distance along the camera's axis, which give how far real-time shadows have faded: the node
/// ShadowFade.
/// unit: 1/m (x)
[extern("Lights")] [with("shadowsFade")] float2 shadowFade;
/// Slot of the light that lightmaps hold; -1: it is not listed.
[extern("Lights")] [with("subtractive")] int mainLight;
/// rgb: the darkest colour that the shadow of that light may have, linear.
/// unit: E/pi
[extern("Lights")] [with("subtractive")] float4 shadowColor;
/// The object's shadow mask: four lights in each texel, 1 lit, 0 in shadow.
[extern] [with("shadowMask")] Texture2D shadowMaskTexture;
/// 1 in the light's channel of shadow masks; all 0: it has none.
[extern("Lights")] [with("shadowMask", "deferred-shadowmask")] float4 lightMask[16];

/// The light of the lightmap at given coordinates, E / pi.
float3 lightmapLight(float2 uv) {
    if (!lightmap) { return float3(0); }
    return DecodeHDR(lightmapTexture.SampleLevel(uv, 0), lightmapDecode);
}

/// The baked shadows at given coordinates of the lightmap: one light in each channel.
float4 lightmapShadows(float2 uv) {
    if (!shadowMask) { return float4(1); }
    return shadowMaskTexture.SampleLevel(uv, 0);
}

/// The fraction of the main light that a fully dark real-time shadow leaves, if lightmaps hold that light.
float mainLightLeft(float3 position) {
    if (!subtractive) { return 1; }
    int map = shadowMapOf(max(mainLight, 0));
    float left = 1;
    if (mainLight >= 0 && map >= 0) { left = shadowInMap(map, position); }
    if (shadowsFade) { left = MixRealtimeAndBakedShadow(left, 1, fadedShadow(position), RealtimeOnly); }
    return left;
}

/// Replaces AmbientIrradiance on an object with a lightmap. `left` is mainLightLeft().
float3 bakedLight(float3 normal, float3 light, float left) {
    if (!subtractive) { return light; }
    int slot = max(mainLight, 0);
    float3 shaded = SubtractMainLight(light, normal, normalize(lightPosition[slot].xyz), lightColor[slot].rgb, left,
                                      shadowColor.rgb, 1 - strengthOfShadow(slot));
    return mainLight >= 0 ? shaded : light;
}

/// How far real-time shadows have faded at a point: 0 not at all, 1 completely.
float fadedShadow(float3 position) {
    if (!shadowsFade) { return 0; }
    return ShadowFade(dot(position - cameraPositionWS, cameraForwardWS), shadowFade.x, shadowFade.y);
}

/// The combined real-time and baked shadow of a light.
float mixedShadow(int index, float3 position, float baked) {
    float realtime = realtimeShadow(index, position);
    float fade = fadedShadow(position);
    if (distanceShadowMask) { return MixRealtimeAndBakedShadow(realtime, baked, fade, DistanceShadowmask); }
    return MixRealtimeAndBakedShadow(realtime, baked, fade, Shadowmask);
}

/// The shadow of a light on an object whose shadow mask holds `mask` at this point.
float maskedShadow(int index, float3 position, float4 mask) {
    float4 channel = lightMask[index];
    float baked = any(channel > 0) ? ShadowMaskChannel(mask, channel) : 1;
    return mixedShadow(index, position, baked);
}

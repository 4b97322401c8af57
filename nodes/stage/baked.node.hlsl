// Baked light: lightmaps and shadow masks of objects that do not move, and how real-time shadows agree with them. What
// belongs to a switch is declared only where the switch is on. A pass that draws objects hands over what it reads of
// the two textures at the second texture coordinates (forward.pass.hlsl).
// source: Unity's built-in shaders, UnityGI_Base, UnityMixRealtimeAndBakedShadows and
// source: SubtractMainLightWithRealtimeAttenuationFromLightmap

/// The object's ambient light lies in a lightmap.
[switch] bool lightmap;
/// Lightmaps hold the main light, too; what its real-time shadow takes away is taken out of them.
[switch] bool subtractive;
/// Shadows of up to four lights lie in a shadow mask of the object.
[switch] bool shadowMask;
/// Baked shadows count only where real-time ones have faded; else the darker of both does.
[switch] bool distanceShadowMask;
/// Real-time shadows end at a distance.
[switch] bool shadowsFade;

[extern] [with("lightmap")] Texture2D lightmapTexture;
[extern("Object")] [perObject] [with("lightmap")] float4 lightmapDecode;  // the instructions of DecodeHDR
[extern("Lights")] [with("subtractive")] int mainLight;        // slot of the light that lightmaps hold; -1: not here
[extern("Lights")] [with("subtractive")] float4 shadowColor;   // rgb: what its shadow does not darken further
[extern] [with("shadowMask")] Texture2D shadowMaskTexture;   // of each texel four lights: 1 lit, 0 in shadow
[extern("Lights")] [with("shadowMask", "deferred-shadowmask")] float4 lightMask[16];  // 1 in the light's channel of
                                                                                        // shadow masks; all 0: none
[extern("Lights")] [with("shadowsFade")] float2 shadowFade;   // scale and offset of ShadowFade

/// Light of the lightmap at its coordinates, E / pi.
float3 lightmapLight(float2 uv) {
    if (!lightmap) { return float3(0); }
    return DecodeHDR(lightmapTexture.SampleLevel(uv, 0), lightmapDecode);
}

/// The baked shadows at the coordinates of the lightmap: one light a channel.
float4 lightmapShadows(float2 uv) {
    if (!shadowMask) { return float4(1); }
    return shadowMaskTexture.SampleLevel(uv, 0);
}

/// How much of the main light its real-time shadow leaves where lightmaps hold that light, were the shadow quite dark.
float mainLightLeft(float3 position) {
    if (!subtractive) { return 1; }
    int map = shadowMapOf(max(mainLight, 0));
    float left = 1;
    if (mainLight >= 0 && map >= 0) { left = shadowInMap(map, position); }
    if (shadowsFade) { left = MixRealtimeAndBakedShadow(left, 1, fadedShadow(position), RealtimeOnly); }
    return left;
}

/// What stands in the place of AmbientIrradiance on an object with a lightmap. `left`: mainLightLeft().
float3 bakedLight(float3 normal, float3 light, float left) {
    if (!subtractive) { return light; }
    int slot = max(mainLight, 0);
    float3 shaded = SubtractMainLight(light, normal, normalize(lightPosition[slot].xyz), lightColor[slot].rgb, left,
                                      shadowColor.rgb, 1 - strengthOfShadow(slot));
    return mainLight >= 0 ? shaded : light;
}

/// How far real-time shadows have faded at a point: 0 not at all, 1 there are none.
float fadedShadow(float3 position) {
    if (!shadowsFade) { return 0; }
    return ShadowFade(dot(position - cameraPositionWS, cameraForwardWS), shadowFade.x, shadowFade.y);
}

/// Real-time and baked shadow of the light in slot `index`, as one.
float mixedShadow(int index, float3 position, float baked) {
    float realtime = realtimeShadow(index, position);
    float fade = fadedShadow(position);
    if (distanceShadowMask) { return MixRealtimeAndBakedShadow(realtime, baked, fade, DistanceShadowmask); }
    return MixRealtimeAndBakedShadow(realtime, baked, fade, Shadowmask);
}

/// `shadow`, of an object whose shadow mask holds `mask` here.
float maskedShadow(int index, float3 position, float4 mask) {
    float4 channel = lightMask[index];
    float baked = any(channel > 0) ? ShadowMaskChannel(mask, channel) : 1;
    return mixedShadow(index, position, baked);
}

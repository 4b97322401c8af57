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
[switch] bool shadow_mask;
/// Baked shadows count only where real-time ones have faded; else the darker of both does.
[switch] bool distance_shadow_mask;
/// Real-time shadows end at a distance.
[switch] bool shadows_fade;

[extern] [with("lightmap")] Texture2D lightmap_texture;
[extern("Object")] [per_object] [with("lightmap")] float4 lightmap_decode;  // the instructions of DecodeHDR
[extern("Lights")] [with("subtractive")] int main_light;        // slot of the light that lightmaps hold; -1: not here
[extern("Lights")] [with("subtractive")] float4 shadow_color;   // rgb: what its shadow does not darken further
[extern] [with("shadow_mask")] Texture2D shadow_mask_texture;   // of each texel four lights: 1 lit, 0 in shadow
[extern("Lights")] [with("shadow_mask", "deferred-shadowmask")] float4 light_mask[16];  // 1 in the light's channel of
                                                                                        // shadow masks; all 0: none
[extern("Lights")] [with("shadows_fade")] float2 shadow_fade;   // scale and offset of ShadowFade

/// Light of the lightmap at its coordinates, E / pi.
float3 lightmap_light(float2 uv) {
    if (!lightmap) { return float3(0); }
    return DecodeHDR(lightmap_texture.SampleLevel(uv, 0), lightmap_decode);
}

/// The baked shadows at the coordinates of the lightmap: one light a channel.
float4 lightmap_shadows(float2 uv) {
    if (!shadow_mask) { return float4(1); }
    return shadow_mask_texture.SampleLevel(uv, 0);
}

/// How much of the main light its real-time shadow leaves where lightmaps hold that light, were the shadow quite dark.
float main_light_left(float3 position) {
    if (!subtractive) { return 1; }
    int map = shadow_map_of(max(main_light, 0));
    float left = 1;
    if (main_light >= 0 && map >= 0) { left = shadow_in_map(map, position); }
    if (shadows_fade) { left = MixRealtimeAndBakedShadow(left, 1, faded_shadow(position), RealtimeOnly); }
    return left;
}

/// What stands in the place of AmbientIrradiance on an object with a lightmap. `left`: main_light_left().
float3 baked_light(float3 normal, float3 light, float left) {
    if (!subtractive) { return light; }
    int slot = max(main_light, 0);
    float3 shaded = SubtractMainLight(light, normal, normalize(light_position[slot].xyz), light_color[slot].rgb, left,
                                      shadow_color.rgb, 1 - strength_of_shadow(slot));
    return main_light >= 0 ? shaded : light;
}

/// How far real-time shadows have faded at a point: 0 not at all, 1 there are none.
float faded_shadow(float3 position) {
    if (!shadows_fade) { return 0; }
    return ShadowFade(dot(position - camera_position_ws, camera_forward_ws), shadow_fade.x, shadow_fade.y);
}

/// Real-time and baked shadow of the light in slot `index`, as one.
float mixed_shadow(int index, float3 position, float baked) {
    float realtime = realtime_shadow(index, position);
    float fade = faded_shadow(position);
    if (distance_shadow_mask) { return MixRealtimeAndBakedShadow(realtime, baked, fade, DistanceShadowmask); }
    return MixRealtimeAndBakedShadow(realtime, baked, fade, Shadowmask);
}

/// `shadow`, of an object whose shadow mask holds `mask` here.
float masked_shadow(int index, float3 position, float4 mask) {
    float4 channel = light_mask[index];
    float baked = any(channel > 0) ? ShadowMaskChannel(mask, channel) : 1;
    return mixed_shadow(index, position, baked);
}

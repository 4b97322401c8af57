// Lights: the engine seam. An engine may replace the [extern] functions; their bodies are what the runtime and the CPU
// reference use.
// Units: a light's colour is E/pi, what a white Lambert surface that faces it sends out.

/// One light, as seen from a point.
struct Light {
    float3 direction;   ///< to the light, unit
    float3 color;       ///< linear colour times intensity
    float attenuation;  ///< of distance and cone, 0 to 1 at one metre or more
    float shadow;       ///< 1: lit, 0: in shadow
    int index;          ///< which light of the list
    int type;           ///< 0 directional, 1 point, 2 spot
};

/// What lights add up to; only `final` reads it.
struct LightSum {
    float3 direct;    ///< sum of `direct` over all lights
    float3 indirect;  ///< `indirect`
};

const int MAX_LIGHTS = 16;

[extern("Lights")] int light_count;
[extern("Lights")] float4 light_position[16];  // xyz: direction to a directional light, else position; w: type
[extern("Lights")] float4 light_color[16];     // rgb: colour times intensity; w: range in metres
[extern("Lights")] float4 light_axis[16];      // xyz: direction that a spot shines along; w: 1 if it has the cookie
[extern("Lights")] float4 light_cone[16];      // cosines of a spot's half angles: x inner, y outer; z: number of the
                                               // light in the scene; w: number of its shadow map, or -1
[extern("Lights")] int vertex_light_count;     // lights behind the first `light_count` that count per vertex, up to four

/// Lights cast shadows.
[switch("shadow-caster")] bool shadows;
[extern("Shadows")] float4x4 world_to_shadow[4];  // to the map's clip space
[extern("Shadows")] float4 shadow_tile[4];        // xy: size of the map in the texture, zw: its upper left corner
[extern("Shadows")] float4 shadow_strength;       // of each map, 0 to 1
[extern("Shadows")] float shadow_texel;           // 1 / width of the texture in texels
[reads("shadow_map")] Texture2D shadow_map;      // red: depth, 0 near to 1 far; up to four maps

/// A light shines through a picture.
[switch] bool cookies;
[extern("Shadows")] [with("cookies")] float4x4 world_to_cookie;
[extern] [with("cookies")] Texture2D light_cookie;

/// Colour times attenuation times shadow.
[member]
float3 radiance(Light light) {
    return light.color * (light.attenuation * light.shadow);
}

/// Number of the shadow map of the light in slot `index`, or -1.
int shadow_map_of(int index) {
    if (!shadows) { return -1; }
    return int(light_cone[index].w);
}

/// How dark the real-time shadow of the light in slot `index` is: 0 to 1.
float strength_of_shadow(int index) {
    if (!shadows) { return 0; }
    int map = shadow_map_of(index);
    return map >= 0 ? shadow_strength[map] : 0;
}

/// How much of its light reaches a point, by a shadow map: 1 lit, 0 in shadow.
float shadow_in_map(int map, float3 position) {
    if (!shadows) { return 1; }
    float4 place = mul(world_to_shadow[map], float4(position, 1));
    float3 at = place.xyz / place.w;
    float2 uv = at.xy * float2(0.5, -0.5) + 0.5;
    return SampleShadowTent5x5(shadow_map, uv, at.z, shadow_texel, shadow_tile[map]);
}

/// How much of the light in slot `index` its shadow map leaves.
float realtime_shadow(int index, float3 position) {
    if (!shadows) { return 1; }
    int map = shadow_map_of(index);
    float lit = 1;
    if (map >= 0) { lit = lerp(1, shadow_in_map(map, position), shadow_strength[map]); }
    return lit;
}

/// How much of the light in slot `index` reaches a point: 1 lit, 0 in shadow.
[extern]
float shadow(int index, float3 position) {
    if (!shadows) { return 1; }
    if (shadows_fade) { return mixed_shadow(index, position, 1); }
    return realtime_shadow(index, position);
}

/// How much of the light in slot `index` its cookie lets through.
[extern] [inline]
float light_through_cookie(int index, float3 position) {
    if (!cookies) { return 1; }
    float passes = CookieAttenuation(light_cookie, mul(world_to_cookie, float4(position, 1)));
    return light_axis[index].w > 0.5 ? passes : 1;
}

/// The inverse square law, with a window that ends it smoothly at the light's range.
/// source: Lagarde and de Rousiers, "Moving Frostbite to PBR", SIGGRAPH 2014, listing 4; the window is that of Karis, "Real
/// source: Shading in Unreal Engine 4", SIGGRAPH 2013, eq. 9
float distance_attenuation(float distance_squared, float range) {
    float ratio = distance_squared / (range * range);
    float window = saturate(1 - ratio * ratio);
    return window * window / max(distance_squared, 0.0001);
}

/// The light in slot `index` of the list, as seen from `position` (world space).
[extern]
Light light_at(int index, float3 position) {
    int slot = clamp(index, 0, MAX_LIGHTS - 1);
    float4 place = light_position[slot];
    float4 color = light_color[slot];
    bool is_local = place.w > 0.5;
    float3 to_light = place.xyz - (is_local ? position : float3(0));
    float distance_squared = dot(to_light, to_light);
    Light light;
    light.direction = to_light * rsqrt(max(distance_squared, 1e-12));
    light.color = color.rgb;
    if (lightmap && subtractive) { light.color = slot == main_light ? float3(0) : light.color; }
    light.attenuation = is_local ? distance_attenuation(distance_squared, color.w) : 1;
    float cosine = -dot(light_axis[slot].xyz, light.direction);
    float4 cone = light_cone[slot];
    float spot = saturate((cosine - cone.y) / max(cone.x - cone.y, 0.001));
    light.attenuation *= place.w > 1.5 ? spot * spot : 1;
    light.attenuation *= light_through_cookie(slot, position);
    light.shadow = shadow(slot, position);
    light.index = int(cone.z);
    light.type = int(place.w);
    return light;
}

/// In a material: the main directional light. In a lighting graph: the light being evaluated.
[semantic("pixel")]
Light light(float3 position = position_ws) {
    return light_at(0, position);
}

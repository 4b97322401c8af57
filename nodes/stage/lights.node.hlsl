// Lights: part of the engine's interface. An engine may replace the [extern] functions; the runtime and the CPU
// reference use the bodies here.
// Units: a light's colour is E/pi, the radiance of a white Lambert surface that faces the light.

/// One light, as seen from a point.
struct Light {
    [is("directionWS")] float3 direction;  ///< to the light, unit
    float3 color;       ///< linear colour times intensity
    float attenuation;  ///< by distance, cone and cookie, 0 to 1 at one metre or more
    float shadow;       ///< 1: lit, 0: in shadow
    int index;          ///< which light of the list
    int type;           ///< 0 directional, 1 point, 2 spot
};

/// The sum of all light; only `final` reads it.
struct LightSum {
    float3 direct;    ///< sum of `direct` over all lights
    float3 indirect;  ///< the result of the output `indirect`
};

const int MAX_LIGHTS = 16;

/// Number of lights that are computed per pixel.
/// block: The lights that a pass sees. The engine fills it for each draw, or once for all that see the same lights.
[extern("Lights")] int lightCount;
/// xyz: the unit direction to a directional light, else the light's position; w: 0 directional, 1 point, 2 spot.
/// unit: m (xyz of a position)
/// space: world
[extern("Lights")] float4 lightPosition[16];
/// rgb: colour times intensity, linear; w: range.
/// unit: E/pi (rgb: the radiance of a white Lambert surface that faces the light), m (w)
[extern("Lights")] float4 lightColor[16];
/// xyz: the unit direction that a spot shines along; w: 1 if it has the cookie.
/// space: world
[extern("Lights")] float4 lightAxis[16];
/// Cosines of a spot's half angles: x inner, y outer; z: number of the light in the scene; w: number of its shadow map, or
/// -1.
[extern("Lights")] float4 lightCone[16];
/// Number of lights, after the first `lightCount`, that are computed per vertex: up to four.
[extern("Lights")] int vertexLightCount;

/// Lights cast shadows.
[switch("shadow-caster")] bool shadows;
/// World to the clip space of each shadow map.
/// space: world to a light's clip
/// block: The shadow maps. The engine fills it once a frame, when they are drawn.
[extern("Shadows")] float4x4 worldToShadow[4];
/// Where each map is in the texture: xy: its size, zw: its upper left corner, 0 to 1.
/// unit: widths of the texture
[extern("Shadows")] float4 shadowTile[4];
/// How dark the shadow of each map is, 0 to 1.
[extern("Shadows")] float4 shadowStrength;
/// Width of a texel: 1 / width of the texture in texels.
/// unit: widths of the texture
[extern("Shadows")] float shadowTexel;
[reads("shadowMap")] Texture2D shadowMap;      // red: depth, 0 near to 1 far; up to four maps

/// A light shines through a texture, its cookie.
[switch] bool cookies;
/// World to the clip space of the light that has the cookie.
/// space: world to a light's clip
[extern("Shadows")] [with("cookies")] float4x4 worldToCookie;
/// The cookie: red is the share of the light that passes.
[extern] [with("cookies")] Texture2D lightCookie;

/// Colour times attenuation times shadow.
[member]
float3 radiance(Light light) {
    return light.color * (light.attenuation * light.shadow);
}

/// Number of a light's shadow map, or -1. Lights are known by their slots.
int shadowMapOf(int index) {
    if (!shadows) { return -1; }
    return int(lightCone[index].w);
}

/// The strength of a light's real-time shadow: 0 to 1.
float strengthOfShadow(int index) {
    if (!shadows) { return 0; }
    int map = shadowMapOf(index);
    return map >= 0 ? shadowStrength[map] : 0;
}

/// How much of a light reaches a point, by its shadow map: 1 lit, 0 in shadow.
float shadowInMap(int map, float3 position) {
    if (!shadows) { return 1; }
    float4 place = mul(worldToShadow[map], float4(position, 1));
    float3 at = place.xyz / place.w;
    float2 uv = at.xy * float2(0.5, -0.5) + 0.5;
    return SampleShadowTent5x5(shadowMap, uv, at.z, shadowTexel, shadowTile[map]);
}

/// How much of a light reaches a point, by its shadow map.
float realtimeShadow(int index, float3 position) {
    if (!shadows) { return 1; }
    int map = shadowMapOf(index);
    float lit = 1;
    if (map >= 0) { lit = lerp(1, shadowInMap(map, position), shadowStrength[map]); }
    return lit;
}

/// How much of a light reaches a point: 1 lit, 0 in shadow.
[extern]
float shadow(int index, float3 position) {
    if (!shadows) { return 1; }
    if (shadowsFade) { return mixedShadow(index, position, 1); }
    return realtimeShadow(index, position);
}

/// How much of a light passes through its cookie.
[extern] [inline]
float lightThroughCookie(int index, float3 position) {
    if (!cookies) { return 1; }
    float passes = CookieAttenuation(lightCookie, mul(worldToCookie, float4(position, 1)));
    return lightAxis[index].w > 0.5 ? passes : 1;
}

/// The inverse square law, with a window that fades it out at the light's range.
/// source: Lagarde and de Rousiers, "Moving Frostbite to PBR", SIGGRAPH 2014, listing 4; the window is that of Karis, "Real
/// source: Shading in Unreal Engine 4", SIGGRAPH 2013, eq. 9
float distanceAttenuation(float distanceSquared, float range) {
    float ratio = distanceSquared / (range * range);
    float window = saturate(1 - ratio * ratio);
    return window * window / max(distanceSquared, 0.0001);
}

/// A light of the list, as seen from a point in world space.
[extern]
Light lightAt(int index, float3 position) {
    int slot = clamp(index, 0, MAX_LIGHTS - 1);
    float4 place = lightPosition[slot];
    float4 color = lightColor[slot];
    float3 direction = place.xyz;
    float attenuation = 1;
    // All pixels take the same branches: a sun costs no distance, and only a spot costs a cone.
    if (place.w > 0.5) {
        float3 toLight = place.xyz - position;
        float distanceSquared = dot(toLight, toLight);
        direction = toLight * rsqrt(max(distanceSquared, 1e-12));
        attenuation = distanceAttenuation(distanceSquared, color.w);
        if (place.w > 1.5) {
            float4 cone = lightCone[slot];
            float cosine = -dot(lightAxis[slot].xyz, direction);
            float spot = saturate((cosine - cone.y) / max(cone.x - cone.y, 0.001));
            attenuation *= spot * spot;
        }
    }
    Light light;
    light.direction = direction;
    light.color = color.rgb;
    if (lightmap && subtractive) { light.color = slot == mainLight ? float3(0) : light.color; }
    light.attenuation = attenuation;
    light.attenuation *= lightThroughCookie(slot, position);
    light.shadow = shadow(slot, position);
    light.index = int(lightCone[slot].z);
    light.type = int(place.w);
    return light;
}

/// In a material: the main directional light. In a lighting graph: the light being evaluated. In a material it is always
/// light 0, which is the brightest directional light if the scene has one.
[semantic("pixel")]
Light light(float3 position = positionWS) {
    return lightAt(0, position);
}

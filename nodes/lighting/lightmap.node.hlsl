// Light that was computed before and lies in a texture, and real-time light that must agree with it.

/// The shadow of a moving object in a lightmap that has the main light in it already.
///
/// What the light would add here is taken away again, as far as the shadow goes, but not below the shadow colour, and
/// nothing gets brighter.
///
/// formula: min(m, lerp(max(m - color saturate(n.l) (1 - attenuation), shadow_color), m, fade))
/// source: Unity built-in shaders, SubtractMainLightWithRealtimeAttenuationFromLightmap
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.8660254037844386, 0, 0.5), float3(1, 0.9, 0.8), 0, float3(0.2, 0.2, 0.25)) == float3(0.3, 0.25, 0.25)
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.8660254037844386, 0, 0.5), float3(1, 0.9, 0.8), 0.5, float3(0.2, 0.2, 0.25)) == float3(0.55, 0.475, 0.4)
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.6, 0, 0.8), float3(1, 0.9, 0.8), 1, float3(0.2, 0.2, 0.25)) == float3(0.8, 0.7, 0.6)
/// test: SubtractMainLight(float3(0.8, 0.8, 0.1), float3(0, 0, 1), float3(0.6, 0, 0.8), 1, 0, float3(0.2, 0.2, 0.2), 0.5) == float3(0.5, 0.5, 0.1)
[node("Lighting/Lightmap/Subtract Main Light")]
float3 SubtractMainLight(
    [color] float3 lightmap = 1,         ///< light of the lightmap, E / pi
    float3 normal = normal_ws,           ///< unit normal
    float3 light_dir = light.direction,  ///< unit direction to the main light
    [color] float3 light_color = 1,      ///< the main light's colour times intensity, E / pi
    [range(0, 1)] float attenuation = 1, ///< how much of it arrives: 0 is in shadow
    [color] float3 shadow_color = 0,     ///< what no shadow falls below
    [range(0, 1)] float fade = 0         ///< how much of the shadow is left out; 1 - strength of the light's shadows
) {
    float3 taken = light_color * (saturate(dot(normal, light_dir)) * (1 - attenuation));
    float3 shadowed = max(lightmap - taken, shadow_color);
    return min(lightmap, lerp(shadowed, lightmap, fade));
}

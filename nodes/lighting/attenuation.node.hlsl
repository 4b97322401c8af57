// Light attenuation by distance, cone and cookie.

/// The inverse square law, faded out smoothly at the light's range.
///
/// formula: saturate(1 - (distance / range)^4)^2 / max(distance^2, 0.0001)
/// source: Lagarde and de Rousiers, "Moving Frostbite to PBR", SIGGRAPH 2014, listing 4; the window is that of Karis, "Real
/// source: Shading in Unreal Engine 4", SIGGRAPH 2013, eq. 9
/// test: InverseSquareAttenuation(2, 4) == 0.2197265625
/// test: InverseSquareAttenuation(0.5, 10) == 3.9999500001562502
/// test: InverseSquareAttenuation(4, 4) == 0
/// test: InverseSquareAttenuation(0, 1) == 10000
[node("Lighting/Attenuation/Inverse Square")] [range(0, 10000)]
float InverseSquareAttenuation(
    [range(0, 100)] [unit("m")] float distance = 1,  ///< distance from the light
    [range(0.01, 100)] [unit("m")] float range = 10  ///< where the light ends
) {
    return distanceAttenuation(distance * distance, max(range, 1e-4));
}

/// The falloff of Unity's built-in point lights: a fit of the texture that they read.
///
/// formula: saturate(saturate(5 (1 - x)) / (1 + 25 x^2)), x = distance / range
/// source: a fit of the built-in falloff texture, whose contents are not public
/// test: UnityAttenuation(0.5) == 0.13793103448275862
/// test: UnityAttenuation(0.9) == 0.023529411764705875
/// test: UnityAttenuation(0) == 1
/// test: UnityAttenuation(1.2) == 0
[node("Lighting/Attenuation/Unity Falloff")] [range(0, 1)]
float UnityAttenuation(
    [range(0, 1)] float distanceOverRange = 0.5  ///< distance from the light, in units of its range
) {
    float x = distanceOverRange;
    return saturate(saturate(5 * (1 - x)) / (1 + 25 * x * x));
}

/// The edge of a light's range: 1 near the light, 0 from the range on.
///
/// formula: saturate(1 - (distance / range)^4)^2
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013, eq. 9
/// test: RangeAttenuation(0, 4) == 1
/// test: RangeAttenuation(2, 4) == 0.87890625
/// test: RangeAttenuation(5, 4) == 0
[node("Lighting/Attenuation/Range Window")] [range(0, 1)]
float RangeAttenuation(
    [range(0, 100)] [unit("m")] float distance = 1,  ///< distance from the light
    [range(0.01, 100)] [unit("m")] float range = 10  ///< where the light ends
) {
    float ratio = distance / max(range, 1e-4);
    float r2 = ratio * ratio;
    float window = saturate(1 - r2 * r2);
    return window * window;
}

/// The cone of a spot light: 1 inside, 0 outside, smooth between.
///
/// formula: saturate((a.d - outer) / (inner - outer))^2
/// source: Lagarde and de Rousiers, "Moving Frostbite to PBR", SIGGRAPH 2014, listing 5
/// test: SpotAttenuation(float3(0, 0, 1), float3(0, 0, -1), 0.9, 0.8) == 1
/// test: SpotAttenuation(float3(0.6, 0, 0.8), float3(0, 0, -1), 0.9, 0.7) == 0.25
/// test: SpotAttenuation(float3(0.8, 0, 0.6), float3(0, 0, -1), 0.9, 0.7) == 0
[node("Lighting/Attenuation/Spot Cone")] [range(0, 1)]
float SpotAttenuation(
    float3 lightDir = light.direction,  ///< unit direction to the light
    float3 axis = float3(0, -1, 0),      ///< unit direction that the spot shines along
    [range(-1, 1)] float inner = 0.9,    ///< cosine of half the angle of the fully lit cone
    [range(-1, 1)] float outer = 0.8     ///< cosine of half the angle at which the cone ends
) {
    float cone = saturate((-dot(lightDir, axis) - outer) / max(inner - outer, 0.001));
    return cone * cone;
}

/// The falloff of Unity's vertex lights.
///
/// formula: 1 / (1 + distance^2 falloff)
/// source: Unity built-in shaders, ShadeVertexLightsFull and Shade4PointLights
/// test: VertexLightAttenuation(4, 0.25) == 0.5
/// test: VertexLightAttenuation(0, 25) == 1
[node("Lighting/Attenuation/Vertex Light")] [range(0, 1)]
float VertexLightAttenuation(
    [range(0, 10000)] float distanceSquared = 1,  ///< squared distance from the light, in square metres
    [range(0, 1000)] float falloff = 0.25          ///< 25 / range^2
) {
    return 1 / (1 + distanceSquared * falloff);
}

/// Lambert's diffuse light of four point lights at once, as Unity computes it at each vertex.
///
/// formula: sum over i of color_i max(0, n.l_i) / (1 + distance_i^2 falloff_i)
/// source: Unity built-in shaders, Shade4PointLights
/// test: FourPointLights(float3(0, 0, 0), float3(0.6, 0.8, 0), float4(1, 0, 0, 5), float4(0, 2, 0, 0), float4(0, 0, -3, 5), float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1), float3(1, 1, 1), float4(0.25, 0.25, 0.25, 25 / 36)) == float3(0.4918767546451239, 0.41187675464512397, 0.01187675464512397)
/// test: FourPointLights(float3(0, 0, 0), float3(0, 1, 0), 0, 0, 0, 1, 1, 1, 1, 1) == float3(0, 0, 0)
[node("Lighting/Attenuation/Four Point Lights")]
float3 FourPointLights(
    [unit("m")] float3 position = positionWS,  ///< the lit point
    float3 normal = normalWS,                  ///< unit normal
    [unit("m")] float4 lightX,                 ///< positions of the four lights: their x
    [unit("m")] float4 lightY,                 ///< their y
    [unit("m")] float4 lightZ,                 ///< their z
    [color] float3 color0,                      ///< colour of the first light
    [color] float3 color1,                      ///< of the second
    [color] float3 color2,                      ///< of the third
    [color] float3 color3,                      ///< of the fourth
    float4 falloff                              ///< 25 / range^2 of each
) {
    float4 x = lightX - position.x;
    float4 y = lightY - position.y;
    float4 z = lightZ - position.z;
    // A light exactly at the point must not give 0 * infinity.
    float4 squared = max(x * x + y * y + z * z, 1e-6);
    float4 ndotl = max((x * normal.x + y * normal.y + z * normal.z) * rsqrt(squared), 0);
    float4 amount = ndotl / (1 + squared * falloff);
    return color0 * amount.x + color1 * amount.y + color2 * amount.z + color3 * amount.w;
}

/// The texture coordinates in a light's cookie, the texture that the light shines through.
///
/// A spot light projects it in perspective, a directional light along its parallel rays.
///
/// formula: uv = p.xy / p.w; lit where p.w > 0
/// source: Unity built-in shaders, UnitySpotCookie
/// test: CookieUV(float4(1, 3, 2, 4)) == float2(0.25, 0.75)
/// test: CookieUV(float4(1, 3, 2, 4)).lit == 1
/// test: CookieUV(float4(1, 3, 2, -4)).lit == 0
/// test: CookieUV(float4(1, 3, 2, 0)).lit == 0
/// test: CookieUV(float4(0.25, -0.5, 7, 1)) == float2(0.25, -0.5)
[node("Lighting/Attenuation/Cookie UV")]
float2 CookieUV(
    float4 place,                ///< the lit point, transformed by the matrix from the world to the cookie
    [range(0, 1)] out float lit  ///< 1 in front of the light, 0 behind it
) {
    lit = place.w > 0 ? 1 : 0;
    return place.xy / max(place.w, 1e-4);
}

/// The share of a light that passes through its cookie.
///
/// formula: cookie(p.xy / p.w) where p.w > 0, else 0
/// source: Unity built-in shaders, UnitySpotCookie; there it is alpha that counts
[node("Lighting/Attenuation/Cookie")]
float CookieAttenuation(
    Texture2D cookie,  ///< red: the share that passes
    float4 place       ///< the lit point, transformed by the matrix from the world to the cookie
) {
    return cookie.SampleLevel(CookieUV(place), 0).r * CookieUV(place).lit;
}

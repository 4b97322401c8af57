// Lightmaps: decoding light that was baked into a texture, and combining it with real-time light.

/// Subtracts the shadow of a moving object from a lightmap that already contains the main light.
///
/// The node subtracts the shadowed share of the main light. The result does not fall below the shadow colour, and does
/// not become brighter.
///
/// formula: min(m, lerp(max(m - color saturate(n.l) (1 - attenuation), shadowColor), m, fade))
/// source: Unity built-in shaders, SubtractMainLightWithRealtimeAttenuationFromLightmap
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.8660254037844386, 0, 0.5), float3(1, 0.9, 0.8), 0, float3(0.2, 0.2, 0.25)) == float3(0.3, 0.25, 0.25)
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.8660254037844386, 0, 0.5), float3(1, 0.9, 0.8), 0.5, float3(0.2, 0.2, 0.25)) == float3(0.55, 0.475, 0.4)
/// test: SubtractMainLight(float3(0.8, 0.7, 0.6), float3(0, 0, 1), float3(0.6, 0, 0.8), float3(1, 0.9, 0.8), 1, float3(0.2, 0.2, 0.25)) == float3(0.8, 0.7, 0.6)
/// test: SubtractMainLight(float3(0.8, 0.8, 0.1), float3(0, 0, 1), float3(0.6, 0, 0.8), 1, 0, float3(0.2, 0.2, 0.2), 0.5) == float3(0.5, 0.5, 0.1)
[node("Lighting/Lightmap/Subtract Main Light")]
float3 SubtractMainLight(
    [color] float3 lightmap = 1,         ///< light of the lightmap, E / pi
    float3 normal = normalWS,           ///< unit normal
    float3 lightDir = light.direction,  ///< unit direction to the main light
    [color] float3 lightColor = 1,      ///< the main light's colour times intensity, E / pi
    [range(0, 1)] float attenuation = 1, ///< share of the light that arrives: 0 is in shadow
    [color] float3 shadowColor = 0,     ///< lower limit of the shadow
    [range(0, 1)] float fade = 0         ///< omitted share of the shadow: 1 - strength of the light's shadows
) {
    float3 taken = lightColor * (saturate(dot(normal, lightDir)) * (1 - attenuation));
    float3 shadowed = max(lightmap - taken, shadowColor);
    return min(lightmap, lerp(shadowed, lightmap, fade));
}

/// How the texels of a lightmap encode light that is brighter than 1.
enum LightmapEncoding {
    FullHDR,    ///< unchanged, in floats
    DoubleLDR,  ///< half of it: up to 2 in gamma space
    RGBM        ///< with a factor in alpha: up to 5 in gamma space
};

/// Decodes the light of a lightmap's texel.
///
/// The ranges are 2 and 5 in gamma space; if lighting is computed in linear space, they are raised to the power of 2.2.
///
/// formula: linear: c, 2^2.2 c, (5 a)^2.2 c; gamma: c, 2 c, 5 a c
/// source: Unity built-in shaders, DecodeLightmap
/// test: DecodeLightmap(float4(3, 2, 1, 0)) == float3(3, 2, 1)
/// test: DecodeLightmap(float4(1, 0.5, 0, 0.3), DoubleLDR) == float3(4.59479341998814, 2.29739670999407, 0)
/// test: DecodeLightmap(float4(1, 0.5, 0, 0.3), DoubleLDR, Gamma) == float3(2, 1, 0)
/// test: DecodeLightmap(float4(0.3, 0.6, 0.9, 0.2), RGBM) == float3(0.3, 0.6, 0.9)
/// test: DecodeLightmap(float4(0.3, 0.6, 0.9, 1), RGBM) == float3(10.347972460959115, 20.69594492191823, 31.043917382877346)
/// test: DecodeLightmap(float4(0.3, 0.6, 0.9, 0.5), RGBM, Gamma) == float3(0.75, 1.5, 2.25)
[node("Lighting/Lightmap/Decode Lightmap")]
float3 DecodeLightmap(
    float4 encoded,                             ///< the texel
    const LightmapEncoding encoding = FullHDR,  ///< how it encodes light
    const WorkingSpace space = Linear           ///< colour space that lighting is computed in
) {
    if (encoding == FullHDR) { return encoded.rgb; }
    if (encoding == DoubleLDR) { return encoded.rgb * (space == Linear ? 4.59479342 : 2); }
    return DecodeHDR(encoded, float4(space == Linear ? 34.4932415 : 5, 2.2, 0, 1), space);
}

/// Encodes light in four 8-bit channels: alpha is a factor for the other three, so that bright and dark values keep
/// their precision. DecodeHDR decodes it, with the range, an exponent of 1, 0 and 1.
///
/// Light above the range loses its hue if the render target clamps it to 1.
///
/// formula: m = ceil(255 max(r, g, b, 0.02 range) / range) / 255; (c / (range m), m)
/// source: Unity built-in shaders, UnityEncodeRGBM
/// test: EncodeRGBM(float3(5, 2.5, 0), 5) == float4(1, 0.5, 0, 1)
/// test: EncodeRGBM(float3(0.5, 0.25, 1), 5) == float4(0.5, 0.25, 1, 0.2)
/// test: EncodeRGBM(float3(0, 0, 0), 5) == float4(0, 0, 0, 0.023529411764705882)
[node("Lighting/Lightmap/Encode RGBM")]
float4 EncodeRGBM(
    [color] float3 color = 1,          ///< light, 0 or more
    [range(0.1, 100)] float range = 5  ///< the brightest light that can be held
) {
    float3 share = color / range;
    float factor = ceil(max(max(max(share.r, share.g), share.b), 0.02) * 255) / 255;
    return float4(share / factor, factor);
}

/// The light of a directional lightmap, which also holds the dominant direction, on a surface with a normal map.
///
/// formula: c (dot(n, t.xyz - 0.5) + 0.5) / max(t.w, 0.0001), t the texel
/// source: Unity built-in shaders, DecodeDirectionalLightmap
/// test: DirectionalLightmap(float3(1, 0.5, 0.25), float4(0.5, 0.5, 1, 0.5), float3(0, 0, 1)) == float3(2, 1, 0.5)
/// test: DirectionalLightmap(float3(1, 0.5, 0.25), float4(0.5, 0.5, 1, 0.5), float3(0.6, 0, 0.8)) == float3(1.8, 0.9, 0.45)
/// test: DirectionalLightmap(float3(1, 0.5, 0.25), float4(0.5, 0.5, 1, 0.5), float3(0, 0, -1)) == float3(0, 0, 0)
/// test: DirectionalLightmap(float3(1, 0.5, 0.25), float4(0.75, 0.25, 0.5, 1), float3(0, 1, 0)) == float3(0.25, 0.125, 0.0625)
[node("Lighting/Lightmap/Directional Lightmap")]
float3 DirectionalLightmap(
    [color] float3 lightmap = 1,     ///< light on the surface without the normal map, decoded
    [range(0, 1)] float4 direction,  ///< xyz: 0.5 d + 0.5, d to the light, short if spread; w: the divisor
    float3 normal = normalWS        ///< unit normal
) {
    float halfLambert = dot(normal, direction.xyz - 0.5) + 0.5;
    return lightmap * (halfLambert / max(direction.w, 1e-4));
}

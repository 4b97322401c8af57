// What a G-buffer holds between the pass that draws surfaces and the one that lights them.

/// A unit normal as a G-buffer of unsigned numbers holds it.
///
/// formula: 0.5 n + 0.5
/// source: Unity built-in shaders, UnityStandardDataToGbuffer
/// test: EncodeGBufferNormal(float3(0.6, 0, 0.8)) == float3(0.8, 0.5, 0.9)
/// test: EncodeGBufferNormal(float3(-0.48, 0.6, 0.64)) == float3(0.26, 0.8, 0.82)
[node("Lighting/Deferred/Encode Normal")] [range(0, 1)]
float3 EncodeGBufferNormal(
    float3 normal = normalWS  ///< unit normal
) {
    return normal * 0.5 + 0.5;
}

/// The unit normal of a G-buffer's texel.
///
/// formula: normalize(2 c - 1)
/// source: Unity built-in shaders, UnityStandardDataFromGbuffer
/// test: DecodeGBufferNormal(float3(0.8, 0.5, 0.9)) == float3(0.6, 0, 0.8)
/// test: DecodeGBufferNormal(float3(0.26, 0.8, 0.82)) == float3(-0.48, 0.6, 0.64)
/// test: DecodeGBufferNormal(float3(0.5, 0.5, 0.75)) == float3(0, 0, 1)
[node("Lighting/Deferred/Decode Normal")] [range(-1, 1)]
float3 DecodeGBufferNormal(
    float3 encoded = float3(0.5, 0.5, 1)  ///< the texel
) {
    float3 normal = encoded * 2 - 1;
    return normal * rsqrt(max(dot(normal, normal), 1e-6));
}

/// Light as a render target of unsigned numbers holds it: lights are then added by multiplying.
///
/// formula: 2^-c
/// source: Unity built-in shaders, the deferred pass without HDR
/// test: EncodeLightLdr(0.7) == float3(0.6155722066724582, 0.6155722066724582, 0.6155722066724582)
/// test: EncodeLightLdr(float3(0, 1, 3)) == float3(1, 0.5, 0.125)
[node("Lighting/Deferred/Encode Light")]
float3 EncodeLightLdr(
    float3 color = 0  ///< linear light, 0 or more
) {
    return exp2(-color);
}

// Unity's target has ten bits, and 0 is what was below half a step of them when it was rounded. No more is known of it, so it
// counts as that half step: light ends at log2(2046) = 10.999, as far beyond the last step, log2(1023) = 9.999, as that is
// beyond the one before.
const float LDR_DARKEST = 0.5 / 1023;

/// The light that EncodeLightLdr wrote.
///
/// The target has ten bits: black counts as half a step of them, so that light ends at 11.
///
/// formula: -log2(max(c, 1 / 2046))
/// source: Unity built-in shaders, the deferred pass without HDR
/// test: DecodeLightLdr(float3(1, 0.5, 0.125)) == float3(0, 1, 3)
/// test: DecodeLightLdr(0.6155722066724582) == float3(0.7, 0.7, 0.7)
/// test: DecodeLightLdr(0) == float3(10.99859042974533, 10.99859042974533, 10.99859042974533)
[node("Lighting/Deferred/Decode Light")]
float3 DecodeLightLdr(
    [range(0, 1)] float3 encoded = 1  ///< the texel
) {
    return -log2(max(encoded, LDR_DARKEST));
}

// The encodings of a G-buffer: one pass writes the surfaces, later passes light them.

/// Encodes a unit normal for a G-buffer with an unsigned format.
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

/// Decodes the unit normal of a G-buffer's texel.
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

/// Encodes light for a render target with an unsigned format: multiplying two encoded values adds their light.
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

// Unity's render target has ten bits, and all values below half a step are rounded to 0. A stored 0 therefore counts as
// half a step: light ends at log2(2046) = 10.999, which is as far above the last step, log2(1023) = 9.999, as that step
// is above the previous one.
const float LDR_DARKEST = 0.5 / 1023;

/// Decodes the light that EncodeLightLdr encoded.
///
/// The render target has ten bits: black counts as half a step, so that light ends at 11.
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

// Storing numbers in textures with 8-bit channels.

/// Stores a number from 0 to 1 in two 8-bit channels: the first holds the coarse value, the second the remainder.
///
/// formula: (floor(255 x) / 255, frac(255 x))
/// source: Unity built-in shaders, EncodeFloatRG; here 1 stays 1, and does not become 0
/// test: EncodeFloatRG(0.5) == float2(0.4980392156862745, 0.5)
/// test: EncodeFloatRG(0.001) == float2(0, 0.255)
/// test: EncodeFloatRG(0) == float2(0, 0)
/// test: EncodeFloatRG(1) == float2(1, 0)
[node("Math/Packing/Encode Float RG")]
float2 EncodeFloatRG(
    [range(0, 1)] float value = 0  ///< the number to store
) {
    float scaled = 255 * value;
    float whole = floor(scaled);
    return float2(whole / 255, scaled - whole);
}

/// Reads the number that EncodeFloatRG stored.
///
/// formula: r + g / 255
/// source: Unity built-in shaders, DecodeFloatRG
/// test: DecodeFloatRG(float2(0.4980392156862745, 0.5)) == 0.5
/// test: DecodeFloatRG(float2(0, 0.255)) == 0.001
/// test: DecodeFloatRG(float2(1, 0)) == 1
[node("Math/Packing/Decode Float RG")]
float DecodeFloatRG(
    [range(0, 1)] float2 encoded = 0  ///< the two channels
) {
    return encoded.x + encoded.y / 255;
}

// Splitting and combining vectors. A link can also select components: "albedo.rgb", "albedo.a".

/// Splits a vector: each component at its own output.
///
/// test: Split(float4(1, 2, 3, 4)).b == 3
/// test: Split(float4(1, 2, 3, 4)).a == 4
/// test: Split(float4(1, 2, 3, 4)) == float4(1, 2, 3, 4)
[node("Vector/Split")] [also("Extract", "Separate", "Separate3", "Break")]
float4 Split(
    float4 value,  ///< colour or vector
    out float r,   ///< red, or x
    out float g,   ///< green, or y
    out float b,   ///< blue, or z
    out float a    ///< alpha, or w
) {
    r = value.r;
    g = value.g;
    b = value.b;
    a = value.a;
    return value;
}

/// Combines components into a vector.
///
/// test: Combine(1, 2, 3, 4) == float4(1, 2, 3, 4)
/// test: Combine(1, 2, 3).rgb == float3(1, 2, 3)
/// test: Combine(1, 2).rg == float2(1, 2)
[node("Vector/Combine")] [also("Append", "Combine2", "Combine3", "Combine4", "MakeFloat3")]
float4 Combine(
    float x = 0,     ///< x, or red
    float y = 0,     ///< y, or green
    float z = 0,     ///< z, or blue
    float w = 0,     ///< w, or alpha
    out float3 rgb,  ///< the first three
    out float2 rg    ///< the first two
) {
    rgb = float3(x, y, z);
    rg = float2(x, y);
    return float4(x, y, z, w);
}

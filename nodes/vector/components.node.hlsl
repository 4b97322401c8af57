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

/// What a component of Swizzle reads.
enum Component {
    X,    ///< the first: red
    Y,    ///< the second: green
    Z,    ///< the third: blue
    W,    ///< the fourth: alpha
    Zero, ///< 0
    One   ///< 1
};

/// One component, or a constant.
float ComponentOf(float4 value, const Component which) {
    if (which == Zero) { return 0; }
    if (which == One) { return 1; }
    return which == X ? value.x : which == Y ? value.y : which == Z ? value.z : value.w;
}

/// Reorders the components of a vector.
///
/// In an expression, `v.zyx` does the same.
///
/// test: Swizzle(float4(1, 2, 3, 4), Z, Y, X, W) == float4(3, 2, 1, 4)
/// test: Swizzle(float4(5, 6, 7, 8), W, One, Zero, Zero) == float4(8, 1, 0, 0)
/// test: Swizzle(float4(5, 6, 7, 8), One, X, Y, Z) == float4(1, 5, 6, 7)
/// test: Swizzle(float4(5, 6, 7, 8), Zero, W, One, One) == float4(0, 8, 1, 1)
/// test: Swizzle(float4(5, 6, 7, 8), Y, Z, W, X) == float4(6, 7, 8, 5)
/// test: Swizzle(float4(5, 6, 7, 8), X, Zero, Z, Y) == float4(5, 0, 7, 6)
[node("Vector/Swizzle")]
float4 Swizzle(
    float4 value,              ///< colour or vector
    const Component first = X,   ///< what the first component reads
    const Component second = Y,  ///< what the second one reads
    const Component third = Z,   ///< what the third one reads
    const Component fourth = W   ///< what the fourth one reads
) {
    return float4(ComponentOf(value, first), ComponentOf(value, second), ComponentOf(value, third),
                  ComponentOf(value, fourth));
}

// What HLSL converts without being told. Each expected value follows from the rules of HLSL's reference: the later of
// bool, int, uint, half and float; the shorter of two vectors; a quotient of integers is cut towards 0.
#pragma hlsl

/// int of a float is cut towards 0.
/// test: Cut(2.9) == 2
/// test: Cut(-2.9) == -2
[node("Test/Cut")]
float Cut(float x) {
    int n = x;
    return n;
}

/// A literal that is a whole number is an int: 7 / 2 is 3.
/// test: Quotient(1) == 3
[node("Test/Quotient")]
float Quotient(float x) {
    return 7 / 2 * x;
}

/// test: Mixed(3) == 4.5
/// test: Mixed(4) == 6
[node("Test/Mixed")]
float Mixed(float x) {
    int n = x;
    return n * 1.5;
}

/// -7 / 2 is -3, and the rest has the sign of the dividend.
/// test: Rest(-7, 2) == float2(-3, -1)
/// test: Rest(7, -2) == float2(-3, 1)
[node("Test/Rest")]
float2 Rest(float a, float b) {
    int i = a, j = b;
    return float2(i / j, i % j);
}

/// A vector that is too long is cut; a number fills one.
/// test: Shorter(float4(1, 2, 3, 4)) == float2(2, 3)
[node("Test/Shorter")]
float2 Shorter(float4 v) {
    float3 three = v;
    float2 two = three;
    two += 1;
    return two;
}

/// The shorter of two vectors decides.
/// test: Shortest(float4(1, 2, 3, 4), float2(10, 20)) == float2(11, 22)
[node("Test/Shortest")]
float2 Shortest(float4 a, float2 b) {
    return a + b;
}

/// test: Truth(0) == 0
/// test: Truth(-0.5) == 3
[node("Test/Truth")]
float Truth(float x) {
    bool is = x;
    float made = is + is;
    if (x) made++;
    return made;
}

/// test: Not(0) == 1
/// test: Not(2) == 0
[node("Test/Not")]
float Not(float x) {
    return !x;
}

/// test: Choice(1) == 10
/// test: Choice(0) == 0.5
[node("Test/Choice")]
float Choice(float x) {
    return x ? 10 : 0.5;
}

/// A condition of three components chooses each component.
/// test: EachChoice(float3(-1, 0, 2)) == float3(0, 0, 2)
[node("Test/EachChoice")]
float3 EachChoice(float3 v) {
    return v > 0 ? v : 0;
}

/// test: Casts(float3(1.5, 2.5, 3.5)) == float3(1, 2, 2.5)
[node("Test/Casts")]
float3 Casts(float3 v) {
    float2 flat = (float2)v;
    int2 whole = (int2)flat;
    return float3((float)whole.x, whole.y, (float)flat.y);
}

/// (float3)1 fills the vector.
/// test: Filled(2) == float3(2, 2, 2)
[node("Test/Filled")]
float3 Filled(float x) {
    return (float3)x;
}

/// test: Bits(6) == float3(2, 14, 12)
[node("Test/Bits")]
float3 Bits(float x) {
    uint u = x;
    return float3(u & 3, u | 8, u << 1);
}

/// sign() is an int: half of it is 0.
/// test: HalfOfSign(5) == 0
[node("Test/HalfOfSign")]
float HalfOfSign(float x) {
    return sign(x) / 2;
}

/// test: Functions(4) == float4(0.25, 2, 9, 2)
[node("Test/Functions")]
float4 Functions(float x) {
    int n = x;
    return float4(rcp(x), log10(100 * x / 4), mad(2, n, 1), max(n, 2) - 2);
}

/// The sine of 0 is 0, and its cosine is 1.
/// test: Circle(0) == float2(0, 1)
[node("Test/Circle")]
float2 Circle(float angle) {
    float s, c;
    sincos(angle, s, c);
    return float2(s, c);
}

/// test: Parts(-2.25) == float2(-0.25, -2)
[node("Test/Parts")]
float2 Parts(float x) {
    float whole;
    float rest = modf(x, whole);
    return float2(rest, whole);
}

/// Elements of a matrix by their names.
/// test: Elements(1) == float4(2, 3, 1, 4)
[node("Test/Elements")]
float4 Elements(float x) {
    float2x2 m = { x, 2, 3, 4 };
    return float4(m._m01_m10, m._11, m._m11);
}

/// The upper left part of a larger matrix.
/// test: Smaller(float3(1, 2, 3)) == float3(2, 4, 6)
[node("Test/Smaller")]
float3 Smaller(float3 v) {
    float4x4 large = float4x4(2, 0, 0, 9, 0, 2, 0, 9, 0, 0, 2, 9, 9, 9, 9, 9);
    float3x3 m = (float3x3)large;
    return mul(m, v);
}

/// Matrices are multiplied element by element with *.
/// test: ByElement(3) == float2(6, 12)
[node("Test/ByElement")]
float2 ByElement(float x) {
    float2x2 m = float2x2(1, 0, 0, 2);
    m = m * 2 * x;
    return float2(m._m00, m._m11);
}

/// mul() of two vectors is their dot product.
/// test: Product(float3(1, 2, 3)) == 14
[node("Test/Product")]
float Product(float3 v) {
    return mul(v, v);
}

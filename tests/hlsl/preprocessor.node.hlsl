#pragma hlsl
// The preprocessor.
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Common.hlsl"
#define PI_TWICE 6.5
#define SQUARE(x) ((x) * (x))
#define LERP(a, b, t) \
    ((a) + ((b) - (a)) * (t))
#define NAME(i) value##i
#define NOTHING

#if defined(PI_TWICE) && !defined(OTHER)
#define KNOWN 1
#elif KNOWN == 7
#error "this is left out"
#else
#define KNOWN 2
#endif
#ifndef KNOWN
this is no code at all ( {
#endif

/// test: Macros(3) == float4(6.5, 16, 2, 1)
[node("Test/Macros")]
float4 Macros(float x) {
    NOTHING
    float value7 = SQUARE(x + 1);
    return float4(PI_TWICE, NAME(7), LERP(1, x, 0.5), KNOWN);
}

#define WEIGHED(weight, ...) (weight * max(__VA_ARGS__))
#define FIRST(...) FIRST_OF(__VA_ARGS__)
#define FIRST_OF(a, ...) a
/// Macros that take any number of arguments.
/// test: AnyNumber(3) == float2(6, 3)
[node("Test/AnyNumber")]
float2 AnyNumber(float x) {
    return float2(WEIGHED(2, 1, x), FIRST(x, 5));
}

#undef SQUARE
#define SQUARE(x) (x + 0)
#define AGAIN SQUARE
/// A macro that names another one with its arguments behind it, and one that names itself.
/// test: Again(2) == 2
[node("Test/Again")]
float Again(float x) {
#define x x
    return SQUARE(x);
#undef x
}

// Functions that HLSL has and the node language does not need. Only files that begin with `#pragma hlsl` call them.

/// 1 / x
[hlsl] [inline]
floatN rcp(floatN x) {
    return 1 / x;
}

/// The logarithm to the base 10.
[hlsl] [inline]
floatN log10(floatN x) {
    return 0.30102999566398120 * log2(x);
}

/// a * b + c
[hlsl] [inline]
floatN mad(floatN a, floatN b, floatN c) {
    return a * b + c;
}

/// a * b + c
[hlsl] [inline]
floatN fma(floatN a, floatN b, floatN c) {
    return a * b + c;
}

/// x times 2 to the power of the exponent.
[hlsl] [inline]
floatN ldexp(floatN x, floatN exponent) {
    return x * exp2(exponent);
}

/// The part behind the point; the other part goes to `whole`. Both have the sign of x.
[hlsl] [inline]
floatN modf(floatN x, out floatN whole) {
    whole = trunc(x);
    return x - whole;
}

/// Sine and cosine of one angle.
[hlsl] [inline]
void sincos(floatN angle, out floatN sine, out floatN cosine) {
    sine = sin(angle);
    cosine = cos(angle);
}

/// The normal, turned so that it faces against the direction.
[hlsl] [inline]
float3 faceforward(float3 normal, float3 direction, float3 reference) {
    return dot(direction, reference) < 0 ? normal : -normal;
}

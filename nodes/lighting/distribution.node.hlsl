// Normal distributions D: the share of a rough surface's microfacets whose normal is the half vector h. Each is
// normalised: the integral of D (n.h) over the hemisphere is 1.

/// GGX (Trowbridge-Reitz): a sharp peak with long tails, as of most real surfaces.
///
/// formula: D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1)^2)
/// source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 33
/// test: DistributionGGX(1, 0.5) == 1.2732395447351628
/// test: DistributionGGX(0.9, 0.5) == 0.5165481539758866
/// test: DistributionGGX(0.5, 0.25) == 0.03393891331239084
/// test: DistributionGGX(0.1, 1) == 0.3183098861837907
/// test: DistributionGGX(0.99, 0.1) == 3.6083444122158266 within 1e-4
[node("Lighting/Distribution/GGX")]
float DistributionGGX(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    // The denominator uses 1 - (n.h)^2, because the printed formula loses precision near the peak. The limit keeps a
    // perfect mirror finite: it is as rough as alpha 0.0004. The quotient is squared rather than its parts, which half
    // precision could not hold.
    float a = max(alpha, 0.0004);
    float p = a / ((1 - ndoth) * (1 + ndoth) + ndoth * a * (ndoth * a));
    return p * p * INV_PI;
}

/// Blinn-Phong, normalised: a round highlight without tails.
///
/// formula: D = (exponent + 2) / (2 pi) (n.h)^exponent
/// source: Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH 1977, here normalised
/// test: DistributionBlinnPhong(1, 30) == 5.092958178940651
/// test: DistributionBlinnPhong(0.95, 30) == 1.093146248340894
/// test: DistributionBlinnPhong(0, 8) == 0
/// test: DistributionBlinnPhong(0.5, 2) == 0.15915494309189535
[node("Lighting/Distribution/Blinn-Phong")]
float DistributionBlinnPhong(
    [range(0, 1)] float ndoth,             ///< cosine of normal and half vector
    [range(0, 20000)] float exponent = 32  ///< sharpness, above 0; BlinnPhongExponentFromAlpha computes it
) {
    return (exponent + 2) * (0.5 * INV_PI) * pow(max(ndoth, 0), exponent);
}

/// The Blinn-Phong exponent whose highlight is as wide as that of a microfacet surface of the given roughness.
///
/// formula: 2 / alpha^2 - 2, from 0.0001 to 19998
/// source: Walter et al., EGSR 2007, section 5.2 (alphaP = 2 alphaB^-2 - 2)
/// test: BlinnPhongExponentFromAlpha(0.5) == 6
/// test: BlinnPhongExponentFromAlpha(0.0625) == 510
/// test: BlinnPhongExponentFromAlpha(0.5625) == 4.320987654320987
/// test: BlinnPhongExponentFromAlpha(0) == 19998
/// test: BlinnPhongExponentFromAlpha(1) == 0.0001
[node("Lighting/Distribution/Blinn-Phong Exponent from Alpha")] [range(0.0001, 19998)]
float BlinnPhongExponentFromAlpha(
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    // The limits keep the exponent finite, and prevent zero to the power of zero.
    return max(2 / max(alpha * alpha, 0.0001) - 2, 0.0001);
}

/// The Blinn-Phong roughness alpha of an exponent: the inverse of BlinnPhongExponentFromAlpha.
///
/// formula: alpha = sqrt(2 / (exponent + 2))
/// source: Walter et al., EGSR 2007, section 5.2
/// test: AlphaFromBlinnPhongExponent(6) == 0.5
/// test: AlphaFromBlinnPhongExponent(0) == 1
/// test: AlphaFromBlinnPhongExponent(510) == 0.0625
[node("Lighting/Distribution/Alpha from Blinn-Phong Exponent")] [range(0, 1)]
float AlphaFromBlinnPhongExponent(
    [range(0, 20000)] float exponent = 32  ///< sharpness, 0 or more
) {
    return sqrt(2 / (max(exponent, 0) + 2));
}

/// The Phong exponent whose highlight is as wide as a Blinn-Phong one: a fourth, because the angle to the mirror
/// direction is twice the angle to the half vector.
///
/// formula: exponent / 4
/// source: Fisher and Woo, "R.E versus N.H Specular Highlights", Graphics Gems IV, 1994
/// test: PhongExponentFromBlinnPhong(128) == 32
/// test: PhongExponentFromBlinnPhong(8) == 2
[node("Lighting/Distribution/Phong Exponent from Blinn-Phong")] [range(0, 5000)]
float PhongExponentFromBlinnPhong(
    [range(0, 20000)] float exponent = 32  ///< of the Blinn-Phong highlight
) {
    return exponent * 0.25;
}

/// Blinn-Phong, normalised, with a roughness instead of an exponent.
///
/// formula: D = (n.h)^(2 / alpha^2 - 2) / (pi alpha^2)
/// source: Walter et al., EGSR 2007, section 5.2
/// test: DistributionBlinnPhongRoughness(1, 0.5) == 1.2732395447351628
/// test: DistributionBlinnPhongRoughness(0.9, 0.5) == 0.6766516968935997
/// test: DistributionBlinnPhongRoughness(0.5, 1) == 0.3183098861837907
/// test: DistributionBlinnPhongRoughness(0, 0.25) == 0
[node("Lighting/Distribution/Blinn-Phong Roughness")]
float DistributionBlinnPhongRoughness(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float a2 = max(alpha * alpha, 1e-7);
    // At alpha 1 the exponent is zero, and 0^0 is not defined: a tiny base gives the correct value, 1.
    return pow(max(ndoth, 1e-7), 2 / a2 - 2) / (PI * a2);
}

/// Beckmann: facets whose slopes follow a Gaussian distribution, with shorter tails than GGX.
///
/// formula: D = exp(((n.h)^2 - 1) / (alpha^2 (n.h)^2)) / (pi alpha^2 (n.h)^4)
/// source: Cook and Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1), 1982
/// test: DistributionBeckmann(1, 0.5) == 1.2732395447351628
/// test: DistributionBeckmann(0.9, 0.5) == 0.7593708123748896
/// test: DistributionBeckmann(0.5, 1) == 0.25356345704959005
/// test: DistributionBeckmann(0, 0.5) == 0
[node("Lighting/Distribution/Beckmann")]
float DistributionBeckmann(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    // Far from the normal, the exponential is zero long before c2 reaches its limit. There are two divisions because
    // half precision could not hold the product.
    float c2 = max(ndoth * ndoth, 0.001);
    float a2 = max(alpha * alpha, 1e-7);
    float tan2 = max(1 - ndoth, 0) * (1 + ndoth) / c2;
    return exp(-tan2 / a2) / (PI * a2) / (c2 * c2);
}

/// GGX as Unity's Standard shader computes it.
///
/// The 0.0000001 in the denominator lowers the peak of surfaces smoother than alpha 0.05, and removes that of mirrors.
///
/// formula: D = alpha^2 / (pi (((n.h)^2 (alpha^2 - 1) + 1)^2 + 0.0000001))
/// source: Unity built-in shaders, GGXTerm; Walter et al., EGSR 2007, eq. 33
/// test: DistributionGGXUnity(1, 0.25) == 5.092827802548905
/// test: DistributionGGXUnity(0.5, 0.25) == 0.03393890752256306
/// test: DistributionGGXUnity(1, 1) == 0.31830985435280523
[node("Lighting/Distribution/GGX Unity")] [also("GGXTerm")]
float DistributionGGXUnity(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float a2 = alpha * alpha;
    float spread = (ndoth * a2 - ndoth) * ndoth + 1;
    return INV_PI * a2 / (spread * spread + 1e-7);
}

/// GGX as Unity's second model (BRDF2) computes it.
///
/// The 0.00001 in the denominator lowers the peak of surfaces smoother than alpha 0.03.
///
/// formula: D = alpha^2 / (pi ((n.h)^2 (alpha^2 - 1) + 1.00001)^2)
/// source: Unity built-in shaders, BRDF2_Unity_PBS; Walter et al., EGSR 2007, eq. 33
/// test: DistributionGGXMinimalist(1, 1) == 0.31830352008155866
/// test: DistributionGGXMinimalist(1, 0.5) == 1.2731376916828072
/// test: DistributionGGXMinimalist(0.5, 0.25) == 0.033938026762228596
/// test: DistributionGGXMinimalist(1, 0) == 0
[node("Lighting/Distribution/GGX Minimalist")]
float DistributionGGXMinimalist(
    [range(0, 1)] float ndoth,        ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float peak = MinimalistPeak(ndoth, alpha);
    return INV_PI * peak * peak;
}

// The square root of pi D, which half precision can still square.
float MinimalistPeak(float ndoth, float alpha) {
    float spread = (1 - ndoth) * (1 + ndoth) + ndoth * ndoth * alpha * alpha;
    return alpha / (spread + 1e-5);
}

/// GGX for half precision: the squared length of a cross product replaces 1 - (n.h)^2, which is inexact near the peak.
///
/// The result is limited to the largest number that half precision holds, which dims the peak of surfaces smoother
/// than alpha 0.004.
///
/// formula: D = p^2 / pi, p = alpha / (|cross(n, h)|^2 + (n.h)^2 alpha^2)
/// source: Guy and Agopian, "Physically Based Rendering in Filament", section 4.4.1 (Lagrange's identity)
/// test: DistributionGGXMobile(float3(0, 0, 1), float3(0.6, 0, 0.8), 0.25) == 0.12433979929054328
/// test: DistributionGGXMobile(float3(0, 0, 1), float3(0, 0, 1), 0.5) == 1.2732395447351628
/// test: DistributionGGXMobile(float3(0, 1, 0), float3(0, 1, 0), 0.001) == 20850.570784583026
[node("Lighting/Distribution/GGX Mobile")]
float DistributionGGXMobile(
    float3 normal = normalWS,        ///< unit normal
    float3 halfVector,               ///< unit half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float3 across = cross(normal, halfVector);
    float a = dot(normal, halfVector) * alpha;
    float p = alpha / max(dot(across, across) + a * a, 6e-8);
    // Just above the square root of 65504: the square of a larger number could be infinite in half precision.
    p = min(p, 255.9375);
    return min(p * p, 65504) * INV_PI;
}

// The parts of GTR's constant. With x = (gamma - 1) ln(alpha^2), it is mean * x / (1 - e^-x) / pi. This equals both
// closed forms (for gamma 1, and for all others); near zero, the quotients are computed as series.
float GTRMean(float a2) {
    float d = a2 - 1;
    float series = 1 / (1 - d * (0.5 - d * (1.0 / 3 - d * (0.25 - d * 0.2))));
    // The other divisor only prevents a division by zero where the series is used.
    return abs(d) < 0.01 ? series : d / (abs(d) < 0.01 ? 1 : log(a2));
}

// |x| / (1 - e^-|x|); the rest of the constant is e^min(x, 0).
float GTRScale(float x) {
    float m = abs(x);
    float series = 1 + m * (0.5 + m * (1.0 / 12 - m * m / 720));
    return m < 0.05 ? series : m / max(1 - exp(-m), 0.04);
}

/// The constant that normalises GTR.
///
/// formula: (gamma - 1) (alpha^2 - 1) / (pi (1 - alpha^(2 - 2 gamma))); gamma 1: (alpha^2 - 1) / (pi log(alpha^2))
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, appendix B
/// test: GTRConstant(0.3, 2) == 0.028647889756541162
/// test: GTRConstant(0.3, 1) == 0.12029424393411509
/// test: GTRConstant(1, 1.5) == 0.3183098861837907
/// test: GTRConstant(1, 1) == 0.3183098861837907
[node("Lighting/Distribution/GTR Constant")]
float GTRConstant(
    [range(0, 1)] float alpha = 0.25,   ///< roughness squared, above 0
    [range(0.1, 10)] float gamma = 1.5  ///< length of the tails: 1 is Berry's, 2 is GGX
) {
    float a2 = max(alpha * alpha, 1e-7);
    float x = (gamma - 1) * log(a2);
    return INV_PI * GTRMean(a2) * GTRScale(x) * exp(min(x, 0));
}

/// GTR, generalised Trowbridge-Reitz: GGX with tails of any length.
///
/// formula: D = c / (1 + (alpha^2 - 1) (n.h)^2)^gamma, c as GTRConstant's
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, appendix B
/// test: DistributionGTR(1, 0.3, 1) == 1.3366027103790554
/// test: DistributionGTR(0.9, 0.3, 1.5) == 0.4604673691537846
/// test: DistributionGTR(0.5, 0.5, 3) == 0.05934443758802033
/// test: DistributionGTR(0.9, 0.5, 2) == 0.5165481539758866
/// test: DistributionGTR(0.4, 1, 1) == 0.3183098861837907
[node("Lighting/Distribution/GTR")]
float DistributionGTR(
    [range(0, 1)] float ndoth,          ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.25,   ///< roughness squared, above 0
    [range(0.1, 10)] float gamma = 1.5  ///< length of the tails: 1 is Berry's, 2 is GGX
) {
    float a2 = max(alpha * alpha, 1e-7);
    float x = (gamma - 1) * log(a2);
    float spread = max(1 - ndoth, 0) * (1 + ndoth) + ndoth * ndoth * a2;
    // The constant may be tiny and the power huge, so their exponents are added first.
    return INV_PI * GTRMean(a2) * GTRScale(x) * exp(min(x, 0) - gamma * log(max(spread, 1e-7)));
}

/// GTR with gamma 1, Berry's distribution: very long tails, as of a clear coat.
///
/// formula: D = (alpha^2 - 1) / (pi log(alpha^2) (1 + (alpha^2 - 1) (n.h)^2))
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, appendix B
/// test: DistributionGTR1(1, 0.3) == 1.3366027103790554
/// test: DistributionGTR1(0.5, 0.001) == 0.03072000950769579
/// test: DistributionGTR1(0.3, 1) == 0.3183098861837907
[node("Lighting/Distribution/GTR 1")]
float DistributionGTR1(
    [range(0, 1)] float ndoth,       ///< cosine of normal and half vector
    [range(0, 1)] float alpha = 0.1  ///< roughness squared, above 0
) {
    float a2 = max(alpha * alpha, 1e-7);
    float spread = max(1 - ndoth, 0) * (1 + ndoth) + ndoth * ndoth * a2;
    return INV_PI * GTRMean(a2) / max(spread, 1e-7);
}

/// Anisotropic GGX (GTR with gamma 2): rougher along one direction than along the other, like brushed metal.
///
/// formula: D = 1 / (pi at ab ((t.h / at)^2 + (b.h / ab)^2 + (n.h)^2)^2)
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, appendix B
/// test: DistributionGGXAnisotropic(1, 0, 0, 0.2, 0.5) == 3.183098861837907
/// test: DistributionGGXAnisotropic(0.8, 0.6, 0, 0.2, 0.5) == 0.034252798482269455
/// test: DistributionGGXAnisotropic(0.8, 0, 0.6, 0.2, 0.5) == 0.7357384573404925
[node("Lighting/Distribution/GGX Anisotropic")]
float DistributionGGXAnisotropic(
    [range(0, 1)] float ndoth,            ///< cosine of normal and half vector
    [range(-1, 1)] float tdoth,           ///< cosine of tangent and half vector
    [range(-1, 1)] float bdoth,           ///< cosine of bitangent and half vector
    [range(0.001, 1)] float alphaT = 0.25,  ///< roughness squared along the tangent
    [range(0.001, 1)] float alphaB = 0.25   ///< roughness squared along the bitangent
) {
    float at = max(alphaT, 1e-4);
    float ab = max(alphaB, 1e-4);
    float x = tdoth / at;
    float y = bdoth / ab;
    float spread = x * x + y * y + ndoth * ndoth;
    return 1 / max(PI * at * ab * spread * spread, 1e-7);
}

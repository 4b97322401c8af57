// Normal distributions D: which part of a rough surface's tiny facets has the half vector h as its normal. Each is
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
    // The denominator as 1 - (n.h)^2 and a sum: near the peak the formula as printed loses its digits. The limit keeps
    // a perfect mirror finite and leaves every peak as it is.
    float a2 = alpha * alpha;
    float d = (1 - ndoth) * (1 + ndoth) + ndoth * ndoth * a2;
    return a2 / max(PI * d * d, 1e-20);
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
    [range(0, 20000)] float exponent = 32  ///< sharpness, above 0; BlinnPhongExponentFromAlpha makes it of roughness
) {
    return (exponent + 2) * (0.5 * INV_PI) * pow(max(ndoth, 0), exponent);
}

/// The Blinn-Phong exponent whose highlight is as wide as that of a microfacet surface of the given roughness.
///
/// formula: 2 / alpha^2 - 2, from 0.0001 to 19998
/// source: Walter et al., EGSR 2007, section 5.2 (alpha_p = 2 alpha_b^-2 - 2)
/// test: BlinnPhongExponentFromAlpha(0.5) == 6
/// test: BlinnPhongExponentFromAlpha(0.0625) == 510
/// test: BlinnPhongExponentFromAlpha(0.5625) == 4.320987654320987
/// test: BlinnPhongExponentFromAlpha(0) == 19998
/// test: BlinnPhongExponentFromAlpha(1) == 0.0001
[node("Lighting/Distribution/Blinn-Phong Exponent from Alpha")]
float BlinnPhongExponentFromAlpha(
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    // The limits keep the exponent finite, and pow away from zero to the power of zero.
    return max(2 / max(alpha * alpha, 0.0001) - 2, 0.0001);
}

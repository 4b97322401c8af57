// Visibility terms V = G / (4 n.l n.v): the share of facets that both the light and the viewer see (the
// masking-shadowing function G), divided by the denominator of the Cook-Torrance BRDF. The BRDF is then D V F.

/// Smith's exact height-correlated masking-shadowing for GGX.
///
/// formula: V = 0.5 / (n.l sqrt((n.v)^2 (1 - alpha^2) + alpha^2) + n.v sqrt((n.l)^2 (1 - alpha^2) + alpha^2))
/// source: Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3(2), 2014
/// test: VisibilitySmithJoint(1, 1, 0.25) == 0.25
/// test: VisibilitySmithJoint(0.5, 0.5, 0.1) == 0.9853292781642932
/// test: VisibilitySmithJoint(0.9, 0.2, 0.5) == 0.7559289460184544
/// test: VisibilitySmithJoint(0.01, 1, 0.25) == 1.9216916070821881
/// test: VisibilitySmithJoint(0.05, 0.05, 1) == 5
[node("Lighting/Visibility/Smith Joint")]
float VisibilitySmithJoint(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float a2 = alpha * alpha;
    float viewPart = ndotl * sqrt(ndotv * ndotv * (1 - a2) + a2);
    float lightPart = ndotv * sqrt(ndotl * ndotl * (1 - a2) + a2);
    // Both cosines are zero only at the silhouette, where the outer factor n.l makes the light zero.
    return 0.5 / max(viewPart + lightPart, 1e-5);
}

/// An approximation of Smith's masking-shadowing for GGX without square roots.
///
/// It is exact at roughness 0 and 1; between them it is too dark at grazing angles. Unity's Standard shader uses it and
/// adds 0.00001 to the denominator. With a guard of 0, it is the formula alone, which is not defined if both cosines
/// are 0.
///
/// formula: V = 0.5 / (n.l (n.v (1 - alpha) + alpha) + n.v (n.l (1 - alpha) + alpha) + guard)
/// source: Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", GDC 2017
/// test: VisibilitySmithJointApproximate(1, 1, 0.25) == 0.24999875000624996
/// test: VisibilitySmithJointApproximate(0.6, 0.3, 0.25) == 1.0100806044322337
/// test: VisibilitySmithJointApproximate(0.5, 0, 1) == 0.9999800003999921
/// test: VisibilitySmithJointApproximate(0, 0, 0.25) == 50000
/// test: VisibilitySmithJointApproximate(0.5, 0.5, 0.1, 0) == 0.9090909090909091
[node("Lighting/Visibility/Smith Joint Approximate")] [also("SmithJointGGXVisibilityTerm")]
float VisibilitySmithJointApproximate(
    [range(0, 1)] float ndotl,                       ///< cosine of normal and light
    [range(0, 1)] float ndotv,                       ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25,                ///< roughness squared
    [range(0.0000001, 0.001)] float guard = 0.00001  ///< added to the denominator
) {
    float viewPart = ndotl * (ndotv * (1 - alpha) + alpha);
    float lightPart = ndotv * (ndotl * (1 - alpha) + alpha);
    return 0.5 / (viewPart + lightPart + guard);
}

/// Smith's separable masking-shadowing for GGX: light and view are independent.
///
/// formula: V = 1 / ((n.v + sqrt((n.v)^2 (1 - alpha^2) + alpha^2)) (n.l + sqrt((n.l)^2 (1 - alpha^2) + alpha^2)))
/// source: Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, eq. 34
/// test: VisibilitySmithSeparable(1, 1, 0.25) == 0.25
/// test: VisibilitySmithSeparable(0.5, 0.5, 0.1) == 0.9852754735826947
/// test: VisibilitySmithSeparable(0.9, 0.2, 0.5) == 0.7510677398116098
/// test: VisibilitySmithSeparable(0.05, 0.05, 1) == 0.9070294784580498
[node("Lighting/Visibility/Smith Separable")]
float VisibilitySmithSeparable(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float a2 = alpha * alpha;
    float viewPart = ndotv + sqrt(ndotv * ndotv * (1 - a2) + a2);
    float lightPart = ndotl + sqrt(ndotl * ndotl * (1 - a2) + a2);
    return 1 / max(viewPart * lightPart, 1e-5);
}

/// How VisibilitySchlick computes k from roughness.
enum SchlickRemapping {
    Ambient,  ///< alpha / 2: for image-based light
    Direct,   ///< (roughness + 1)^2 / 8: for direct light, less extreme at low roughness
    Beckmann  ///< alpha sqrt(2 / pi): Schlick's own, for the Beckmann distribution
};

/// Schlick's approximation of Smith's masking-shadowing: straight lines instead of square roots.
///
/// formula: V = 0.25 / ((n.v (1 - k) + k) (n.l (1 - k) + k))
/// source: Schlick 1994; the remappings: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013
/// test: VisibilitySchlick(1, 1, 0.5, Ambient) == 0.25
/// test: VisibilitySchlick(0.7, 0.4, 0.5, Ambient) == 0.7136485280999109
/// test: VisibilitySchlick(0.7, 0.4, 0.5, Direct) == 0.5603957795192854
/// test: VisibilitySchlick(0.6, 0.3, 0.5, Beckmann) == 0.8365253419235278
[node("Lighting/Visibility/Schlick")]
float VisibilitySchlick(
    [range(0, 1)] float ndotl,                  ///< cosine of normal and light
    [range(0, 1)] float ndotv,                  ///< cosine of normal and view
    [range(0, 1)] float roughness = 0.5,        ///< perceptual roughness
    const SchlickRemapping remapping = Ambient  ///< how k is computed from it
) {
    float k = 0.5 * roughness * roughness;
    if (remapping == Direct) { k = (roughness + 1) * (roughness + 1) * 0.125; }
    if (remapping == Beckmann) { k = roughness * roughness * 0.7978845608028654; }
    return 0.25 / max((ndotv * (1 - k) + k) * (ndotl * (1 - k) + k), 1e-5);
}

/// Schlick's masking-shadowing for Beckmann as in Unity's older shaders: with 0.00001 in the denominator.
///
/// formula: V = 0.25 / ((n.l (1 - k) + k) (n.v (1 - k) + k) + 0.00001), k = alpha sqrt(2 / pi)
/// source: Schlick 1994; Unity built-in shaders, SmithBeckmannVisibilityTerm
/// test: VisibilitySmithBeckmannUnity(1, 1, 0.25) == 0.24999750002499974
/// test: VisibilitySmithBeckmannUnity(0.6, 0.3, 0.25) == 0.836497351874196
/// test: VisibilitySmithBeckmannUnity(0.1, 0.1, 1) == 0.3735294687019935
[node("Lighting/Visibility/Smith-Beckmann Unity")] [also("SmithBeckmannVisibilityTerm")]
float VisibilitySmithBeckmannUnity(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float k = alpha * 0.7978845608028654;
    return 0.25 / ((ndotl * (1 - k) + k) * (ndotv * (1 - k) + k) + 1e-5);
}

/// Smith's separable masking-shadowing for Beckmann, by Walter's rational fit.
///
/// formula: G1 = (3.535 a + 2.181 a^2) / (1 + 2.276 a + 2.577 a^2) for a < 1.6, else 1; a = cot(angle) / alpha
/// source: Walter et al., EGSR 2007, eq. 27
/// test: VisibilitySmithBeckmann(1, 1, 0.5) == 0.25
/// test: VisibilitySmithBeckmann(0.5, 0.5, 0.5) == 0.9790937244413153
/// test: VisibilitySmithBeckmann(0.9, 0.2, 0.5) == 1.0638383103234452
[node("Lighting/Visibility/Smith-Beckmann")]
float VisibilitySmithBeckmann(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    return 0.25 * BeckmannMaskingOverCosine(ndotl, alpha) * BeckmannMaskingOverCosine(ndotv, alpha);
}

// Walter's G1 divided by the cosine, which stays finite as the cosine approaches zero.
float BeckmannMaskingOverCosine(float cosine, float alpha) {
    float c = max(cosine, 1e-4);
    float sine = sqrt(max(1 - c * c, 0));
    // a / c, which saves one division by the cosine.
    float slope = 1 / max(alpha * sine, 1e-6);
    float a = c * slope;
    float fit = slope * (3.535 + 2.181 * a) / (1 + 2.276 * a + 2.577 * a * a);
    return a < 1.6 ? fit : 1 / c;
}

/// Smith's Lambda for GGX: the number of hidden facets for each visible one.
///
/// formula: (sqrt(1 + alpha^2 (1 - c^2) / c^2) - 1) / 2
/// source: Heitz, JCGT 3(2), 2014, eq. 72
/// test: SmithLambda(1, 0.5) == 0
/// test: SmithLambda(0.5, 0.5) == 0.16143782776614768
[node("Lighting/Visibility/Smith Lambda")]
float SmithLambda(
    [range(0, 1)] float cosine,       ///< cosine of normal and direction
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float c2 = max(cosine * cosine, 1e-7);
    return 0.5 * (sqrt(1 + alpha * alpha * max(1 - c2, 0) / c2) - 1);
}

/// Smith's masking for GGX: the share of facets that are visible from one direction.
///
/// formula: G1 = 1 / (1 + lambda)
/// source: Heitz, JCGT 3(2), 2014, eq. 43
/// test: SmithMasking(1, 0.5) == 1
/// test: SmithMasking(0.5, 0.5) == 0.8610017480861207
/// test: SmithMasking(0.1, 0.1) == 0.8296436322557342
[node("Lighting/Visibility/Smith Masking G1")] [range(0, 1)]
float SmithMasking(
    [range(0, 1)] float cosine,       ///< cosine of normal and direction
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    // 2 c / (c + sqrt(c^2 + alpha^2 (1 - c^2))): the same without dividing by the cosine.
    float c2 = cosine * cosine;
    return 2 * cosine / max(cosine + sqrt(c2 + alpha * alpha * max(1 - c2, 0)), 1e-5);
}

/// The factor of one direction in the separable Smith visibility for GGX: the factors of light and view multiply to V.
///
/// formula: G1 / (2 c) = 1 / (c + sqrt(c^2 + alpha^2 (1 - c^2)))
/// source: Walter et al., EGSR 2007, eq. 34; Disney's BRDF Explorer uses it for the clearcoat, with alpha 0.25
/// test: SmithVisibilityFactor(0.6, 0.25) == 0.8113883008418966
/// test: SmithVisibilityFactor(1, 0.5) == 0.5
/// test: SmithVisibilityFactor(0, 0.25) == 4
[node("Lighting/Visibility/Smith Factor")]
float SmithVisibilityFactor(
    [range(0, 1)] float cosine,       ///< cosine of normal and direction
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float c2 = cosine * cosine;
    return 1 / max(cosine + sqrt(c2 + alpha * alpha * max(1 - c2, 0)), 1e-5);
}

/// Smith's joint masking-shadowing for GGX: the share of facets that light and viewer both see.
///
/// formula: G = 1 / (1 + lambda(n.l) + lambda(n.v))
/// source: Heitz, JCGT 3(2), 2014, eq. 99
/// test: SmithMaskingShadowing(0.9, 0.1, 0.6) == 0.2819099113151851
/// test: SmithMaskingShadowing(1, 1, 1) == 1
[node("Lighting/Visibility/Smith Masking-Shadowing G2")] [range(0, 1)]
float SmithMaskingShadowing(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    return 4 * ndotl * ndotv * VisibilitySmithJoint(ndotl, ndotv, alpha);
}

/// Walter's masking with Disney's remapped roughness, for one direction.
///
/// formula: G1 = 2 c / (c + sqrt(g^2 + (1 - g^2) c^2)), g = (0.5 + roughness / 2)^2
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, section 5.6
/// test: DisneyMasking(0.5, 0.5) == 0.8346742918437764
/// test: DisneyMasking(1, 0) == 1
[node("Lighting/Visibility/Disney Masking G1")] [range(0, 1)]
float DisneyMasking(
    [range(0, 1)] float cosine,          ///< cosine of normal and direction
    [range(0, 1)] float roughness = 0.5  ///< perceptual roughness
) {
    float root = 0.5 + 0.5 * roughness;
    return SmithMasking(cosine, root * root);
}

/// Cook and Torrance's masking-shadowing: facets are the sides of V-shaped grooves. The result is a factor G, not a V.
///
/// formula: G = min(1, 2 (n.h) (n.v) / (v.h), 2 (n.h) (n.l) / (v.h))
/// source: Torrance and Sparrow 1967; Cook and Torrance, ACM TOG 1(1), 1982
/// test: MaskingCookTorrance(0.5, 0.5, 1, 0.5) == 1
/// test: MaskingCookTorrance(0.6, 0.2, 0.95, 0.7) == 0.5428571428571429
[node("Lighting/Visibility/Cook-Torrance G")] [range(0, 1)]
float MaskingCookTorrance(
    [range(0, 1)] float ndotl,  ///< cosine of normal and light
    [range(0, 1)] float ndotv,  ///< cosine of normal and view
    [range(0, 1)] float ndoth,  ///< cosine of normal and half vector
    [range(0, 1)] float ldoth   ///< cosine of light (or view) and half vector
) {
    return min(1, 2 * ndoth * min(ndotl, ndotv) / max(ldoth, 1e-4));
}

/// The implicit visibility: G = (n.l) (n.v), which cancels the denominator. It is cheap, but too dark at grazing angles.
///
/// formula: V = 1 / 4
/// source: Hoffman, "Background: Physics and Math of Shading", SIGGRAPH 2013
/// test: VisibilityImplicit() == 0.25
[node("Lighting/Visibility/Implicit")]
float VisibilityImplicit() {
    return 0.25;
}

/// Kelemen and Szirmay-Kalos's visibility: depends only on the half vector, not on roughness.
///
/// formula: V = 1 / (4 (l.h)^2)
/// source: Kelemen and Szirmay-Kalos, "A Microfacet Based Coupled Specular-Matte BRDF Model", Eurographics 2001
/// test: VisibilityKelemen(0.5) == 1
/// test: VisibilityKelemen(0.9) == 0.30864197530864196
[node("Lighting/Visibility/Kelemen")]
float VisibilityKelemen(
    [range(0, 1)] float ldoth  ///< cosine of light (or view) and half vector
) {
    return 0.25 / max(ldoth * ldoth, 1e-4);
}

/// Schüler's visibility, which includes Fresnel's curve: multiply it by f0 alone.
///
/// Visibility and Fresnel's curve together are close to one over the squared cosine.
///
/// formula: V F = 1 / (4 max(0.1, (l.h)^2) (alpha + 0.5))
/// source: Schüler, "An Efficient and Physically Plausible Real Time Shading Model", ShaderX 7, 2009
/// source: Unity built-in shaders, BRDF2_Unity_PBS
/// test: VisibilityMinimalist(1, 0.5) == 0.25
/// test: VisibilityMinimalist(0.5, 0) == 2
/// test: VisibilityMinimalist(0, 0.5) == 2.5
[node("Lighting/Visibility/Minimalist")]
float VisibilityMinimalist(
    [range(0, 1)] float ldoth,        ///< cosine of light (or view) and half vector
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    return 0.25 / (max(ldoth * ldoth, 0.1) * (alpha + 0.5));
}

/// Neumann's visibility: divides by the larger cosine, so that it does not grow without limit at grazing angles.
///
/// formula: V = 1 / (4 max(n.l, n.v))
/// source: Neumann, Neumann and Szirmay-Kalos, "Compact Metallic Reflectance Models", Eurographics 1999
/// test: VisibilityNeumann(0.5, 0.25) == 0.5
/// test: VisibilityNeumann(1, 0.2) == 0.25
[node("Lighting/Visibility/Neumann")]
float VisibilityNeumann(
    [range(0, 1)] float ndotl,  ///< cosine of normal and light
    [range(0, 1)] float ndotv   ///< cosine of normal and view
) {
    return 0.25 / max(max(ndotl, ndotv), 1e-4);
}

/// Neubelt and Pettineo's visibility, made for cloth.
///
/// formula: V = 1 / (4 (n.l + n.v - (n.l) (n.v)))
/// source: Neubelt and Pettineo, "Crafting a Next-Gen Material Pipeline for The Order: 1886", SIGGRAPH 2013
/// test: VisibilityNeubelt(0.6, 0.4) == 0.32894736842105265
/// test: VisibilityNeubelt(1, 1) == 0.25
[node("Lighting/Visibility/Neubelt")]
float VisibilityNeubelt(
    [range(0, 1)] float ndotl,  ///< cosine of normal and light
    [range(0, 1)] float ndotv   ///< cosine of normal and view
) {
    return 0.25 / max(ndotl + ndotv - ndotl * ndotv, 1e-4);
}

/// Smith's joint visibility for anisotropic GGX.
///
/// formula: V = 0.5 / (n.l |(at t.v, ab b.v, n.v)| + n.v |(at t.l, ab b.l, n.l)|)
/// source: Heitz, JCGT 3(2), 2014, section 5.4
/// test: VisibilitySmithAnisotropic(1, 0, 0, 1, 0, 0, 0.3, 0.3) == 0.25
/// test: VisibilitySmithAnisotropic(0.8, 0.6, 0, 0.8, -0.6, 0, 0.2, 0.5) == 0.38630326283917865
/// test: VisibilitySmithAnisotropic(0.8, 0.6, 0, 0.8, 0, 0.6, 0.25, 0.25) == 0.38393444802121945
[node("Lighting/Visibility/Smith Anisotropic")]
float VisibilitySmithAnisotropic(
    [range(0, 1)] float ndotl,               ///< cosine of normal and light
    [range(-1, 1)] float tdotl,              ///< cosine of tangent and light
    [range(-1, 1)] float bdotl,              ///< cosine of bitangent and light
    [range(0, 1)] float ndotv,               ///< cosine of normal and view
    [range(-1, 1)] float tdotv,              ///< cosine of tangent and view
    [range(-1, 1)] float bdotv,              ///< cosine of bitangent and view
    [range(0.001, 1)] float alphaT = 0.25,  ///< roughness squared along the tangent
    [range(0.001, 1)] float alphaB = 0.25   ///< roughness squared along the bitangent
) {
    float viewPart = ndotl * length(float3(alphaT * tdotv, alphaB * bdotv, ndotv));
    float lightPart = ndotv * length(float3(alphaT * tdotl, alphaB * bdotl, ndotl));
    return 0.5 / max(viewPart + lightPart, 1e-5);
}

/// Converts a masking-shadowing factor G to a visibility term V.
///
/// formula: V = G / (4 (n.l) (n.v))
/// source: Walter et al., EGSR 2007, eq. 20
/// test: VisibilityFromMasking(0.8, 0.5, 0.5) == 0.8
/// test: VisibilityFromMasking(1, 1, 1) == 0.25
[node("Lighting/Visibility/V from G")]
float VisibilityFromMasking(
    [range(0, 1)] float masking,  ///< G
    [range(0, 1)] float ndotl,    ///< cosine of normal and light
    [range(0, 1)] float ndotv     ///< cosine of normal and view
) {
    return masking / max(4 * ndotl * ndotv, 1e-5);
}

/// Converts a visibility term V to its masking-shadowing factor G.
///
/// formula: G = 4 (n.l) (n.v) V
/// source: Walter et al., EGSR 2007, eq. 20
/// test: MaskingFromVisibility(0.8, 0.5, 0.5) == 0.8
/// test: MaskingFromVisibility(0.25, 1, 1) == 1
[node("Lighting/Visibility/G from V")]
float MaskingFromVisibility(
    [range(0, 1000)] float visibility,  ///< V
    [range(0, 1)] float ndotl,          ///< cosine of normal and light
    [range(0, 1)] float ndotv           ///< cosine of normal and view
) {
    return 4 * ndotl * ndotv * visibility;
}

/// Smith's separable masking-shadowing for anisotropic GGX, as in Disney's model.
///
/// formula: V = 1 / ((n.v + |(at t.v, ab b.v, n.v)|) (n.l + |(at t.l, ab b.l, n.l)|))
/// source: Burley, "Physically Based Shading at Disney", SIGGRAPH 2012, and its reference implementation
/// test: VisibilitySmithAnisotropicSeparable(1, 0, 0, 1, 0, 0, 0.25, 0.5) == 0.25
/// test: VisibilitySmithAnisotropicSeparable(0.6, 0.8, 0, 0.8, 0.6, 0, 0.25, 0.25) == VisibilitySmithSeparable(0.6, 0.8, 0.25)
/// test: VisibilitySmithAnisotropicSeparable(0.6, 0, 0.8, 1, 0, 0, 0.1, 0.75) == 1 / (2 * (0.6 + sqrt(0.72)))
[node("Lighting/Visibility/Smith Anisotropic Separable")]
float VisibilitySmithAnisotropicSeparable(
    [range(0, 1)] float ndotl,                ///< cosine of normal and light
    [range(-1, 1)] float tdotl,               ///< cosine of tangent and light
    [range(-1, 1)] float bdotl,               ///< cosine of bitangent and light
    [range(0, 1)] float ndotv,                ///< cosine of normal and view
    [range(-1, 1)] float tdotv,               ///< cosine of tangent and view
    [range(-1, 1)] float bdotv,               ///< cosine of bitangent and view
    [range(0.001, 1)] float alphaT = 0.25,   ///< roughness squared along the tangent
    [range(0.001, 1)] float alphaB = 0.25    ///< roughness squared along the bitangent
) {
    float viewPart = ndotv + length(float3(alphaT * tdotv, alphaB * bdotv, ndotv));
    float lightPart = ndotl + length(float3(alphaT * tdotl, alphaB * bdotl, ndotl));
    return 1 / max(viewPart * lightPart, 1e-5);
}

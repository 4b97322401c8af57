// Visibility terms V = G / (4 n.l n.v): how much of the facets both the light and the viewer see (the masking-shadowing
// function G), with the denominator of the Cook-Torrance BRDF already in it. The BRDF is then D V F.

/// Smith's masking-shadowing for GGX, with the correlation of heights, exact.
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
    float view_part = ndotl * sqrt(ndotv * ndotv * (1 - a2) + a2);
    float light_part = ndotv * sqrt(ndotl * ndotl * (1 - a2) + a2);
    // Both are zero only at the very outline, where the factor n.l outside makes the light vanish.
    return 0.5 / max(view_part + light_part, 1e-5);
}

/// Smith's masking-shadowing for GGX without its square roots.
///
/// Exact at roughness 0 and 1; between them it is too dark at grazing angles. It is what Unity's Standard shader uses,
/// with the 0.00001 that it adds to the denominator.
///
/// formula: V = 0.5 / (n.l (n.v (1 - alpha) + alpha) + n.v (n.l (1 - alpha) + alpha) + 0.00001)
/// source: Hammon, "PBR Diffuse Lighting for GGX+Smith Microsurfaces", GDC 2017
/// test: VisibilitySmithJointApproximate(1, 1, 0.25) == 0.24999875000624996
/// test: VisibilitySmithJointApproximate(0.6, 0.3, 0.25) == 1.0100806044322337
/// test: VisibilitySmithJointApproximate(0.5, 0, 1) == 0.9999800003999921
/// test: VisibilitySmithJointApproximate(0, 0, 0.25) == 50000
[node("Lighting/Visibility/Smith Joint Approximate")]
float VisibilitySmithJointApproximate(
    [range(0, 1)] float ndotl,        ///< cosine of normal and light
    [range(0, 1)] float ndotv,        ///< cosine of normal and view
    [range(0, 1)] float alpha = 0.25  ///< roughness squared
) {
    float view_part = ndotl * (ndotv * (1 - alpha) + alpha);
    float light_part = ndotv * (ndotl * (1 - alpha) + alpha);
    return 0.5 / (view_part + light_part + 1e-5);
}

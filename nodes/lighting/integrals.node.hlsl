// Integrals over the hemisphere by quadrature: too slow for rendering, used to compute its tables.

/// Which visibility term a split sum is for.
enum SplitSumVisibility {
    SmithJoint,             ///< Smith's exact joint form
    SmithJointApproximate,  ///< its approximation in Unity and Unreal, without the guard
    SchlickAmbient          ///< Schlick's, remapped for ambient light
};

// asinh, which the language lacks.
float inverseSinh(float x) {
    return log(x + sqrt(x * x + 1));
}

// 4 V (n.l) (v.h) / (n.h): the remaining factor of the BRDF times n.l if half vectors are sampled by GGX.
float splitSumWeight(float ndotl, float ndotv, float ndoth, float vdoth, float alpha, const SplitSumVisibility form) {
    float visibility = VisibilitySmithJoint(ndotl, ndotv, alpha);
    if (form == SmithJointApproximate) { visibility = VisibilitySmithJointApproximate(ndotl, ndotv, alpha, 0); }
    if (form == SchlickAmbient) { visibility = VisibilitySchlick(ndotl, ndotv, sqrt(alpha), Ambient); }
    return 4 * visibility * ndotl * vdoth / ndoth;
}

/// How strongly a rough surface reflects a uniform environment: the entries of SplitSumTable.
///
/// The reflectance is f0 scale + f90 offset. Half vectors are integrated over tan(angle) = alpha sinh(x), in which GGX
/// is smooth at its peak and in its tail. The first range ends where some reflected light falls below the horizon, the
/// second where all of it does.
///
/// formula: scale = integral of (1 - F) w, offset = integral of F w, over D (n.h) dh;
/// formula: F = (1 - v.h)^5, w = 4 V (n.l) (v.h) / (n.h)
/// source: Karis, "Real Shading in Unreal Engine 4", SIGGRAPH 2013
/// test: SplitSumIntegral(1, 1, SmithJoint, 32).total == 0.3068528194400547 within 1e-3
/// test: SplitSumIntegral(0.5, 0.5, SmithJoint, 32).out == 0.834916 within 2e-3
/// test: SplitSumIntegral(0.5, 0.5, SmithJointApproximate, 32).out == 0.737192 within 2e-3
/// test: SplitSumIntegral(0.5, 0.5, SchlickAmbient, 32).offset == 0.018546 within 3e-3
[node("Lighting/Ambient/Split Sum Integral")]
float SplitSumIntegral(
    [range(0.05, 1)] float roughness = 0.5,            ///< perceptual roughness
    [range(0.01, 1)] float ndotv,                      ///< cosine of normal and view
    const SplitSumVisibility visibility = SmithJoint,  ///< visibility term
    const int samples = 16,                            ///< samples along the angle of each range; half as many around
    out float offset,                                  ///< share of f90
    out float total                                    ///< scale + offset: the share of light after one bounce
) {
    float alpha = roughness * roughness;
    float viewSine = sqrt(max(1 - ndotv * ndotv, 0));
    float viewAngle = acos(clamp(ndotv, 0, 1));
    float scale = 0;
    offset = 0;
    for (int segment = 0; segment < 2; segment++) {
        float begin = segment == 0 ? 0 : inverseSinh(tan(0.25 * PI - 0.5 * viewAngle) / alpha);
        float end = inverseSinh(tan(0.25 * PI + (float(segment) - 0.5) * viewAngle) / alpha);
        for (int i = 0; i < samples; i++) {
            // Points are denser at both ends, where the integrand has a root.
            float s = (float(i) + 0.5) / float(samples);
            float x = begin + (end - begin) * s * s * (3 - 2 * s);
            float step = (end - begin) * 6 * s * (1 - s) / float(samples);
            float tangent = alpha * sinh(x);
            float ndoth = rsqrt(1 + tangent * tangent);
            float sine = tangent * ndoth;
            float density = 2 * sinh(x) / (cosh(x) * cosh(x) * cosh(x));
            // Beyond this azimuth, the light is below the horizon.
            float edge = (ndotv / (2 * ndoth) - ndotv * ndoth) / max(viewSine * sine, 1e-7);
            float last = acos(clamp(edge, -1, 1));
            for (int k = 0; k < samples / 2; k++) {
                float azimuth = last * (float(k) + 0.5) / float(samples / 2);
                float vdoth = viewSine * sine * cos(azimuth) + ndotv * ndoth;
                float ndotl = max(2 * vdoth * ndoth - ndotv, 1e-7);
                float weight = splitSumWeight(ndotl, ndotv, ndoth, vdoth, alpha, visibility);
                float share = density * step * last / (PI * float(samples / 2));
                float fresnel = SchlickWeight(vdoth);
                scale += (1 - fresnel) * weight * share;
                offset += fresnel * weight * share;
            }
        }
    }
    total = scale + offset;
    return scale;
}

/// Coefficients of light whose radiance depends only on the height z of the direction, like that of a sky.
///
/// Give the radiance at three heights above the horizon and at the same three below it: z = 0.1127017, 0.5 and
/// 0.8872983. The result is exact if the radiance above, and that below, is a polynomial of z up to the third degree.
/// The other six coefficients are zero.
///
/// formula: c_l = 2 pi integral of L(z) Y_l0(z) dz from -1 to 1, by Gauss and Legendre's rule of three points in each half
/// source: Ramamoorthi and Hanrahan, SIGGRAPH 2001; Abramowitz and Stegun, "Handbook of Mathematical Functions", 25.4.30
/// test: SHFromZonal(float3(1, 1, 1), float3(1, 1, 1)) == 3.5449077018110318
/// test: SHFromZonal(float3(1, 1, 1), float3(0, 0, 0)).l1 == 1.5349900619197328
/// test: SHFromZonal(float3(0.1127016653792583, 0.5, 0.8872983346207417), float3(0, 0, 0)).l2 == 0.4954159122007514
[node("Lighting/Ambient/SH from Zonal")]
float SHFromZonal(
    float3 above,  ///< radiance at the three heights above the horizon, from low to high
    float3 below,  ///< radiance at the three heights below it, from near the horizon to far below
    out float l1,  ///< coefficient of l = 1, m = 0: along z
    out float l2   ///< coefficient of l = 2, m = 0: 3 z^2 - 1
) {
    float3 z = float3(0.1127016653792583, 0.5, 0.8872983346207417);
    float3 weight = float3(5, 8, 5) * (TWO_PI / 18);
    float3 even = (above + below) * weight;
    float3 odd = (above - below) * weight;
    l1 = 0.4886025119029199 * dot(odd, z);
    l2 = 0.31539156525252005 * dot(even, 3 * z * z - 1);
    return 0.28209479177387814 * (even.x + even.y + even.z);
}

// Thin films: light that is reflected at both faces of a film of some hundred nanometres meets itself again, and some
// wavelengths cancel. Oil on water, soap, and anodised metal get their colours so.

// RGB of the light that interferes over an optical path. The eye's sensitivities are sums of Gaussians in wave numbers,
// and so are their Fourier transforms. `shift`: phase, of X, Y and Z.
float3 interference(float pathNm, float3 shift) {
    float k = 2 * PI * pathNm * 1e-9;
    float3 weights = float3(5.4856e-13, 4.4201e-13, 5.2481e-13);
    float3 places = float3(1.6810e6, 1.7953e6, 2.2084e6);
    float3 widths = float3(4.3278e9, 9.3046e9, 6.6121e9);
    // The whole is divided by 1.0685e-7, the integral of Y. The factors come first, because half cannot hold them.
    float3 scale = weights / 1.0685e-7 * sqrt(2 * PI * widths);
    float3 xyz = scale * cos(places * k + shift) * exp(-widths * (k * k));
    float second = 9.7470e-14 / 1.0685e-7 * sqrt(2 * PI * 4.5282e9);
    xyz.x += second * cos(2.2399e6 * k + shift.x) * exp(-4.5282e9 * (k * k));
    return float3(dot(float3(3.2404542, -1.5371385, -0.4985314), xyz),
                  dot(float3(-0.9692660, 1.8760108, 0.0415560), xyz),
                  dot(float3(0.0556434, -0.2040259, 1.0572252), xyz));
}

/// The reflectance of a surface under a thin film, for unpolarised light.
///
/// Both faces follow Schlick's curve, and the sum over further reflections has two terms, as in glTF. Below 10 nm the
/// film vanishes. The reflectance has a different hue at each angle and thickness.
///
/// formula: R = R12 + T^2 R23 / (1 - R12 R23) + sum over m = 1, 2 of 2 (Rs - T) (R12 R23)^(m/2) S(m D, m phi)
/// formula: D = 2 n d cos(t2), Rs = T^2 R23 / (1 - R12 R23), T = 1 - R12
/// source: Belcour and Barla, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence", ACM
/// source: TOG 36(4), 2017; Khronos Group, KHR_materials_iridescence, 2022
/// test: FresnelThinFilm(1, 1.3, 0, float3(0.04, 0.04, 0.04)) == float3(0.04, 0.04, 0.04)
/// test: FresnelThinFilm(0, 1.3, 400, float3(0.04, 0.04, 0.04)) == float3(1, 1, 1)
[node("Lighting/Fresnel/Thin Film")] [range(0, 1)] [inFloat]
float3 FresnelThinFilm(
    [range(0, 1)] float cosine,                              ///< cosine of light and half vector
    [range(1, 3)] float filmIor = 1.3,                       ///< index of refraction of the film
    [range(0, 1200)] [unit("nm")] float thickness = 400,     ///< thickness of the film
    [color] float3 f0 = 0.04                                 ///< reflectance of the surface below, in air
) {
    float c = saturate(cosine);
    float ior = lerp(1, filmIor, smoothstep(0, 10, thickness));
    float inside2 = 1 - (1 - c * c) / (ior * ior);
    // Inside, total reflection is impossible: the film is not thinner than air.
    float inside = sqrt(max(inside2, 0));
    float r0 = (ior - 1) / (ior + 1);
    float first = r0 * r0 + (1 - r0 * r0) * SchlickWeight(c);
    float through = 1 - first;

    float3 root = sqrt(clamp(f0, 0, 0.9999));
    float3 below = (1 + root) / (1 - root);
    float3 ratio = (below - ior) / (below + ior);
    float3 second = ratio * ratio + (1 - ratio * ratio) * SchlickWeight(inside);
    // Light that is reflected at an optically denser medium is shifted by half a wave.
    float3 shift = PI + PI * step(below, ior);
    float path = 2 * ior * thickness * inside;

    float3 both = min(first * second, 0.9999);
    float3 repeated = through * through * second / (1 - both);
    float3 amplitude = sqrt(both);
    float3 change = (repeated - through) * amplitude;
    float3 sum = first + repeated + 2 * change * interference(path, shift);
    sum += 2 * change * amplitude * interference(2 * path, 2 * shift);
    return saturate(sum);
}

/// The reflectance at normal incidence with which Schlick's curve gives a reflectance at one angle: so that a split-sum
/// table, which knows f0 alone, can reflect the environment with another Fresnel term.
///
/// formula: f0 = (F - w) / (1 - w), w = (1 - cosine)^5, at most 0.999
/// source: the inverse of Schlick 1994
/// test: F0FromSchlick(float3(0.07, 0.515625, 1), 0.5) == float3(0.04, 0.5, 1)
/// test: F0FromSchlick(float3(0.3, 0.3, 0.3), 1) == float3(0.3, 0.3, 0.3)
[node("Lighting/Fresnel/F0 from Schlick")] [range(0, 1)]
float3 F0FromSchlick(
    [color] float3 atAngle,      ///< F at the angle
    [range(0, 1)] float cosine   ///< of the angle
) {
    float weight = min(SchlickWeight(cosine), 0.999);
    return saturate((atAngle - weight) / (1 - weight));
}

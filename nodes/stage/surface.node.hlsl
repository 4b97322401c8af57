// The lighting surface: what stands between a material and its lighting. A workflow fills it, lighting graphs read it,
// a G-buffer stores it. A lighting model's own inputs are added to it by the compiler.

/// What lighting knows about a point of a surface.
struct LightingSurface {
    float3 diffuseColor;          ///< diffuse albedo, linear
    float3 f0;                    ///< specular reflectance at normal incidence, linear
    float3 baseColor;             ///< colour of the surface: albedo of a dielectric, f0 of a metal
    float metallic;               ///< 0 dielectric, 1 metal
    float oneMinusReflectivity;   ///< what the specular reflection leaves to the diffuse one
    float roughness;              ///< perceptual roughness, 0 to 1
    float3 normalWS;             ///< shaded normal in world space, unit
    float occlusion;              ///< ambient occlusion: 1 open, 0 closed
    [hdr] float3 emission;        ///< radiance that the surface sends out by itself
    float alpha;                  ///< coverage
    float alphaClip;              ///< a cutout surface is cut where alpha is below it
};

/// The surface that is being lit.
[given] LightingSurface surface;
/// What the lights and the surroundings add up to; only in `final`.
[given] LightSum sum;

/// Roughness squared: the alpha of the microfacet terms.
[member]
float alphaRoughness(LightingSurface surface) {
    return surface.roughness * surface.roughness;
}

/// 1 - perceptual roughness.
[member]
float smoothness(LightingSurface surface) {
    return 1 - surface.roughness;
}

/// The colour of an unlit surface as what it sends out: a transparent one has no highlight that would stay without it, and
/// shows its colour only as far as it covers what is behind it.
[inline]
float3 shownUnlitColor(float3 color, float alpha) {
    return premultiplied ? color * alpha : color;
}

/// The surface as it is lit: a transparent one scatters light only as far as it covers what is behind it, and still
/// mirrors as if it were whole.
[inline]
LightingSurface asLit(LightingSurface whole) {
    LightingSurface surface = whole;
    if (premultiplied) {
        surface.diffuseColor = PremultiplyAlpha(whole.diffuseColor, whole.alpha, whole.oneMinusReflectivity).out;
        surface.alpha = PremultiplyAlpha(whole.diffuseColor, whole.alpha, whole.oneMinusReflectivity).outAlpha;
    }
    return surface;
}

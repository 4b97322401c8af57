// The lighting surface: the interface between a material and its lighting. A workflow fills it, lighting graphs read
// it, and a G-buffer stores it. The compiler adds the lighting model's own inputs to it.

/// The properties of a surface point that lighting reads.
struct LightingSurface {
    float3 diffuseColor;          ///< diffuse albedo, linear
    float3 f0;                    ///< specular reflectance at normal incidence, linear
    float3 baseColor;             ///< colour of the surface: albedo of a dielectric, f0 of a metal
    float metallic;               ///< 0 dielectric, 1 metal
    float oneMinusReflectivity;   ///< share of the light that is left for diffuse reflection
    float roughness;              ///< perceptual roughness, 0 to 1
    float3 normalWS;              ///< shaded normal in world space, unit
    float occlusion;              ///< ambient occlusion: 1 open, 0 closed
    [hdr] float3 emission;        ///< radiance that the surface emits
    float alpha;                  ///< coverage
    float alphaClip;              ///< where alpha is below it, a cutout surface is not drawn, nor a blended one that states it
};

/// The surface that is being lit.
[given] LightingSurface surface;
/// The sum of the light from all lights and the environment; only in `final`.
[given] LightSum sum;

/// Perceptual roughness squared: the alpha of the microfacet terms.
[member]
float alphaRoughness(LightingSurface surface) {
    return surface.roughness * surface.roughness;
}

/// 1 - perceptual roughness.
[member]
float smoothness(LightingSurface surface) {
    return 1 - surface.roughness;
}

/// The emitted colour of an unlit surface. It has no reflections that keep full strength, so a transparent surface
/// shows its colour only as far as it covers the background.
[inline]
float3 shownUnlitColor(float3 color, float alpha) {
    return premultiplied ? color * alpha : color;
}

/// The surface as it is lit: a transparent surface scatters light only as far as it covers the background, but its
/// reflections keep full strength.
[inline]
LightingSurface asLit(LightingSurface whole) {
    LightingSurface surface = whole;
    if (premultiplied) {
        surface.diffuseColor = PremultiplyAlpha(whole.diffuseColor, whole.alpha, whole.oneMinusReflectivity).out;
        surface.alpha = PremultiplyAlpha(whole.diffuseColor, whole.alpha, whole.oneMinusReflectivity).outAlpha;
    }
    return surface;
}

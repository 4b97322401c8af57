// Light that passes through: thin panes, filled volumes, and what is seen behind them on the screen.

/// The width of the lobe of light that passes a rough surface: without a step in the index of refraction, facets bend
/// nothing, and at 1.5 the lobe is as wide as the reflected one.
///
/// formula: alpha clamp(2 ior - 2, 0, 1)
/// source: Khronos Group, glTF sample viewer, applyIorToRoughness
/// test: TransmissionAlpha(0.25, 1.5) == 0.25
/// test: TransmissionAlpha(0.25, 1) == 0
/// test: TransmissionAlpha(0.5, 1.25) == 0.25
[node("Lighting/Transmission/Transmission Alpha")] [range(0, 1)]
float TransmissionAlpha(
    [range(0, 1)] float alpha = 0.25,  ///< roughness squared
    [range(1, 3)] float ior = 1.5      ///< index of refraction
) {
    return alpha * saturate(2 * ior - 2);
}

/// The half vector of light that passes a thin rough pane: that of the light as mirrored at the pane.
///
/// formula: normalize(v + l - 2 (n.l) n)
/// source: Khronos Group, KHR_materials_transmission, 2021
/// test: TransmissionHalfVector(float3(0, 0, 1), float3(0, 0, 1), float3(0, 0, -1)) == float3(0, 0, 1)
/// test: TransmissionHalfVector(float3(0, 0, 1), float3(-0.6, 0, 0.8), float3(0.6, 0, -0.8)) == float3(0, 0, 1)
[node("Lighting/Transmission/Transmission Half Vector")] [range(-1, 1)]
float3 TransmissionHalfVector(
    float3 normal = normalWS,           ///< unit normal
    float3 view = viewDirWS,            ///< unit direction to the viewer
    float3 lightDir = light.direction   ///< unit direction to the light, which is behind
) {
    return HalfVectorExact(view, lightDir - 2 * dot(normal, lightDir) * normal);
}

/// The share of light that a medium lets pass.
///
/// formula: color^(depth / distance); a distance of 0 stands for an infinite one, and all light passes
/// source: the law of Beer and Lambert; Khronos Group, KHR_materials_volume, 2021
/// test: Transmittance(float3(0.5, 0.25, 1), 2, 1) == float3(0.7071067811865476, 0.5, 1)
/// test: Transmittance(float3(0.5, 0.25, 1), 2, 0) == float3(1, 1, 1)
/// test: Transmittance(float3(0.5, 0.25, 1), 0, 1) == float3(1, 1, 1)
[node("Lighting/Transmission/Transmittance")] [range(0, 1)] [inFloat]
float3 Transmittance(
    [color] float3 color = 1,                          ///< what white light becomes over the distance
    [range(0, 10)] [unit("m")] float distance = 0,     ///< over which it becomes so
    [range(0, 10)] [unit("m")] float depth = 1         ///< length of the way through the medium
) {
    float turns = distance > 0 ? depth / max(distance, 1e-4) : 0;
    // A power of ten thousand is black for every color below 1, and half can hold it.
    return exp2(log2(clamp(color, 1e-4, 1)) * min(turns, 10000));
}

/// The indices of refraction of red, green and blue light.
///
/// formula: n - h, n, n + h; h = 0.025 (n - 1) dispersion, which is 20 over the Abbe number
/// source: Khronos Group, KHR_materials_dispersion, 2024
/// test: DispersedIor(1.5, 0) == float3(1.5, 1.5, 1.5)
/// test: DispersedIor(1.5, 1) == float3(1.4875, 1.5, 1.5125)
[node("Lighting/Transmission/Dispersed IOR")] [range(1, 4)]
float3 DispersedIor(
    [range(1, 3)] float ior = 1.5,       ///< index of refraction of green light
    [range(0, 1)] float dispersion = 0   ///< 20 over the Abbe number: 0.36 is diamond, 0.33 crown glass
) {
    float half_spread = 0.025 * (ior - 1) * dispersion;
    return max(float3(ior - half_spread, ior, ior + half_spread), 1);
}

/// Where a view ray leaves a volume that it enters here: it is bent once, and goes straight for the thickness.
///
/// formula: position + thickness refract(-v, n, 1 / ior)
/// source: Snell's law; Khronos Group, KHR_materials_volume, 2021
/// test: ExitPoint(float3(0, 0, 0), float3(0, 0, 1), float3(0, 0, 1), 1.5, 2) == float3(0, 0, -2)
/// test: ExitPoint(float3(1, 0, 0), float3(0, 0, 1), float3(0.6, 0, 0.8), 1, 1) == float3(0.4, 0, -0.8)
/// test: ExitPoint(float3(0, 0, 0), float3(0, 0, 1), float3(0.6, 0, 0.8), 2, 1) == float3(-0.3, 0, -0.9539392014169457)
[node("Lighting/Transmission/Exit Point")]
float3 ExitPoint(
    [unit("m")] float3 position = positionWS,       ///< where the ray enters
    float3 normal = normalWS,                       ///< unit normal
    float3 view = viewDirWS,                        ///< unit direction to the viewer
    [range(1, 3)] float ior = 1.5,                  ///< index of refraction of the volume
    [range(0, 10)] [unit("m")] float thickness = 0  ///< of the volume, along the ray
) {
    return position + refract(-view, normal, 1 / max(ior, 1)) * thickness;
}

/// The scene behind a rough pane: the mean of 16 places in a disc around a place of the screen.
///
/// The disc is turned differently at each pixel, so that 16 copies of a bright point become grain. Its radius is a fifth
/// of the picture's height for the widest lobe, wherever the things behind are.
///
/// source: Vogel, "A better way to construct the sunflower head", Mathematical Biosciences 44, 1979; the turn: Jimenez,
/// source: "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014; the radius is ours
[node("Lighting/Transmission/Scene Through Rough Surface")] [inFloat]
float3 SceneThroughRoughSurface(
    float2 uv = screenUV,              ///< place on the screen, 0 to 1 from the top left
    [range(0, 1)] float alpha = 0,     ///< width of the lobe, see TransmissionAlpha
    [hidden] float2 screen = screenSize  ///< size of the picture in pixels
) {
    if (alpha < 0.001) { return SceneColor(saturate(uv)); }
    float2 pixel = uv * screen;
    float turn = TWO_PI * frac(52.9829189 * frac(dot(pixel, float2(0.06711056, 0.00583715))));
    float2 radius = 0.2 * alpha * float2(screen.y / screen.x, 1);
    float3 sum = float3(0);
    for (int i = 0; i < 16; i++) {
        // 2.4 is the golden angle: pi (3 - sqrt(5)).
        float angle = turn + 2.399963 * float(i);
        float2 place = float2(cos(angle), sin(angle)) * sqrt((float(i) + 0.5) / 16);
        sum += SceneColor(saturate(uv + radius * place));
    }
    return sum / 16;
}

// Colour grading, on linear colours.

/// Makes a colour greyer or more vivid, and keeps its luminance.
///
/// formula: lerp(luminance, color, amount)
/// test: Saturation(float3(0, 1, 0), 0) == float3(0.7152, 0.7152, 0.7152)
/// test: Saturation(float3(0.2, 0.4, 0.8), 1) == float3(0.2, 0.4, 0.8)
/// test: Saturation(float3(0, 1, 0), 2) == float3(-0.7152, 1.2848, -0.7152)
[node("Color/Saturation")]
float3 Saturation(
    [color] float3 color = 1,       ///< linear colour
    [range(0, 2)] float amount = 1  ///< 0 is grey, 1 leaves it as it is, 2 doubles the distance from grey
) {
    return lerp(Luminance(color), color, amount);
}

/// Moves a colour away from a middle grey, or towards it.
///
/// formula: midpoint + (color - midpoint) amount
/// test: Contrast(float3(0.18, 0.28, 0.08), 2) == float3(0.18, 0.38, -0.02)
/// test: Contrast(float3(0, 0.5, 1), 0, 0.25) == float3(0.25, 0.25, 0.25)
[node("Color/Contrast")]
float3 Contrast(
    [color] float3 color = 1,            ///< linear colour
    [range(0, 2)] float amount = 1,      ///< 0 is flat, 1 leaves it as it is
    [range(0, 1)] float midpoint = 0.18  ///< the value that stays; a photographer's grey card is 18 %
) {
    return midpoint + (color - midpoint) * amount;
}

/// Rotates a colour around the grey axis: a third of a turn makes red green and green blue.
///
/// formula: c cos + cross(k, c) sin + k dot(k, c) (1 - cos), k = (1, 1, 1) / sqrt(3)
/// source: Rodrigues, 1840: rotation about an axis
/// test: HueRotate(float3(1, 0, 0), 2.0943951023931953) == float3(0, 1, 0)
/// test: HueRotate(float3(0.2, 0.5, 0.9), 0) == float3(0.2, 0.5, 0.9)
/// test: HueRotate(float3(1, 0, 0), 3.141592653589793) == float3(-1 / 3, 2 / 3, 2 / 3)
[node("Color/Hue Rotate")] [also("HueShift")]
float3 HueRotate(
    [color] float3 color = 1,      ///< linear colour
    [unit("rad")] float angle = 0  ///< angle of the rotation
) {
    const float axis = 0.57735026918962576;  // each component of the unit vector along grey
    float3 crossed = axis * (color.brg - color.gbr);
    float grey = (color.r + color.g + color.b) / 3;
    return lerp(grey, color, cos(angle)) + crossed * sin(angle);
}

/// Applies a detail map to a colour: middle grey keeps it, darker texels darken it, brighter texels brighten it.
///
/// Unity uses 0.5^2.2 for the middle grey of a texture; sRGB decodes it to 0.2140, which darkens by 2 percent.
///
/// formula: base lerp(1, k detail, mask), k = 2^2.2 in linear colour, 2 in gamma-encoded colour
/// source: Unity built-in shaders, Albedo: unity_ColorSpaceDouble and LerpWhiteTo
/// test: DetailAlbedo(float3(0.2, 0.4, 0.8), float3(0.5, 0.25, 1), 1, Gamma) == float3(0.2, 0.2, 1.6)
/// test: DetailAlbedo(float3(0.2, 0.4, 0.8), float3(0.5, 0.25, 1), 0.5, Gamma) == float3(0.2, 0.3, 1.2)
/// test: DetailAlbedo(float3(0.5, 0.5, 0.5), 0.21763764082403103, 1) == float3(0.5, 0.5, 0.5)
/// test: DetailAlbedo(float3(0.2, 0.4, 0.8), 1, 1) == float3(0.918958684, 1.837917368, 3.675834736)
/// test: DetailAlbedo(float3(0.2, 0.4, 0.8), 0, 0) == float3(0.2, 0.4, 0.8)
[node("Color/Detail Albedo")]
float3 DetailAlbedo(
    [color] float3 base = 0.5,            ///< the colour below
    [color] float3 detail = 0.217637641,  ///< colour of the detail map
    [range(0, 1)] float mask = 1,         ///< 0: the base alone
    const WorkingSpace space = Linear     ///< colour space of the colours
) {
    return base * lerp(1, (space == Linear ? 4.59479342 : 2) * detail, mask);
}

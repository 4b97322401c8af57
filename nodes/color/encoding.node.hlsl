// Colour encodings. Lighting is computed on linear colours; pictures and colour pickers hold sRGB colours.

/// The relative luminance of a colour: its Rec. 709 primaries, weighted as the eye perceives them.
///
/// formula: 0.2126 r + 0.7152 g + 0.0722 b
/// source: ITU-R BT.709-6, section 3.2
/// test: Luminance(float3(1, 1, 1)) == 1
/// test: Luminance(float3(0, 1, 0)) == 0.7152
/// test: Luminance(float3(0.5, 0, 2)) == 0.2507
[node("Color/Luminance")] [also("Desaturate")]
float Luminance(
    [color] float3 color = 1  ///< linear colour
) {
    return dot(color, float3(0.2126, 0.7152, 0.0722));
}

/// Converts a linear colour to sRGB.
///
/// A material seldom needs it: colours are encoded once, after all other computations.
///
/// formula: 12.92 c up to 0.0031308, else 1.055 c^(1 / 2.4) - 0.055
/// source: IEC 61966-2-1:1999
/// test: LinearToSrgb(0.002) == float3(0.02584, 0.02584, 0.02584)
/// test: LinearToSrgb(float3(0, 0.5, 1)) == float3(0, 0.7353569830524495, 1)
[node("Color/Linear to sRGB")] [also("LinearToGamma")]
float3 LinearToSrgb(
    float3 color = 0  ///< linear colour; below zero counts as zero
) {
    float3 dark = max(color, 0) * 12.92;
    float3 light = 1.055 * pow(max(color, 0.0031308), 1 / 2.4) - 0.055;
    return color <= 0.0031308 ? dark : light;
}

/// Converts an sRGB colour to linear.
///
/// Hexadecimal colours and textures whose usage is "color" are decoded already; use this node for other values.
///
/// formula: c / 12.92 up to 0.04045, else ((c + 0.055) / 1.055)^2.4
/// source: IEC 61966-2-1:1999
/// test: SrgbToLinear(0.02) == float3(0.0015479876160990713, 0.0015479876160990713, 0.0015479876160990713)
/// test: SrgbToLinear(float3(0, 0.735, 1)) == float3(0, 0.4994581635400763, 1)
[node("Color/sRGB to Linear")] [also("GammaToLinear")]
float3 SrgbToLinear(
    float3 color = 0  ///< sRGB colour; below zero counts as zero
) {
    float3 dark = max(color, 0) / 12.92;
    float3 light = pow((max(color, 0.04045) + 0.055) / 1.055, 2.4);
    return color <= 0.04045 ? dark : light;
}

/// Converts a linear colour to sRGB with the cheap fit of Unity's shaders. Very dark colours become black.
///
/// formula: max(1.055 c^0.416666667 - 0.055, 0)
/// source: Unity built-in shaders, LinearToGammaSpace
/// test: LinearToSrgbApproximate(0.5) == float3(0.7353569828698382, 0.7353569828698382, 0.7353569828698382)
/// test: LinearToSrgbApproximate(float3(0.0005, 0, 1)) == float3(0, 0, 1)
[node("Color/Linear to sRGB Approximate")] [also("LinearToGammaSpace")]
float3 LinearToSrgbApproximate(
    float3 color = 0  ///< linear colour; below zero counts as zero
) {
    return max(1.055 * pow(max(color, 0), 0.416666667) - 0.055, 0);
}

/// Converts an sRGB colour to linear with the cheap fit of Unity's shaders.
///
/// formula: c (c (0.305306011 c + 0.682171111) + 0.012522878)
/// source: Chilliant, "sRGB Approximations for HLSL", 2012
/// test: SrgbToLinearApproximate(0.5) == float3(0.21496746812500003, 0.21496746812500003, 0.21496746812500003)
/// test: SrgbToLinearApproximate(float3(0.02, 0, 1)) == float3(0.0005257684524880001, 0, 1)
[node("Color/sRGB to Linear Approximate")] [also("GammaToLinearSpace")]
float3 SrgbToLinearApproximate(
    float3 color = 0  ///< sRGB colour, 0 to 1
) {
    return color * (color * (color * 0.305306011 + 0.682171111) + 0.012522878);
}

/// Converts a linear colour to sRGB as Unity's exact function does: values above 1 use a plain power.
///
/// formula: 12.92 c up to 0.0031308, 1.055 c^0.4166667 - 0.055 up to 1, c^0.45454545 above
/// source: Unity built-in shaders, LinearToGammaSpaceExact; IEC 61966-2-1:1999
/// test: LinearToSrgbUnity(0.002) == float3(0.02584, 0.02584, 0.02584)
/// test: LinearToSrgbUnity(float3(0, 0.5, 2)) == float3(0, 0.7353569647913258, 1.3703509804026013)
/// test: LinearToSrgbUnity(float3(-1, 1, 1)) == float3(0, 1, 1)
[node("Color/Linear to sRGB Unity")] [also("LinearToGammaSpaceExact")]
float3 LinearToSrgbUnity(
    float3 color = 0  ///< linear colour; below zero counts as zero
) {
    float3 dark = max(color, 0) * 12.92;
    float3 light = 1.055 * pow(max(color, 0.0031308), 0.4166667) - 0.055;
    float3 above = pow(max(color, 1), 0.45454545);
    return color <= 0.0031308 ? dark : color < 1 ? light : above;
}

/// Converts an sRGB colour to linear as Unity's exact function does: values above 1 use a plain power.
///
/// formula: c / 12.92 up to 0.04045, ((c + 0.055) / 1.055)^2.4 up to 1, c^2.2 above
/// source: Unity built-in shaders, GammaToLinearSpaceExact; IEC 61966-2-1:1999
/// test: SrgbToLinearUnity(0.02) == float3(0.0015479876160990713, 0.0015479876160990713, 0.0015479876160990713)
/// test: SrgbToLinearUnity(float3(0, 0.5, 1.5)) == float3(0, 0.21404114048223255, 2.440061485194822)
/// test: SrgbToLinearUnity(float3(-1.292, 1, 1)) == float3(-0.1, 1, 1)
[node("Color/sRGB to Linear Unity")] [also("GammaToLinearSpaceExact")]
float3 SrgbToLinearUnity(
    float3 color = 0  ///< sRGB colour
) {
    float3 dark = color / 12.92;
    float3 light = pow((max(color, 0.04045) + 0.055) / 1.055, 2.4);
    float3 above = pow(max(color, 1), 2.2);
    return color <= 0.04045 ? dark : color < 1 ? light : above;
}

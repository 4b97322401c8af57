// Adjustments of a colour as picture editors offer them: channels, hue, white balance, and one colour for another.

/// Mixes the channels of a colour: each channel of the result is a sum of the three, with weights of its own.
///
/// formula: (dot(color, red), dot(color, green), dot(color, blue))
/// test: ChannelMixer(float3(0.2, 0.4, 0.8)) == float3(0.2, 0.4, 0.8)
/// test: ChannelMixer(float3(0.2, 0.4, 0.8), float3(0, 0, 1), float3(0.5, 0.5, 0), float3(1, -1, 0)) == float3(0.8, 0.3, -0.2)
[node("Color/Channel Mixer")]
float3 ChannelMixer(
    [color] float3 color = 1,         ///< linear colour
    float3 red = float3(1, 0, 0),    ///< shares of red, green and blue in the new red
    float3 green = float3(0, 1, 0),  ///< shares in the new green
    float3 blue = float3(0, 0, 1)    ///< shares in the new blue
) {
    return float3(dot(color, red), dot(color, green), dot(color, blue));
}

/// The unit of a change of hue.
enum HueUnit {
    Degrees,    ///< 360 are the whole circle
    Normalized  ///< 1 is the whole circle
};

/// Changes the hue of a colour, and keeps its saturation and value (HSV).
///
/// HueRotate keeps the sum of the channels instead of the largest one.
///
/// formula: HsvToRgb(h + offset, s, v)
/// source: Smith, "Color Gamut Transform Pairs", SIGGRAPH 1978
/// test: Hue(float3(1, 0, 0), 120) == float3(0, 1, 0)
/// test: Hue(float3(0.8, 0.2, 0.5), -120, Degrees) == float3(0.2, 0.5, 0.8)
/// test: Hue(float3(0, 0, 1), 0.5, Normalized) == float3(1, 1, 0)
/// test: Hue(float3(0.3, 0.3, 0.3), 0.25, Normalized) == float3(0.3, 0.3, 0.3)
[node("Color/Hue")]
float3 Hue(
    [color] float3 color = 1,     ///< the colour
    [range(-360, 360)] float offset = 0,  ///< how far the hue moves, from red towards green
    const HueUnit unit = Degrees  ///< unit of the offset
) {
    float3 hsv = RgbToHsv(color);
    return HsvToRgb(float3(hsv.x + (unit == Degrees ? offset / 360 : offset), hsv.yz));
}

/// Changes hue, saturation and value of a colour at once.
///
/// formula: HsvToRgb(h + hue, s saturation, v value)
/// source: MaterialX, hsvadjust
/// test: HsvAdjust(float3(1, 0, 0), 1 / 3, 1, 0.5) == float3(0, 0.5, 0)
/// test: HsvAdjust(float3(0.25, 0.5, 0.25), 0, 2, 1) == float3(0, 0.5, 0)
/// test: HsvAdjust(float3(0.2, 0.6, 0.4), 0, 1, 1) == float3(0.2, 0.6, 0.4)
[node("Color/HSV Adjust")]
float3 HsvAdjust(
    [color] float3 color = 1,           ///< the colour
    [range(-1, 1)] float hue = 0,       ///< turns that the hue moves
    [range(0, 2)] float saturation = 1, ///< factor on the saturation
    [range(0, 4)] float value = 1       ///< factor on the value
) {
    return HsvToRgb(RgbToHsv(color) * float3(1, saturation, value) + float3(hue, 0, 0));
}

/// Inverts the channels that are chosen: of the others, the sign is dropped.
///
/// formula: |channels - color|
/// source: Unity Shader Graph, Invert Colors
/// test: InvertColors(float3(0.2, 0.4, 0.8)) == float3(0.8, 0.6, 0.2)
/// test: InvertColors(float4(0.2, 0.4, 0.8, 0.5), float4(1, 0, 1, 0)) == float4(0.8, 0.4, 0.2, 0.5)
/// test: InvertColors(-0.25, 0) == 0.25
[node("Color/Invert")]
floatN InvertColors(
    [color] floatN color = 1,         ///< the colour
    [range(0, 1)] floatN channels = 1  ///< for each channel 1 to invert it, or 0
) {
    return abs(channels - color);
}

/// How far a colour is from a range around another one: 0 up to the edge, 1 where the soft edge ends.
float OutsideOfRange(float3 color, float3 center, float range, float fuzziness) {
    return saturate((distance(color, center) - range) / max(fuzziness, 1e-5));
}

/// Replaces a colour, and all that are near it, by another one.
///
/// formula: lerp(to, color, saturate((|color - from| - range) / max(fuzziness, 1e-5)))
/// source: Unity Shader Graph, Replace Color
/// test: ReplaceColor(float3(1, 0, 0), float3(1, 0, 0), float3(0, 0, 1), 0.1, 0) == float3(0, 0, 1)
/// test: ReplaceColor(float3(0, 0.5, 0), float3(0, 0, 0), float3(1, 1, 1), 0.25, 0.5) == float3(0.5, 0.75, 0.5)
/// test: ReplaceColor(float3(0, 1, 0), float3(1, 0, 0), float3(0, 0, 1), 0.5, 0.5) == float3(0, 1, 0)
[node("Color/Replace Color")]
float3 ReplaceColor(
    [color] float3 color = 1,           ///< the colour
    [color] float3 from = 0,            ///< the colour to replace
    [color] float3 to = 0,              ///< what takes its place
    [range(0, 2)] float range = 0,      ///< how far a colour may be from `from`
    [range(0, 2)] float fuzziness = 0   ///< width of the soft edge beyond that
) {
    return lerp(to, color, OutsideOfRange(color, from, range, fuzziness));
}

/// A mask of all that has a given colour: 1 in the range, 0 outside of it.
///
/// formula: saturate(1 - (|color - maskColor| - range) / max(fuzziness, 1e-5))
/// source: Unity Shader Graph, Color Mask
/// test: ColorMask(float3(1, 0, 0), float3(1, 0, 0), 0.1, 0) == 1
/// test: ColorMask(float3(0, 0.5, 0), float3(0, 0, 0), 0.25, 0.5) == 0.5
/// test: ColorMask(float3(0, 1, 0), float3(1, 0, 0), 0.5, 0.5) == 0
[node("Color/Color Mask")] [range(0, 1)]
float ColorMask(
    [color] float3 color = 1,          ///< the colour
    [color] float3 maskColor = 0,      ///< the colour to look for
    [range(0, 2)] float range = 0,     ///< how far a colour may be from it
    [range(0, 2)] float fuzziness = 0  ///< width of the soft edge beyond that
) {
    return 1 - OutsideOfRange(color, maskColor, range, fuzziness);
}

/// Makes a colour greyer or more vivid, with the weights of Unity's node: they have one more digit.
///
/// formula: lerp(luma, color, amount), luma = 0.2126729 r + 0.7151522 g + 0.0721750 b
/// source: Unity Shader Graph, Saturation; the weights: the sRGB primaries in XYZ with the white D65, as Lindbloom,
/// source: "RGB Working Space Information", rounds them
/// test: SaturationUnity(float3(0, 1, 0), 0) == float3(0.7151522, 0.7151522, 0.7151522)
/// test: SaturationUnity(float3(0.2, 0.4, 0.8), 1) == float3(0.2, 0.4, 0.8)
/// test: SaturationUnity(float3(1, 0, 0), 2) == float3(1.7873271, -0.2126729, -0.2126729)
[node("Color/Saturation Unity")]
float3 SaturationUnity(
    [color] float3 color = 1,       ///< linear colour
    [range(0, 2)] float amount = 1  ///< 0 is grey, 1 leaves it as it is, 2 doubles the distance from grey
) {
    return lerp(dot(color, float3(0.2126729, 0.7151522, 0.0721750)), color, amount);
}

/// The responses of the eye's cones to a linear Rec. 709 colour.
float3 ConesOfColor(float3 color) {
    return float3(dot(color, float3(0.390405, 0.549941, 0.00892632)), dot(color, float3(0.0708416, 0.963172, 0.00135775)),
                  dot(color, float3(0.0231082, 0.128021, 0.936245)));
}

/// The inverse of ConesOfColor.
float3 ColorOfCones(float3 cones) {
    return float3(dot(cones, float3(2.85847, -1.62879, -0.0248910)), dot(cones, float3(-0.210182, 1.15820, 0.000324281)),
                  dot(cones, float3(-0.0418120, -0.118169, 1.06867)));
}

/// The cones' responses to the white at a place of the chromaticity diagram, for a luminance of 1.
float3 ConesOfWhite(float2 xy) {
    float3 white = float3(xy.x / xy.y, 1, (1 - xy.x - xy.y) / xy.y);
    return float3(dot(white, float3(0.7328, 0.4296, -0.1624)), dot(white, float3(-0.7036, 1.6975, 0.0061)),
                  dot(white, float3(0.0030, 0.0136, 0.9834)));
}

/// Warms or cools a colour, as if the light were another white.
///
/// Zero and zero leave colours as they are. The useful range is about -1.67 to 1.67.
///
/// formula: M^-1 (M color (w1 / w2)), M: linear Rec. 709 to CAT02 cones, w1: the white D65, w2: the white at (x, y),
/// formula: x = 0.31271 - t (0.1 if t < 0, else 0.05), y = 2.87 x - 3 x^2 - 0.27509507 + 0.05 u,
/// formula: t = temperature / 0.6, u = tint / 0.6
/// source: von Kries, 1902; the cones: Moroney et al., "The CIECAM02 Color Appearance Model", 2002; daylight y(x): CIE
/// source: 15, 3.1, shifted so that D65 is on it; the scales, and the rounding of M: Unity Shader Graph, White Balance
/// test: WhiteBalance(float3(0.2, 0.4, 0.8), 0, 0) == float3(0.2, 0.4, 0.8) within 1e-3
/// test: WhiteBalance(float3(0.5, 0.5, 0.5), 1, 0) == float3(0.763221, 0.502277, 0.176027) within 1e-3
/// test: WhiteBalance(float3(0.5, 0.5, 0.5), -1, 0.5) == float3(0.085343, 0.571868, 3.778291) within 1e-3
[node("Color/White Balance")] [inFloat]
float3 WhiteBalance(
    [color] float3 color = 1,              ///< linear colour
    [range(-1.67, 1.67)] float temperature = 0,  ///< above 0: warmer, more yellow; below: cooler, more blue
    [range(-1.67, 1.67)] float tint = 0          ///< above 0: more magenta; below: more green
) {
    float warmth = temperature / 0.6;
    float x = 0.31271 - warmth * (warmth < 0 ? 0.1 : 0.05);
    float y = 2.87 * x - 3 * x * x - 0.27509507 + tint / 0.6 * 0.05;
    float3 balance = float3(0.949237, 1.03542, 1.08728) / ConesOfWhite(float2(x, y));
    return ColorOfCones(ConesOfColor(color) * balance);
}

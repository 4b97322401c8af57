// Other coordinates of a colour: hue, saturation and value or lightness, and the perceptual space OkLab. Hues are in
// turns: 0 is red, 1/3 green, 2/3 blue. HSV and HSL describe the numbers they are given: pickers use sRGB-encoded ones.

// Keeps a ratio of zero and zero away: the colour is grey, and the ratio 0.
const float GREY = 1e-10;

/// The hue of a colour, its largest and its smallest component.
float3 HueAndRange(float3 color) {
    float largest = max(color.r, max(color.g, color.b));
    float smallest = min(color.r, min(color.g, color.b));
    float range = max(largest - smallest, GREY);
    float3 sixths = (color.gbr - color.brg) / (6 * range) + float3(0, 2, 4) / 6;
    float hue = largest == color.r ? sixths.x : largest == color.g ? sixths.y : sixths.z;
    return float3(largest - smallest > 0 ? frac(hue) : 0, largest, smallest);
}

/// Converts red, green and blue to hue, saturation and value.
///
/// The hue is in turns; a grey has the hue 0, and black the saturation 0.
///
/// formula: v = max, s = (max - min) / max, h = ((g - b) / (max - min) + 0, 2 or 4) / 6 by the largest component
/// source: Smith, "Color Gamut Transform Pairs", SIGGRAPH 1978
/// test: RgbToHsv(float3(1, 0, 0)) == float3(0, 1, 1)
/// test: RgbToHsv(float3(0.25, 0.5, 0.25)) == float3(1 / 3, 0.5, 0.5)
/// test: RgbToHsv(float3(0.8, 0.2, 0.5)) == float3(0.9166666666666666, 0.75, 0.8)
/// test: RgbToHsv(float3(0.3, 0.3, 0.3)) == float3(0, 0, 0.3)
/// test: RgbToHsv(float3(0, 0, 0)) == float3(0, 0, 0)
[node("Color/RGB to HSV")]
float3 RgbToHsv(
    [color] float3 color = 1  ///< red, green and blue
) {
    float3 range = HueAndRange(color);
    return float3(range.x, (range.y - range.z) / max(range.y, GREY), range.y);
}

/// Converts hue, saturation and value to red, green and blue.
///
/// formula: v lerp(1, saturate(|6 frac(h + (1, 2/3, 1/3)) - 3| - 1), s)
/// source: Smith, "Color Gamut Transform Pairs", SIGGRAPH 1978
/// test: HsvToRgb(float3(0, 1, 1)) == float3(1, 0, 0)
/// test: HsvToRgb(float3(1 / 3, 0.5, 0.5)) == float3(0.25, 0.5, 0.25)
/// test: HsvToRgb(float3(0.9166666666666666, 0.75, 0.8)) == float3(0.8, 0.2, 0.5)
/// test: HsvToRgb(float3(-0.5, 1, 2)) == float3(0, 2, 2)
[node("Color/HSV to RGB")]
float3 HsvToRgb(
    float3 hsv = float3(0, 1, 1)  ///< hue in turns, saturation, value
) {
    float3 pure = saturate(abs(frac(hsv.x + float3(3, 2, 1) / 3) * 6 - 3) - 1);
    return hsv.z * lerp(1, pure, hsv.y);
}

/// Converts red, green and blue to hue, saturation and lightness.
///
/// The hue is in turns; a grey has the hue 0. Pure colours have a lightness of 0.5, white of 1.
///
/// formula: l = (max + min) / 2, s = (max - min) / (1 - |2 l - 1|), h as in RgbToHsv
/// source: Joblove and Greenberg, "Color Spaces for Computer Graphics", SIGGRAPH 1978
/// test: RgbToHsl(float3(1, 0, 0)) == float3(0, 1, 0.5)
/// test: RgbToHsl(float3(0.25, 0.75, 0.25)) == float3(1 / 3, 0.5, 0.5)
/// test: RgbToHsl(float3(1, 1, 1)) == float3(0, 0, 1)
/// test: RgbToHsl(float3(0.2, 0.2, 0.6)) == float3(2 / 3, 0.5, 0.4)
[node("Color/RGB to HSL")]
float3 RgbToHsl(
    [color] float3 color = 1  ///< red, green and blue
) {
    float3 range = HueAndRange(color);
    float lightness = (range.y + range.z) / 2;
    float widest = 1 - abs(2 * lightness - 1);
    return float3(range.x, (range.y - range.z) / max(widest, GREY), lightness);
}

/// Converts hue, saturation and lightness to red, green and blue.
///
/// formula: l + s (1 - |2 l - 1|) (p - 0.5), p = saturate(|6 frac(h + (1, 2/3, 1/3)) - 3| - 1)
/// source: Joblove and Greenberg, "Color Spaces for Computer Graphics", SIGGRAPH 1978
/// test: HslToRgb(float3(0, 1, 0.5)) == float3(1, 0, 0)
/// test: HslToRgb(float3(1 / 3, 0.5, 0.5)) == float3(0.25, 0.75, 0.25)
/// test: HslToRgb(float3(0.4, 1, 1)) == float3(1, 1, 1)
/// test: HslToRgb(float3(2 / 3, 0.5, 0.4)) == float3(0.2, 0.2, 0.6)
[node("Color/HSL to RGB")]
float3 HslToRgb(
    float3 hsl = float3(0, 1, 0.5)  ///< hue in turns, saturation, lightness
) {
    return hsl.z + hsl.y * (1 - abs(2 * hsl.z - 1)) * (HsvToRgb(float3(hsl.x, 1, 1)) - 0.5);
}

/// The cube root, of negative numbers too.
float3 CubeRoot(float3 value) {
    return sign(value) * pow(max(abs(value), 1e-30), 1.0 / 3);
}

/// Converts a linear colour to OkLab: lightness, and how green or red (a) and blue or yellow (b) it is.
///
/// Equal steps look about equally large, so it is good for gradients: no dark or grey places in the middle.
///
/// formula: lms = M1 rgb, (L, a, b) = M2 lms^(1/3)
/// source: Ottosson, "A perceptual color space for image processing", 2020
/// test: LinearToOkLab(float3(1, 1, 1)) == float3(1, 0, 0) within 1e-4
/// test: LinearToOkLab(float3(0, 0, 0)) == float3(0, 0, 0) within 1e-4
/// test: LinearToOkLab(float3(1, 0, 0)) == float3(0.627955361, 0.224863061, 0.125846299) within 1e-4
/// test: LinearToOkLab(float3(0.125, 0.125, 0.125)) == float3(0.5, 0, 0) within 1e-4
[node("Color/Linear to OkLab")]
float3 LinearToOkLab(
    [color] float3 color = 1  ///< linear colour
) {
    float3 lms = float3(dot(color, float3(0.4122214708, 0.5363325363, 0.0514459929)),
                        dot(color, float3(0.2119034982, 0.6806995451, 0.1073969566)),
                        dot(color, float3(0.0883024619, 0.2817188376, 0.6299787005)));
    float3 root = CubeRoot(lms);
    return float3(dot(root, float3(0.2104542553, 0.7936177850, -0.0040720468)),
                  dot(root, float3(1.9779984951, -2.4285922050, 0.4505937099)),
                  dot(root, float3(0.0259040371, 0.7827717662, -0.8086757660)));
}

/// Converts OkLab to a linear colour.
///
/// formula: rgb = M1^-1 (M2^-1 (L, a, b))^3
/// source: Ottosson, "A perceptual color space for image processing", 2020
/// test: OkLabToLinear(float3(1, 0, 0)) == float3(1, 1, 1) within 1e-4
/// test: OkLabToLinear(float3(0.5, 0, 0)) == float3(0.125, 0.125, 0.125) within 1e-4
/// test: OkLabToLinear(float3(0.729350082, -0.0967860628, 0.000134615619)) == float3(0.1, 0.5, 0.4) within 1e-4
[node("Color/OkLab to Linear")]
float3 OkLabToLinear(
    float3 lab = float3(1, 0, 0)  ///< lightness, a, b
) {
    float3 root = lab.x + float3(dot(lab.yz, float2(0.3963377774, 0.2158037573)),
                                 dot(lab.yz, float2(-0.1055613458, -0.0638541728)),
                                 dot(lab.yz, float2(-0.0894841775, -1.2914855480)));
    float3 lms = root * root * root;
    return float3(dot(lms, float3(4.0767416621, -3.3077115913, 0.2309699292)),
                  dot(lms, float3(-1.2684380046, 2.6097574011, -0.3413193965)),
                  dot(lms, float3(-0.0041960863, -0.7034186147, 1.7076147010)));
}

/// Converts OkLab to lightness, chroma and hue. The hue is in turns; it means nothing if the chroma is 0.
///
/// formula: C = |(a, b)|, h = atan2(b, a) / (2 pi), from 0 to 1
/// source: Ottosson, "A perceptual color space for image processing", 2020
/// test: OkLabToOkLCh(float3(0.5, 0.3, 0.4)) == float3(0.5, 0.5, 0.14758361765043326)
/// test: OkLabToOkLCh(float3(0.5, 0, -0.25)) == float3(0.5, 0.25, 0.75)
/// test: OkLabToOkLCh(float3(1, 0, 0)) == float3(1, 0, 0)
[node("Color/OkLab to OkLCh")]
float3 OkLabToOkLCh(
    float3 lab = float3(1, 0, 0)  ///< lightness, a, b
) {
    float chroma = length(lab.yz);
    float hue = atan2(lab.z, chroma > 0 ? lab.y : 1);
    return float3(lab.x, chroma, frac(hue / TWO_PI));
}

/// Converts lightness, chroma and hue to OkLab.
///
/// formula: (a, b) = C (cos, sin) (2 pi h)
/// source: Ottosson, "A perceptual color space for image processing", 2020
/// test: OkLChToOkLab(float3(0.5, 0.25, 0.25)) == float3(0.5, 0, 0.25)
/// test: OkLChToOkLab(float3(0.5, 0.5, 0.14758361765043326)) == float3(0.5, 0.3, 0.4)
[node("Color/OkLCh to OkLab")]
float3 OkLChToOkLab(
    float3 lch = float3(1, 0, 0)  ///< lightness, chroma, hue in turns
) {
    float angle = TWO_PI * lch.z;
    return float3(lch.x, lch.y * cos(angle), lch.y * sin(angle));
}

/// The spaces of ColorspaceConversion.
enum ColorSpace {
    RGB,     ///< red, green and blue, encoded as sRGB
    Linear,  ///< red, green and blue, linear: what materials compute with
    HSV,     ///< hue in turns, saturation, value, of the encoded colour
    HSL,     ///< hue in turns, saturation, lightness, of the encoded colour
    OkLab,   ///< perceptual lightness, a, b
    OkLCh    ///< perceptual lightness, chroma, hue in turns
};

/// Converts a colour from one space to another.
///
/// Below zero, the encoding of sRGB continues in a straight line.
///
/// source: as of the nodes that it consists of: LinearToSrgb, RgbToHsv, RgbToHsl, LinearToOkLab and their inverses
/// test: ColorspaceConversion(float3(0, 0.5, 1), Linear, RGB) == float3(0, 0.7353569830524495, 1)
/// test: ColorspaceConversion(float3(0, 0.735, 1), RGB, Linear) == float3(0, 0.4994581635400763, 1)
/// test: ColorspaceConversion(float3(-0.1, 0.002, 1), Linear, RGB) == float3(-1.292, 0.02584, 1)
/// test: ColorspaceConversion(float3(-1.292, 0.02584, 1), RGB, Linear) == float3(-0.1, 0.002, 1)
/// test: ColorspaceConversion(float3(0.25, 0.5, 0.25), RGB, HSV) == float3(1 / 3, 0.5, 0.5)
/// test: ColorspaceConversion(float3(1 / 3, 0.5, 0.5), HSV, RGB) == float3(0.25, 0.5, 0.25)
/// test: ColorspaceConversion(float3(0, 1, 0.735), HSV, Linear) == float3(0.4994581635400763, 0, 0)
/// test: ColorspaceConversion(float3(0.5, 0, 0), Linear, HSV) == float3(0, 1, 0.7353569830524495)
/// test: ColorspaceConversion(float3(0.25, 0.75, 0.25), RGB, HSL) == float3(1 / 3, 0.5, 0.5)
/// test: ColorspaceConversion(float3(1 / 3, 0.5, 0.5), HSL, RGB) == float3(0.25, 0.75, 0.25)
/// test: ColorspaceConversion(float3(0.125, 0.125, 0.125), Linear, OkLab) == float3(0.5, 0, 0) within 1e-4
/// test: ColorspaceConversion(float3(0.5, 0, 0), OkLab, Linear) == float3(0.125, 0.125, 0.125) within 1e-4
/// test: ColorspaceConversion(float3(0.5, 0.3, 0.4), OkLab, OkLCh) == float3(0.5, 0.5, 0.14758361765043326) within 1e-4
/// test: ColorspaceConversion(float3(0.5, 0.25, 0.25), OkLCh, OkLab) == float3(0.5, 0, 0.25) within 1e-4
/// test: ColorspaceConversion(float3(0.1, 0.2, 3), HSV, HSV) == float3(0.1, 0.2, 3)
[node("Color/Colorspace Conversion")]
float3 ColorspaceConversion(
    [color] float3 color = 0,     ///< the colour, in the space `from`
    const ColorSpace from = RGB,  ///< the space of the input
    const ColorSpace to = RGB     ///< the space of the result
) {
    if (from == to) { return color; }
    // To linear, or to OkLab or to the encoded colour if that is as far as the way leads.
    const bool perceptual = (from == OkLab || from == OkLCh) && (to == OkLab || to == OkLCh);
    const bool encoded = (from == RGB || from == HSV || from == HSL) && (to == RGB || to == HSV || to == HSL);
    float3 middle = color;
    if (from == HSV) { middle = HsvToRgb(color); }
    if (from == HSL) { middle = HslToRgb(color); }
    if (from == OkLCh) { middle = OkLChToOkLab(color); }
    if (!perceptual && (from == OkLab || from == OkLCh)) { middle = OkLabToLinear(middle); }
    if (!encoded && (from == RGB || from == HSV || from == HSL)) { middle = SrgbToLinear(middle) + min(middle, 0) / 12.92; }
    if (!encoded && (to == RGB || to == HSV || to == HSL)) { middle = LinearToSrgb(middle) + min(middle, 0) * 12.92; }
    if (!perceptual && (to == OkLab || to == OkLCh)) { middle = LinearToOkLab(middle); }
    if (to == HSV) { return RgbToHsv(middle); }
    if (to == HSL) { return RgbToHsl(middle); }
    if (to == OkLCh) { return OkLabToOkLCh(middle); }
    return middle;
}

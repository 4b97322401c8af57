// Colour ramps: a number becomes a colour. A ramp of a few keys, one of numbers (for its opacity), and a palette of
// cosines.

/// How a ramp goes from one key to the next.
enum RampMode {
    Blended,     ///< in a straight line
    Fixed,       ///< each key's colour from the place of the key before to its own
    Perceptual,  ///< in a straight line in OkLab: no dark or grey places in the middle
    FixedUnity   ///< Fixed, but each colour begins one per cent of its length late, as in Unity's gradients
};

/// The share of the next key: from 0 at the place of the one before to 1 at its own.
float RampShare(float position, float before, float at, float isSharp, float first) {
    float share = saturate((position - before) / max(at - before, 1e-6));
    return lerp(share, step(first, share), isSharp);
}

/// A colour from a ramp of up to eight keys.
///
/// Before the first key and after the last one, the ramp is constant. The keys stand in the order of their places.
///
/// formula: c = c_0, then for each further key i: lerp(c, c_i, saturate((position - a_(i-1)) / (a_i - a_(i-1))))
/// source: Perceptual: Ottosson, "A perceptual color space for image processing", 2020; FixedUnity: Unity Shader Graph,
/// source: Sample Gradient
/// test: ColorRamp(0.25, Blended, 2, float3(0, 0, 0), 0, float3(1, 0.5, 0), 1) == float3(0.25, 0.125, 0)
/// test: ColorRamp(0.9, Blended, 3, float3(0, 0, 0), 0.2, float3(1, 0, 0), 0.4, float3(1, 1, 0), 0.8) == float3(1, 1, 0)
/// test: ColorRamp(0.7, Blended, 3, float3(0, 0, 0), 0.2, float3(1, 0, 0), 0.4, float3(1, 1, 0), 0.8) == float3(1, 0.75, 0)
/// test: ColorRamp(0.1, Blended, 3, float3(0, 0, 1), 0.2, float3(1, 0, 0), 0.4, float3(1, 1, 0), 0.8) == float3(0, 0, 1)
/// test: ColorRamp(0.202, Fixed, 2, float3(0, 0, 0), 0.2, float3(1, 0.5, 0), 0.6) == float3(1, 0.5, 0)
/// test: ColorRamp(0.202, FixedUnity, 2, float3(0, 0, 0), 0.2, float3(1, 0.5, 0), 0.6) == float3(0, 0, 0)
/// test: ColorRamp(0.3, FixedUnity, 2, float3(0, 0, 0), 0.2, float3(1, 0.5, 0), 0.6) == float3(1, 0.5, 0)
/// test: ColorRamp(0.5, Perceptual, 2, float3(0, 0, 0), 0, float3(1, 1, 1), 1) == float3(0.125, 0.125, 0.125) within 1e-4
[node("Color/Ramp")] [also("Ramp", "RampGradient")]
float3 ColorRamp(
    [range(0, 1)] float position = 0,                    ///< where on the ramp
    const RampMode mode = Blended,         ///< how it goes from key to key
    [range(1, 8)] const int keys = 2,      ///< how many keys there are
    [color] float3 color0 = 0,             ///< colour of the first key
    [range(0, 1)] float at0 = 0,                         ///< its place
    [color] float3 color1 = 1,             ///< colour of the second key
    [range(0, 1)] float at1 = 1,                         ///< its place
    [color] float3 color2 = 1,             ///< colour of the third key
    [range(0, 1)] float at2 = 1,                         ///< its place
    [color] float3 color3 = 1,             ///< colour of the fourth key
    [range(0, 1)] float at3 = 1,                         ///< its place
    [color] float3 color4 = 1,             ///< colour of the fifth key
    [range(0, 1)] float at4 = 1,                         ///< its place
    [color] float3 color5 = 1,             ///< colour of the sixth key
    [range(0, 1)] float at5 = 1,                         ///< its place
    [color] float3 color6 = 1,             ///< colour of the seventh key
    [range(0, 1)] float at6 = 1,                         ///< its place
    [color] float3 color7 = 1,             ///< colour of the eighth key
    [range(0, 1)] float at7 = 1                          ///< its place
) {
    const float3 colors[8] = { color0, color1, color2, color3, color4, color5, color6, color7 };
    const float places[8] = { at0, at1, at2, at3, at4, at5, at6, at7 };
    const float isSharp = mode == Fixed || mode == FixedUnity ? 1 : 0;
    const float first = mode == FixedUnity ? 0.01 : 1e-6;
    float3 color = mode == Perceptual ? LinearToOkLab(colors[0]) : colors[0];
    for (int i = 1; i < min(keys, 8); i++) {
        float3 next = mode == Perceptual ? LinearToOkLab(colors[i]) : colors[i];
        color = lerp(color, next, RampShare(position, places[i - 1], places[i], isSharp, first));
    }
    return mode == Perceptual ? OkLabToLinear(color) : color;
}

/// A number from a ramp of up to eight keys: the opacity of a gradient, or a curve of straight lines.
///
/// Before the first key and after the last one, the ramp is constant. The keys stand in the order of their places.
///
/// formula: v = v_0, then for each further key i: lerp(v, v_i, saturate((position - a_(i-1)) / (a_i - a_(i-1))))
/// test: ValueRamp(0.25, Blended, 2, 1, 0, 3, 1) == 1.5
/// test: ValueRamp(0.7, Blended, 3, 0, 0.2, 1, 0.4, 3, 0.8) == 2.5
/// test: ValueRamp(0.1, Perceptual, 3, 5, 0.2, 1, 0.4, 3, 0.8) == 5
/// test: ValueRamp(0.202, Fixed, 2, 0, 0.2, 1, 0.6) == 1
/// test: ValueRamp(0.202, FixedUnity, 2, 0, 0.2, 1, 0.6) == 0
[node("Color/Value Ramp")]
float ValueRamp(
    [range(0, 1)] float position = 0,                ///< where on the ramp
    const RampMode mode = Blended,     ///< how it goes from key to key; Perceptual is the same as Blended
    [range(1, 8)] const int keys = 2,  ///< how many keys there are
    float value0 = 0,                  ///< value of the first key
    [range(0, 1)] float at0 = 0,                     ///< its place
    float value1 = 1,                  ///< value of the second key
    [range(0, 1)] float at1 = 1,                     ///< its place
    float value2 = 1,                  ///< value of the third key
    [range(0, 1)] float at2 = 1,                     ///< its place
    float value3 = 1,                  ///< value of the fourth key
    [range(0, 1)] float at3 = 1,                     ///< its place
    float value4 = 1,                  ///< value of the fifth key
    [range(0, 1)] float at4 = 1,                     ///< its place
    float value5 = 1,                  ///< value of the sixth key
    [range(0, 1)] float at5 = 1,                     ///< its place
    float value6 = 1,                  ///< value of the seventh key
    [range(0, 1)] float at6 = 1,                     ///< its place
    float value7 = 1,                  ///< value of the eighth key
    [range(0, 1)] float at7 = 1                      ///< its place
) {
    const float values[8] = { value0, value1, value2, value3, value4, value5, value6, value7 };
    const float places[8] = { at0, at1, at2, at3, at4, at5, at6, at7 };
    const float isSharp = mode == Fixed || mode == FixedUnity ? 1 : 0;
    const float first = mode == FixedUnity ? 0.01 : 1e-6;
    float value = values[0];
    for (int i = 1; i < min(keys, 8); i++) {
        value = lerp(value, values[i], RampShare(position, places[i - 1], places[i], isSharp, first));
    }
    return value;
}

/// A palette of three cosines: endless colours that repeat without a seam.
///
/// formula: middle + swing cos(2 pi (turns position + phase))
/// source: Quilez, "Procedural Color Palette", 1999
/// test: CosinePalette(0, float3(0.5, 0.4, 0.3), float3(0.5, 0.2, 0.1), 1, float3(0, 0.25, 0.5)) == float3(1, 0.4, 0.2)
/// test: CosinePalette(0.5, float3(0.5, 0.4, 0.3), float3(0.5, 0.2, 0.1), float3(1, 2, 0.5), 0) == float3(0, 0.6, 0.3)
[node("Color/Cosine Palette")]
float3 CosinePalette(
    float position = 0,                         ///< where on the palette; it repeats after 1
    float3 middle = 0.5,                        ///< the colour around which it swings
    float3 swing = 0.5,                         ///< how far each channel swings
    float3 turns = 1,                           ///< how often each channel swings; whole numbers leave no seam
    float3 phase = float3(0, 0.3333333, 0.6666667)  ///< where each channel begins, in turns
) {
    return middle + swing * cos(TWO_PI * (turns * position + phase));
}

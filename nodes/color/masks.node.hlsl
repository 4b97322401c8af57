// Masks and filters of values: channels, an ordered dither, a dissolving transition, and layers by their heights.

/// Keeps the channels that are chosen, and sets the others to zero.
///
/// test: ChannelMask(float3(0.2, 0.4, 0.8)) == float3(0.2, 0.4, 0.8)
/// test: ChannelMask(float4(0.2, 0.4, 0.8, 0.5), float4(1, 0, 1, 0)) == float4(0.2, 0, 0.8, 0)
[node("Color/Channel Mask")] [also("ColorWriteMask")]
floatN ChannelMask(
    [color] floatN value = 0,         ///< colour or vector
    [range(0, 1)] floatN channels = 1  ///< for each channel 1 to keep it, or 0
) {
    return channels > 0.5 ? value : 0;
}

/// Dithers a value: subtracts a threshold that differs from pixel to pixel, in a pattern of four by four.
///
/// The result is above zero in a share of the pixels that grows with the value: with it, `alphaClip` fades a surface
/// without blending.
///
/// formula: value - (m + 1) / 17, m = 0 to 15 by the place of the pixel in the pattern
/// source: Bayer, "An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures", 1973
/// test: Dither(0.5, float2(0.5, 0.5)) == 0.4411764705882353
/// test: Dither(float3(0, 0.5, 1), float2(5.5, 6.5)) == float3(-0.8823529411764706, -0.3823529411764706, 0.11764705882352941)
/// test: Dither(1, float2(3.5, 0.5)) == 0.058823529411764705
/// test: Dither(0, float2(7.5, 3.5)) == -0.35294117647058826
[node("Color/Dither")] [also("DitherTemporalAA")]
floatN Dither(
    [range(0, 1)] floatN value = 0,  ///< a value from 0 to 1
    float2 pixel = fragCoord.xy  ///< pixels, counted from the upper left; Unity counts rows from the bottom
) {
    // A pattern of 4 x 4 is one of 2 x 2 in each cell of another 2 x 2: the bits of m, the last one first.
    float2 cell = floor(pixel);
    float2 low = cell - 2 * floor(cell / 2);
    float2 high = floor(cell / 2) - 2 * floor(cell / 4);
    float m = 8 * abs(low.x - low.y) + 4 * low.x + 2 * abs(high.x - high.y) + high.x;
    return value - (m + 1) / 17;
}

/// A transition that dissolves along a noise: parts with a low noise go last.
///
/// formula: saturate(fade (contrast + 1) + (noise - 1) contrast)
/// source: Unity Shader Graph, Fade Transition
/// test: FadeTransition(0.5, 0.5, 1) == 0.5
/// test: FadeTransition(0.25, 0.5, 2) == 0
/// test: FadeTransition(0.75, 0.5, 1) == 0.75
/// test: FadeTransition(0.3, 1, 4) == 1
[node("Color/Fade Transition")] [range(0, 1)]
float FadeTransition(
    [range(0, 1)] float noise = 0.5,  ///< a pattern from 0 to 1
    [range(0, 1)] float fade = 0.5,   ///< 0: all is gone, 1: all is there
    [range(0, 10)] float contrast = 1  ///< 0: fades everywhere at once; the larger, the sharper the edge
) {
    return saturate(fade * (contrast + 1) + (noise - 1) * contrast);
}

/// Blends two layers where their heights meet: sand fills the joints of stones before it covers them.
///
/// formula: (c_1 w_1 + c_2 w_2) / (w_1 + w_2), w_i = max(h_i + a_i - (max(h_1 + a_1, h_2 + a_2) - depth), 0), a = (1 - mask, mask)
/// source: Mishkinis, "Advanced Terrain Texture Splatting", 2013
/// test: HeightBlend(float3(1, 0, 0), float3(0, 0, 1), 0.5, 0.5, 0.5) == float3(0.5, 0, 0.5)
/// test: HeightBlend(float3(1, 0, 0), float3(0, 0, 1), 0.9, 0.2, 0.5, 0.2) == float3(1, 0, 0)
/// test: HeightBlend(1, 3, 0.5, 0.6, 0.5, 0.2) == 2.3333333333333335
/// test: HeightBlend(1, 3, 0.5, 0.6, 0.5, 0.2).share == 0.6666666666666666
/// test: HeightBlend(1, 3, 0, 0, 1) == 3
[node("Color/Height Blend")] [also("HeightLerp")]
floatN HeightBlend(
    [color] floatN lower = 0,            ///< the layer where the mask is 0
    [color] floatN upper = 1,            ///< the layer where the mask is 1
    [range(0, 1)] float lowerHeight = 0.5,  ///< height of the lower layer
    [range(0, 1)] float upperHeight = 0.5,  ///< height of the upper layer
    [range(0, 1)] float mask = 0.5,         ///< how much of the upper layer there is
    [range(0.01, 1)] float depth = 0.2,     ///< difference of heights over which the layers mix
    [range(0, 1)] out float share           ///< the share of the upper layer, to blend more with it
) {
    float first = lowerHeight + 1 - mask;
    float second = upperHeight + mask;
    float floorHeight = max(first, second) - max(depth, 1e-4);
    float firstWeight = max(first - floorHeight, 0);
    float secondWeight = max(second - floorHeight, 0);
    share = secondWeight / (firstWeight + secondWeight);
    return lerp(lower, upper, share);
}

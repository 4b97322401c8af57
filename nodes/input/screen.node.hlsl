// The screen: its size, and the place of a pixel on it.

/// The size of the picture in pixels.
///
/// test: ScreenSize(float2(800, 600)) == float2(800, 600)
/// test: ScreenSize(float2(800, 600)).aspect == 1.3333333333333333
[node("Input/Screen Size")] [also("Screen", "ScreenResolution", "ViewSize")]
float2 ScreenSize(
    [hidden] float2 size = screenSize,  ///< width and height in pixels
    out float aspect                    ///< width divided by height
) {
    aspect = size.x / size.y;
    return size;
}

/// How the place of a pixel is measured.
enum ScreenPositionMode {
    Default,  ///< from 0 to 1
    Raw,      ///< as Default, times w, which is the distance along the camera's axis in a perspective view; z is that of clip space
    Center,   ///< from -1 to 1, zero in the middle
    Tiled,    ///< squares as high as half of the picture, each from 0 to 1, counted from the middle
    Pixel     ///< in pixels
};

/// Where y of a screen position is zero.
enum ScreenOrigin {
    Top,    ///< at the top, as texture coordinates are counted here
    Bottom  ///< at the bottom, as Unity counts
};

// z and w of a point in clip space.
float2 ClipDepth(float3 position) {
    float4 clip = mul(worldToClip, float4(position, 1));
    return clip.zw;
}

/// The place of this pixel on the screen, in the forms of Unity's Shader Graph. ScreenUV is the plain one.
///
/// source: Unity Shader Graph, node Screen Position
/// test: ScreenPosition(Default, Top, float2(0.25, 0.75), float2(800, 400), float2(0, 2)) == float4(0.25, 0.75, 0, 0)
/// test: ScreenPosition(Default, Bottom, float2(0.25, 0.75), float2(800, 400), float2(0, 2)) == float4(0.25, 0.25, 0, 0)
/// test: ScreenPosition(Raw, Top, float2(0.25, 0.75), float2(800, 400), float2(1, 2)) == float4(0.5, 1.5, 1, 2)
/// test: ScreenPosition(Center, Top, float2(0.25, 0.75), float2(800, 400), float2(0, 2)) == float4(-0.5, 0.5, 0, 0)
/// test: ScreenPosition(Tiled, Top, float2(0.375, 0.875), float2(800, 400), float2(0, 2)) == float4(0.5, 0.75, 0, 0)
/// test: ScreenPosition(Pixel, Bottom, float2(0.25, 0.25), float2(800, 400), float2(0, 2)) == float4(200, 300, 0, 0)
[node("Input/Screen Position")]
float4 ScreenPosition(
    const ScreenPositionMode mode = Default,        ///< how the place is measured
    const ScreenOrigin origin = Top,                ///< where y is zero
    [hidden] float2 uv = screenUV,                 ///< the place, from the top
    [hidden] float2 size = screenSize,              ///< of the picture, in pixels
    [hidden] float2 depth = ClipDepth(positionWS)  ///< z and w in clip space
) {
    float2 place = origin == Bottom ? float2(uv.x, 1 - uv.y) : uv;
    float2 centered = place * 2 - 1;
    if (mode == Raw) { return float4(place * depth.y, depth); }
    if (mode == Center) { return float4(centered, 0, 0); }
    if (mode == Tiled) { return float4(frac(float2(centered.x * size.x / size.y, centered.y)), 0, 0); }
    if (mode == Pixel) { return float4(place * size, 0, 0); }
    return float4(place, 0, 0);
}

// Parallax: reading a texture elsewhere, so that the flat surface seems to have the relief of a height map. Lengths are in
// units of uv. Directions are in tangent space, whose y points up in the texture's picture while v grows downwards.

// A step in the surface's plane, as a step of uv.
float2 uvOfTangent(float2 tangent) {
    return float2(tangent.x, -tangent.y);
}

/// How far to move the texture coordinates so that a height map seems to stand out: the more, the more slanted the view.
///
/// One step, so it is right for shallow relief only: ParallaxOcclusion hides what lies behind. Half of the height lies
/// above the surface and half below. The 0.42 keeps the offset below 1.2 heights at the outline.
///
/// formula: height (texel - 0.5) v.xy / (v.z + 0.42), v = normalize(viewTS); uv runs against v.y
/// source: Kaneko et al., "Detailed Shape Representation with Parallax Mapping", ICAT 2001; Welsh, "Parallax Mapping",
/// source: ShaderX 3, 2004; the 0.42: Unity built-in shaders, ParallaxOffset1Step
/// test: ParallaxOffset(1, 0.08, float3(0.6, 0, 0.8)) == float2(0.019672131147540985, 0)
/// test: ParallaxOffset(0, 0.08, float3(3, 0, 4)) == float2(-0.019672131147540985, 0)
/// test: ParallaxOffset(1, 0.08, float3(0, 0, 1)) == float2(0, 0)
/// test: ParallaxOffset(0.5, 0.02, float3(0.6, 0.3, 0.1)) == float2(0, 0)
/// test: ParallaxOffset(1, 0.084, float3(0, 1, 0)) == float2(0, -0.1)
[node("UV/Parallax Offset")]
float2 ParallaxOffset(
    [range(0, 1)] float texel = 0.5,           ///< of the height map: 0 is deep, 1 high
    [range(0.005, 0.08)] float height = 0.02,  ///< between the deepest and the highest point, in units of uv
    float3 viewTS                             ///< direction to the viewer in tangent space: WorldToTangent gives it
) {
    float3 view = viewTS * rsqrt(max(dot(viewTS, viewTS), 1e-6));
    return (texel * height - 0.5 * height) * uvOfTangent(view.xy) / (max(view.z, 0) + 0.42);
}

/// How far to move the texture coordinates to what is seen of a height map's relief, high parts hiding what lies behind.
///
/// The surface itself is the top, and the relief is cut into it. The line of sight is followed down from there in equal
/// steps, and where it has passed below the relief it is cut with the straight line between the last two heights. A part
/// that is thinner than a step can be missed: flat views take more steps. Views flatter than 6 degrees are taken for as
/// flat as that.
///
/// Where a high part hides what lies behind it the moved coordinates jump. Read textures there by SampleTexture2DGrad, which
/// takes its level of detail from the coordinates before; SampleTexture2D would draw seams along the edges.
///
/// formula: uv(t) = uv - t height v.xy / v.z, the first t at which 1 - t is not above the map's red
/// source: Tatarchuk, "Practical Parallax Occlusion Mapping with Approximate Soft Shadows for Detailed Surface
/// source: Rendering", SIGGRAPH 2006 course, chapter 5
[node("UV/Parallax Occlusion")]
float2 ParallaxOcclusion(
    Texture2D texture,                       ///< the height map, in red: 0 is deep, 1 the surface itself
    float2 uv = uv0,                         ///< where the surface is looked at, before the texture's own tiling
    [range(0, 0.2)] float height = 0.05,     ///< how deep 0 lies, in units of uv
    float3 viewTS,                          ///< direction to the viewer in tangent space: WorldToTangent gives it
    [range(1, 128)] float fewestSteps = 8,  ///< along a view straight down
    [range(1, 128)] float mostSteps = 32    ///< along the surface
) {
    float3 view = viewTS * rsqrt(max(dot(viewTS, viewTS), 1e-6));
    float2 deepest = -uvOfTangent(view.xy) * (height / max(view.z, 0.1));

    // Where the loop reads, no neighbouring pixels are known: what is a texel's share of a pixel is found before.
    float2 start = uv * texture.tiling.xy + texture.tiling.zw;
    float2 path = deepest * texture.tiling.xy;
    float2 right = ddx(start);
    float2 down = ddy(start);

    int steps = min(int(ceil(max(lerp(mostSteps, fewestSteps, saturate(view.z)), 1))), 128);
    float stride = 1 / float(steps);
    float above = 1 - texture.SampleGrad(start, right, down).r;
    float seen = above > 0 ? -1 : 0;  // t; below 0: not yet
    for (int i = 1; i < min(steps + 1, 129); i++) {
        if (seen < 0) {
            float t = float(i) * stride;
            float gap = 1 - t - texture.SampleGrad(start + path * t, right, down).r;
            seen = gap > 0 ? -1 : t - stride * gap / (gap - above);
            above = gap;
        }
    }
    return deepest * (seen < 0 ? 1 : seen);
}

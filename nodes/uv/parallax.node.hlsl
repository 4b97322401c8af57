// Parallax: moving texture coordinates so that a flat surface seems to have the relief of a height map. Lengths are in
// units of uv. Directions are in tangent space, whose y points up in the texture while v grows downwards.

// Converts a step in the surface's plane to a step of uv.
float2 uvOfTangent(float2 tangent) {
    return float2(tangent.x, -tangent.y);
}

/// The offset of texture coordinates that makes a height map stand out: it grows as the view slants.
///
/// The node takes one step, so it suits only shallow relief: ParallaxOcclusion also hides covered parts. Half of the
/// height lies above the surface and half below. The 0.42 keeps the offset below 1.2 heights at the silhouette.
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
    [range(0, 1)] float texel = 0.5,           ///< value of the height map: 0 is deep, 1 high
    [range(0.005, 0.08)] float height = 0.02,  ///< distance between the deepest and the highest point, in units of uv
    float3 viewTS                             ///< direction to the viewer in tangent space, from WorldToTangent
) {
    float3 view = viewTS * rsqrt(max(dot(viewTS, viewTS), 1e-6));
    return (texel * height - 0.5 * height) * uvOfTangent(view.xy) / (max(view.z, 0) + 0.42);
}

/// The channel of a height map that holds the height.
enum HeightChannel {
    Red,    ///< red
    Green,  ///< green
    Blue,   ///< blue
    Alpha   ///< alpha
};

float HeightOf(float4 texel, const HeightChannel channel) {
    return channel == Red ? texel.r : channel == Green ? texel.g : channel == Blue ? texel.b : texel.a;
}

// Where the line of sight meets a relief, as a share of the way down to its deepest level: 1 if it meets nothing before. `path` is
// the way to that level. Inside the loop no neighbouring pixels are known: `right` and `down` give the level of detail.
float ReliefDepth(Texture2D texture, SamplerState sampler, float2 start, float2 path, float2 right, float2 down,
                  int steps, const HeightChannel channel) {
    float stride = 1 / float(steps);
    float above = 1 - HeightOf(texture.SampleGrad(sampler, start, right, down), channel);
    float seen = above > 0 ? -1 : 0;  // below 0: not yet
    for (int i = 1; i < min(steps + 1, 257); i++) {
        if (seen < 0) {
            float t = float(i) * stride;
            float gap = 1 - t - HeightOf(texture.SampleGrad(sampler, start + path * t, right, down), channel);
            seen = gap > 0 ? -1 : t - stride * gap / (gap - above);
            above = gap;
        }
    }
    return seen < 0 ? 1 : seen;
}

/// The offset of texture coordinates to the visible point of a height map's relief; high parts hide parts behind them.
///
/// The surface itself is the top, and the relief is cut into it. The node follows the line of sight down in equal
/// steps. Once the line is below the relief, it is intersected with the straight line between the last two heights. A
/// part that is thinner than a step can be missed: flat views take more steps. Views flatter than 6 degrees are treated
/// as 6 degrees.
///
/// Where a high part hides another, the moved coordinates jump. Read textures there with SampleTexture2DMoved, which
/// takes the mip level from the original coordinates; SampleTexture2D would draw seams along the edges.
///
/// formula: uv(t) = uv - t height v.xy / v.z, the first t at which 1 - t is not above the map's red
/// source: Tatarchuk, "Practical Parallax Occlusion Mapping with Approximate Soft Shadows for Detailed Surface
/// source: Rendering", SIGGRAPH 2006 course, chapter 5
[node("UV/Parallax Occlusion")]
float2 ParallaxOcclusion(
    [is("data")] Texture2D texture,         ///< the height map, in red: 0 is deep, 1 the surface itself
    float2 uv = uv0,                        ///< texture coordinates of the surface, before the texture's own tiling
    [range(0, 0.2)] float height = 0.05,    ///< depth of the value 0, in units of uv
    float3 viewTS,                          ///< direction to the viewer in tangent space, from WorldToTangent
    [range(1, 128)] float fewestSteps = 8,  ///< steps for a view straight down
    [range(1, 128)] float mostSteps = 32,   ///< steps for a view along the surface
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float3 view = viewTS * rsqrt(max(dot(viewTS, viewTS), 1e-6));
    float2 deepest = -uvOfTangent(view.xy) * (height / max(view.z, 0.1));

    float2 start = uv * texture.tiling.xy + texture.tiling.zw;
    float2 path = deepest * texture.tiling.xy;
    int steps = min(int(ceil(max(lerp(mostSteps, fewestSteps, saturate(view.z)), 1))), 128);
    return deepest * ReliefDepth(texture, sampler, start, path, ddx(start), ddy(start), steps, Red);
}

/// Texture coordinates that a height map moves by one step, as Unity's Shader Graph does: ParallaxOffset and its texture in one.
///
/// formula: uv + ParallaxOffset(texel, amplitude / 100, viewTS)
/// source: Unity Shader Graph, node Parallax Mapping
[node("UV/Parallax Mapping")]
float2 ParallaxMapping(
    [is("data")] Texture2D texture,         ///< the height map: 0 is deep, 1 high
    float2 uv = uv0,                        ///< texture coordinates of the surface, before the texture's own tiling
    [range(0, 8)] float amplitude = 1,      ///< distance between the deepest and the highest point, in hundredths of a unit of uv
    const HeightChannel channel = Green,    ///< where the height is
    float3 viewTS = WorldToTangent(viewDirWS, geometryNormalWS, tangentWS, bitangentWS),  ///< direction to the viewer in tangent space
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float texel = HeightOf(SampleTexture2D(texture, uv, sampler), channel);
    return uv + ParallaxOffset(texel, amplitude * 0.01, viewTS);
}

/// Texture coordinates of the visible point of a relief, with the settings of Unity's Shader Graph.
///
/// ParallaxOcclusion is the simpler node: it takes more steps where the view is flat. Both cut the relief into the surface.
///
/// formula: h = 2 amplitude / 100 / (|tiling.x| + |tiling.y|); the path is h v.xy / v.z tiling / primitiveSize
/// source: Tatarchuk, SIGGRAPH 2006 course, chapter 5; Unity Shader Graph, node Parallax Occlusion Mapping
[node("UV/Parallax Occlusion Mapping")] [also("Pom")]
float2 ParallaxOcclusionMapping(
    [is("data")] Texture2D texture,           ///< the height map: 0 is deep, 1 the surface itself
    float2 uv = uv0,                          ///< texture coordinates of the surface
    [range(0, 20)] float amplitude = 1,       ///< depth of the value 0, in centimetres
    [range(1, 256)] float steps = 5,          ///< how many samples find the visible point
    float2 tiling = 1,                        ///< how often the texture fits on the surface
    float2 offset = 0,                        ///< translation, in textures
    float2 primitiveSize = 1,                 ///< size of the surface that uv from 0 to 1 covers, in metres; not zero
    [range(0, 14)] float level = 0,           ///< mip level with which the relief is read, for fading it out
    [range(0, 14)] float levelThreshold = 0,  ///< from this level on, the relief fades; one level further it is flat
    const HeightChannel channel = Red,        ///< where the height is
    float3 viewTS = WorldToTangent(viewDirWS, geometryNormalWS, tangentWS, bitangentWS),  ///< direction to the viewer in tangent space
    SamplerState sampler = texture.sampler,   ///< how it is read; default: as the texture says
    [unit("m")] out float depthOffset         ///< how much farther from the viewer the visible point is than the surface
) {
    float3 view = viewTS * rsqrt(max(dot(viewTS, viewTS), 1e-6));
    float height = amplitude * 0.02 / max(abs(tiling.x) + abs(tiling.y), 1e-6);
    float2 path = -uvOfTangent(view.xy) * (height / max(view.z, 0.1)) * tiling / primitiveSize;
    float2 start = uv * tiling + offset;
    int count = min(int(ceil(max(steps, 1))), 256);
    float t = ReliefDepth(texture, sampler, start, path, ddx(start), ddy(start), count, channel);
    depthOffset = height * t / max(view.z, 0.1);
    return start + path * t * (1 - saturate(level - levelThreshold));
}

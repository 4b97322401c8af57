// Textures that flow: two copies of a texture move along a flow, each only for a short time, and one fades in while the other
// begins again.

/// The two places from which a flowing texture is read, and how much of the second is shown.
///
/// Each copy moves for one cycle and then jumps back, at the moment at which it is not shown.
///
/// formula: uv - flow strength (p - 1/2), p = frac(t) and frac(t + 1/2), t = seconds speed; blend = |1 - 2 frac(t)|
/// source: Vlachos, "Water Flow in Portal 2", SIGGRAPH 2010
/// test: FlowPhases(float2(0.5, 0.5), float2(1, 0), 0.25, 1, 0.4) == float2(0.6, 0.5)
/// test: FlowPhases(float2(0.5, 0.5), float2(1, 0), 0.25, 1, 0.4).second == float2(0.9, 1)
/// test: FlowPhases(float2(0.5, 0.5), float2(1, 0), 0.25, 1, 0.4).blend == 0.5
/// test: FlowPhases(float2(0, 0), float2(0, -1), 3, 0.5, 1) == float2(0, 0)
/// test: FlowPhases(float2(0, 0), float2(0, -1), 3, 0.5, 1).blend == 0
/// test: FlowPhases(float2(0, 0), float2(0, -1), 4, 0.5, 1).blend == 1
[node("UV/Flow Phases")] [also("FlowUV")]
float2 FlowPhases(
    float2 uv = uv0,                  ///< texture coordinates
    float2 flow = float2(1, 0),       ///< velocity of the flow, along u and v: from -1 to 1
    [unit("s")] float seconds = time,  ///< the clock; a little noise added to it hides that all places begin again at once
    float speed = 0.5,                ///< cycles in a second
    float strength = 0.25,            ///< how far a texture moves in one cycle at a flow of 1, in units of uv
    out float2 second,                ///< where to read the second copy; half a texture away, so that both differ
    out float blend                   ///< the share of the second copy, from 0 to 1
) {
    float phase = frac(seconds * speed);
    blend = abs(1 - 2 * phase);
    second = uv - flow * (strength * (frac(phase + 0.5) - 0.5)) + 0.5;
    return uv - flow * (strength * (phase - 0.5));
}

/// Samples a texture that flows, such as foam on water, along a velocity that may differ from place to place.
///
/// formula: lerp(texture(first), texture(second), blend), from FlowPhases
/// source: Vlachos, "Water Flow in Portal 2", SIGGRAPH 2010
[node("UV/Sample Flow")] [also("FlowMapping")] [is("texel")]
float4 SampleFlow(
    Texture2D texture,                      ///< texture to read; it must repeat
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    float2 flow = float2(1, 0),             ///< velocity of the flow, along u and v: from -1 to 1
    [unit("s")] float seconds = time,       ///< the clock
    float speed = 0.5,                      ///< cycles in a second
    float strength = 0.25,                  ///< how far the texture moves in one cycle at a flow of 1, in units of uv
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    float4 first = SampleTexture2D(texture, FlowPhases(uv, flow, seconds, speed, strength), sampler);
    float4 second = SampleTexture2D(texture, FlowPhases(uv, flow, seconds, speed, strength).second, sampler);
    return lerp(first, second, FlowPhases(uv, flow, seconds, speed, strength).blend);
}

/// The velocity that a flow map stores: red and green, 0.5 for rest.
///
/// formula: 2 texel - 1, with v downwards: green above 0.5 flows up in the picture
/// source: Vlachos, "Water Flow in Portal 2", SIGGRAPH 2010
/// test: FlowFromMap(float2(0.5, 0.5)) == float2(0, 0)
/// test: FlowFromMap(float2(1, 1)) == float2(1, -1)
/// test: FlowFromMap(float2(0.25, 0)) == float2(-0.5, 1)
[node("UV/Flow from Map")] [also("FlowMap", "DecodeFlow")]
float2 FlowFromMap(
    [range(0, 1)] float2 texel  ///< red and green of the flow map, read as data
) {
    return float2(2 * texel.x - 1, 1 - 2 * texel.y);
}

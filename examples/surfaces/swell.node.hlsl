/// Waves of a sea: where a point of a plane goes, and the frame that it has there. The plane lies in x and y, u runs along
/// x, and the waves rise along z.
///
/// Four waves, each half as long and as high as the one before, about the wind's direction. The frame is that of the moved
/// surface: its derivatives along x and y.
///
/// formula: p = (x + sum q a d.x cos w, y + sum q a d.y cos w, sum a sin w), w = k d.(x, y) - sqrt(g k) seconds
/// source: Finch, "Effective Water Simulation from Physical Models", GPU Gems, 2004: Gerstner waves
/// test: Swell(float3(0, 0, 0), 6.283185307179586, 0.1, 0.4, 0) == float3(0.1425, 0.06, 0)
/// test: Swell(float3(0, 0, 0), 6.283185307179586, 0.1, 0.4, 0).normal == float3(-0.264, -0.048, 1) / 1.035374328443582
/// test: Swell(float3(0, 0, 0), 6.283185307179586, 0.1, 0.4, 0).tangent == float3(1, 0, 0.264) / 1.034262055911
/// test: Swell(float3(0.3, -0.2, 0), 1, 0, 0.5, 2).normal == float3(0, 0, 1)
[node("Examples/Swell")]
float3 Swell(
    float3 position = positionOS,                ///< a point of the plane
    [unit("m")] float wavelength = 1.2,           ///< of the longest wave
    [unit("m")] float amplitude = 0.05,           ///< of the longest wave
    [range(0, 1)] float steepness = 0.6,          ///< 0: round as a sine, 1: the crests come to a point
    [unit("s")] float seconds = time,             ///< the clock
    out float3 normal,                            ///< unit normal of the moved plane
    out float3 tangent,                           ///< unit direction of growing u on the moved plane
    out float crest                               ///< height over that of the highest crest, -1 to 1
) {
    const float2 directions[4] = { float2(0.8, 0.6), float2(0.96, -0.28), float2(0.28, 0.96), float2(0.6, -0.8) };
    float3 moved = position;
    float3 alongX = float3(1, 0, 0);
    float3 alongY = float3(0, 1, 0);
    float share = 1;
    float total = 0;
    for (int i = 0; i < 4; i++) {
        float2 d = directions[i];
        float a = amplitude * share;
        float k = TWO_PI / (wavelength * share);
        float phase = k * dot(d, position.xy) - sqrt(9.81 * k) * seconds;
        float s = sin(phase);
        float c = cos(phase);
        // With q k a summed over the waves at most 1, no wave turns over.
        float q = steepness / (4 * max(k * a, 1e-4));
        moved += float3(q * a * d * c, a * s);
        alongX += k * a * d.x * float3(-q * d * s, c);
        alongY += k * a * d.y * float3(-q * d * s, c);
        total += a;
        share = share * 0.5;
    }
    normal = normalize(cross(alongX, alongY));
    tangent = normalize(alongX);
    crest = (moved.z - position.z) / max(total, 1e-4);
    return moved;
}

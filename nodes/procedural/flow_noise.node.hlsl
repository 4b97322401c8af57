// Noise that is made from gradient noise: a flow that never gathers, and noise that bends itself.

// SignedGradientNoise and its slope: x the value, yz its change along x and y, per cell.
float3 GradientNoiseSlope(float2 position) {
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float2 d = position - corner;
    float2 t = LatticeFade(d);
    float2 change = 30 * d * d * (1 - d) * (1 - d);
    // A lattice point's height at d is its slope times the way to it: xy its slope, z that height.
    float2 slopeA = RandomAt(cell) * 2 - 1;
    float2 slopeB = RandomAt(cell + int2(1, 0)) * 2 - 1;
    float2 slopeC = RandomAt(cell + int2(0, 1)) * 2 - 1;
    float2 slopeD = RandomAt(cell + int2(1, 1)) * 2 - 1;
    float a = dot(slopeA, d);
    float b = dot(slopeB, d - float2(1, 0));
    float c = dot(slopeC, d - float2(0, 1));
    float e = dot(slopeD, d - 1);
    float upper = lerp(a, b, t.x);
    float lower = lerp(c, e, t.x);
    float2 slope = lerp(lerp(slopeA, slopeB, t.x), lerp(slopeC, slopeD, t.x), t.y);
    slope += change * float2(lerp(b - a, e - c, t.y), lower - upper);
    return float3(lerp(upper, lower, t.y), slope);
}

/// The velocity of a flow without sources or sinks: swirls as of smoke or water, which neither gather nor spread.
///
/// The flow runs along the lines of equal height of gradient noise, and is the faster the steeper it is.
///
/// formula: (dn/dv, -dn/du), n: gradient noise from -1 to 1, derivatives per cell
/// source: Bridson et al., "Curl-Noise for Procedural Fluid Flow", SIGGRAPH 2007
/// test: CurlNoise(float2(0.3, 0.45), 4) == float2(-1.2972534367217126, 0.8224859604000211)
/// test: CurlNoise(float2(-1.25, 2.75), 1) == float2(-1.4324815910793374, -0.9575419542051654)
/// test: CurlNoise(float2(0.3, 0.45), 4).height == 0.02649439725795888 within 1e-4
[node("Procedural/Noise/Curl Noise")] [also("CurlNoise2D")]
float2 CurlNoise(
    float2 uv = uv0,                  ///< texture coordinates
    [range(0, 100)] float scale = 4,  ///< lattice cells in one unit of uv
    out float height                  ///< the noise whose lines of equal height the flow follows, from -1 to 1
) {
    float3 noise = GradientNoiseSlope(uv * scale);
    height = noise.x;
    return float2(noise.z, -noise.y);
}

/// Fractal noise that fractal noise has moved: marble, lava, wood grain and clouds in wind; from 0 to 1, around 0.5.
///
/// formula: f(p + strength q), q = 2 (f(p), f(p + (5.2, 1.3))) - 1, f: FractalNoise
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985 (marble); Quilez, "Domain warping", 2002 (the form, and the offset,
/// source: which only keeps the two parts of q apart)
/// test: WarpedNoise(float2(0.3, 0.45), 3, 1, 2) == 0.5060077477601247
/// test: WarpedNoise(float2(-0.7, 0.2), 2, 2.5, 3) == 0.3963949144132639
/// test: WarpedNoise(float2(0.3, 0.45), 3, 1, 2).moved == float2(0.3332952473949917, -0.1372331342130343)
[node("Procedural/Noise/Warped Noise")] [also("DomainWarp", "DomainWarpedNoise", "WarpNoise")]
float WarpedNoise(
    float2 uv = uv0,                      ///< texture coordinates
    [range(0, 100)] float scale = 3,      ///< lattice cells of the coarsest octave in one unit of uv
    [range(0, 4)] float strength = 1,     ///< how far the noise is moved, in cells
    [range(1, 12)] const int octaves = 4,  ///< layers of each of the three noises
    out float2 moved                      ///< where to and how far, as a share of strength: colours follow it well
) {
    float2 position = uv * scale;
    float along = FractalNoise(position, 1, octaves) * 2 - 1;
    moved = float2(along, FractalNoise(position + float2(5.2, 1.3), 1, octaves) * 2 - 1);
    return FractalNoise(position + strength * moved, 1, octaves);
}

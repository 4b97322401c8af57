// The noise of Unity's Shader Graph, with its two families of hashes: a picture made of these nodes is the picture that Unity
// makes, if uv counts from the lower left as there: (u, 1 - v). Patina's own noise (noise.node.hlsl, patterns.node.hlsl) has
// a better hash and no visible repetition.

/// Which random numbers the noise uses.
enum NoiseHash {
    Deterministic,  ///< whole numbers: the same on every machine; Unity's choice since Shader Graph 13
    Legacy          ///< the hash of older files: a sine, or remainders of 289 for gradient noise
};

// Two rounds of whole-number arithmetic on a lattice point; both words of the result are random.
uint2 UnityHashBits(float2 cell) {
    uint2 v = uint2(int2(round(cell)));
    v.y = v.y ^ 1103515245u;
    v.x += v.y;
    v.x *= v.y;
    v.x = v.x ^ (v.x >> 5u);
    v.x *= 668265261u;  // 0x27d4eb2d
    v.y = v.y ^ (v.x << 3u);
    return v;
}

// The upper 24 bits as a fraction from 0 to 1, both included. They are converted in two parts, because a half ends at 65504.
float2 UnityFractionOf(uint2 bits) {
    return (float2(bits >> 20u) * 4096 + float2((bits >> 8u) & 4095u)) / 16777215;
}

// A number from 0 to 1 for a lattice point.
[inFloat]
float UnityHash(float2 cell, const NoiseHash hash) {
    if (hash == Legacy) { return frac(sin(dot(cell, float2(12.9898, 78.233))) * 43758.5453); }
    return UnityFractionOf(UnityHashBits(cell)).x;
}

// Two numbers from 0 to 1 for a lattice point.
[inFloat]
float2 UnityHash2(float2 cell, const NoiseHash hash) {
    if (hash == Legacy) {
        float2 angles = float2(dot(cell, float2(15.27, 99.41)), dot(cell, float2(47.63, 89.98)));
        return frac(sin(angles) * 46839.32);
    }
    return UnityFractionOf(UnityHashBits(cell));
}

// The remainders of 289 make a permutation of lattice points: the polynomial 34 x^2 + x, applied twice; then the last
// number modulo 41 is spread over -1 to 1.
[inFloat]
float UnityPermutation(float2 cell) {
    float2 p = fmod(cell, 289);
    float x = fmod((34 * p.x + 1) * p.x, 289) + p.y;
    x = fmod((34 * x + 1) * x, 289);
    return frac(x / 41) * 2 - 1;
}

// The height at a point of the slope of one lattice point. A number becomes a direction on the edge of a diamond.
[inFloat]
float UnitySlope(float2 cell, float2 fromCell, const NoiseHash hash) {
    float x = hash == Legacy ? UnityPermutation(cell) : UnityHash(cell, Deterministic);
    return dot(normalize(float2(x - floor(x + 0.5), abs(x) - 0.5)), fromCell);
}

/// Unity's gradient noise: unit slopes at the points of a lattice, interpolated smoothly; around 0.5.
///
/// formula: Perlin's noise with slopes of length 1, + 0.5; the curve is 6 t^5 - 15 t^4 + 10 t^3
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; the hash Legacy: McEwan et al., "Efficient Computational Noise in
/// source: GLSL", 2012; the hash Deterministic: Unity Shader Graph 13
/// test: GradientNoiseUnity(float2(0.3, 0.7), 10) == 0.5 within 1e-4
/// test: GradientNoiseUnity(float2(-0.25, 0.45), 10) == 0.6123651785758847
/// test: GradientNoiseUnity(float2(-0.25, 0.45), 10, Legacy) == 0.1506391399580832
/// test: GradientNoiseUnity(float2(3.25, 200.5), 2, Legacy) == 0.060872336455679854
[node("Procedural/Noise/Gradient Noise (Unity)")] [inFloat]
float GradientNoiseUnity(
    float2 uv = uv0,                          ///< texture coordinates; Unity's are (u, 1 - v)
    [range(0, 100)] float scale = 10,         ///< lattice cells in one unit of uv
    const NoiseHash hash = Deterministic      ///< which random numbers; `Legacy` is Unity's "Legacy Mod"
) {
    float2 position = uv * scale;
    float2 cell = floor(position);
    float2 d = position - cell;
    float2 t = LatticeFade(d);
    float left = lerp(UnitySlope(cell, d, hash), UnitySlope(cell + float2(0, 1), d - float2(0, 1), hash), t.y);
    float right = lerp(UnitySlope(cell + float2(1, 0), d - float2(1, 0), hash), UnitySlope(cell + 1, d - 1, hash), t.y);
    return lerp(left, right, t.x) + 0.5;
}

// Random values at the points of a lattice, interpolated with 3 t^2 - 2 t^3.
[inFloat]
float UnityValueNoise(float2 position, const NoiseHash hash) {
    float2 cell = floor(position);
    float2 d = position - cell;
    float2 t = d * d * (3 - 2 * d);
    float first = lerp(UnityHash(cell, hash), UnityHash(cell + float2(1, 0), hash), t.x);
    float second = lerp(UnityHash(cell + float2(0, 1), hash), UnityHash(cell + 1, hash), t.x);
    return lerp(first, second, t.y);
}

/// Unity's simple noise: three layers of value noise, the finest with the least weight; from 0 to 0.875.
///
/// formula: v(p) / 8 + v(p / 2) / 4 + v(p / 4) / 2, p = scale uv, v: value noise with the curve 3 t^2 - 2 t^3
/// source: Unity Shader Graph, node Simple Noise
/// test: SimpleNoise(float2(0.3, 0.7), 10) == 0.5185675765686435
/// test: SimpleNoise(float2(-0.31, 0.12), 40) == 0.33349510019678474
/// test: SimpleNoise(float2(0, 0), 5, Legacy) == 0
[node("Procedural/Noise/Simple Noise")] [inFloat]
float SimpleNoise(
    float2 uv = uv0,                       ///< texture coordinates; Unity's are (u, 1 - v)
    [range(0, 1000)] float scale = 500,    ///< lattice cells of the finest layer in one unit of uv
    const NoiseHash hash = Deterministic   ///< which random numbers; `Legacy` is Unity's "Legacy Sine"
) {
    float2 position = uv * scale;
    return UnityValueNoise(position, hash) * 0.125 + UnityValueNoise(position / 2, hash) * 0.25 +
           UnityValueNoise(position / 4, hash) * 0.5;
}

/// Unity's Voronoi noise: the distance to the nearest of random points, one in each cell, which an angle moves.
///
/// formula: min |c + (sin(a h.y), cos(a h.x)) / 2 + 1/2 - p| over the nine cells c around p; h: two random numbers of c
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; Unity Shader Graph, node Voronoi
/// test: VoronoiUnity(float2(0.3, 0.7), 2, 5) == 0.39070543813644
/// test: VoronoiUnity(float2(0.3, 0.7), 2, 5).cells == 0.7209220116650702
/// test: VoronoiUnity(float2(-0.33, 0.12), 5, 8) == 0.6332615787089066
/// test: VoronoiUnity(float2(0.25, 0.5), 0, 2, Legacy) == 0
/// test: VoronoiUnity(float2(0.25, 0.25), 0, 1, Legacy).cells == 0.5
[node("Procedural/Noise/Voronoi (Unity)")] [inFloat]
float VoronoiUnity(
    float2 uv = uv0,                        ///< texture coordinates; Unity's are (u, 1 - v)
    float angleOffset = 2,                  ///< moves the points: each on a path of its own; 0 makes a grid
    [range(0, 100)] [also("cellDensity")] float scale = 5,  ///< cells in one unit of uv
    const NoiseHash hash = Deterministic,   ///< which random numbers; `Legacy` is Unity's "Legacy Sine"
    out float cells                         ///< a number for each point, from 0 to 1: how far right in its cell it is
) {
    float2 position = uv * scale;
    float2 cell = floor(position);
    float2 d = position - cell;
    float nearest = 8;
    for (int j = -1; j < 2; j++) {
        for (int i = -1; i < 2; i++) {
            float2 stepTo = float2(i, j);
            float2 random = UnityHash2(cell + stepTo, hash);
            float2 inCell = float2(sin(random.y * angleOffset), cos(random.x * angleOffset)) * 0.5 + 0.5;
            float away = length(stepTo + inCell - d);
            if (away < nearest) {
                nearest = away;
                cells = inCell.x;
            }
        }
    }
    return nearest;
}

// Noise without textures. All functions use one integer hash, so every machine renders the same picture: the hash uses
// unsigned integers, which wrap in the same way everywhere, and its result is a fraction that a float holds exactly.
// Coordinates must fit into an int: about two thousand million cells.

/// Two independent random numbers for a cell of the integer lattice, 0 or more and less than 1.
///
/// formula: pcg2d: two rounds of v.x += v.y m, v.y += v.x m, v ^= v >> 16 on m v + c, m = 1664525, c = 1013904223
/// source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020
float2 RandomAt(int2 cell) {
    const uint multiplier = 1664525u;
    uint2 v = uint2(cell) * multiplier + 1013904223u;
    v.x += v.y * multiplier;
    v.y += v.x * multiplier;
    v = v ^ (v >> 16u);
    v.x += v.y * multiplier;
    v.y += v.x * multiplier;
    v = v ^ (v >> 16u);
    // A float holds the upper 24 bits. They are converted in two parts, because a half ends at 65504.
    return float2(v >> 21u) / 2048 + float2((v >> 8u) & 8191u) / 8192 / 2048;
}

/// The interpolation curve between lattice points; its slope and curvature are zero at both ends.
///
/// formula: t^3 (6 t^2 - 15 t + 10)
/// source: Perlin, "Improving Noise", SIGGRAPH 2002
floatN LatticeFade(floatN t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/// A random number for each cell: constant within the cell, unrelated to its neighbours.
///
/// source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020
/// test: Random(float2(0, 0)) == 0.097231924533844
/// test: Random(float2(3.5, 7.25)) == 0.2815369963645935
/// test: Random(float2(-0.5, -1.5)) == 0.7766901254653931
[node("Procedural/Noise/Random")] [also("WhiteNoise", "Random2D")]
float Random(
    float2 position = uv0,  ///< anywhere in the cell; cells are one unit wide and begin at whole numbers
    out float second        ///< another random number of the same cell
) {
    float2 random = RandomAt(int2(floor(position)));
    second = random.y;
    return random.x;
}

/// Soft blotches: random values at the points of a lattice, interpolated smoothly.
///
/// At a lattice point, the result is the value of Random there; half-way between four points, it is their mean.
///
/// source: Perlin, "Improving Noise", SIGGRAPH 2002 (the curve); Jarzynski and Olano, JCGT 9(3), 2020 (the values)
/// test: ValueNoise(float2(0.5, 0.25), 8) == 0.27105700969696045
/// test: ValueNoise(float2(3.5, 7.5), 1) == 0.550646960735321
/// test: ValueNoise(float2(-1.25, 2.75), 1) == 0.7191152535576748
[node("Procedural/Noise/Value Noise")]
float ValueNoise(
    float2 uv = uv0,                 ///< texture coordinates
    [range(0, 100)] float scale = 8  ///< lattice cells in one unit of uv
) {
    float2 position = uv * scale;
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float2 t = LatticeFade(position - corner);
    float upper = lerp(RandomAt(cell).x, RandomAt(cell + int2(1, 0)).x, t.x);
    float lower = lerp(RandomAt(cell + int2(0, 1)).x, RandomAt(cell + int2(1, 1)).x, t.x);
    return lerp(upper, lower, t.y);
}

/// The height at a point of the slope of one lattice point; slopes are random in the square from -1 to 1.
float SlopeAt(int2 cell, float2 fromCorner) {
    return dot(RandomAt(cell) * 2 - 1, fromCorner);
}

/// Gradient noise between -1 and 1; GradientNoise and FractalNoise use it.
float SignedGradientNoise(float2 position) {
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float2 d = position - corner;
    float2 t = LatticeFade(d);
    float upper = lerp(SlopeAt(cell, d), SlopeAt(cell + int2(1, 0), d - float2(1, 0)), t.x);
    float lower = lerp(SlopeAt(cell + int2(0, 1), d - float2(0, 1)), SlopeAt(cell + int2(1, 1), d - 1), t.x);
    return lerp(upper, lower, t.y);
}

/// Soft waves: random slopes at the points of a lattice, interpolated smoothly; from 0 to 1, around 0.5.
///
/// Its grid is less visible than that of ValueNoise. At every lattice point, the result is 0.5.
///
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985, with the curve of "Improving Noise", SIGGRAPH 2002
/// test: GradientNoise(float2(0.375, 0.625), 8) == 0.5
/// test: GradientNoise(float2(3.5, 7.5), 1) == 0.3744928613305092
/// test: GradientNoise(float2(-1.25, 2.75), 1) == 0.500304522816009
[node("Procedural/Noise/Gradient Noise")] [also("PerlinNoise", "Perlin", "GradientNoise2D")]
float GradientNoise(
    float2 uv = uv0,                 ///< texture coordinates
    [range(0, 100)] float scale = 8  ///< lattice cells in one unit of uv
) {
    return SignedGradientNoise(uv * scale) * 0.5 + 0.5;
}

/// How layers of noise are added.
enum FractalKind {
    Smooth,      ///< the noise itself: clouds and hills
    Turbulence,  ///< its absolute value: round lumps between sharp creases, also called billow
    Ridged       ///< sharp ridges; each layer counts most near the ridges of the previous one
};

// The height that one layer adds. Ridges also read the height of the previous layer, `before`.
float FractalLayer(float noise, float before, const FractalKind kind) {
    float ridge = saturate(1 - abs(noise));
    return kind == Smooth ? noise : kind == Turbulence ? abs(noise) : ridge * ridge * saturate(2 * before);
}

/// Layers of ever finer gradient noise, as in clouds, rust and mountains; from 0 to 1.
///
/// formula: sum of gain^i f(noise(lacunarity^i p)) / sum of gain^i; Smooth: n, and the result from -1 to 1 is brought to 0 to 1;
/// formula: Turbulence: |n|; Ridged: (1 - |n|)^2 times twice the previous layer, at most 1
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985 (turbulence); Musgrave, in Ebert et al., "Texturing and Modeling: A
/// source: Procedural Approach", 2003, chapter 16 (fBm, ridged multifractal)
/// test: FractalNoise(float2(0.375, 0.625), 8, 5) == 0.5
/// test: FractalNoise(float2(3.5, 7.5), 1, 1) == 0.3744928613305092
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2, 0.5) == 0.4788152412317103
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2.5, 0.6, Turbulence) == 0.04778121198678931
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2.5, 0.6, Ridged) == 0.9100546007602622
[node("Procedural/Noise/Fractal Noise")] [also("Fbm", "FractalNoise2D")]
float FractalNoise(
    float2 uv = uv0,                       ///< texture coordinates
    [range(0, 100)] float scale = 4,       ///< lattice cells of the coarsest octave in one unit of uv
    [range(1, 12)] const int octaves = 4,  ///< how many layers of noise; each costs as much as the first
    [range(1, 4)] float lacunarity = 2,    ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5,        ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth        ///< how the layers are added
) {
    float2 position = uv * scale;
    float height = 0;
    float total = 0;
    float amplitude = 1;
    float layer = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        layer = FractalLayer(SignedGradientNoise(position), layer, kind);
        height += layer * amplitude;
        total += amplitude;
        amplitude *= gain;
        // The offset keeps the layers' lattices from meeting at the origin.
        position = position * lacunarity + float2(37, 17);
    }
    return kind == Smooth ? height / total * 0.5 + 0.5 : height / total;
}

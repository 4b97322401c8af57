// Noise without textures, in the plane. All functions use one hash of whole numbers (lookup3.node.hlsl), which wrap in the same way
// everywhere, so every machine renders the same picture, and MaterialX's documents can hold it. Coordinates must fit into an
// int: about two thousand million cells.

/// Two independent random numbers for a cell of the lattice, from 0 to 1: those of MaterialX's cell noise.
///
/// source: Jenkins, "lookup3.c", 2006
[inFloat]
float2 RandomAt(int2 cell) {
    return float2(RandomOf(int3(cell, 0)), RandomOf(int3(cell, 1)));
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
/// source: Jenkins, "lookup3.c", 2006
/// test: Random(float2(0, 0)) == 0.6110676516804536
/// test: Random(float2(3.5, 7.25)) == 0.19924021842871797
/// test: Random(float2(-0.5, -1.5)) == 0.5698580014449214
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
/// source: Perlin, "Improving Noise", SIGGRAPH 2002 (the curve); Jenkins, "lookup3.c", 2006 (the values)
/// test: ValueNoise(float2(0.5, 0.25), 8) == 0.7106531811204397
/// test: ValueNoise(float2(3.5, 7.5), 1) == 0.4087437744971234
/// test: ValueNoise(float2(-1.25, 2.75), 1) == 0.3591350480563387
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

/// Soft waves: random slopes at the points of a lattice, interpolated smoothly; from 0 to 1, around 0.5.
///
/// Its grid is less visible than that of ValueNoise. At every lattice point, the result is 0.5.
///
/// formula: 0.5 + 0.5 PerlinNoise2D(scale uv)
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985, with the curve of "Improving Noise", SIGGRAPH 2002
/// test: GradientNoise(float2(0.375, 0.625), 8) == 0.5
/// test: GradientNoise(float2(3.5, 7.5), 1) == 0.5
/// test: GradientNoise(float2(-1.25, 2.75), 1) == 0.2465829765319824
[node("Procedural/Noise/Gradient Noise")] [also("GradientNoise2D")]
float GradientNoise(
    float2 uv = uv0,                 ///< texture coordinates
    [range(0, 100)] float scale = 8  ///< lattice cells in one unit of uv
) {
    return PerlinNoise2D(uv * scale) * 0.5 + 0.5;
}

/// How layers of noise are added.
enum FractalKind {
    Smooth,      ///< the noise itself: clouds and hills
    Turbulence,  ///< its absolute value: round lumps between sharp creases, also called billow
    Ridged       ///< sharp ridges; each layer counts most near the ridges of the previous one
};

// What one layer adds. `before` is what the previous layer gave, for ridges.
float FractalLayer(float noise, float before, const FractalKind kind) {
    float ridge = saturate(1 - abs(noise));
    return kind == Smooth ? noise : kind == Turbulence ? abs(noise) : ridge * ridge * saturate(2 * before);
}

// The sum of the layers' heights.
float FractalTotal(const int octaves, float gain) {
    float total = 0;
    float amplitude = 1;
    [unroll] for (int i = 0; i < min(octaves, 12); i++) {
        total += amplitude;
        amplitude *= gain;
    }
    return total;
}

/// Layers of ever finer gradient noise, as in clouds, rust and mountains; from 0 to 1.
///
/// formula: sum of gain^i f(noise(lacunarity^i p)) / sum of gain^i; Smooth: n, and the result from -1 to 1 is brought to 0 to 1;
/// formula: Turbulence: |n|; Ridged: (1 - |n|)^2 times twice the previous layer, at most 1
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985 (turbulence); Musgrave, in Ebert et al., "Texturing and Modeling: A
/// source: Procedural Approach", 2003, chapter 16 (fBm, ridged multifractal)
/// test: FractalNoise(float2(0.375, 0.625), 8, 5) == 0.5
/// test: FractalNoise(float2(3.5, 7.5), 1, 1) == 0.5
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2, 0.5) == 0.5866516281917443
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2.5, 0.6, Turbulence) == 0.13767561487660182
/// test: FractalNoise(float2(0.3, 0.45), 2, 3, 2.5, 0.6, Ridged) == 0.7663721262556298
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
    float total = FractalTotal(octaves, gain);
    if (kind == Smooth) { return PerlinFractal2D(position, min(octaves, 12), lacunarity, gain) / total * 0.5 + 0.5; }
    float sum = 0;
    float amplitude = 1;
    float before = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        before = FractalLayer(PerlinNoise2D(position), before, kind);
        sum += amplitude * before;
        amplitude *= gain;
        position *= lacunarity;
    }
    return sum / total;
}

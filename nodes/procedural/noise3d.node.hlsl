// Noise in space, and noise in space that changes with time: the forms of noise.node.hlsl, from 0 to 1 and with a scale. It needs
// no texture coordinates, so it has no seams and no poles. The random numbers are those of MaterialX (lookup3.node.hlsl), and a
// MaterialX document can hold these nodes.

// The numbers of the eight corners of a cell, interpolated. `low` and `high` are two opposite corners.
[inFloat]
float ValueCell3(int3 low, int3 high, float3 t) {
    float a = lerp(RandomOf(int3(low.x, low.y, low.z)), RandomOf(int3(high.x, low.y, low.z)), t.x);
    float b = lerp(RandomOf(int3(low.x, high.y, low.z)), RandomOf(int3(high.x, high.y, low.z)), t.x);
    float c = lerp(RandomOf(int3(low.x, low.y, high.z)), RandomOf(int3(high.x, low.y, high.z)), t.x);
    float d = lerp(RandomOf(int3(low.x, high.y, high.z)), RandomOf(int3(high.x, high.y, high.z)), t.x);
    return lerp(lerp(a, b, t.y), lerp(c, d, t.y), t.z);
}

/// Soft blotches in space: random values at the points of a lattice, interpolated smoothly.
///
/// At a lattice point, the result is the value of CellNoise3D there.
///
/// source: Perlin, "Improving Noise", SIGGRAPH 2002 (the curve); Jenkins, "lookup3.c", 2006 (the values)
/// test: ValueNoise3D(float3(3, -2, 5), 1) == 0.525200029026065
/// test: ValueNoise3D(float3(0.3, 0.45, 0.7), 4) == 0.6718229540186985
[node("Procedural/Noise/Value Noise 3D")] [range(0, 1)] [inFloat]
float ValueNoise3D(
    float3 position = positionOS,    ///< where
    [range(0, 100)] float scale = 4  ///< lattice cells in one unit
) {
    float3 place = position * scale;
    float3 corner = floor(place);
    int3 cell = int3(corner);
    return ValueCell3(cell, cell + 1, LatticeFade(place - corner));
}

/// Soft blotches in space that change with time.
///
/// source: Perlin, "Improving Noise", SIGGRAPH 2002 (the curve); Jenkins, "lookup3.c", 2006 (the values)
/// test: ValueNoise4D(float4(3, -2, 5, 1), 1) == 0.06148277038277191
/// test: ValueNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4) == 0.7292707402029673
[node("Procedural/Noise/Value Noise 4D")] [range(0, 1)] [inFloat]
float ValueNoise4D(
    float4 position,                 ///< a place, and the time as the fourth number
    [range(0, 100)] float scale = 4  ///< lattice cells in one unit
) {
    float4 place = position * scale;
    float4 corner = floor(place);
    int4 cell = int4(corner);
    float4 t = LatticeFade(place - corner);
    float value = 0;
    [unroll] for (int i = 0; i < 16; i++) {
        int4 step = int4(i & 1, (i >> 1) & 1, (i >> 2) & 1, i >> 3);
        int4 at = cell + step;
        float4 share = lerp(1 - t, t, float4(step));
        value += share.x * share.y * share.z * share.w * FractionOf(HashOf4(at.x, at.y, at.z, at.w));
    }
    return value;
}

/// Soft waves in space, from 0 to 1, around 0.5: PerlinNoise3D with a scale.
///
/// formula: 0.5 + 0.5 PerlinNoise3D(scale p)
/// source: Perlin, "Improving Noise", SIGGRAPH 2002
/// test: GradientNoise3D(float3(3, -2, 5), 1) == 0.5
/// test: GradientNoise3D(float3(0.3, 0.45, 0.7), 4) == 0.4767046406847598
[node("Procedural/Noise/Gradient Noise 3D")]
float GradientNoise3D(
    float3 position = positionOS,    ///< where
    [range(0, 100)] float scale = 4  ///< lattice cells in one unit
) {
    return PerlinNoise3D(position * scale) * 0.5 + 0.5;
}

/// Soft waves in space that change with time, from 0 to 1, around 0.5: PerlinNoise4D with a scale.
///
/// formula: 0.5 + 0.5 PerlinNoise4D(scale p)
/// source: Perlin, "Improving Noise", SIGGRAPH 2002
/// test: GradientNoise4D(float4(3, -2, 5, 1), 1) == 0.5
/// test: GradientNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4) == 0.6173248670457305
[node("Procedural/Noise/Gradient Noise 4D")]
float GradientNoise4D(
    float4 position,                 ///< a place, and the time as the fourth number
    [range(0, 100)] float scale = 4  ///< lattice cells in one unit
) {
    return PerlinNoise4D(position * scale) * 0.5 + 0.5;
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

/// Layers of ever finer gradient noise in space: clouds, rust, marble and mountains, from 0 to 1.
///
/// formula: sum of gain^i f(noise(lacunarity^i p)) / sum of gain^i; Smooth: n, and the result from -1 to 1 is brought to 0 to 1;
/// formula: Turbulence: |n|; Ridged: (1 - |n|)^2 times twice the previous layer, at most 1
/// source: Perlin, "An Image Synthesizer", SIGGRAPH 1985 (turbulence); Musgrave, in Ebert et al., "Texturing and Modeling: A
/// source: Procedural Approach", 2003, chapter 16 (fBm, ridged multifractal)
/// test: FractalNoise3D(float3(1, -2, 3), 1) == 0.5
/// test: FractalNoise3D(float3(0.3, 0.45, 0.7), 4, 3) == 0.5118343781555637
/// test: FractalNoise3D(float3(0.3, 0.45, 0.7), 4, 3, 2, 0.5, Turbulence) == 0.08317063539443025
/// test: FractalNoise3D(float3(0.3, 0.45, 0.7), 4, 3, 2.5, 0.6, Ridged) == 0.6791361320768433
[node("Procedural/Noise/Fractal Noise 3D")] [also("Fbm3D", "Turbulence", "Billow", "RidgedNoise", "Ridged")]
float FractalNoise3D(
    float3 position = positionOS,          ///< where
    [range(0, 100)] float scale = 4,       ///< lattice cells of the coarsest octave in one unit
    [range(1, 12)] const int octaves = 4,  ///< how many layers of noise; each costs as much as the first
    [range(1, 4)] float lacunarity = 2,    ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5,        ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth        ///< how the layers are added
) {
    float3 place = position * scale;
    float total = FractalTotal(octaves, gain);
    if (kind == Smooth) { return PerlinFractal3D(place, min(octaves, 12), lacunarity, gain) / total * 0.5 + 0.5; }
    float sum = 0;
    float amplitude = 1;
    float before = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        before = FractalLayer(PerlinNoise3D(place), before, kind);
        sum += amplitude * before;
        amplitude *= gain;
        place *= lacunarity;
    }
    return sum / total;
}

/// Layers of ever finer gradient noise in space that change with time, from 0 to 1.
///
/// formula: as FractalNoise3D, of PerlinNoise4D
/// source: as FractalNoise3D
/// test: FractalNoise4D(float4(1, -2, 3, 4), 1) == 0.5
/// test: FractalNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4, 3) == 0.5077565911187931
/// test: FractalNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4, 3, 2, 0.5, Turbulence) == 0.2526579424383695
/// test: FractalNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4, 3, 2, 0.5, Ridged) == 0.5401582707947734
[node("Procedural/Noise/Fractal Noise 4D")] [also("Fractal4D", "Fbm4D")]
float FractalNoise4D(
    float4 position,                       ///< a place, and the time as the fourth number
    [range(0, 100)] float scale = 4,       ///< lattice cells of the coarsest octave in one unit
    [range(1, 12)] const int octaves = 4,  ///< how many layers of noise; each costs as much as the first
    [range(1, 4)] float lacunarity = 2,    ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5,        ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth        ///< how the layers are added
) {
    float4 place = position * scale;
    float total = FractalTotal(octaves, gain);
    float sum = 0;
    float amplitude = 1;
    float before = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        before = FractalLayer(PerlinNoise4D(place), before, kind);
        sum += amplitude * before;
        amplitude *= gain;
        place *= lacunarity;
    }
    return kind == Smooth ? sum / total * 0.5 + 0.5 : sum / total;
}

// --- without a seam

// The cell of one period, for any cell.
int3 WrappedCell3(float3 cell, float3 period) {
    return int3(cell - period * floor((cell + 0.5) / period));
}

/// ValueNoise3D without a seam: it repeats with each unit of each direction.
///
/// source: as ValueNoise3D, on a lattice whose cells are counted modulo `scale`
/// test: ValueNoise3DTiled(float3(0.9, 0.3, 0.55), float3(4, 3, 5)) == 0.38734340577254595
/// test: ValueNoise3DTiled(float3(-0.1, 1.3, 2.55), float3(4, 3, 5)) == 0.3873434057725458
[node("Procedural/Noise/Value Noise 3D (Tiled)")] [range(0, 1)] [inFloat]
float ValueNoise3DTiled(
    float3 position = positionOS,     ///< where
    [range(1, 100)] float3 scale = 4  ///< lattice cells in one unit of each direction: whole numbers
) {
    float3 period = max(round(scale), 1);
    float3 place = position * period;
    float3 corner = floor(place);
    return ValueCell3(WrappedCell3(corner, period), WrappedCell3(corner + 1, period), LatticeFade(place - corner));
}

// PerlinNoise3D with a period.
[inFloat]
float PerlinNoise3DTiled(float3 place, float3 period) {
    float3 corner = floor(place);
    return 0.982 * PerlinCell3(WrappedCell3(corner, period), WrappedCell3(corner + 1, period), place - corner, 0u);
}

/// GradientNoise3D without a seam: it repeats with each unit of each direction.
///
/// source: as GradientNoise3D, on a lattice whose cells are counted modulo `scale`
/// test: GradientNoise3DTiled(float3(0.9, 0.3, 0.55), float3(4, 3, 5)) == 0.5532999807703471
/// test: GradientNoise3DTiled(float3(-0.1, 1.3, 2.55), float3(4, 3, 5)) == 0.5532999807703474
[node("Procedural/Noise/Gradient Noise 3D (Tiled)")]
float GradientNoise3DTiled(
    float3 position = positionOS,     ///< where
    [range(1, 100)] float3 scale = 4  ///< lattice cells in one unit of each direction: whole numbers
) {
    float3 period = max(round(scale), 1);
    return PerlinNoise3DTiled(position * period, period) * 0.5 + 0.5;
}

/// FractalNoise3D without a seam: it repeats with each unit of each direction. Each layer is twice as fine as the previous one.
///
/// source: as FractalNoise3D, on lattices whose cells are counted modulo their number
/// test: FractalNoise3DTiled(float3(0.9, 0.3, 0.55), float3(4, 3, 5), 3) == 0.49384645306575264
/// test: FractalNoise3DTiled(float3(-0.1, 1.3, 2.55), float3(4, 3, 5), 3) == 0.4938464530657528
/// test: FractalNoise3DTiled(float3(0.9, 0.3, 0.55), float3(4, 3, 5), 3, 0.5, Turbulence) == 0.13778803968707093
/// test: FractalNoise3DTiled(float3(0.9, 0.3, 0.55), float3(4, 3, 5), 3, 0.5, Ridged) == 0.7506532045545626
[node("Procedural/Noise/Fractal Noise 3D (Tiled)")]
float FractalNoise3DTiled(
    float3 position = positionOS,          ///< where
    [range(1, 100)] float3 scale = 4,      ///< lattice cells of the coarsest layer in one unit of each direction: whole numbers
    [range(1, 12)] const int octaves = 4,  ///< how many layers of noise
    [range(0, 1)] float gain = 0.5,        ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth        ///< how the layers are added
) {
    float3 period = max(round(scale), 1);
    float total = FractalTotal(octaves, gain);
    float sum = 0;
    float amplitude = 1;
    float before = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        before = FractalLayer(PerlinNoise3DTiled(position * period, period), before, kind);
        sum += amplitude * before;
        amplitude *= gain;
        period *= 2;
    }
    return kind == Smooth ? sum / total * 0.5 + 0.5 : sum / total;
}

// Noise that repeats: its right edge continues its left one, and its bottom its top, so that one unit of uv is a tile without a
// seam. The lattice has a whole number of cells, and the last one has the first as its neighbour.

// The cell of one period, for any cell.
int2 WrappedCell(float2 cell, float2 period) {
    return int2(cell - period * floor((cell + 0.5) / period));
}

// At least one cell, and whole ones.
float2 WholeCells(float2 cells) {
    return max(round(cells), 1);
}

// PerlinNoise2D with a period.
[inFloat]
float PerlinNoise2DTiled(float2 position, float2 period) {
    float2 corner = floor(position);
    return 0.6616 * PerlinCell2(WrappedCell(corner, period), WrappedCell(corner + 1, period), position - corner, 0u);
}

/// ValueNoise without a seam: it repeats with each unit of uv.
///
/// source: as ValueNoise, on a lattice whose cells are counted modulo `scale`
/// test: ValueNoiseTiled(float2(0.9, 0.3), float2(4, 3)) == 0.6006736198414473
/// test: ValueNoiseTiled(float2(-0.1, 1.3), float2(4, 3)) == 0.600673619841447
/// test: ValueNoiseTiled(float2(0.125, 0.5), 4) == ValueNoise(float2(0.5, 2), 1)
[node("Procedural/Noise/Value Noise (Tiled)")]
float ValueNoiseTiled(
    float2 uv = uv0,                  ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 8  ///< lattice cells in one unit of u and v: whole numbers
) {
    float2 period = WholeCells(scale);
    float2 position = uv * period;
    float2 corner = floor(position);
    float2 t = LatticeFade(position - corner);
    float a = RandomAt(WrappedCell(corner, period)).x;
    float b = RandomAt(WrappedCell(corner + float2(1, 0), period)).x;
    float c = RandomAt(WrappedCell(corner + float2(0, 1), period)).x;
    float d = RandomAt(WrappedCell(corner + 1, period)).x;
    return lerp(lerp(a, b, t.x), lerp(c, d, t.x), t.y);
}

/// GradientNoise without a seam: it repeats with each unit of uv.
///
/// source: as GradientNoise, on a lattice whose cells are counted modulo `scale`
/// test: GradientNoiseTiled(float2(0.9, 0.3), float2(4, 3)) == 0.6243237893457927
/// test: GradientNoiseTiled(float2(-1.1, 2.3), float2(4, 3)) == 0.6243237893457916
/// test: GradientNoiseTiled(float2(0.25, 1), float2(4, 3)) == 0.5
[node("Procedural/Noise/Gradient Noise (Tiled)")]
float GradientNoiseTiled(
    float2 uv = uv0,                  ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 8  ///< lattice cells in one unit of u and v: whole numbers
) {
    float2 period = WholeCells(scale);
    return PerlinNoise2DTiled(uv * period, period) * 0.5 + 0.5;
}

/// FractalNoise without a seam: it repeats with each unit of uv. Each layer is twice as fine as the previous one.
///
/// source: as FractalNoise, on lattices whose cells are counted modulo their number
/// test: FractalNoiseTiled(float2(0.93, 0.3), float2(4, 3), 3) == 0.710147816582145
/// test: FractalNoiseTiled(float2(-0.07, 1.3), float2(4, 3), 3) == 0.7101478165821447
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 1) == 0.6243237893457927
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 3, 0.5, Turbulence) == 0.31904633045577213
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 3, 0.5, Ridged) == 0.46805946977121154
[node("Procedural/Noise/Fractal Noise (Tiled)")]
float FractalNoiseTiled(
    float2 uv = uv0,                       ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 4,      ///< lattice cells of the coarsest layer in one unit of u and v: whole numbers
    [range(1, 12)] const int octaves = 4,  ///< how many layers of noise
    [range(0, 1)] float gain = 0.5,        ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth        ///< how the layers are added
) {
    float2 period = WholeCells(scale);
    float total = FractalTotal(octaves, gain);
    float sum = 0;
    float amplitude = 1;
    float before = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        before = FractalLayer(PerlinNoise2DTiled(uv * period, period), before, kind);
        sum += amplitude * before;
        amplitude *= gain;
        period *= 2;
    }
    return kind == Smooth ? sum / total * 0.5 + 0.5 : sum / total;
}

/// Voronoi without a seam: it repeats with each unit of uv.
///
/// source: as Voronoi, on a lattice whose cells are counted modulo `scale`
/// test: VoronoiTiled(float2(0.95, 0.3), float2(4, 3)) == 0.665513697121826
/// test: VoronoiTiled(float2(-0.05, 1.3), float2(4, 3)).random == 0.620079174083676
/// test: VoronoiTiled(float2(0.95, 0.3), float2(4, 3)).toPoint == float2(-0.17992082591632386, -0.6407315954893666)
/// test: VoronoiTiled(float2(0.5, 0.5), 4, 0) == 0.7071067811865476
[node("Procedural/Noise/Voronoi (Tiled)")]
float VoronoiTiled(
    float2 uv = uv0,                   ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 8,  ///< cells in one unit of u and v: whole numbers
    [range(0, 1)] float jitter = 1,    ///< how far the points are from their cell's centre: 0 makes a grid
    out float random,                  ///< a random number for each point, from 0 to 1
    out float2 toPoint                 ///< from here to the nearest point, in cells
) {
    float2 period = WholeCells(scale);
    float2 position = uv * period;
    float2 corner = floor(position);
    float nearest = 8;  // squared; larger than any distance within nine cells
    for (int j = -1; j < 2; j++) {
        for (int i = -1; i < 2; i++) {
            float2 stepTo = float2(i, j);
            float2 hash = RandomAt(WrappedCell(corner + stepTo, period));
            float2 away = stepTo + 0.5 + (hash - 0.5) * jitter - (position - corner);
            float squared = dot(away, away);
            if (squared < nearest) {
                nearest = squared;
                random = hash.x;
                toPoint = away;
            }
        }
    }
    return sqrt(nearest);
}

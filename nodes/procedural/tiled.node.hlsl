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

// SignedGradientNoise with a period.
float SignedGradientNoiseTiled(float2 position, float2 period) {
    float2 corner = floor(position);
    float2 d = position - corner;
    float2 t = LatticeFade(d);
    float a = SlopeAt(WrappedCell(corner, period), d);
    float b = SlopeAt(WrappedCell(corner + float2(1, 0), period), d - float2(1, 0));
    float c = SlopeAt(WrappedCell(corner + float2(0, 1), period), d - float2(0, 1));
    float e = SlopeAt(WrappedCell(corner + 1, period), d - 1);
    return lerp(lerp(a, b, t.x), lerp(c, e, t.x), t.y);
}

/// ValueNoise without a seam: it repeats with each unit of uv.
///
/// source: as ValueNoise, on a lattice whose cells are counted modulo `scale`
/// test: ValueNoiseTiled(float2(0.9, 0.3), float2(4, 3)) == 0.4033442434297225
/// test: ValueNoiseTiled(float2(-0.1, 1.3), float2(4, 3)) == 0.4033442434297225
/// test: ValueNoiseTiled(float2(0.125, 0.5), 4) == ValueNoise(float2(0.5, 2), 1)
[node("Procedural/Noise/Value Noise (Tiled)")]
float ValueNoiseTiled(
    float2 uv = uv0,                                  ///< texture coordinates
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
/// test: GradientNoiseTiled(float2(0.9, 0.3), float2(4, 3)) == 0.3852447896490933
/// test: GradientNoiseTiled(float2(-1.1, 2.3), float2(4, 3)) == 0.3852447896490933
/// test: GradientNoiseTiled(float2(0.25, 1), float2(4, 3)) == 0.5
[node("Procedural/Noise/Gradient Noise (Tiled)")]
float GradientNoiseTiled(
    float2 uv = uv0,                                  ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 8  ///< lattice cells in one unit of u and v: whole numbers
) {
    float2 period = WholeCells(scale);
    return SignedGradientNoiseTiled(uv * period, period) * 0.5 + 0.5;
}

/// FractalNoise without a seam: it repeats with each unit of uv. Each layer is twice as fine as the previous one.
///
/// source: as FractalNoise, on lattices whose cells are counted modulo their number
/// test: FractalNoiseTiled(float2(0.93, 0.3), float2(4, 3), 3) == 0.4230053213121429
/// test: FractalNoiseTiled(float2(-0.07, 1.3), float2(4, 3), 3) == 0.4230053213121429
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 1) == 0.3852447896490933
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 3, 0.5, Turbulence) == 0.192738242229342
/// test: FractalNoiseTiled(float2(0.9, 0.3), float2(4, 3), 3, 0.5, Ridged) == 0.6563722709184006
[node("Procedural/Noise/Fractal Noise (Tiled)")]
float FractalNoiseTiled(
    float2 uv = uv0,                                   ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 4,  ///< cells of the coarsest layer in one unit of u and v: whole numbers
    [range(1, 12)] const int octaves = 4,              ///< how many layers of noise
    [range(0, 1)] float gain = 0.5,                    ///< height of each layer as a fraction of the previous one
    const FractalKind kind = Smooth                    ///< how the layers are added
) {
    float2 period = WholeCells(scale);
    float height = 0;
    float total = 0;
    float amplitude = 1;
    float layer = 1;
    for (int i = 0; i < min(octaves, 12); i++) {
        layer = FractalLayer(SignedGradientNoiseTiled(uv * period, period), layer, kind);
        height += layer * amplitude;
        total += amplitude;
        amplitude *= gain;
        period *= 2;
    }
    return kind == Smooth ? height / total * 0.5 + 0.5 : height / total;
}

/// Voronoi without a seam: it repeats with each unit of uv.
///
/// source: as Voronoi, on a lattice whose cells are counted modulo `scale`
/// test: VoronoiTiled(float2(0.95, 0.3), float2(4, 3)) == 0.583449159278075
/// test: VoronoiTiled(float2(-0.05, 1.3), float2(4, 3)).random == 0.22207015752792358
/// test: VoronoiTiled(float2(0.95, 0.3), float2(4, 3)).toPoint == float2(-0.5779298424720762, -0.08006259202957144)
/// test: VoronoiTiled(float2(0.5, 0.5), 4, 0) == 0.7071067811865476
[node("Procedural/Noise/Voronoi (Tiled)")]
float VoronoiTiled(
    float2 uv = uv0,                                   ///< texture coordinates
    [range(1, 100)] [also("cells")] float2 scale = 8,  ///< cells in one unit of u and v: whole numbers
    [range(0, 1)] float jitter = 1,                    ///< how far the points are from their cell's centre: 0 makes a grid
    out float random,                                  ///< a random number for each point, from 0 to 1
    out float2 toPoint                                 ///< from here to the nearest point, in cells
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

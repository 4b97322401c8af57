// Cellular noise in the plane and in space, with the random points of MaterialX: one in each cell of the lattice.

/// What cellular noise gives.
enum WorleyStyle {
    Distance,   ///< the distances to the nearest points
    Cell,       ///< a random number of the nearest point's cell, in all components
    CellVector  ///< three random numbers of the nearest point's cell
};

// Three numbers in ascending order, with one more among them; the largest of the four is left out.
float3 NearestWith(float3 nearest, float another) {
    float later = max(another, nearest.x);
    return float3(min(another, nearest.x), min(later, nearest.y), min(max(later, nearest.y), nearest.z));
}

// The random point of a cell, from the corner of the lattice.
[inFloat]
float2 PointOf2(int2 cell, float jitter) {
    float2 random = float2(RandomOf(int3(cell, 0)), RandomOf(int3(cell, 1)));
    return (random - 0.5) * jitter + 0.5;
}

[inFloat]
float3 PointOf3(int3 cell, float jitter) {
    float3 random = float3(FractionOf(HashOf4(cell.x, cell.y, cell.z, 0)), FractionOf(HashOf4(cell.x, cell.y, cell.z, 1)),
                           FractionOf(HashOf4(cell.x, cell.y, cell.z, 2)));
    return (random - 0.5) * jitter + 0.5;
}

/// The distances to the three nearest of random points in a plane, or random numbers of the nearest one: MaterialX's
/// `worleynoise2d`.
///
/// The node searches the nine cells around the position. Above a jitter of 0.65, a nearer point may rarely lie outside.
///
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; MaterialX 1.39, worleynoise2d
/// test: WorleyNoise2D(float2(0.3, 7.75), 1) == float3(0.25901410601997904, 0.43569279520638743, 1.036798050937848)
/// test: WorleyNoise2D(float2(-1.25, 0.5), 0.5) == float3(0.4675893427607417, 0.9702049701445509, 0.989115425674556)
/// test: WorleyNoise2D(float2(0.3, 7.75), 1, Cell) == float3(0.5444470917676685, 0.5444470917676685, 0.5444470917676685)
/// test: WorleyNoise2D(float2(0.3, 7.75), 1, CellVector) == float3(0.38090769373367256, 0.5039466476309921, 0.5404840853392342)
[node("Procedural/Noise/Worley Noise 2D")] [inFloat]
float3 WorleyNoise2D(
    float2 position = uv0,              ///< where; the cells are one unit wide
    [range(0, 1)] float jitter = 1,     ///< how far the points are from their cell's centre: 0 makes a grid
    const WorleyStyle style = Distance  ///< what the numbers are
) {
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float2 d = position - corner;
    float3 nearest = 1e6;
    float2 toPoint = 0;
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            int2 stepTo = int2(i, j);
            float2 away = float2(stepTo) + PointOf2(cell + stepTo, jitter) - d;
            float squared = dot(away, away);
            toPoint = squared < nearest.x ? away : toPoint;
            nearest = NearestWith(nearest, squared);
        }
    }
    int2 home = int2(floor(toPoint + position));
    if (style == Cell) { return FractionOf(HashOf2(home.x, home.y)); }
    if (style == CellVector) {
        return float3(RandomOf(int3(home, 0)), RandomOf(int3(home, 1)), RandomOf(int3(home, 2)));
    }
    return sqrt(nearest);
}

/// The distances to the three nearest of random points in space, or random numbers of the nearest one: MaterialX's
/// `worleynoise3d`.
///
/// The node searches the 27 cells around the position. Above a jitter of 0.65, a nearer point may rarely lie outside.
///
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; MaterialX 1.39, worleynoise3d
/// test: WorleyNoise3D(float3(0.3, 7.75, -2.5), 1) == float3(0.23488026447724053, 0.4027931237885559, 0.818188452501073)
/// test: WorleyNoise3D(float3(0.3, 7.75, -2.5), 1, Cell) == float3(0.9951689811412173, 0.9951689811412173, 0.9951689811412173)
/// test: WorleyNoise3D(float3(0.3, 7.75, -2.5), 1, CellVector) == float3(0.12254689659982615, 0.7362456612140512, 0.6532643236343899)
[node("Procedural/Noise/Worley Noise 3D")] [inFloat]
float3 WorleyNoise3D(
    float3 position = positionOS,       ///< where; the cells are one unit wide
    [range(0, 1)] float jitter = 1,     ///< how far the points are from their cell's centre: 0 makes a grid
    const WorleyStyle style = Distance  ///< what the numbers are
) {
    float3 corner = floor(position);
    int3 cell = int3(corner);
    float3 d = position - corner;
    float3 nearest = 1e6;
    float3 toPoint = 0;
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            for (int k = -1; k < 2; k++) {
                int3 stepTo = int3(i, j, k);
                float3 away = float3(stepTo) + PointOf3(cell + stepTo, jitter) - d;
                float squared = dot(away, away);
                toPoint = squared < nearest.x ? away : toPoint;
                nearest = NearestWith(nearest, squared);
            }
        }
    }
    int3 home = int3(floor(toPoint + position));
    if (style == Cell) { return RandomOf(home); }
    if (style == CellVector) {
        return float3(FractionOf(HashOf4(home.x, home.y, home.z, 0)), FractionOf(HashOf4(home.x, home.y, home.z, 1)),
                      FractionOf(HashOf4(home.x, home.y, home.z, 2)));
    }
    return sqrt(nearest);
}

// The distance of a point by a metric.
float PointDistance3(float3 away, const CellMetric metric) {
    float3 size = abs(away);
    return metric == Euclidean ? length(away) : metric == Manhattan ? size.x + size.y + size.z : max(size.x, max(size.y, size.z));
}

/// Cellular noise in space: the distances to the two nearest of random points, one in each cell.
///
/// `f2 - out` is a ridge along the borders between cells. The node searches the 27 cells around the position. Above a jitter of
/// 0.65, a nearer point may rarely lie outside.
///
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; the points are those of WorleyNoise3D
/// test: Worley3D(float3(0.3, 7.75, -2.5), 1) == 0.2348802644772406
/// test: Worley3D(float3(0.3, 7.75, -2.5), 1).f2 == 0.4027931237885554
/// test: Worley3D(float3(0.3, 7.75, -2.5), 1).random == 0.9951689811412173
/// test: Worley3D(float3(0.3, 7.75, -2.5), 1).toPoint == float3(-0.17745310340017384, -0.013754338785949116, 0.15326432363439002)
/// test: Worley3D(float3(0.3, 0.45, 0.7), 4, 0.8, Manhattan).f2 == 1.158702416871372
/// test: Worley3D(float3(0.3, 0.45, 0.7), 4, 0.8, Chebyshev) == 0.24506342027919903
[node("Procedural/Noise/Worley 3D")] [also("Voronoi3D", "Cellular3D")] [inFloat]
float Worley3D(
    float3 position = positionOS,         ///< where
    [range(0, 100)] float scale = 4,      ///< cells in one unit
    [range(0, 1)] float jitter = 1,       ///< how far the points are from their cell's centre: 0 makes a grid
    const CellMetric metric = Euclidean,  ///< how distance is measured
    out float f2,                         ///< distance to the second nearest point, in cells
    out float random,                     ///< a random number for each point, from 0 to 1
    out float3 toPoint                    ///< from here to the nearest point, in cells
) {
    float3 place = position * scale;
    float3 corner = floor(place);
    int3 cell = int3(corner);
    float3 d = place - corner;
    float nearest = 8;  // larger than any distance within 27 cells
    float second = 8;
    int3 home = int3(0, 0, 0);
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            for (int k = -1; k < 2; k++) {
                int3 stepTo = int3(i, j, k);
                float3 away = float3(stepTo) + PointOf3(cell + stepTo, jitter) - d;
                float distanceTo = PointDistance3(away, metric);
                second = min(second, max(distanceTo, nearest));
                if (distanceTo < nearest) {
                    nearest = distanceTo;
                    home = cell + stepTo;
                    toPoint = away;
                }
            }
        }
    }
    f2 = second;
    random = RandomOf(home);
    return nearest;
}

/// Worley3D without a seam: it repeats with each unit of each direction.
///
/// source: as Worley3D, on a lattice whose cells are counted modulo `scale`
/// test: Worley3DTiled(float3(0.95, 0.3, 0.55), float3(4, 3, 5)) == 0.6565124295577449
/// test: Worley3DTiled(float3(-0.05, 1.3, 2.55), float3(4, 3, 5)).f2 == 0.7440427476523075
/// test: Worley3DTiled(float3(0.95, 0.3, 0.55), float3(4, 3, 5)).random == 0.04130606656924497
/// test: Worley3DTiled(float3(0.95, 0.3, 0.55), float3(4, 3, 5), 0.8, Manhattan) == 1.0003466290539005
/// test: Worley3DTiled(float3(0.95, 0.3, 0.55), float3(4, 3, 5), 0.8, Chebyshev) == 0.5115280795170757
[node("Procedural/Noise/Worley 3D (Tiled)")] [also("Voronoi3DTiled")] [inFloat]
float Worley3DTiled(
    float3 position = positionOS,         ///< where
    [range(1, 100)] float3 scale = 4,     ///< cells in one unit of each direction: whole numbers
    [range(0, 1)] float jitter = 1,       ///< how far the points are from their cell's centre: 0 makes a grid
    const CellMetric metric = Euclidean,  ///< how distance is measured
    out float f2,                         ///< distance to the second nearest point, in cells
    out float random                      ///< a random number for each point, from 0 to 1
) {
    float3 period = max(round(scale), 1);
    float3 place = position * period;
    float3 corner = floor(place);
    float3 d = place - corner;
    float nearest = 8;  // larger than any distance within 27 cells
    float second = 8;
    int3 home = int3(0, 0, 0);
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            for (int k = -1; k < 2; k++) {
                float3 stepTo = float3(int3(i, j, k));
                int3 cell = WrappedCell3(corner + stepTo, period);
                float distanceTo = PointDistance3(stepTo + PointOf3(cell, jitter) - d, metric);
                second = min(second, max(distanceTo, nearest));
                if (distanceTo < nearest) {
                    nearest = distanceTo;
                    home = cell;
                }
            }
        }
    }
    f2 = second;
    random = RandomOf(home);
    return nearest;
}

// Cellular noise in full: the two nearest points, the borders between cells, and other measures of distance. Voronoi
// (patterns.node.hlsl) is the short form.

/// How the distance to a point is measured.
enum CellMetric {
    Euclidean,  ///< straight lines: round cells
    Manhattan,  ///< along the axes: diamonds
    Chebyshev   ///< the longer of the two axes: squares
};

float CellDistance(float2 away, const CellMetric metric) {
    float2 size = abs(away);
    return metric == Euclidean ? length(away) : metric == Manhattan ? size.x + size.y : max(size.x, size.y);
}

// From the corner of the cell that holds a position to the random point of a cell nearby.
float2 CellPoint(int2 cell, int2 stepTo, float jitter) {
    return float2(stepTo) + 0.5 + (RandomAt(cell + stepTo) - 0.5) * jitter;
}

/// Cellular noise: the distances to the two nearest of random points, one in each cell, and to the border between cells.
///
/// `f2 - out` is a ridge along the borders that is cheaper than `edge` and not equally wide everywhere. The node searches the
/// 25 cells around the position, and, if `edge` is read, again the 25 around the nearest point: use Voronoi if its outputs are
/// enough.
///
/// formula: edge = min over the other points q of dot((a + b) / 2, b - a) / |b - a|, a and b: from here to the nearest point, to q
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996; edge: Quilez, "Voronoi edges", 2012
/// test: Worley(float2(0.3, 0.6), 4) == 0.3980660311555204
/// test: Worley(float2(0.3, 0.6), 4).f2 == 0.46899629667704096
/// test: Worley(float2(0.3, 0.6), 4).edge == 0.09747282158855752
/// test: Worley(float2(0.3, 0.6), 4).random == 0.01066964864730835
/// test: Worley(float2(0.3, 0.6), 4).toPoint == float2(-0.1893303513526916, -0.35015794038772574)
/// test: Worley(float2(0.3, 0.6), 4, 1, Manhattan).f2 == 0.5641603589057922
/// test: Worley(float2(-1.3, 2.65), 1, 0.8, Chebyshev) == 0.1275032520294188
/// test: Worley(float2(-1.3, 2.65), 1, 0.8).edge == 0.14917368687283364
/// test: Worley(float2(0.5, 0.75), 1, 0).edge == 0.25
[node("Procedural/Noise/Worley")] [also("CellNoise", "Cellular", "F1F2", "WorleyNoise", "Worley2D")]
float Worley(
    float2 uv = uv0,                      ///< texture coordinates
    [range(0, 100)] float scale = 8,      ///< cells in one unit of uv
    [range(0, 1)] float jitter = 1,       ///< how far the points are from their cell's centre: 0 makes a grid
    const CellMetric metric = Euclidean,  ///< how distance is measured; `edge` is Euclidean, from the nearest point by this metric
    out float f2,                         ///< distance to the second nearest point, in cells
    out float edge,                       ///< distance to the nearest border between two points, in cells
    out float random,                     ///< a random number for each point, from 0 to 1
    out float2 toPoint                    ///< from here to the nearest point, in cells
) {
    float2 position = uv * scale;
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float2 d = position - corner;
    float nearest = 8;  // larger than any distance within 25 cells
    float second = 8;
    int2 home = int2(0, 0);
    for (int j = -2; j < 3; j++) {
        for (int i = -2; i < 3; i++) {
            int2 stepTo = int2(i, j);
            float2 away = CellPoint(cell, stepTo, jitter) - d;
            float distanceTo = CellDistance(away, metric);
            second = min(second, max(distanceTo, nearest));
            if (distanceTo < nearest) {
                nearest = distanceTo;
                home = stepTo;
                toPoint = away;
            }
        }
    }
    float border = 8;
    for (int l = -2; l < 3; l++) {
        for (int k = -2; k < 3; k++) {
            float2 away = CellPoint(cell, home + int2(k, l), jitter) - d;
            float2 between = away - toPoint;
            float squared = dot(between, between);
            float toBorder = dot(away + toPoint, between) * 0.5 * rsqrt(max(squared, 1e-8));
            border = squared > 1e-6 ? min(border, toBorder) : border;
        }
    }
    f2 = second;
    edge = border;
    random = RandomAt(cell + home).x;
    return nearest;
}

// Patterns of cells: boards, walls and Voronoi cells.

/// A checkerboard: squares alternate between 0 and 1.
///
/// test: Checkerboard(float2(0.1, 0.1), 4) == 0
/// test: Checkerboard(float2(0.3, 0.1), 4) == 1
/// test: Checkerboard(float2(-0.1, 0.1), 4) == 1
/// test: Checkerboard(float2(0.9, 0.6), float2(2, 4)) == 1
[node("Procedural/Pattern/Checkerboard")] [also("Checker", "CheckerTexture")]
float Checkerboard(
    float2 uv = uv0,                      ///< texture coordinates
    [also("frequency")] float2 scale = 4  ///< squares in one unit of u and v
) {
    int2 cell = int2(floor(uv * scale));
    return float((cell.x + cell.y) & 1);
}

/// A wall of bricks: 1 on a brick, 0 in the mortar between.
///
/// test: Bricks(float2(0.125, 0.0625), float2(4, 8)) == 1
/// test: Bricks(float2(0.25, 0.0625), float2(4, 8)) == 0
/// test: Bricks(float2(0.25, 0.1875), float2(4, 8)) == 1
/// test: Bricks(float2(0.265, 0.0625), float2(4, 8), 0.5, 0.01, 0.01) == 0.5
/// test: Bricks(float2(0.25, 0.1875), float2(4, 8)).local == float2(0.5, 0.5)
/// test: Bricks(float2(0.125, 0.0625), float2(4, 8)).random == 0.097231924533844
[node("Procedural/Pattern/Bricks")]
float Bricks(
    float2 uv = uv0,                              ///< texture coordinates
    [also("count")] float2 scale = float2(4, 8),  ///< bricks in one unit of u and v
    [range(0, 1)] float shift = 0.5,              ///< how far every second row is moved, in bricks
    [range(0, 0.1)] float mortar = 0.01,          ///< half the width of a joint, in units of uv
    [range(0, 0.1)] float bevel = 0.005,          ///< width of the brick's soft edge, in units of uv; not zero
    out float2 local,                             ///< position in the brick, from 0 to 1
    out float random                              ///< a random number for each brick, from 0 to 1
) {
    float2 position = uv * scale;
    float row = floor(position.y);
    position.x += shift * (row - 2 * floor(row / 2));
    float2 corner = floor(position);
    local = position - corner;
    random = RandomAt(int2(corner)).x;
    float2 toEdge = min(local, 1 - local) / scale;
    return smoothstep(mortar, mortar + bevel, min(toEdge.x, toEdge.y));
}

/// The distance to the nearest of random points, one in each cell: a pattern as of skin, stones or foam.
///
/// The node searches the nine cells around the position. Above a jitter of 0.65, a nearer point may rarely lie outside.
///
/// source: Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996
/// test: Voronoi(float2(0.5, 0.25), 1, 0) == 0.25
/// test: Voronoi(float2(0, 0), 1, 0) == 0.7071067811865476
/// test: Voronoi(float2(0.25, -0.25), 2, 0) == 0
/// test: Voronoi(float2(0.25, 0.25), 2, 0).random == 0.097231924533844
/// test: Voronoi(float2(0.3, 0.6), 4, 1) == 0.3980660311555204
[node("Procedural/Noise/Voronoi")] [also("Voronoi2D")]
float Voronoi(
    float2 uv = uv0,                  ///< texture coordinates
    [range(0, 100)] float scale = 8,  ///< cells in one unit of uv
    [range(0, 1)] float jitter = 1,   ///< how far the points are from their cell's centre: 0 makes a grid
    out float random,                 ///< a random number for each point, from 0 to 1
    out float2 toPoint                ///< from here to the nearest point, in cells
) {
    float2 position = uv * scale;
    float2 corner = floor(position);
    int2 cell = int2(corner);
    float nearest = 8;  // squared; larger than any distance within nine cells
    for (int j = -1; j < 2; j++) {
        for (int i = -1; i < 2; i++) {
            int2 stepTo = int2(i, j);
            float2 hash = RandomAt(cell + stepTo);
            float2 away = float2(stepTo) + 0.5 + (hash - 0.5) * jitter - (position - corner);
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

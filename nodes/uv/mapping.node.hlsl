// Texture coordinates. (0, 0) is the upper left corner of the texture, and v grows downwards.

/// Scales and moves texture coordinates.
///
/// formula: uv tiling + offset
/// test: TilingOffset(float2(0.5, 0.25), float2(2, 4), float2(0.1, 0.2)) == float2(1.1, 1.2)
/// test: TilingOffset(float2(0.5, 0.25), 1, 0) == float2(0.5, 0.25)
[node("UV/Tiling and Offset")] [also("TilingAndOffset", "Place2D", "TransformTex")]
float2 TilingOffset(
    float2 uv = uv0,    ///< texture coordinates
    float2 tiling = 1,  ///< how often the texture fits along u and v
    float2 offset = 0   ///< translation, in textures
) {
    return uv * tiling + offset;
}

/// Rotates texture coordinates around a centre. A positive angle turns u towards v.
///
/// formula: (x cos - y sin, x sin + y cos) of uv - center
/// test: Rotate(float2(1, 0), 1.5707963267948966, float2(0, 0)) == float2(0, 1)
/// test: Rotate(float2(0.75, 0.5), 3.141592653589793) == float2(0.25, 0.5)
/// test: Rotate(float2(2, 1), 0.5235987755982988, float2(1, 1)) == float2(1.8660254037844386, 1.5)
[node("UV/Rotate")] [also("Rotate2D", "Rotator")]
float2 Rotate(
    float2 uv = uv0,                ///< texture coordinates
    [unit("rad")] float angle = 0,  ///< angle of the rotation
    float2 center = 0.5             ///< centre of the rotation
) {
    float2 d = uv - center;
    float sine = sin(angle);
    float cosine = cos(angle);
    return center + float2(d.x * cosine - d.y * sine, d.x * sine + d.y * cosine);
}

/// The distance and direction from a centre, as texture coordinates: for rings, rays and spirals.
///
/// u is the distance: 1 at the edge of the circle that fits into the texture. v is the direction in turns, -0.5 to 0.5,
/// 0 towards growing u and 0.25 towards growing v; it jumps at the seam opposite to u, and has no value at the centre.
///
/// test: PolarCoordinates(float2(1, 0.5)) == float2(1, 0)
/// test: PolarCoordinates(float2(0.5, 1)) == float2(1, 0.25)
/// test: PolarCoordinates(float2(0.25, 0.25), 0.5, 2, 8) == float2(1.4142135623730951, -3)
[node("UV/Polar Coordinates")] [also("PolarCoord")]
float2 PolarCoordinates(
    float2 uv = uv0,         ///< texture coordinates
    float2 center = 0.5,     ///< where the distance is zero
    float radialScale = 1,  ///< factor on the distance
    float angularScale = 1  ///< factor on the direction: a whole number gives that many rays
) {
    float2 fromCenter = uv - center;
    float radius = length(fromCenter) * 2;
    float turns = atan2(fromCenter.y, fromCenter.x) / TWO_PI;
    return float2(radius * radialScale, turns * angularScale);
}

/// Where the first frame of a flip-book is; the others follow along its row, and then row by row.
enum FlipbookOrder {
    FromUpperLeft,   ///< as text is read
    FromUpperRight,  ///< rows run to the left
    FromLowerLeft,   ///< rows follow one another upwards
    FromLowerRight   ///< both
};

/// The texture coordinates of one frame of a flip-book: frames lie in rows, the first at the upper left.
///
/// test: Flipbook(float2(0.5, 0.5), 4, 2, 0) == float2(0.125, 0.25)
/// test: Flipbook(float2(0, 0), 4, 2, 5) == float2(0.25, 0.5)
/// test: Flipbook(float2(0, 0), 4, 2, 9.75) == float2(0.25, 0)
/// test: Flipbook(float2(0, 0), 4, 2, -1) == float2(0.75, 0.5)
/// test: Flipbook(float2(0, 0), 4, 2, 5, FromUpperRight) == float2(0.5, 0.5)
/// test: Flipbook(float2(0, 0), 4, 2, 5, FromLowerLeft) == float2(0.25, 0)
/// test: Flipbook(float2(0.5, 0.5), 4, 2, 0, FromLowerRight) == float2(0.875, 0.75)
[node("UV/Flipbook")] [also("SpriteSheet", "SubUV")]
float2 Flipbook(
    float2 uv = uv0,                   ///< texture coordinates within the frame
    [range(1, 64)] float columns = 4,  ///< frames in a row, a whole number
    [range(1, 64)] float rows = 4,     ///< rows, a whole number
    float frame = 0,                   ///< which frame, from 0; a fraction is dropped, and the first follows the last
    const FlipbookOrder order = FromUpperLeft  ///< where the first frame is
) {
    // Half a frame is added so that rounding cannot move a whole quotient just below its value.
    float whole = floor(frame);
    float count = columns * rows;
    float index = whole - count * floor((whole + 0.5) / count);
    float row = floor((index + 0.5) / columns);
    float column = index - row * columns;
    if (order == FromUpperRight || order == FromLowerRight) { column = columns - 1 - column; }
    if (order == FromLowerLeft || order == FromLowerRight) { row = rows - 1 - row; }
    return (uv + float2(column, row)) / float2(columns, rows);
}

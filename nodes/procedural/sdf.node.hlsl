// Signed distances: how far a point is from the edge of a shape, below zero inside. They are combined by SdfCombine, made into
// lines by SdfOutline, and turned into a picture by SdfMask. Lengths are in units of uv; shapes lie around `center`, and a point of
// a shape looks up, to small v.

/// The signed distance to a circle.
///
/// formula: |uv - center| - radius
/// source: the definition of a circle
/// test: SdfCircle(float2(0.5, 0.5), 0.25) == -0.25
/// test: SdfCircle(float2(0.8, 0.9), 0.25) == 0.25
[node("Procedural/Distance/Sdf Circle")] [also("CircleSdf", "DistanceToCircle")]
float SdfCircle(
    float2 uv = uv0,                   ///< where
    [range(0, 1)] float radius = 0.4,  ///< radius of the circle
    float2 center = 0.5                ///< its centre
) {
    return length(uv - center) - radius;
}

/// The signed distance to a rectangle, also with round corners.
///
/// formula: |max(q, 0)| + min(max q, 0) - r, q = |uv - center| - size / 2 + r, r = rounding
/// source: Quilez, "2D distance functions" (box); by symmetry one corner is enough
/// test: SdfBox(float2(0.5, 0.5), float2(0.5, 0.25)) == -0.125
/// test: SdfBox(float2(1, 0.5), float2(0.5, 0.25)) == 0.25
/// test: SdfBox(float2(1.05, 1.025), float2(0.5, 0.25)) == 0.5
/// test: SdfBox(float2(0.9, 0.9), 0.4, 0.1) == 0.3242640687119285
[node("Procedural/Distance/Sdf Box")] [also("BoxSdf", "SdfRectangle", "SdfRoundedBox")]
float SdfBox(
    float2 uv = uv0,                     ///< where
    float2 size = 0.6,                   ///< width and height
    [range(0, 0.5)] float rounding = 0,  ///< radius of the corners; at most half of the shorter side
    float2 center = 0.5                  ///< its centre
) {
    float2 q = abs(uv - center) - 0.5 * size + rounding;
    return length(max(q, 0)) + min(max(q.x, q.y), 0) - rounding;
}

/// The signed distance to a line between two points, with round ends.
///
/// formula: |p - t d| - width / 2, p = uv - from, d = to - from, t = saturate(dot(p, d) / dot(d, d))
/// source: the projection of a point on a line; Quilez, "2D distance functions" (segment)
/// test: SdfLine(float2(0.5, 0.25), float2(0, 0), float2(1, 0), 0.1) == 0.2
/// test: SdfLine(float2(1.3, 0.4), float2(0, 0), float2(1, 0), 0) == 0.5
/// test: SdfLine(float2(0.3, 0.4), float2(0, 0), float2(0, 0), 0.2) == 0.4
[node("Procedural/Distance/Sdf Line")] [also("SdfSegment", "SdfCapsule", "LineSdf")]
float SdfLine(
    float2 uv = uv0,                    ///< where
    float2 from = float2(0.2, 0.5),     ///< one end
    float2 to = float2(0.8, 0.5),       ///< the other end
    [range(0, 1)] float width = 0.05    ///< width of the line
) {
    float2 p = uv - from;
    float2 d = to - from;
    float along = saturate(dot(p, d) / max(dot(d, d), 1e-8));
    return length(p - d * along) - 0.5 * width;
}

/// The signed distance to a regular polygon; one of its corners looks up.
///
/// formula: q = uv - center turned into the sector of the nearest side; its distance to that side, or beyond the end to the corner
/// source: by symmetry the distance to one side is enough; Quilez, "2D distance functions" (regular polygons)
/// test: SdfPolygon(float2(0.5, 0.5), 4, 0.5) == -0.35355339059327373
/// test: SdfPolygon(float2(0.5, -0.25), 4, 0.5) == 0.25
/// test: SdfPolygon(float2(0.75, 0.25), 4, 0.5) == 0
/// test: SdfPolygon(float2(0.5, 1), 3, 0.5) == 0.25
[node("Procedural/Distance/Sdf Polygon")] [also("PolygonSdf", "SdfTriangle", "SdfHexagon")]
float SdfPolygon(
    float2 uv = uv0,                   ///< where
    [range(3, 64)] float sides = 6,    ///< number of sides, a whole number
    [range(0, 1)] float radius = 0.4,  ///< from the centre to a corner
    float2 center = 0.5                ///< its centre
) {
    float2 p = uv - center;
    float sector = TWO_PI / sides;
    float distanceTo = length(p);
    float angle = distanceTo > 0 ? atan2(p.x, -p.y) : 0;
    // From the middle of the nearest side, which lies half a sector after a corner.
    float turned = angle / sector;
    float fromMiddle = (turned - floor(turned) - 0.5) * sector;
    float2 q = distanceTo * float2(cos(fromMiddle), abs(sin(fromMiddle)));
    float2 corner = radius * float2(cos(0.5 * sector), sin(0.5 * sector));
    float beyond = max(q.y - corner.y, 0);
    float toSide = q.x - corner.x;
    return toSide > 0 ? length(float2(toSide, beyond)) : toSide;
}

/// The signed distance to a star; one of its points looks up.
///
/// formula: as for a polygon, with one half of a point instead of one half of a side: the line from its tip to its notch
/// source: by symmetry the distance to one line is enough; Quilez, "2D distance functions" (star)
/// test: SdfStar(float2(0.5, 0.1), 5, 0.4, 0.2) == 0
/// test: SdfStar(float2(0.5, 0), 5, 0.4, 0.2) == 0.1
/// test: SdfStar(float2(0.5, 0.5), 4, 0.5, 0.3535533905932738) == -0.35355339059327373
/// test: SdfStar(float2(0.5, 0.7), 5, 0.4, 0.2) == 0
[node("Procedural/Distance/Sdf Star")] [also("StarSdf")]
float SdfStar(
    float2 uv = uv0,                  ///< where
    [range(3, 64)] float points = 5,  ///< number of points, a whole number
    [range(0, 1)] float outer = 0.4,  ///< from the centre to a tip
    [range(0, 1)] float inner = 0.2,  ///< from the centre to a notch
    float2 center = 0.5               ///< its centre
) {
    float2 p = uv - center;
    float sector = TWO_PI / points;
    float distanceTo = length(p);
    float angle = distanceTo > 0 ? atan2(p.x, -p.y) : 0;
    float turned = angle / sector;
    float fromTip = abs(turned - floor(turned + 0.5)) * sector;
    float2 q = distanceTo * float2(cos(fromTip), sin(fromTip));
    float2 tip = float2(outer, 0);
    float2 line = inner * float2(cos(0.5 * sector), sin(0.5 * sector)) - tip;
    float2 fromOuter = q - tip;
    float2 nearest = fromOuter - line * saturate(dot(fromOuter, line) / max(dot(line, line), 1e-8));
    float side = line.x * fromOuter.y - line.y * fromOuter.x;
    return side < 0 ? length(nearest) : -length(nearest);
}

/// How two shapes are combined.
enum SdfOperation {
    Union,         ///< both shapes
    Intersection,  ///< where both are
    Difference     ///< the first without the second
};

/// Combines two shapes, with a smooth joint if wanted: drops that merge, a corner that is filled.
///
/// The result is exact outside of a union and a bound elsewhere: inside a joint, distances are a little too small.
///
/// formula: union: min(a, b) - h^2 / (4 k), h = max(k - |a - b|, 0); intersection: -union(-a, -b); difference: -union(-a, b)
/// source: Quilez, "Smooth minimum" (quadratic)
/// test: SdfCombine(0.25, -0.5) == -0.5
/// test: SdfCombine(0.25, -0.5, Intersection) == 0.25
/// test: SdfCombine(-0.25, -0.5, Difference) == 0.5
/// test: SdfCombine(0.25, 0.25, Union, 0.4) == 0.15
/// test: SdfCombine(0.25, 0.25, Intersection, 0.4) == 0.35
/// test: SdfCombine(0.3, 0.1, Union, 0.4) == 0.075
/// test: SdfCombine(-0.1, 0.3, Difference, 0.2) == -0.1
[node("Procedural/Distance/Sdf Combine")] [also("SmoothUnion", "SmoothMinimum", "Smin", "SdfUnion")]
float SdfCombine(
    float a,                               ///< the first distance
    float b,                               ///< the second distance
    const SdfOperation operation = Union,  ///< what remains
    [range(0, 1)] float smoothness = 0     ///< width of the joint, in units of distance; 0: none
) {
    float first = operation == Union ? a : -a;
    float second = operation == Intersection ? -b : b;
    float overlap = max(smoothness - abs(first - second), 0);
    float united = min(first, second) - overlap * overlap / (4 * max(smoothness, 1e-6));
    return operation == Union ? united : -united;
}

/// The signed distance to a line along the edge of a shape.
///
/// formula: |d| - width / 2
/// source: Quilez, "2D distance functions" (annular shapes)
/// test: SdfOutline(0.1, 0.05) == 0.075
/// test: SdfOutline(-0.01, 0.05) == -0.015
[node("Procedural/Distance/Sdf Outline")] [also("SdfRing", "SdfOnion", "SdfStroke")]
float SdfOutline(
    float value,                       ///< distance to a shape
    [range(0, 1)] float width = 0.02  ///< width of the line
) {
    return abs(value) - 0.5 * width;
}

/// A shape as a mask: 1 inside, 0 outside, with an edge that is one pixel wide, or softer.
///
/// formula: saturate(1/2 - d / w), w: change of d over one pixel, or `softness` if that is more
/// source: the coverage of a pixel by a straight edge
[node("Procedural/Distance/Sdf Mask")] [also("SdfFill", "SdfToMask")] [range(0, 1)]
float SdfMask(
    float value,                        ///< distance to a shape
    [range(0, 1)] float softness = 0  ///< width of the edge, in units of distance; at least one pixel
) {
    return saturate(0.5 - value / max(max(fwidth(value), softness), 1e-6));
}

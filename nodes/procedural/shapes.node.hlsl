// Shapes in the square of uv from 0 to 1, with smooth edges one pixel wide: 1 inside, 0 outside. Each also gives the measure
// that its edge follows, from which borders and glows are made. Their forms are those of Unity's Shader Graph; the shapes that
// can be combined are signed distances (sdf.node.hlsl). A point of a shape looks up, to small v.

// 1 where a measure is below 1, 0 where it is above, and between them over one pixel.
float InsideOne(float measure) {
    return saturate((1 - measure) / max(fwidth(measure), 1e-6));
}

/// An ellipse in the middle of the texture.
///
/// formula: measure = |(2 uv - 1) / (width, height)|
/// source: the equation of an ellipse, 1 on its edge; edge: one pixel of fwidth
/// test: Ellipse(float2(0.75, 0.5), 0.5, 1).measure == 1
/// test: Ellipse(float2(0.5, 0.75), 0.5, 1).measure == 0.5
/// test: Ellipse(float2(0.8, 0.9), 0.5, 0.5).measure == 2
[node("Procedural/Shape/Ellipse")] [also("Circle", "Disc")] [range(0, 1)]
float Ellipse(
    float2 uv = uv0,                   ///< texture coordinates
    [range(0, 1)] float width = 0.5,   ///< width as a share of the texture's; not zero
    [range(0, 1)] float height = 0.5,  ///< height as a share of the texture's; not zero
    out float measure                  ///< 0 in the middle, 1 on the edge, growing outwards
) {
    measure = length((uv * 2 - 1) / float2(width, height));
    return InsideOne(measure);
}

/// How the edges of a rectangle are smoothed.
enum EdgeSmoothing {
    Fastest,  ///< the edge fades inside the shape
    Nicest    ///< each pixel is covered by the share of it that the shape covers, also where the shape is thinner than a pixel
};

/// A rectangle in the middle of the texture.
///
/// formula: measure = max |2 uv - 1| - (width, height); Nicest: the product of both directions' coverage of a pixel
/// source: the coverage of a pixel by an axis-aligned box, with pixels of size fwidth(uv)
/// test: Rectangle(float2(0.75, 0.5), 0.5, 0.25).measure == 0
/// test: Rectangle(float2(0.5, 0.5), 0.5, 0.25).measure == -0.25
/// test: Rectangle(float2(0.5, 1), 0.5, 0.25, Nicest).measure == 0.75
[node("Procedural/Shape/Rectangle")] [also("Box", "Square")] [range(0, 1)]
float Rectangle(
    float2 uv = uv0,                          ///< texture coordinates
    [range(0, 1)] float width = 0.5,          ///< width as a share of the texture's
    [range(0, 1)] float height = 0.5,         ///< height as a share of the texture's
    const EdgeSmoothing smoothing = Fastest,  ///< how the edges are smoothed
    out float measure                         ///< below 0 inside, 0 on the edge: the distance to the nearer edge, in half textures
) {
    float2 size = float2(width, height);
    float2 fromEdge = abs(uv * 2 - 1) - size;
    measure = max(fromEdge.x, fromEdge.y);
    float2 pixel = max(fwidth(uv), 1e-6);
    if (smoothing == Nicest) {
        // Both edges of each direction: the part of the pixel that lies between them.
        float2 middle = abs(uv - 0.5);
        float2 covered = min(saturate(0.5 + (0.5 * size - middle) / pixel), size / pixel);
        return covered.x * covered.y;
    }
    float2 faded = 1 - fromEdge / max(fwidth(fromEdge), 1e-6);
    return saturate(min(faded.x, faded.y));
}

/// A rectangle with round corners in the middle of the texture.
///
/// formula: measure = |max(|2 uv - 1| - (width, height) + r, 0)| / r, r = 2 radius, at most the shorter side
/// source: the distance to the inner rectangle from which a disc of radius r rounds the corners
/// test: RoundedRectangle(float2(0.75, 0.5), 0.5, 0.5, 0.1).measure == 1
/// test: RoundedRectangle(float2(0.5, 0.5), 0.5, 0.5, 0.1).measure == 0
/// test: RoundedRectangle(float2(0.75, 0.75), 0.5, 0.5, 0.1).measure == 1.4142135623730951
/// test: RoundedRectangle(float2(0.75, 0.5), 0.5, 0.25, 0.5).measure == 1
[node("Procedural/Shape/Rounded Rectangle")] [also("RoundedBox", "RoundedCorners")] [range(0, 1)]
float RoundedRectangle(
    float2 uv = uv0,                   ///< texture coordinates
    [range(0, 1)] float width = 0.5,   ///< width as a share of the texture's
    [range(0, 1)] float height = 0.5,  ///< height as a share of the texture's
    [range(0, 1)] float radius = 0.1,  ///< radius of the corners, in textures
    out float measure                  ///< 0 inside, 1 on the edge, growing outwards; it grows only within `radius` of the edge
) {
    float round = max(min(abs(radius * 2), min(abs(width), abs(height))), 1e-5);
    float2 outwards = max(abs(uv * 2 - 1) - float2(width, height) + round, 0);
    measure = length(outwards) / round;
    return InsideOne(measure);
}

/// A regular polygon in the middle of the texture; one of its sides lies at the bottom.
///
/// formula: measure = |p| cos(angle from the middle of the nearest side), p = (2 uv - 1) / (width, height) / cos(pi / sides)
/// source: the polar equation of a regular polygon, with its corners on an ellipse of the given size
/// test: Polygon(float2(0.5, 0.5), 6).measure == 0
/// test: Polygon(float2(0.5, 0.75), 4, 0.5, 0.5).measure == 1.4142135623730951
/// test: Polygon(float2(0.5, 0), 3, 1, 1).measure == 1
/// test: Polygon(float2(0.5, 1), 3, 1, 1).measure == 2
[node("Procedural/Shape/Polygon")] [also("RegularPolygon", "Ngon")] [range(0, 1)]
float Polygon(
    float2 uv = uv0,                   ///< texture coordinates
    [range(3, 64)] float sides = 6,    ///< number of sides, a whole number
    [range(0, 1)] float width = 0.5,   ///< width of the ellipse around it, as a share of the texture's; not zero
    [range(0, 1)] float height = 0.5,  ///< its height; not zero
    out float measure                  ///< 0 in the middle, 1 on the edge, growing outwards
) {
    float sector = TWO_PI / sides;
    float2 p = (uv * 2 - 1) / (float2(width, height) * cos(0.5 * sector));
    float radius = length(p);
    float angle = radius > 0 ? atan2(p.x, p.y) : 0;
    float fromMiddle = angle - sector * floor(0.5 + angle / sector);
    measure = radius * cos(fromMiddle);
    return InsideOne(measure);
}

/// A regular polygon with round corners in the middle of the texture; one of its sides lies at the bottom.
///
/// Each corner is replaced by an arc that touches both sides. The edge of the arc is found by the law of cosines in the triangle of
/// the polygon's centre, the arc's centre and the edge, in which the angle at the arc's centre is taken as proportional to that at
/// the polygon's: the arc is slightly flatter than a circle.
///
/// formula: measure = |p| cos a on a side, |p| / sqrt(c^2 + r^2 + 2 c r cos g) on an arc: c: distance of its centre, r: its radius
/// source: the law of cosines; Unity Shader Graph, node Rounded Polygon (proportional angles)
/// test: RoundedPolygon(float2(0.5, 0.5), 1, 1, 5, 0.3).measure == 0
/// test: RoundedPolygon(float2(0.5, 0), 1, 1, 4, 0.000001).measure == 1.4142135623730951 within 1e-3
/// test: RoundedPolygon(float2(1, 1), 1, 1, 4, 0.000001).measure == 1.4142135623730951 within 1e-3
/// test: RoundedPolygon(float2(1, 0.5), 0.5, 0.5, 6, 1).measure == 2.3094010767585034
/// test: RoundedPolygon(float2(0.5, 0), 1, 1, 4, 1).measure == 1.4142135623730951
/// test: RoundedPolygon(float2(0.62, 0.11), 1, 0.9, 5, 0.4).measure == 1.0410368733879531
/// test: RoundedPolygon(float2(0.5, 0), 1, 1, 5, 0.3).measure == 1.0721421557611042
[node("Procedural/Shape/Rounded Polygon")] [range(0, 1)]
float RoundedPolygon(
    float2 uv = uv0,                      ///< texture coordinates
    [range(0, 1)] float width = 0.5,      ///< width of the ellipse through the corners before they are rounded; not zero
    [range(0, 1)] float height = 0.5,     ///< its height; not zero
    [range(3, 64)] float sides = 5,       ///< number of sides; a fraction is dropped
    [range(0, 1)] float roundness = 0.3,  ///< 0: sharp corners, 1: a circle
    out float measure                     ///< 0 in the middle, 1 on the edge, growing outwards
) {
    float halfSector = PI / max(floor(abs(sides)), 3);
    // Scaled so that the middle of each side is 1 from the centre.
    float2 p = (uv * 2 - 1) / (float2(width, height) * cos(halfSector));
    float radius = length(p);
    // The angle from the middle of the nearest side, of which one looks along +y.
    float angle = radius > 0 ? atan2(p.x, p.y) : 0;
    float turned = angle / (2 * halfSector);
    float fromMiddle = abs(turned - floor(turned + 0.5)) * 2 * halfSector;
    // The arc takes a share of the angle at each corner; its centre is on the corner's axis.
    float arc = clamp(roundness, 1e-6, 1) * halfSector;
    float straight = halfSector - arc;
    float alongSide = tan(straight) / tan(halfSector);
    float centerDistance = alongSide / cos(halfSector);
    float arcRadius = 1 - alongSide;
    float share = (halfSector - fromMiddle) / arc;  // 0 at the corner's axis, 1 where the arc begins
    float atCenter = halfSector * share;
    float edge = sqrt(centerDistance * centerDistance + arcRadius * arcRadius +
                      2 * centerDistance * arcRadius * cos(atCenter));
    measure = share < 1 ? radius / edge : radius * cos(fromMiddle);
    return InsideOne(measure);
}

/// A checkerboard of two colours with smooth edges, which turns into their mean where its squares are smaller than a pixel.
///
/// formula: wave = product over x, y of (4 |frac(f (uv + 1/2) + 1/4) - 1/2| - 1); its zero is the edge, 0.35 / pixel its slope
/// source: two triangle waves whose product changes its sign at each edge; the contrast fades as sqrt(1.1 - pixel), pixel: the
/// source: change of f uv over one pixel (Unity Shader Graph, node Checkerboard)
/// test: CheckerboardUnity(float2(0.5, 0.5), 0, 1, 1).wave == 0
/// test: CheckerboardUnity(float2(0.25, 0.75), 0, 1, 1).wave == -1
/// test: CheckerboardUnity(float2(0.3, 0.6), 0, 1, float2(2, 3)).wave == -0.32
[node("Procedural/Pattern/Checkerboard (Unity)")]
float3 CheckerboardUnity(
    float2 uv = uv0,                       ///< texture coordinates
    [color] float3 colorA = 0.2,           ///< of the squares where `wave` is below zero
    [color] float3 colorB = 0.7,           ///< of the others
    [also("frequency")] float2 scale = 1,  ///< pairs of squares in one unit of u and v
    out float wave                         ///< from -1 to 1; its sign tells the two kinds of squares apart
) {
    float2 position = (uv + 0.5) * scale;
    float2 right = ddx(position);
    float2 down = ddy(position);
    float2 pixel = max(sqrt(right * right + down * down), 1e-6);
    float2 triangles = 4 * abs(frac(position + 0.25) - 0.5) - 1;
    wave = triangles.x * triangles.y;
    float2 edges = clamp(triangles * 0.35 / pixel, -1, 1);
    float contrast = sqrt(saturate(1.1 - max(pixel.x, pixel.y)));
    return lerp(colorA, colorB, saturate(0.5 + 0.5 * edges.x * edges.y * contrast));
}

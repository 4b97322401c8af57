// Simplex noise: the plane or space is cut into triangles or tetrahedra, and each of their corners adds a slope within its reach.
// It reads fewer corners than gradient noise, 3, 4 and 5 instead of 4, 8 and 16, and its directions are less visible. The slopes
// and their random numbers are those of perlin.node.hlsl.

// What a corner adds: its slope within a distance of sqrt(1/2). Nothing of it reaches beyond the cells that it belongs to.
float SimplexKernel(float squared) {
    float reach = max(0.5 - squared, 0);
    return reach * reach * reach * reach;
}

/// Simplex noise in a plane, from 0 to 1, around 0.5.
///
/// formula: 0.5 + 0.5 * 45.1 sum over the corners of max(1/2 - |d|^2, 0)^4 slope.d. No combination of slopes exceeds 1 / 45.1,
/// formula: which was found numerically
/// source: Perlin, "Noise Hardware", SIGGRAPH 2001 course notes; Gustavson, "Simplex Noise Demystified", 2005; McEwan et al.,
/// source: "Efficient Computational Noise in GLSL", 2012
/// test: SimplexNoise2D(float2(0, 0), 1) == 0.5
/// test: SimplexNoise2D(float2(0.3, 0.45), 4) == 0.7733131652787024
/// test: SimplexNoise2D(float2(-1.25, 7.75), 1) == 0.5960575866241975
[node("Procedural/Noise/Simplex Noise 2D")] [also("SimplexNoise", "Simplex")] [range(0, 1)] [inFloat]
float SimplexNoise2D(
    float2 uv = uv0,                 ///< texture coordinates
    [range(0, 100)] float scale = 8  ///< cells in one unit of uv
) {
    // Triangles are squares that are cut and compressed along their diagonal: by (sqrt(3) - 1) / 2, and back by (3 - sqrt(3)) / 6.
    float2 place = uv * scale;
    float2 corner = floor(place + dot(place, float2(0.3660254037844386)));
    float2 first = place - corner + dot(corner, float2(0.21132486540518713));
    int2 cell = int2(corner);
    int2 middle = first.x > first.y ? int2(1, 0) : int2(0, 1);
    float2 second = first - float2(middle) + 0.21132486540518713;
    float2 third = first - 1 + 0.42264973081037427;
    float sum = SimplexKernel(dot(first, first)) * PerlinSlope2(HashOf2(cell.x, cell.y), first.x, first.y);
    sum += SimplexKernel(dot(second, second)) *
           PerlinSlope2(HashOf2(cell.x + middle.x, cell.y + middle.y), second.x, second.y);
    sum += SimplexKernel(dot(third, third)) * PerlinSlope2(HashOf2(cell.x + 1, cell.y + 1), third.x, third.y);
    return 0.5 + 0.5 * 45.1 * sum;
}

// A corner of a tetrahedron, `count` steps from the first one.
[inFloat]
float SimplexCorner3(int3 cell, float3 first, int3 step, float count) {
    float3 d = first - float3(step) + count / 6;
    int3 at = cell + step;
    return SimplexKernel(dot(d, d)) * PerlinSlope3(HashOf3(at.x, at.y, at.z), d.x, d.y, d.z);
}

/// Simplex noise in space, from 0 to 1, around 0.5.
///
/// formula: as SimplexNoise2D, with the factor 76.8
/// source: as SimplexNoise2D
/// test: SimplexNoise3D(float3(0, 0, 0), 1) == 0.5
/// test: SimplexNoise3D(float3(0.3, 0.45, 0.7), 4) == 0.5000607067654324
/// test: SimplexNoise3D(float3(-1.25, 7.75, 2.5), 1) == 0.8093749999999997
[node("Procedural/Noise/Simplex Noise 3D")] [also("Simplex3D")] [range(0, 1)] [inFloat]
float SimplexNoise3D(
    float3 position = positionOS,    ///< where
    [range(0, 100)] float scale = 4  ///< cells in one unit
) {
    // Tetrahedra are cubes that are cut into six and compressed along their diagonal: by 1/3, and back by 1/6.
    float3 place = position * scale;
    float3 corner = floor(place + dot(place, float3(1)) / 3);
    float3 first = place - corner + dot(corner, float3(1)) / 6;
    int3 cell = int3(corner);
    // A coordinate's rank is how many others are smaller; the path to the last corner steps along the largest one first.
    float xy = step(first.y, first.x);
    float xz = step(first.z, first.x);
    float yz = step(first.z, first.y);
    float3 rank = float3(xy + xz, 1 - xy + yz, 2 - xz - yz);
    int3 second = int3(step(2, rank));
    int3 third = int3(step(1, rank));
    float sum = SimplexCorner3(cell, first, int3(0, 0, 0), 0) + SimplexCorner3(cell, first, second, 1) +
                SimplexCorner3(cell, first, third, 2) + SimplexCorner3(cell, first, int3(1, 1, 1), 3);
    return 0.5 + 0.5 * 76.8 * sum;
}

[inFloat]
float SimplexCorner4(int4 cell, float4 first, int4 step, float count) {
    float4 d = first - float4(step) + count * 0.13819660112501053;
    int4 at = cell + step;
    return SimplexKernel(dot(d, d)) * PerlinSlope4(HashOf4(at.x, at.y, at.z, at.w), d.x, d.y, d.z, d.w);
}

/// Simplex noise in four dimensions, from 0 to 1, around 0.5: noise in space that changes with time.
///
/// formula: as SimplexNoise2D, with the factor 62.7
/// source: as SimplexNoise2D
/// test: SimplexNoise4D(float4(0, 0, 0, 0), 1) == 0.5
/// test: SimplexNoise4D(float4(0.3, 0.45, 0.7, 0.2), 4) == 0.24834873302931482
/// test: SimplexNoise4D(float4(-1.25, 7.75, 2.5, 3.25), 1) == 0.5361019346544196
[node("Procedural/Noise/Simplex Noise 4D")] [also("Simplex4D")] [range(0, 1)] [inFloat]
float SimplexNoise4D(
    float4 position,                 ///< a place, and the time as the fourth number
    [range(0, 100)] float scale = 4  ///< cells in one unit
) {
    // As in space, by (sqrt(5) - 1) / 4 and (5 - sqrt(5)) / 20.
    float4 place = position * scale;
    float4 corner = floor(place + dot(place, float4(0.30901699437494745)));
    float4 first = place - corner + dot(corner, float4(0.13819660112501053));
    int4 cell = int4(corner);
    float3 x = step(first.yzw, first.x);
    float2 y = step(first.zw, first.y);
    float z = step(first.w, first.z);
    float4 rank = float4(x.x + x.y + x.z, 1 - x.x + y.x + y.y, 2 - x.y - y.x + z, 3 - x.z - y.y - z);
    float sum = SimplexCorner4(cell, first, int4(0, 0, 0, 0), 0) + SimplexCorner4(cell, first, int4(step(3, rank)), 1) +
                SimplexCorner4(cell, first, int4(step(2, rank)), 2) + SimplexCorner4(cell, first, int4(step(1, rank)), 3) +
                SimplexCorner4(cell, first, int4(1, 1, 1, 1), 4);
    return 0.5 + 0.5 * 62.7 * sum;
}

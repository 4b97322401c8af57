// Textures that repeat without showing it: the plane is covered with triangles, each corner reads the texture at a place of its own,
// and the three corners around a point are blended. A texture is sampled three times. Sand, grass, bark and concrete suit it;
// bricks and other regular patterns do not.

/// The triangle of a point: its corners, as cells of a skewed lattice, and how near the point is to each.
struct HexTriangle {
    float3 weights;  ///< of the three corners; their sum is 1
    float2 first;    ///< a cell
    float2 second;   ///< a cell
    float2 third;    ///< a cell
};

// The lattice has the axes (1, 0) and (1/2, sqrt(3)/2). Within a cell, the line from (1, 0) to (0, 1) parts two triangles; the
// weights are the barycentric coordinates.
HexTriangle HexTriangleAt(float2 position) {
    float2 skewed = float2(position.x - position.y * 0.57735026918962576, position.y * 1.1547005383792515);
    float2 cell = floor(skewed);
    float2 d = skewed - cell;
    bool lower = d.x + d.y < 1;
    HexTriangle result;
    result.first = lower ? cell : cell + 1;
    result.second = cell + float2(1, 0);
    result.third = cell + float2(0, 1);
    result.weights = lower ? float3(1 - d.x - d.y, d.x, d.y) : float3(d.x + d.y - 1, 1 - d.y, 1 - d.x);
    return result;
}

// Where a corner of a triangle is.
float2 HexCenter(float2 cell) {
    return float2(cell.x + 0.5 * cell.y, cell.y * 0.86602540378443865);
}

// The turn of a corner's copy: cosine and sine.
float2 HexTurn(float2 cell, float rotation) {
    float angle = (RandomAt(int2(cell) + int2(71, 13)).x * 2 - 1) * rotation;
    return float2(cos(angle), sin(angle));
}

float2 TurnedBy(float2 v, float2 turn) {
    return float2(v.x * turn.x - v.y * turn.y, v.x * turn.y + v.y * turn.x);
}

// A corner's copy of the texture: turned around the corner, and moved to a random place.
float4 HexSample(Texture2D texture, SamplerState how, float2 uv, float2 center, float2 cell, float2 turn, float2 right, float2 down) {
    float2 place = TurnedBy(uv - center, turn) + center + RandomAt(int2(cell));
    float2 tiling = texture.tiling.xy;
    return texture.SampleGrad(how, place * tiling + texture.tiling.zw, TurnedBy(right, turn) * tiling, TurnedBy(down, turn) * tiling);
}

// Nearness to the three corners, sharpened; where a copy is brighter than the others, it counts more.
float3 HexWeights(float3 nearness, float3 brightness, float contrast, float sharpness) {
    float3 weights = pow(max(nearness, 0), sharpness) * max(lerp(float3(1), brightness, contrast), 1e-4);
    return weights / max(dot(weights, 1), 1e-6);
}

/// Samples a texture that repeats without visible repetition: hexagons of it are moved, turned and blended.
///
/// formula: sum of w_i t(R_i (uv - c_i) + c_i + r_i), w_i = n_i^sharpness lerp(1, brightness_i, contrast), divided by their sum
/// source: Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(3), 2022
[node("UV/Hex Tiling")] [also("HexagonTiling", "TextureBombing", "HexTile")] [is("texel")]
float4 HexTiling(
    Texture2D texture,                           ///< texture to read; it must repeat
    float2 uv = uv0,                             ///< texture coordinates, before the texture's own tiling
    [range(0.1, 16)] float density = 3,          ///< hexagons in one unit of uv
    [range(0, 3.2)] [unit("rad")] float rotation = 0,  ///< the largest turn of a hexagon; 0 where the texture has a direction
    [range(0, 1)] float contrast = 0.6,          ///< how much a brighter copy counts more: keeps contrast in the joints
    [range(1, 16)] float sharpness = 7,          ///< the larger, the narrower the joints
    SamplerState sampler = texture.sampler       ///< how it is read; default: as the texture says
) {
    HexTriangle at = HexTriangleAt(uv * density);
    float2 right = ddx(uv);
    float2 down = ddy(uv);
    float4 a = HexSample(texture, sampler, uv, HexCenter(at.first) / density, at.first, HexTurn(at.first, rotation), right, down);
    float4 b = HexSample(texture, sampler, uv, HexCenter(at.second) / density, at.second, HexTurn(at.second, rotation), right, down);
    float4 c = HexSample(texture, sampler, uv, HexCenter(at.third) / density, at.third, HexTurn(at.third, rotation), right, down);
    float3 brightness = float3(Luminance(a.rgb), Luminance(b.rgb), Luminance(c.rgb));
    float3 weights = HexWeights(at.weights, brightness, contrast, sharpness);
    return a * weights.x + b * weights.y + c * weights.z;
}

/// Samples a normal map as HexTiling samples a texture: a normal in tangent space. With the same settings, both fit together.
///
/// The bumps of a turned copy are turned back. With a contrast of 0, colours and bumps have the same joints.
///
/// source: Mikkelsen, "Practical Real-Time Hex-Tiling", JCGT 11(3), 2022; slopes are blended instead of normals: Mikkelsen,
/// source: "Surface Gradient-Based Bump Mapping Framework", JCGT 9(3), 2020
[node("UV/Hex Tiling Normal")] [is("normalTS")]
float3 HexTilingNormal(
    [is("normalMap")] Texture2D texture,         ///< a normal map that repeats
    float2 uv = uv0,                             ///< texture coordinates, before the texture's own tiling
    [range(0.1, 16)] float density = 3,          ///< hexagons in one unit of uv
    [range(0, 3.2)] [unit("rad")] float rotation = 0,  ///< the largest turn of a hexagon
    [range(1, 16)] float sharpness = 7,          ///< the larger, the narrower the joints
    [range(-2, 2)] float strength = 1,           ///< strength of the bumps
    SamplerState sampler = texture.sampler       ///< how it is read; default: as the texture says
) {
    HexTriangle at = HexTriangleAt(uv * density);
    float2 right = ddx(uv);
    float2 down = ddy(uv);
    float2 turnA = HexTurn(at.first, rotation);
    float2 turnB = HexTurn(at.second, rotation);
    float2 turnC = HexTurn(at.third, rotation);
    float4 a = HexSample(texture, sampler, uv, HexCenter(at.first) / density, at.first, turnA, right, down);
    float4 b = HexSample(texture, sampler, uv, HexCenter(at.second) / density, at.second, turnB, right, down);
    float4 c = HexSample(texture, sampler, uv, HexCenter(at.third) / density, at.third, turnC, right, down);
    float3 weights = HexWeights(at.weights, 1, 0, sharpness);
    float2 slope = HexSlope(a, strength, turnA) * weights.x + HexSlope(b, strength, turnB) * weights.y +
                   HexSlope(c, strength, turnC) * weights.z;
    return normalize(float3(slope, 1));
}

// The slope of a bump, turned back. uv is turned from u towards v, which is down: in tangent space, whose y is up, a copy is
// turned by the opposite angle, so turning it back is a turn by the same one.
float2 HexSlope(float4 texel, float strength, float2 turn) {
    float3 normal = UnpackNormal(texel, strength);
    return TurnedBy(normal.xy / max(normal.z, 0.05), turn);
}

/// Samples a texture that repeats without visible repetition, and keeps its contrast: three moved copies are blended so that the
/// result varies around the texture's mean as much as the texture does.
///
/// The blend is right for textures whose values are distributed like a bell, as those of sand or noise; others look a little
/// flatter or harsher. The mean is the texture's smallest mip level, so it needs all its levels.
///
/// formula: m + sum w_i (t(uv + r_i) - m) / sqrt(sum w_i^2), m: the mean
/// source: Heitz and Neyret, "High-Performance By-Example Noise using a Histogram-Preserving Blending Operator", HPG 2018; without
/// source: its table: Deliot and Heitz, "Procedural Stochastic Textures by Tiling and Blending", GPU Zen 2, 2019
[node("UV/Stochastic Tiling")] [also("StochasticTexture", "StochasticSample", "TilingAndBlending")] [is("texel")]
float4 StochasticTiling(
    Texture2D texture,                      ///< texture to read; it must repeat
    float2 uv = uv0,                        ///< texture coordinates, before the texture's own tiling
    [range(0.1, 16)] float density = 3,     ///< corners of triangles in one unit of uv
    SamplerState sampler = texture.sampler  ///< how it is read; default: as the texture says
) {
    HexTriangle at = HexTriangleAt(uv * density);
    float2 right = ddx(uv);
    float2 down = ddy(uv);
    float4 mean = texture.SampleLevel(sampler, float2(0.5, 0.5), 14);
    float4 a = HexSample(texture, sampler, uv, float2(0), at.first, float2(1, 0), right, down) - mean;
    float4 b = HexSample(texture, sampler, uv, float2(0), at.second, float2(1, 0), right, down) - mean;
    float4 c = HexSample(texture, sampler, uv, float2(0), at.third, float2(1, 0), right, down) - mean;
    float4 sum = a * at.weights.x + b * at.weights.y + c * at.weights.z;
    return max(mean + sum * rsqrt(dot(at.weights, at.weights)), 0);
}

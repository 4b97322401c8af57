// Noise in space rather than on a surface: it has no seam where texture coordinates begin again, and no poles.

/// Three independent numbers for a cell of the lattice, -1 to 1.
///
/// formula: pcg3d: two rounds of v.x += v.y v.z, v.y += v.z v.x, v.z += v.x v.y on 1664525 v + 1013904223
/// source: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020
float3 latticeGradient(int3 cell) {
    uint3 v = uint3(cell) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v = v ^ (v >> 16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return float3(v >> 8u) / 8388608.0 - 1;
}

float corner(int3 cell, float3 offset, int x, int y, int z) {
    return dot(latticeGradient(cell + int3(x, y, z)), offset - float3(float(x), float(y), float(z)));
}

/// Gradient noise, zero at whole numbers.
///
/// source: Perlin, "Improving Noise", SIGGRAPH 2002
float gradientNoise(float3 position) {
    int3 cell = int3(floor(position));
    float3 offset = position - floor(position);
    float3 t = offset * offset * offset * (offset * (offset * 6 - 15) + 10);
    float low = lerp(lerp(corner(cell, offset, 0, 0, 0), corner(cell, offset, 1, 0, 0), t.x),
                     lerp(corner(cell, offset, 0, 1, 0), corner(cell, offset, 1, 1, 0), t.x), t.y);
    float high = lerp(lerp(corner(cell, offset, 0, 0, 1), corner(cell, offset, 1, 0, 1), t.x),
                      lerp(corner(cell, offset, 0, 1, 1), corner(cell, offset, 1, 1, 1), t.x), t.y);
    return lerp(low, high, t.z);
}

/// Clouds in space: five octaves of noise, 0 to 1 around 0.5.
///
/// test: Noise3(float3(1, -2, 3), 1) == 0.5
/// test: Noise3(float3(0.5, 0, -0.25), 4) == 0.5
[node("Examples/Noise 3D")]
float Noise3(
    float3 position = positionOS,   ///< where
    [range(0, 100)] float scale = 4  ///< cells of the coarsest octave in one unit
) {
    float sum = 0;
    float weight = 0.5;
    float3 place = position * scale;
    for (int i = 0; i < 5; i++) {
        sum += weight * gradientNoise(place);
        place = place * 2;
        weight = weight * 0.5;
    }
    return saturate(0.5 + 0.7 * sum);
}

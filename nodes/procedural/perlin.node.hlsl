// Gradient noise in two, three and four dimensions: a random slope at each point of a lattice, interpolated smoothly. The slopes
// are chosen by the hash of lookup3.node.hlsl. The nodes that MaterialX has too (PerlinNoise2D, PerlinFractal3D, ...) have its
// values, from about -1 to 1.

/// The height of a lattice point's slope, which is one of (+-1, +-2) and (+-2, +-1).
///
/// source: MaterialX 1.39, noise2d
float PerlinSlope2(uint hash, float x, float y) {
    uint h = hash & 7u;
    float u = h < 4u ? x : y;
    float v = 2 * (h < 4u ? y : x);
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

/// The same in space: the slope points to the middle of an edge of a cube.
///
/// source: Perlin, "Improving Noise", SIGGRAPH 2002
float PerlinSlope3(uint hash, float x, float y, float z) {
    uint h = hash & 15u;
    float u = h < 8u ? x : y;
    float v = h < 4u ? y : h == 12u || h == 14u ? x : z;
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

/// The same in four dimensions: the slope points to the middle of one of the 32 edges of a cube.
///
/// source: Gustavson, "Simplex Noise Demystified", 2005
float PerlinSlope4(uint hash, float x, float y, float z, float w) {
    uint h = hash & 31u;
    float a = h < 24u ? x : y;
    float b = h < 16u ? y : z;
    float c = h < 8u ? z : w;
    return ((h & 1u) != 0u ? -a : a) + ((h & 2u) != 0u ? -b : b) + ((h & 4u) != 0u ? -c : c);
}

// The interpolated heights of the four corners of a cell. `low` and `high` are the numbers of two opposite corners, so that a
// noise that repeats can give the first corner after the last one. `shift` chooses which bits of the hash are read.
[inFloat]
float PerlinCell2(int2 low, int2 high, float2 d, uint shift) {
    float2 t = LatticeFade(d);
    float lower = lerp(PerlinSlope2(HashOf2(low.x, low.y) >> shift, d.x, d.y),
                       PerlinSlope2(HashOf2(high.x, low.y) >> shift, d.x - 1, d.y), t.x);
    float upper = lerp(PerlinSlope2(HashOf2(low.x, high.y) >> shift, d.x, d.y - 1),
                       PerlinSlope2(HashOf2(high.x, high.y) >> shift, d.x - 1, d.y - 1), t.x);
    return lerp(lower, upper, t.y);
}

[inFloat]
float PerlinLayer3(int2 low, int2 high, int z, float3 d, uint shift) {
    float2 t = LatticeFade(d.xy);
    float lower = lerp(PerlinSlope3(HashOf3(low.x, low.y, z) >> shift, d.x, d.y, d.z),
                       PerlinSlope3(HashOf3(high.x, low.y, z) >> shift, d.x - 1, d.y, d.z), t.x);
    float upper = lerp(PerlinSlope3(HashOf3(low.x, high.y, z) >> shift, d.x, d.y - 1, d.z),
                       PerlinSlope3(HashOf3(high.x, high.y, z) >> shift, d.x - 1, d.y - 1, d.z), t.x);
    return lerp(lower, upper, t.y);
}

[inFloat]
float PerlinCell3(int3 low, int3 high, float3 d, uint shift) {
    return lerp(PerlinLayer3(low.xy, high.xy, low.z, d, shift),
                PerlinLayer3(low.xy, high.xy, high.z, d - float3(0, 0, 1), shift), LatticeFade(d.z));
}

// The factors bring the noise to about -1 to 1; they are those of MaterialX and, for four dimensions, of Open Shading Language.
[inFloat]
float PerlinChannel2(float2 position, uint shift) {
    float2 corner = floor(position);
    int2 cell = int2(corner);
    return 0.6616 * PerlinCell2(cell, cell + 1, position - corner, shift);
}

[inFloat]
float PerlinChannel3(float3 position, uint shift) {
    float3 corner = floor(position);
    int3 cell = int3(corner);
    return 0.982 * PerlinCell3(cell, cell + 1, position - corner, shift);
}

/// Gradient noise in a plane, from about -1 to 1: MaterialX's `noise2d`.
///
/// formula: 0.6616 times the interpolated heights of the slopes (+-1, +-2) and (+-2, +-1)
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; MaterialX 1.39, noise2d
/// test: PerlinNoise2D(float2(0.3, 0.45)) == 0.162413265756003
/// test: PerlinNoise2D(float2(-1.25, 7.75)) == -0.4147391876220703
[node("Procedural/Noise/Perlin Noise 2D")] [also("Noise2D")] [inFloat]
float PerlinNoise2D(
    float2 position = uv0  ///< where; the cells of the lattice are one unit wide
) {
    return PerlinChannel2(position, 0u);
}

/// Three gradient noises in a plane, each from about -1 to 1: MaterialX's `noise2d` of vectors and colours.
///
/// formula: as PerlinNoise2D; the first, second and third byte of the hash choose the slopes
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; MaterialX 1.39, noise2d
/// test: PerlinNoise2DVector(float2(-1.25, 7.75)) == float3(-0.4147391876220703, -0.14888044281005858, -0.5882948593139649)
/// test: PerlinNoise2DVector(float2(3, -2)) == float3(0, 0, 0)
[node("Procedural/Noise/Perlin Noise 2D Vector")] [inFloat]
float3 PerlinNoise2DVector(
    float2 position = uv0  ///< where; the cells of the lattice are one unit wide
) {
    return float3(PerlinChannel2(position, 0u), PerlinChannel2(position, 8u), PerlinChannel2(position, 16u));
}

/// Gradient noise in space, from about -1 to 1: MaterialX's `noise3d`. It has no seams and no poles.
///
/// formula: 0.982 times the interpolated heights of slopes to the middles of a cube's edges
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; MaterialX 1.39, noise3d
/// test: PerlinNoise3D(float3(0.3, 0.45, 0.7)) == 0.2226468976867436
/// test: PerlinNoise3D(float3(-1.25, 7.75, 2.5)) == -0.03380419921875
[node("Procedural/Noise/Perlin Noise 3D")] [also("Noise3D", "Perlin3D")] [inFloat]
float PerlinNoise3D(
    float3 position = positionOS  ///< where; the cells of the lattice are one unit wide
) {
    return PerlinChannel3(position, 0u);
}

/// Three gradient noises in space, each from about -1 to 1: MaterialX's `noise3d` of vectors and colours.
///
/// formula: as PerlinNoise3D; the first, second and third byte of the hash choose the slopes
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; MaterialX 1.39, noise3d
/// test: PerlinNoise3DVector(float3(-1.25, 7.75, 2.5)) == float3(-0.03380419921875, -0.35291280555725096, 0.31253197765350343)
/// test: PerlinNoise3DVector(float3(3, -2, 5)) == float3(0, 0, 0)
[node("Procedural/Noise/Perlin Noise 3D Vector")] [inFloat]
float3 PerlinNoise3DVector(
    float3 position = positionOS  ///< where; the cells of the lattice are one unit wide
) {
    return float3(PerlinChannel3(position, 0u), PerlinChannel3(position, 8u), PerlinChannel3(position, 16u));
}

/// Gradient noise in four dimensions, from about -1 to 1: noise in space that changes with time.
///
/// formula: 0.8344 times the interpolated heights of slopes to the middles of the edges of a cube of four dimensions
/// source: Perlin, "Improving Noise", SIGGRAPH 2002; Open Shading Language, snoise of a point and a time
/// test: PerlinNoise4D(float4(3, -2, 5, 1)) == 0
/// test: PerlinNoise4D(float4(0.3, 0.45, 0.7, 0.2)) == 0.12581009114806344
/// test: PerlinNoise4D(float4(-1.25, 7.75, 2.5, 3.25)) == 0.20234626522883772
[node("Procedural/Noise/Perlin Noise 4D")] [also("Noise4D", "Perlin4D")] [inFloat]
float PerlinNoise4D(
    float4 position  ///< a place, and the time as the fourth number
) {
    float4 corner = floor(position);
    int4 cell = int4(corner);
    float4 d = position - corner;
    float4 t = LatticeFade(d);
    float noise = 0;
    [unroll] for (int i = 0; i < 16; i++) {
        int4 step = int4(i & 1, (i >> 1) & 1, (i >> 2) & 1, i >> 3);
        int4 at = cell + step;
        float4 away = d - float4(step);
        float4 share = lerp(1 - t, t, float4(step));
        noise += share.x * share.y * share.z * share.w *
                 PerlinSlope4(HashOf4(at.x, at.y, at.z, at.w), away.x, away.y, away.z, away.w);
    }
    return 0.8344 * noise;
}

/// Layers of ever finer gradient noise in a plane, around 0: MaterialX's `fractal2d`.
///
/// formula: sum of gain^i noise(lacunarity^i p)
/// source: Musgrave, in Ebert et al., "Texturing and Modeling", 2003, chapter 16 (fBm); MaterialX 1.39, fractal2d
/// test: PerlinFractal2D(float2(0.3, 0.45), 3, 2, 0.5) == 0.26213917358883493
/// test: PerlinFractal2D(float2(-1.25, 7.75), 1) == -0.4147391876220703
[node("Procedural/Noise/Perlin Fractal 2D")] [also("Fractal2D")] [inFloat]
float PerlinFractal2D(
    float2 position = uv0,               ///< where; the cells of the coarsest lattice are one unit wide
    [range(0, 16)] int octaves = 3,      ///< how many layers of noise, 16 at most
    [range(1, 4)] float lacunarity = 2,  ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5       ///< height of each layer as a fraction of the previous one; MaterialX's `diminish`
) {
    float sum = 0;
    float amplitude = 1;
    float2 at = position;
    for (int i = 0; i < min(octaves, 16); i++) {
        sum += amplitude * PerlinNoise2D(at);
        amplitude *= gain;
        at *= lacunarity;
    }
    return sum;
}

/// Three sums of layers of gradient noise in a plane: MaterialX's `fractal2d` of vectors and colours.
///
/// formula: as PerlinFractal2D, of PerlinNoise2DVector
/// source: Musgrave, in Ebert et al., "Texturing and Modeling", 2003, chapter 16 (fBm); MaterialX 1.39, fractal2d
/// test: PerlinFractal2DVector(float2(0.3, 0.45), 3, 2, 0.5) == float3(0.26213917358883493, 0.9559134228479428, -0.41040932322394513)
/// test: PerlinFractal2DVector(float2(-1.25, 7.75), 1) == float3(-0.4147391876220703, -0.14888044281005858, -0.5882948593139649)
[node("Procedural/Noise/Perlin Fractal 2D Vector")] [inFloat]
float3 PerlinFractal2DVector(
    float2 position = uv0,               ///< where; the cells of the coarsest lattice are one unit wide
    [range(0, 16)] int octaves = 3,      ///< how many layers of noise, 16 at most
    [range(1, 4)] float lacunarity = 2,  ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5       ///< height of each layer as a fraction of the previous one
) {
    float3 sum = 0;
    float amplitude = 1;
    float2 at = position;
    for (int i = 0; i < min(octaves, 16); i++) {
        sum += amplitude * PerlinNoise2DVector(at);
        amplitude *= gain;
        at *= lacunarity;
    }
    return sum;
}

/// Layers of ever finer gradient noise in space, around 0: MaterialX's `fractal3d`.
///
/// formula: sum of gain^i noise(lacunarity^i p)
/// source: Musgrave, in Ebert et al., "Texturing and Modeling", 2003, chapter 16 (fBm); MaterialX 1.39, fractal3d
/// test: PerlinFractal3D(float3(0.3, 0.45, 0.7), 4, 2, 0.5) == 0.29472767090639446
/// test: PerlinFractal3D(float3(-1.25, 7.75, 2.5), 1) == -0.03380419921875
[node("Procedural/Noise/Perlin Fractal 3D")] [also("Fractal3D")] [inFloat]
float PerlinFractal3D(
    float3 position = positionOS,        ///< where; the cells of the coarsest lattice are one unit wide
    [range(0, 16)] int octaves = 3,      ///< how many layers of noise, 16 at most
    [range(1, 4)] float lacunarity = 2,  ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5       ///< height of each layer as a fraction of the previous one; MaterialX's `diminish`
) {
    float sum = 0;
    float amplitude = 1;
    float3 at = position;
    for (int i = 0; i < min(octaves, 16); i++) {
        sum += amplitude * PerlinNoise3D(at);
        amplitude *= gain;
        at *= lacunarity;
    }
    return sum;
}

/// Three sums of layers of gradient noise in space: MaterialX's `fractal3d` of vectors and colours.
///
/// formula: as PerlinFractal3D, of PerlinNoise3DVector
/// source: Musgrave, in Ebert et al., "Texturing and Modeling", 2003, chapter 16 (fBm); MaterialX 1.39, fractal3d
/// test: PerlinFractal3DVector(float3(0.3, 0.45, 0.7), 3, 2, 0.5) == float3(0.2960960272982469, -0.8020272276767495, -0.05610100081413897)
/// test: PerlinFractal3DVector(float3(-1.25, 7.75, 2.5), 1) == float3(-0.03380419921875, -0.35291280555725096, 0.31253197765350343)
[node("Procedural/Noise/Perlin Fractal 3D Vector")] [inFloat]
float3 PerlinFractal3DVector(
    float3 position = positionOS,        ///< where; the cells of the coarsest lattice are one unit wide
    [range(0, 16)] int octaves = 3,      ///< how many layers of noise, 16 at most
    [range(1, 4)] float lacunarity = 2,  ///< how much finer each layer is than the previous one
    [range(0, 1)] float gain = 0.5       ///< height of each layer as a fraction of the previous one
) {
    float3 sum = 0;
    float amplitude = 1;
    float3 at = position;
    for (int i = 0; i < min(octaves, 16); i++) {
        sum += amplitude * PerlinNoise3DVector(at);
        amplitude *= gain;
        at *= lacunarity;
    }
    return sum;
}

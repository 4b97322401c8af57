// Random numbers of lattice cells, by the hash that MaterialX and Open Shading Language use. A node of this file, of
// perlin.node.hlsl and of points.node.hlsl that is named in their standard libraries has the same values as theirs, so that a
// material looks the same in other programs. Coordinates must fit into an int.

uint RotatedLeft(uint bits, uint count) {
    return (bits << count) | (bits >> (32u - count));
}

/// The last step of the hash.
///
/// source: Jenkins, "lookup3.c", 2006: final()
uint HashEnd(uint first, uint second, uint third) {
    uint a = first;
    uint b = second;
    uint c = third;
    c = (c ^ b) - RotatedLeft(b, 14u);
    a = (a ^ c) - RotatedLeft(c, 11u);
    b = (b ^ a) - RotatedLeft(a, 25u);
    c = (c ^ b) - RotatedLeft(b, 16u);
    a = (a ^ c) - RotatedLeft(c, 4u);
    b = (b ^ a) - RotatedLeft(a, 14u);
    c = (c ^ b) - RotatedLeft(b, 24u);
    return c;
}

// The hash of n numbers begins with 0xdeadbeef + 4 n + 13.
uint HashOf1(int x) {
    return HashEnd(3735928576u + uint(x), 3735928576u, 3735928576u);
}

uint HashOf2(int x, int y) {
    return HashEnd(3735928580u + uint(x), 3735928580u + uint(y), 3735928580u);
}

uint HashOf3(int x, int y, int z) {
    return HashEnd(3735928584u + uint(x), 3735928584u + uint(y), 3735928584u + uint(z));
}

/// The hash of four numbers: three are mixed before the last one is added.
///
/// source: Jenkins, "lookup3.c", 2006: mix() and final()
uint HashOf4(int x, int y, int z, int w) {
    uint a = 3735928588u + uint(x);
    uint b = 3735928588u + uint(y);
    uint c = 3735928588u + uint(z);
    a = (a - c) ^ RotatedLeft(c, 4u);
    c += b;
    b = (b - a) ^ RotatedLeft(a, 6u);
    a += c;
    c = (c - b) ^ RotatedLeft(b, 8u);
    b += a;
    a = (a - c) ^ RotatedLeft(c, 16u);
    c += b;
    b = (b - a) ^ RotatedLeft(a, 19u);
    a += c;
    c = (c - b) ^ RotatedLeft(b, 4u);
    b += a;
    return HashEnd(a + uint(w), b, c);
}

// A fraction of the largest number with 32 bits.
[inFloat]
float FractionOf(uint bits) {
    return float(bits) / 4294967295.0;
}

// A random number for a cell of space, from 0 to 1: CellNoise3D of whole numbers.
[inFloat]
float RandomOf(int3 cell) {
    return FractionOf(HashOf3(cell.x, cell.y, cell.z));
}

/// A random number for each cell of a line, from 0 to 1.
///
/// source: Jenkins, "lookup3.c", 2006 (the hash); MaterialX 1.39: the cell noise of one number
/// test: CellNoise1D(0.5) == 0.5824258563999147
/// test: CellNoise1D(-7.25) == 0.8001946028788096
[node("Procedural/Noise/Cell Noise 1D")] [range(0, 1)] [inFloat]
float CellNoise1D(
    float position  ///< anywhere in the cell; cells are one unit wide and begin at whole numbers
) {
    return FractionOf(HashOf1(int(floor(position))));
}

/// A random number for each cell of a plane, from 0 to 1: MaterialX's `cellnoise2d`.
///
/// source: Jenkins, "lookup3.c", 2006 (the hash); MaterialX 1.39, cellnoise2d
/// test: CellNoise2D(float2(-1.25, 7.75)) == 0.06009313721677594
/// test: CellNoise2D(float2(0.5, 0.5)) == 0.8603127584467439
[node("Procedural/Noise/Cell Noise 2D")] [range(0, 1)] [inFloat]
float CellNoise2D(
    float2 position = uv0  ///< anywhere in the cell; cells are one unit wide and begin at whole numbers
) {
    int2 cell = int2(floor(position));
    return FractionOf(HashOf2(cell.x, cell.y));
}

/// A random number for each cell of space, from 0 to 1: MaterialX's `cellnoise3d`.
///
/// source: Jenkins, "lookup3.c", 2006 (the hash); MaterialX 1.39, cellnoise3d
/// test: CellNoise3D(float3(-1.25, 7.75, 2.5)) == 0.4837402348601586
/// test: CellNoise3D(float3(0.5, 0.5, 0.5)) == 0.6110676516804536
[node("Procedural/Noise/Cell Noise 3D")] [also("Random3D", "WhiteNoise3D")] [range(0, 1)] [inFloat]
float CellNoise3D(
    float3 position = positionOS  ///< anywhere in the cell; cells are one unit wide and begin at whole numbers
) {
    return RandomOf(int3(floor(position)));
}

/// A random number for each cell of a space of four dimensions, from 0 to 1.
///
/// source: Jenkins, "lookup3.c", 2006 (the hash); MaterialX 1.39: the cell noise of four numbers
/// test: CellNoise4D(float4(0.5, 0.5, 0.5, 0.5)) == 0.11157296879952144
/// test: CellNoise4D(float4(-1.25, 7.75, 2.5, 3.25)) == 0.06054584287585361
[node("Procedural/Noise/Cell Noise 4D")] [also("Random4D", "WhiteNoise4D")] [range(0, 1)] [inFloat]
float CellNoise4D(
    float4 position  ///< anywhere in the cell: a place, and the time as the fourth number
) {
    int4 cell = int4(floor(position));
    return FractionOf(HashOf4(cell.x, cell.y, cell.z, cell.w));
}

// The noise of MaterialX's standard library in the node language: gradient noise by Perlin, "Improving Noise", SIGGRAPH
// 2002, and random points of cells by Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996, both over the hash
// "lookup3" of Bob Jenkins, 2006. An import writes the parts that it uses into files beside the graph, so that the
// pictures are those of other programs: the library's own noise has another hash. An export knows the functions by
// their names (compiler/exporters/mtlx/noise.cpp).
#pragma once

#include <string_view>

namespace patina::importers::mtlx {

inline constexpr std::string_view kHash = R"(
uint RotatedLeft(uint bits, uint count) {
    return (bits << count) | (bits >> (32u - count));
}

// The last step of lookup3.
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

// The hash of two numbers begins with 0xdeadbeef + 4 * 2 + 13, and so on.
uint HashOf2(int x, int y) {
    return HashEnd(3735928580u + uint(x), 3735928580u + uint(y), 3735928580u);
}

uint HashOf3(int x, int y, int z) {
    return HashEnd(3735928584u + uint(x), 3735928584u + uint(y), 3735928584u + uint(z));
}
)";

inline constexpr std::string_view kHash4 = R"(
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
)";

// A fraction of all numbers with 32 bits.
inline constexpr std::string_view kFraction = R"(
float FractionOf(uint bits) {
    return float(bits) / 4294967295.0;
}
)";

inline constexpr std::string_view kFade = R"(
float Fade(float t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}
)";

inline constexpr std::string_view kGradient2 = R"(
// The slope of a corner is one of (+-1, +-2) and (+-2, +-1).
float CornerOf2(uint hash, float x, float y) {
    uint h = hash & 7u;
    float u = h < 4u ? x : y;
    float v = 2 * (h < 4u ? y : x);
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

// `shift` chooses which bits of the hash a channel reads.
float Gradient2(float2 position, uint shift) {
    float2 corner = floor(position);
    float2 d = position - corner;
    int x = int(corner.x);
    int y = int(corner.y);
    float u = Fade(d.x);
    float lower = lerp(CornerOf2(HashOf2(x, y) >> shift, d.x, d.y), CornerOf2(HashOf2(x + 1, y) >> shift, d.x - 1, d.y), u);
    float upper = lerp(CornerOf2(HashOf2(x, y + 1) >> shift, d.x, d.y - 1), CornerOf2(HashOf2(x + 1, y + 1) >> shift, d.x - 1, d.y - 1), u);
    return 0.6616 * lerp(lower, upper, Fade(d.y));
}
)";

inline constexpr std::string_view kGradient3 = R"(
// The slope of a corner points to the middle of an edge of a cube.
float CornerOf3(uint hash, float x, float y, float z) {
    uint h = hash & 15u;
    float u = h < 8u ? x : y;
    float v = h < 4u ? y : h == 12u || h == 14u ? x : z;
    return ((h & 1u) != 0u ? -u : u) + ((h & 2u) != 0u ? -v : v);
}

float Layer3(int x, int y, int z, float3 d, uint shift) {
    float u = Fade(d.x);
    float lower = lerp(CornerOf3(HashOf3(x, y, z) >> shift, d.x, d.y, d.z), CornerOf3(HashOf3(x + 1, y, z) >> shift, d.x - 1, d.y, d.z), u);
    float upper = lerp(CornerOf3(HashOf3(x, y + 1, z) >> shift, d.x, d.y - 1, d.z), CornerOf3(HashOf3(x + 1, y + 1, z) >> shift, d.x - 1, d.y - 1, d.z), u);
    return lerp(lower, upper, Fade(d.y));
}

// `shift` chooses which bits of the hash a channel reads.
float Gradient3(float3 position, uint shift) {
    float3 corner = floor(position);
    float3 d = position - corner;
    int x = int(corner.x);
    int y = int(corner.y);
    int z = int(corner.z);
    return 0.982 * lerp(Layer3(x, y, z, d, shift), Layer3(x, y, z + 1, d - float3(0, 0, 1), shift), Fade(d.z));
}
)";

// Templates: <N> is 2 or 3, and <tests> are lines. A function of numbers has <T> float, and one of colours has <T>
// float3, <V> "Vector", and <each>. "<noise(position)>" is the gradient noise at a place, <cell> the numbers of a cell.
inline constexpr std::string_view kNoise = R"(
/// Gradient noise of MaterialX, between about -1 and 1<each>.
///
<tests>[node("MaterialX/Noise <N>D< V>")]
<T> MaterialXNoise<N>D<V>(float<N> position) {
    return <noise(position)>;
}
)";
inline constexpr std::string_view kFractal = R"(
/// Layers of MaterialX's gradient noise<each>.
///
<tests>[node("MaterialX/Fractal <N>D< V>")]
<T> MaterialXFractal<N>D<V>(float<N> position, int octaves = 3, float lacunarity = 2, float diminish = 0.5) {
    <T> sum = 0;
    float amplitude = 1;
    float<N> at = position;
    for (int i = 0; i < min(octaves, 16); i++) {
        sum += amplitude * <noise(at)>;
        amplitude *= diminish;
        at *= lacunarity;
    }
    return sum;
}
)";
inline constexpr std::string_view kCell = R"(
/// A random number of each cell, from 0 to 1.
///
<tests>[node("MaterialX/Cell Noise <N>D")]
float MaterialXCellNoise<N>D(float<N> position) {
    float<N> cell = floor(position);
    return FractionOf(HashOf<N>(<cell>));
}
)";
inline constexpr std::string_view kWorley2 = R"(
/// The distances to the three nearest of random points, one in each cell.
///
/// test: MaterialXWorleyNoise2D(float2(0.3, 7.75), 1) == float3(0.25901410601997904, 0.43569279520638743, 1.036798050937848)
/// test: MaterialXWorleyNoise2D(float2(-1.25, 0.5), 0.5) == float3(0.4675893427607417, 0.9702049701445509, 0.989115425674556)
[node("MaterialX/Worley Noise 2D")]
float3 MaterialXWorleyNoise2D(float2 position, float jitter = 1) {
    float2 corner = floor(position);
    float2 d = position - corner;
    float3 nearest = 1e6;
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            int x = int(corner.x) + i;
            int y = int(corner.y) + j;
            float2 random = float2(FractionOf(HashOf3(x, y, 0)), FractionOf(HashOf3(x, y, 1)));
            float2 away = float2(float(i), float(j)) + (random - 0.5) * jitter + 0.5 - d;
            float squared = dot(away, away);
            float later = max(squared, nearest.x);
            nearest = float3(min(squared, nearest.x), min(max(squared, nearest.x), nearest.y), min(max(later, nearest.y), nearest.z));
        }
    }
    return sqrt(nearest);
}
)";
inline constexpr std::string_view kWorley3 = R"(
/// The distances to the three nearest of random points, one in each cell.
///
/// test: MaterialXWorleyNoise3D(float3(0.3, 7.75, -2.5), 1) == float3(0.23488026447724053, 0.4027931237885559, 0.818188452501073)
[node("MaterialX/Worley Noise 3D")]
float3 MaterialXWorleyNoise3D(float3 position, float jitter = 1) {
    float3 corner = floor(position);
    float3 d = position - corner;
    float3 nearest = 1e6;
    for (int i = -1; i < 2; i++) {
        for (int j = -1; j < 2; j++) {
            for (int k = -1; k < 2; k++) {
                int x = int(corner.x) + i;
                int y = int(corner.y) + j;
                int z = int(corner.z) + k;
                float3 random = float3(FractionOf(HashOf4(x, y, z, 0)), FractionOf(HashOf4(x, y, z, 1)), FractionOf(HashOf4(x, y, z, 2)));
                float3 away = float3(float(i), float(j), float(k)) + (random - 0.5) * jitter + 0.5 - d;
                float squared = dot(away, away);
                float later = max(squared, nearest.x);
                nearest = float3(min(squared, nearest.x), min(max(squared, nearest.x), nearest.y), min(max(later, nearest.y), nearest.z));
            }
        }
    }
    return sqrt(nearest);
}
)";

}  // namespace patina::importers::mtlx

// Light from the surroundings, in the three forms that Patina's shaders read: nine coefficients, a blurred cube map and
// the table of the split sum. It is computed on the CPU. patina::lighting is a library of its own. It needs no other
// library: no compiler, no GPU and no code that reads pictures.
//
//   patina::lighting::Environment sky = patina::lighting::prefilter({.width = 1024, .height = 512, .numbers = pixels});
//   if (!sky.error.empty()) return fail(sky.error);
//   upload(sky.levels);   fill(block.ambientSH, sky.coefficients);   upload(patina::lighting::split_sum_table());
//
// All functions may be called from any thread.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "patina/export.h"

// Light from the surroundings.
namespace patina::lighting {

// A picture of everything around a point, in linear light: equirectangular (width : height is 2:1), a cross of a cube's
// faces (4:3, 3:4) or a strip of them (6:1, 1:6). Ahead, in the middle of a 2:1 picture, is -z; to the right is +x; up
// is +y (docs/environments.md).
struct Picture {
    // Pixels.
    int width = 0, height = 0;
    // Numbers of a pixel, 3 or more. The first three are red, green and blue.
    int channels = 3;
    // width * height * channels, rows from the top. They are only read during the call. Numbers below 0 count as 0.
    std::span<const float> numbers{};
};

// How a picture becomes an environment.
struct Options {
    // Degrees that the picture is turned about y, counter-clockwise seen from above.
    double rotation = 0;
    // Factor of its light, 0 to 1e6.
    double intensity = 1;
    // Texels along a face of the first level: a power of two, 256 to 1024. 0: as fine as the picture, 256 or 512.
    int face_size = 0;
    // The result is for a world in which ahead is +z, as in Unity and often with Direct3D; else ahead is -z.
    bool is_left_handed = false;
    // Called on the calling thread with the share that is done, 0 to 1. If it throws, the work ends, and the
    // exception's text is the error.
    std::function<void(double)> progress{};
};

// A level of a cube map.
struct Level {
    // Texels along a face.
    int size = 0;
    // The perceptual roughness of the surfaces that read this level, 0 to 1.
    float roughness = 0;
    // Linear red, green, blue and 1: 4 * 6 * size * size numbers. Faces follow each other in the order +x, -x, +y, -y,
    // +z, -z, each with rows from the top, as Vulkan, Direct3D and OpenGL store cube maps.
    std::vector<float> texels{};
};

// The surroundings as light.
struct Environment {
    // Empty if all is well. Else a sentence that says what is wrong with the picture or the options, or "out of
    // memory"; then all other members are empty.
    std::string error{};
    // The value of `ambientSH`: red, green and blue of radiance for each of the nine functions of the real basis
    // without the Condon-Shortley sign, order l(l+1)+m, on the axes of the world (Ramamoorthi and Hanrahan, "An
    // Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001). Surroundings with small bright
    // lamps are smoothed until no surface receives less than no light (Sloan, "Stupid Spherical Harmonics Tricks", GDC
    // 2008).
    std::array<std::array<float, 3>, 9> coefficients{};
    // The texture `environmentMap`: six levels. Level i is for the roughness r with 5 r (1.7 - 0.7 r) = i (Karis, "Real
    // Shading in Unreal Engine 4", SIGGRAPH 2013).
    std::vector<Level> levels{};
};

// Computes the light of a picture. It takes a second or more, on up to six threads. The same picture gives the same
// numbers each time. It never throws.
PATINA_API Environment prefilter(const Picture& picture, const Options& options = {});

// The texture `splitSumTable`. It is the same for all environments.
struct SplitSumTable {
    // Texels along both sides. x is the square root of n.v, y the perceptual roughness, both from 0 to 1 at the centres
    // of the outer texels.
    int size = 0;
    // Two numbers a texel, rows from roughness 0: the reflectance of a uniform environment is f0 * first + f90 *
    // second, for GGX with Smith's exact joint visibility (Karis, SIGGRAPH 2013).
    std::vector<float> texels{};
};
// The table is computed when Patina is built, and this function copies it. It throws std::bad_alloc if there is no
// memory for the copy.
PATINA_API SplitSumTable split_sum_table();

}  // namespace patina::lighting

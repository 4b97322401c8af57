// A picture of everything around a point, as radiance from each direction.
//
// Ahead is -z, to the right is +x, up is +y: what the default camera looks at is in the middle of the picture. Shapes,
// width by height:
//   2:1   equirectangular: ahead in the middle, behind at both sides
//   4:3   horizontal cross: left, ahead, right, behind in the middle row; up above ahead, down below it
//   3:4   vertical cross: up, then left, ahead and right, then down, then behind, upside down
//   6:1, 1:6   right, left, up, down, ahead, behind; up and down have ahead at their lower and at their upper edge
// Faces of a cube are seen from its middle: the order +X, -X, +Y, -Y, +Z, -Z of cube maps, whose +Z is ahead.
//
//   Outcome<Panorama> around = panorama_of(image, "sunset.hdr");
//   if (around) around.value.radiance({0, 0, -1});   // of the middle of the picture
#pragma once

#include <string>

#include "runtime/lighting/prefilter.h"
#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

struct Panorama {
    Radiance radiance{};
    int quarter = 0;  // pixels that a quarter of a turn spans
};

// `image`: linear. Numbers below 0 become 0. A picture of another shape, or with numbers that are not finite, is
// refused; `name` is for the message, and may be empty.
Outcome<Panorama> panorama_of(Image image, const std::string& name);

// The same, turned by so many degrees about y, counter-clockwise seen from above.
Radiance turned(Radiance radiance, double degrees);

// Texels along a face of a map that is as fine as its picture.
inline constexpr int kSmallestMap = 256, kLargestMap = 512;
// The radiance on a cube. `face_size`: 0: as fine as the picture, within these limits.
Pyramid pyramid_of(const Panorama& around, int face_size = 0);
// Of all texels of its finest level; no surface receives less than no light of it.
SphericalHarmonics ambient_of(const Pyramid& pyramid);

}  // namespace patina::runtime

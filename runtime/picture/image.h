// The room `picture`: pixels in memory, their files and their comparison. It knows no scene, material or device.
//
// Pictures in memory as float RGBA (image.cpp, which needs no other library), and reading and writing their files
// (read_image.cpp and write_image.cpp: OpenImageIO). Colour encoding is explicit: load_image and save_exr keep the
// numbers as they are, save_png encodes linear light to sRGB. Not a texture: see
// mip_chain.h for mip levels, and values/textures.h for GPU formats.
//
//   Outcome<Image> image = load_image("rust.png");           // the file's own numbers, 8 bits as n / 255
//   if (image) decode_srgb(image.value);                     // now linear
//   std::string error = save_png("out.png", image.value);    // encodes once; empty: written
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/outcome.h"

namespace patina::runtime {

// Rows from the top, four floats a pixel, straight (unassociated) alpha.
struct Image {
    int width = 0, height = 0;
    int bits = 32;  // per channel in the file it came from: 8 or less says that it fits an 8-bit texture exactly
    std::vector<float> pixels{};

    std::span<float> at(int x, int y) { return {pixels.data() + 4 * (std::size_t(y) * width + x), 4}; }
    std::span<const float> at(int x, int y) const { return {pixels.data() + 4 * (std::size_t(y) * width + x), 4}; }
};

// A part of an image, in pixels from the top left.
struct PixelArea {
    int x = 0, y = 0, width = 0, height = 0;
};

inline constexpr int kLargestImage = 16384;  // pixels on a side

Image make_image(int width, int height, float red = 0, float green = 0, float blue = 0, float alpha = 1);

// The transfer function of IEC 61966-2-1, and its inverse. Odd about zero, so values below it survive a round trip.
float srgb_encode(float linear);
float srgb_decode(float encoded);
// Colour channels in place; alpha is always linear.
void encode_srgb(Image& image);
void decode_srgb(Image& image);

// Within 0..1; NaN becomes 0.
float to_unit_range(float value);
// What an 8-bit file keeps of encoded values: clamped to 0..1 and rounded to n / 255; NaN becomes 0.
Image quantized(const Image& encoded);

// Any format that OpenImageIO reads (read_image.cpp), within the limits of picture_bounds.h. One channel is a grey, two
// a grey and alpha; without alpha it is 1.
Outcome<Image> load_image(const std::string& path);
// The same from the bytes of a file; `path` says the format by its ending, and names it in messages.
Outcome<Image> decode_image(const std::string& path, std::string_view bytes);

// Bytes of files by their normal paths (std::filesystem::path::lexically_normal).
using MemoryFiles = std::map<std::string, std::string>;

// The bytes of a picture's file. Equal pictures have equal bytes: they hold no date. PNG: 8 bits, sRGB-encoded here,
// from linear values. EXR: 32-bit float, the values as they are.
Outcome<std::string> encode_png(const Image& linear);
Outcome<std::string> encode_exr(const Image& linear);
// One EXR file with several pictures. The channels R, G, B and A are the picture. Each layer has channels of its own
// ("normalWS.R"), with names as in compositing programs and OpenImageIO. 32-bit floats, the numbers as they are.
struct Layer {
    std::string name{};
    Image image{};  // as large as the picture
};
Outcome<std::string> encode_layers(const Image& picture, std::span<const Layer> layers);
// By the ending of the name: .png or .exr.
Outcome<std::string> encode_image(const std::string& path, const Image& linear);

// The same, written to a file (runtime/files): all of it or nothing. Returns nothing, or what is wrong.
std::string save_png(const std::string& path, const Image& linear);
std::string save_exr(const std::string& path, const Image& linear);
std::string save_image(const std::string& path, const Image& linear);
// For pictures whose numbers must not change, such as normals and differences: they are not encoded, and the file
// declares no colour space.
Outcome<std::string> encode_png_data(const Image& numbers);
std::string save_png_as_is(const std::string& path, const Image& encoded);

// What a PNG file says of itself, in its text chunks: keyword -> text. Keywords have 1 to 79 characters of ASCII.
using PictureNotes = std::map<std::string, std::string>;
// Colours that are encoded as sRGB already.
Outcome<std::string> encode_png_as_is(const Image& encoded, const PictureNotes& notes = {});
// None if there are none, or if the file is no picture.
PictureNotes load_notes(const std::string& path);

// Averages blocks of `factor` x `factor` pixels. Colours count by their alpha, so that a transparent background does
// not darken an edge.
Image box_filtered(const Image& image, int factor);

}  // namespace patina::runtime

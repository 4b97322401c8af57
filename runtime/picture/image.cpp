#include "runtime/picture/image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace patina::runtime {
namespace {

// OpenImageIO's own words: the first line, without the full stop.
std::string reason(std::string text) {
    text = text.substr(0, text.find('\n'));
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text.empty() ? "unknown reason" : text;
}

template <class Function>
void change_colors(Image& image, Function function) {
    for (std::size_t i = 0; i < image.pixels.size(); i++)
        if (i % 4 != 3) image.pixels[i] = function(image.pixels[i]);
}

std::string write(const std::string& path, const Image& image, OIIO::TypeDesc type, const char* color_space) {
    std::filesystem::path target(path);
    std::filesystem::path part = target;
    part.replace_extension(".part" + target.extension().string());

    auto failure = [&](const std::string& why) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        return "cannot write '" + path + "': " + reason(why);
    };
    auto output = OIIO::ImageOutput::create(part.string());
    if (!output) return failure(OIIO::geterror());
    OIIO::ImageSpec spec(image.width, image.height, 4, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("oiio:ColorSpace", color_space);
    if (!output->open(part.string(), spec)) return failure(output->geterror());
    if (!output->write_image(OIIO::TypeDesc::FLOAT, image.pixels.data())) return failure(output->geterror());
    if (!output->close()) return failure(output->geterror());

    std::error_code error;
    std::filesystem::rename(part, target, error);
    return error ? failure(error.message()) : "";
}

}  // namespace

Image make_image(int width, int height, float red, float green, float blue, float alpha) {
    Image image{.width = width, .height = height};
    image.pixels.reserve(4 * std::size_t(width) * height);
    for (std::size_t i = 0; i < std::size_t(width) * height; i++)
        image.pixels.insert(image.pixels.end(), {red, green, blue, alpha});
    return image;
}

float srgb_encode(float linear) {
    float x = std::abs(linear);
    float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
    return std::copysign(encoded, linear);
}

float srgb_decode(float encoded) {
    float x = std::abs(encoded);
    float linear = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    return std::copysign(linear, encoded);
}

void encode_srgb(Image& image) {
    change_colors(image, srgb_encode);
}
void decode_srgb(Image& image) {
    change_colors(image, srgb_decode);
}

Image quantized(const Image& encoded) {
    Image result = encoded;
    result.bits = 8;
    for (float& value : result.pixels)
        value = std::isnan(value) ? 0 : std::round(std::clamp(value, 0.0f, 1.0f) * 255) / 255;
    return result;
}

Outcome<Image> load_image(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return Failure{"cannot read '" + path + "': it is a folder"};
    if (!std::filesystem::is_regular_file(path, ignored)) return Failure{"there is no file '" + path + "'"};
    OIIO::ImageSpec straight;
    straight.attribute("oiio:UnassociatedAlpha", 1);  // a texture's alpha is data: keep the colours under it
    auto input = OIIO::ImageInput::open(path, &straight);
    if (!input) return Failure{"cannot read '" + path + "' as an image: " + reason(OIIO::geterror())};

    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1)
        return Failure{"cannot read '" + path + "' as an image: it has no pixels, or is a volume"};
    if (spec.width > kLargestImage || spec.height > kLargestImage)
        return Failure{"'" + path + "' is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                       " pixels, and the limit is " + std::to_string(kLargestImage) + " on a side"};
    int channels = std::clamp(spec.nchannels, 1, 4);
    std::size_t count = std::size_t(spec.width) * spec.height;
    std::vector<float> read(count * channels);
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, read.data()))
        return Failure{"cannot read '" + path + "' as an image: " + reason(input->geterror())};

    Image image{.width = spec.width, .height = spec.height, .bits = int(spec.format.size() * 8), .pixels = {}};
    image.pixels.reserve(count * 4);
    for (std::size_t i = 0; i < count; i++) {
        const float* p = &read[i * channels];
        bool grey = channels < 3;
        float alpha = channels == 4 ? p[3] : channels == 2 ? p[1] : 1;
        image.pixels.insert(image.pixels.end(), {p[0], grey ? p[0] : p[1], grey ? p[0] : p[2], alpha});
    }
    return image;
}

std::string save_png(const std::string& path, const Image& linear) {
    Image encoded = linear;
    encode_srgb(encoded);
    return save_png_as_is(path, encoded);
}

std::string save_png_as_is(const std::string& path, const Image& encoded) {
    return write(path, quantized(encoded), OIIO::TypeDesc::UINT8, "sRGB");
}

std::string save_exr(const std::string& path, const Image& linear) {
    return write(path, linear, OIIO::TypeDesc::FLOAT, "Linear");
}

std::string save_image(const std::string& path, const Image& linear) {
    if (path.ends_with(".png")) return save_png(path, linear);
    if (path.ends_with(".exr")) return save_exr(path, linear);
    return "cannot write '" + path + "': a picture's name ends in .png or .exr";
}

Image box_filtered(const Image& image, int factor) {
    if (factor <= 1) return image;
    Image result = make_image(image.width / factor, image.height / factor);
    for (int y = 0; y < result.height; y++) {
        for (int x = 0; x < result.width; x++) {
            std::array<double, 4> weighted{}, plain{};
            for (int j = 0; j < factor; j++) {
                for (int i = 0; i < factor; i++) {
                    std::span<const float> pixel = image.at(x * factor + i, y * factor + j);
                    double weight = std::max(pixel[3], 0.0f);
                    for (int c = 0; c < 3; c++) weighted[c] += pixel[c] * weight;
                    weighted[3] += weight;
                    for (int c = 0; c < 4; c++) plain[c] += pixel[c];
                }
            }
            double count = double(factor) * factor;
            std::span<float> out = result.at(x, y);
            for (int c = 0; c < 3; c++) out[c] = float(weighted[3] > 0 ? weighted[c] / weighted[3] : plain[c] / count);
            out[3] = float(plain[3] / count);
        }
    }
    return result;
}

}  // namespace patina::runtime

// Pictures to files.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include "runtime/files/files.h"
#include "runtime/picture/image.h"
#include "runtime/picture/openimageio.h"

namespace patina::runtime {
namespace {

// Takes what OpenImageIO writes, without a copy of it.
class StringOutput : public OIIO::Filesystem::IOProxy {
public:
    explicit StringOutput(std::string& bytes) : IOProxy("", Write), bytes_(bytes) {}
    const char* proxytype() const override { return "string"; }
    std::size_t write(const void* from, std::size_t size) override {
        const std::size_t written = pwrite(from, size, m_pos);
        m_pos += std::int64_t(written);
        return written;
    }
    std::size_t pwrite(const void* from, std::size_t size, std::int64_t offset) override {
        const std::size_t begin = std::size_t(offset);
        if (bytes_.size() < begin + size) bytes_.resize(begin + size);
        std::memcpy(bytes_.data() + begin, from, size);
        return size;
    }
    std::size_t size() const override { return bytes_.size(); }

private:
    std::string& bytes_;
};

// `write` gives the pixels to the open file; false: it could not. OpenImageIO chooses the format by the ending of
// `name`.
Outcome<std::string> encode(const char* name, const OIIO::ImageSpec& spec,
                            const std::function<bool(OIIO::ImageOutput&)>& write) {
    std::string bytes;
    StringOutput memory(bytes);
    auto output = OIIO::ImageOutput::create(name);
    if (!output) return Failure{reason(OIIO::geterror())};
    const bool made = output->set_ioproxy(&memory) && output->open(name, spec) && write(*output) && output->close();
    if (!made) return Failure{reason(output->geterror())};
    return bytes;
}

// `color_space`: what the file says of its numbers. Null: nothing.
OIIO::ImageSpec spec_of(const Image& image, OIIO::TypeDesc type, const char* color_space) {
    OIIO::ImageSpec spec(image.width, image.height, 4, type);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (color_space) spec.attribute("oiio:ColorSpace", color_space);
    return spec;
}

constexpr const char* kSrgb = "sRGB";

// Row after row, so that no second picture is made. `encoding` is applied to the colours, and not to alpha.
Outcome<std::string> encode_png_with(const Image& image, float (*encoding)(float), const char* color_space,
                                     const PictureNotes& notes = {}) {
    const auto write = [&](OIIO::ImageOutput& output) {
        std::vector<unsigned char> row(4 * std::size_t(image.width));
        for (int y = 0; y < image.height; y++) {
            const float* from = image.at(0, y).data();
            for (std::size_t i = 0; i < row.size(); i++) {
                const float value = i % 4 != 3 && encoding ? encoding(from[i]) : from[i];
                row[i] = static_cast<unsigned char>(std::round(to_unit_range(value) * 255));
            }
            if (!output.write_scanline(y, 0, OIIO::TypeDesc::UINT8, row.data())) return false;
        }
        return true;
    };
    OIIO::ImageSpec spec = spec_of(image, OIIO::TypeDesc::UINT8, color_space);
    for (const auto& [keyword, text] : notes) spec.attribute(keyword, text);
    return encode("picture.png", spec, write);
}

std::string save(const std::string& path, Outcome<std::string> bytes) {
    if (!bytes) return "cannot write '" + path + "': " + bytes.error;
    return write_file(path, std::move(bytes.value));
}

}  // namespace

Outcome<std::string> encode_png(const Image& linear) {
    return encode_png_with(linear, srgb_encode, kSrgb);
}

Outcome<std::string> encode_exr(const Image& linear) {
    OIIO::ImageSpec spec = spec_of(linear, OIIO::TypeDesc::FLOAT, "Linear");
    spec.attribute("DateTime", "");  // without this, OpenImageIO writes the time of day
    return encode("picture.exr", spec, [&](OIIO::ImageOutput& output) {
        return output.write_image(OIIO::TypeDesc::FLOAT, linear.pixels.data());
    });
}

Outcome<std::string> encode_layers(const Image& picture, std::span<const Layer> layers) {
    OIIO::ImageSpec spec = spec_of(picture, OIIO::TypeDesc::FLOAT, "Linear");
    spec.attribute("DateTime", "");
    for (const Layer& layer : layers) {
        if (layer.image.width != picture.width || layer.image.height != picture.height)
            return Failure{"the layer '" + layer.name + "' has another size than the picture"};
        for (const char* channel : {"R", "G", "B", "A"}) spec.channelnames.push_back(layer.name + "." + channel);
    }
    spec.nchannels = int(spec.channelnames.size());
    const std::size_t pixels = std::size_t(picture.width) * std::size_t(picture.height);
    std::vector<float> all;
    all.reserve(pixels * spec.channelnames.size());
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto add = [&](const Image& image) {
            all.insert(all.end(), image.pixels.begin() + std::ptrdiff_t(4 * i),
                       image.pixels.begin() + std::ptrdiff_t(4 * i + 4));
        };
        add(picture);
        for (const Layer& layer : layers) add(layer.image);
    }
    return encode("picture.exr", spec,
                  [&](OIIO::ImageOutput& output) { return output.write_image(OIIO::TypeDesc::FLOAT, all.data()); });
}

Outcome<std::string> encode_image(const std::string& path, const Image& linear) {
    if (path.ends_with(".png")) return encode_png(linear);
    if (path.ends_with(".exr")) return encode_exr(linear);
    return Failure{"a picture's name ends in .png or .exr"};
}

std::string save_png(const std::string& path, const Image& linear) {
    return save(path, encode_png(linear));
}

std::string save_png_as_is(const std::string& path, const Image& encoded) {
    return save(path, encode_png_data(encoded));
}

Outcome<std::string> encode_png_as_is(const Image& encoded, const PictureNotes& notes) {
    return encode_png_with(encoded, nullptr, kSrgb, notes);
}

Outcome<std::string> encode_png_data(const Image& numbers) {
    return encode_png_with(numbers, nullptr, nullptr);
}

std::string save_exr(const std::string& path, const Image& linear) {
    return save(path, encode_exr(linear));
}

std::string save_image(const std::string& path, const Image& linear) {
    return save(path, encode_image(path, linear));
}

}  // namespace patina::runtime

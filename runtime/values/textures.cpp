#include "runtime/values/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <mutex>

#include "patina/complaints.h"
#include "runtime/lighting/split_sum.h"
#include "runtime/picture/formats/stated_space.h"
#include "runtime/picture/picture_bounds.h"
#include "runtime/values/texture_layers.h"

namespace patina::runtime {
namespace {

Outcome<Image> image_at(const std::string& source, const MemoryFiles* in_memory) {
    const auto found = in_memory ? in_memory->find(source) : MemoryFiles::const_iterator();
    return in_memory && found != in_memory->end() ? decode_image(source, found->second) : load_image(source);
}

// The layers and levels of a linear picture. A named default is one texel everywhere.
Outcome<TextureData> data_of(const Texture& texture, Image image, const std::string& source, bool is_named) {
    const auto with = [&](std::vector<TextureLevel> levels, std::size_t layers) {
        return TextureData{.levels = std::move(levels), .sampler = texture.sampler, .layers = int(layers)};
    };
    if (texture.dimension == TextureDimension::Flat) return with(mip_chain(std::move(image)), 1);
    const bool is_cube = texture.dimension == TextureDimension::Cube;
    Outcome<std::vector<Image>> layers = is_cube
                                             ? cube_faces(std::move(image), source)
                                             : grid_layers(image, is_named ? std::array{1, 1} : texture.grid, source);
    if (!layers) return Failure{layers.error};
    if (texture.dimension == TextureDimension::Volume) return with(volume_mip_chain(layers.value), 1);
    return with(mip_chain(layers.value), layers.value.size());
}

// What to do if a file declares another colour space than the one in which it is read; empty: it does not.
std::string color_space_remark(const Texture& texture, const std::string& source, bool fits_8_bits) {
    const StatedSpace stated = stated_space(source);
    const bool is_color = texture.usage == TextureUsage::Color, is_decoded = is_color && fits_8_bits;
    if (stated.space == ColorSpace::None || is_decoded == (stated.space == ColorSpace::Srgb)) return "";
    // Numbers that are data are no light, but neither are they encoded.
    const char* const read = is_decoded ? "a colour, decoded from sRGB"
                             : is_color ? "linear light, because it has more than 8 bits a channel"
                                        : "numbers that are not decoded";
    const char* const advice = is_decoded ? "write \"usage\": \"data\", or save the file encoded as sRGB"
                               : is_color ? "save the file with 8 bits a channel, or as linear light"
                                          : "write \"usage\": \"color\", or save the file without a colour space";
    return patina::complaint(Complaint::OtherColorSpace,
                             {texture.name, read, source,
                              stated.space == ColorSpace::Srgb ? "encoded as sRGB" : "linear", stated.by, advice})
        .message;
}

Outcome<LoadedTexture> load_texture(const Texture& texture, const std::string& source, bool exact,
                                    const MemoryFiles* in_memory, std::vector<TextureRemark>& warnings) {
    Image image = default_texture(source);
    const bool is_named = !image.pixels.empty();
    if (!is_named) {
        Outcome<Image> loaded = image_at(source, in_memory);
        if (!loaded) return Failure{"texture '" + texture.name + "': " + loaded.error};
        image = std::move(loaded.value);
    }
    bool is_color = texture.usage == TextureUsage::Color;
    bool fits_8_bits = image.bits <= 8;
    std::string remark = is_named || in_memory ? "" : color_space_remark(texture, source, fits_8_bits);
    if (!remark.empty()) warnings.push_back({texture.name, std::move(remark)});
    // Pictures with more bits are taken as linear already.
    if (is_color && (fits_8_bits || is_named)) decode_srgb(image);

    Outcome<TextureData> data = data_of(texture, std::move(image), source, is_named);
    if (!data) return Failure{"texture '" + texture.name + "': " + data.error};
    TexelFormat format = exact || !fits_8_bits ? TexelFormat::Float32
                         : is_color            ? TexelFormat::Srgb8
                                               : TexelFormat::Unorm8;
    return LoadedTexture{.name = texture.name,
                         .data = std::make_shared<const TextureData>(std::move(data.value)),
                         .format = format,
                         .dimension = texture.dimension};
}

// All pictures of a material together. Materials have some dozen, of which few are as large as one may be.
Outcome<LoadedTexture> within_budget(LoadedTexture texture, const std::string& source, std::size_t& pixels) {
    constexpr std::size_t kPictures = 4;
    const TextureLevel& finest = texture.data->levels.front();
    pixels += finest.texels.size() / 4;
    const std::size_t most = kPictures * most_pixels();
    if (pixels <= most) return texture;
    return Failure{fmt::format(
        "texture '{}': with '{}' the pictures of the material have {} pixels, and the limit is {} in all: --max-pixels "
        "allows another number",
        texture.name, source, pixels, most)};
}

// The default as a name or as a file that can be opened.
std::string default_source(const Texture& texture, const std::string& graph_folder) {
    if (texture.default_texture != TextureDefault::File) return texture.default_text();
    return (std::filesystem::path(graph_folder) / texture.default_file).lexically_normal().generic_string();
}

// Blurring takes half a second, and all materials of a scene ask for the same map: the last one is kept.
std::shared_ptr<const TextureData> map_of(const SphericalHarmonics& ambient) {
    struct Kept {
        std::mutex mutex;
        SphericalHarmonics ambient;
        std::shared_ptr<const TextureData> map;
    };
    static Kept kept;
    const std::lock_guard lock(kept.mutex);
    if (!kept.map || kept.ambient.coefficients != ambient.coefficients) {
        kept.ambient = ambient;
        kept.map = Environment(ambient).map();
    }
    return kept.map;
}

// Texels along a face of a cube, so that in the middle of a picture each pixel sees one.
int picture_size(const Scene& scene) {
    constexpr float kSmallest = 256, kLargest = 1280;  // a picture of 4096 x 2048 pixels at its own resolution
    const float tangent = std::tan(glm::radians(scene.camera.fov) / 2);
    return int(std::clamp(float(scene.height) / tangent, kSmallest, kLargest));
}

std::shared_ptr<const TextureData> engine_texture(const std::string& name, const Scene& scene) {
    if (name == "splitSumTable") return split_sum_table();
    if (name == "backdropMap" && scene.environment) return scene.environment->picture(picture_size(scene));
    if (name != "backdropMap" && name != "environmentMap" && name != "probeMap") return nullptr;
    return scene.environment ? scene.environment->map() : map_of(scene.ambient);
}

}  // namespace

Image default_texture(const std::string& name) {
    Image image;
    if (name == "white") image = make_image(1, 1, 1, 1, 1);
    if (name == "black") image = make_image(1, 1, 0, 0, 0);
    if (name == "gray") image = make_image(1, 1, 0.5f, 0.5f, 0.5f);
    if (name == "bump") image = make_image(1, 1, 0.5f, 0.5f, 1);
    return image;
}

void add_engine_textures(std::vector<LoadedTexture>& textures, const Reflection& reflection, const Scene& scene) {
    for (const Texture& texture : reflection.textures) {
        if (texture.is_material) continue;
        bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
            return std::count(pass.textures.begin(), pass.textures.end(), texture.name) > 0;
        });
        std::shared_ptr<const TextureData> data = is_read ? engine_texture(texture.name, scene) : nullptr;
        if (data) textures.push_back({.name = texture.name, .data = std::move(data), .dimension = texture.dimension});
    }
}

LoadedTextures load_textures(const Reflection& reflection, const std::string& graph_folder,
                             const std::map<std::string, std::string>& files, bool exact,
                             const MemoryFiles* in_memory) {
    LoadedTextures result;
    std::size_t pixels = 0;  // of all so far
    for (const Texture& texture : reflection.textures) {
        if (!texture.is_material) continue;
        auto chosen = files.find(texture.name);
        const std::string source = chosen == files.end() ? default_source(texture, graph_folder) : chosen->second;
        Outcome<LoadedTexture> loaded = load_texture(texture, source, exact, in_memory, result.warnings);
        if (loaded) loaded = within_budget(std::move(loaded.value), source, pixels);
        if (loaded) {
            if (default_texture(source).pixels.empty()) result.files.push_back(source);
            result.textures.push_back(std::move(loaded.value));
        } else {
            result.errors.push_back({texture.name, loaded.error});
        }
    }
    return result;
}

}  // namespace patina::runtime

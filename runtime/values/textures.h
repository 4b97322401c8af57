// Textures for both renderers: mip levels of linear texels, from a file or a named default, and the format in which a
// GPU should store them.
//
//   LoadedTextures loaded = load_textures(reflection, "graphs", {{"_MainTex", "rust.png"}}, false);
//   if (loaded.errors.empty()) use(loaded.textures);
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "patina/interpret.h"
#include "patina/reflection.h"
#include "runtime/outcome.h"
#include "runtime/picture/image.h"
#include "runtime/picture/mip_chain.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

enum class TexelFormat {
    Srgb8,   // colour from an 8-bit file: R8G8B8A8_SRGB
    Unorm8,  // data from an 8-bit file: R8G8B8A8_UNORM
    Float32  // everything else, and everything in a comparison of witnesses
};

struct LoadedTexture {
    std::string name{};  // Texture::name
    std::shared_ptr<const TextureData> data{};
    TexelFormat format = TexelFormat::Float32;
    TextureDimension dimension = TextureDimension::Flat;
};

// white | black | gray (0.5) | bump (0.5, 0.5, 1): one texel as a file would hold it, so a colour texture decodes it.
// No such name: an empty image.
Image default_texture(const std::string& name);

// A message about a texture.
struct TextureRemark {
    std::string texture{};  // Texture::name
    std::string text{};
};

struct LoadedTextures {
    std::vector<LoadedTexture> textures{};  // one for each of the material that could be loaded, in its order
    std::vector<TextureRemark> errors{};    // one for each that could not
    std::vector<TextureRemark> warnings{};  // files that state another colour space than the one they are read in
    std::vector<std::string> files{};       // that were read
};

// The scene's textures for a material that reads them: its environment and the table of the split sum.
void add_engine_textures(std::vector<LoadedTexture>& textures, const Reflection& reflection, const Scene& scene);

// The reflection's own defaults are files below `graph_folder`. `files` maps texture names to a default's name or a
// file, as one opens it, and wins over them. `in_memory`: files of a model, which are found before those of the file
// system; null: none. What the pictures of a model state of their colour space does not count (glTF 2.0, "Images").
LoadedTextures load_textures(const Reflection& reflection, const std::string& graph_folder,
                             const std::map<std::string, std::string>& files, bool exact,
                             const MemoryFiles* in_memory = nullptr);

}  // namespace patina::runtime

// Writes a glTF file in its binary form (.glb): one mesh with one material, with its pictures inside. The file has all
// that a viewer needs.
//
//   const std::vector<WrittenPicture> pictures = {{.name = "rust.baseColor", .png = bytes}};
//   WrittenMaterial material{.name = "rust", .base_color_texture = 0};
//   Outcome<std::string> glb = write_glb("rust", mesh, material, pictures);
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/mesh/mesh.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct WrittenPicture {
    std::string name;
    std::string png;  // the bytes of a PNG file
};

// An index into the pictures that are written. Nothing: the factors alone count.
using WrittenTexture = std::optional<std::size_t>;

// An extension of a material, by the names of its properties. One number is a number, three are a colour.
struct WrittenExtension {
    std::string name{};
    std::map<std::string, std::vector<double>> numbers{};
    std::map<std::string, std::size_t> textures{};
};

// As the specification says, a texture's value is multiplied by its factor. Colours are linear.
struct WrittenMaterial {
    enum class Alpha { Opaque, Mask, Blend };
    std::string name{};
    bool is_unlit = false;  // KHR_materials_unlit: base colour and alpha alone count
    bool is_double_sided = false;
    Alpha alpha = Alpha::Opaque;
    double cutoff = 0.5;  // of Mask
    glm::dvec4 base_color{1};
    WrittenTexture base_color_texture{};
    double metallic = 1, roughness = 1;
    WrittenTexture metallic_roughness_texture{};  // green: roughness, blue: metallic
    WrittenTexture normal_texture{};
    WrittenTexture occlusion_texture{};  // red
    double occlusion_strength = 1;
    glm::dvec3 emission{0};        // 0 to 1
    double emissive_strength = 1;  // KHR_materials_emissive_strength
    WrittenTexture emission_texture{};
    // KHR_materials_pbrSpecularGlossiness; viewers without it show the values above.
    struct SpecularGlossiness {
        glm::dvec4 diffuse{1};
        WrittenTexture diffuse_texture{};
        glm::dvec3 specular{1};
        double glossiness = 1;
        WrittenTexture texture{};  // specular, and glossiness in alpha
    };
    std::optional<SpecularGlossiness> specular_glossiness{};
    std::vector<WrittenExtension> layers{};  // not together with the last one
};

// Texture coordinates are written if there is a texture, and tangents if there is a normal map or anisotropy.
// Vertex colours are not:
// they would be multiplied with the base colour.
Outcome<std::string> write_glb(const std::string& name, const Mesh& mesh, const WrittenMaterial& material,
                               std::span<const WrittenPicture> pictures);

}  // namespace patina::runtime

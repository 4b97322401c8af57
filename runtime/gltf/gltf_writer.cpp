#include "runtime/gltf/gltf_writer.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "patina/patina.h"

namespace patina::runtime {
namespace {

using Object = tinygltf::Value::Object;
using tinygltf::Value;

constexpr const char *kUnlit = "KHR_materials_unlit", *kStrength = "KHR_materials_emissive_strength",
                     *kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness",
                     *kAnisotropy = "KHR_materials_anisotropy";

// What a float means in as few decimals as give it back: 0.3, not 0.30000001192092896.
double short_number(double value) {
    char text[32];
    const std::to_chars_result end = std::to_chars(text, text + sizeof text, float(value));
    double made = value;  // what has no decimals, such as infinity, stays
    std::from_chars(text, end.ptr, made);
    return made;
}

template <int N>
std::vector<double> numbers(const glm::vec<N, double, glm::defaultp>& value) {
    std::vector<double> made;
    for (int i = 0; i < N; i++) made.push_back(short_number(value[i]));
    return made;
}

template <int N>
Value number_array(const glm::vec<N, double, glm::defaultp>& value) {
    Value::Array made;
    for (const double number : numbers(value)) made.emplace_back(number);
    return Value(made);
}

Value texture_info(std::size_t texture) {
    return Value(Object{{"index", Value(int(texture))}});
}

class Writing {
public:
    Writing(const std::string& name, const Mesh& mesh, const WrittenMaterial& material,
            std::span<const WrittenPicture> pictures)
        : name_(name), mesh_(mesh), material_(material), pictures_(pictures) {}

    Outcome<std::string> run() {
        model_.asset.version = "2.0";
        model_.asset.generator = "Patina " + std::string(version());
        model_.buffers.emplace_back();
        add_mesh();
        add_pictures();
        add_material();
        std::ostringstream out;
        tinygltf::TinyGLTF writer;
        if (!writer.WriteGltfSceneToStream(&model_, out, false, true)) return Failure{"tinygltf cannot write the file"};
        return std::move(out).str();
    }

private:
    // --- the buffer, in which everything begins at a multiple of four bytes

    int add_view(const void* bytes, std::size_t size, int target) {
        std::vector<unsigned char>& data = model_.buffers[0].data;
        data.resize((data.size() + 3) / 4 * 4);
        tinygltf::BufferView view;
        view.buffer = 0;
        view.byteOffset = data.size();
        view.byteLength = size;
        view.target = target;
        const auto* first = static_cast<const unsigned char*>(bytes);
        data.insert(data.end(), first, first + size);
        model_.bufferViews.push_back(std::move(view));
        return int(model_.bufferViews.size() - 1);
    }

    int add_accessor(int view, int component, int type, std::size_t count) {
        tinygltf::Accessor accessor;
        accessor.bufferView = view;
        accessor.componentType = component;
        accessor.type = type;
        accessor.count = count;
        model_.accessors.push_back(std::move(accessor));
        return int(model_.accessors.size() - 1);
    }

    template <class Get>
    void add_attribute(tinygltf::Primitive& primitive, const std::string& name, int type, const Get& get) {
        std::vector<decltype(get(mesh_.vertices[0]))> values;
        for (const Vertex& vertex : mesh_.vertices) values.push_back(get(vertex));
        const int view = add_view(values.data(), values.size() * sizeof values[0], TINYGLTF_TARGET_ARRAY_BUFFER);
        primitive.attributes[name] = add_accessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size());
    }

    void add_mesh() {
        tinygltf::Primitive primitive;
        primitive.mode = TINYGLTF_MODE_TRIANGLES;
        primitive.material = 0;
        const int view = add_view(mesh_.indices.data(), mesh_.indices.size() * sizeof mesh_.indices[0],
                                  TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        primitive.indices =
            add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, mesh_.indices.size());
        add_attribute(primitive, "POSITION", TINYGLTF_TYPE_VEC3, [](const Vertex& v) { return v.position; });
        add_bounds(model_.accessors[std::size_t(primitive.attributes["POSITION"])]);
        if (!material_.is_unlit)
            add_attribute(primitive, "NORMAL", TINYGLTF_TYPE_VEC3, [](const Vertex& v) { return v.normal; });
        if (needs_tangents())
            add_attribute(primitive, "TANGENT", TINYGLTF_TYPE_VEC4, [](const Vertex& v) { return v.tangent; });
        if (!pictures_.empty())
            add_attribute(primitive, "TEXCOORD_0", TINYGLTF_TYPE_VEC2, [](const Vertex& v) { return v.uv0; });
        tinygltf::Mesh mesh;
        mesh.name = name_;
        mesh.primitives.push_back(std::move(primitive));
        model_.meshes.push_back(std::move(mesh));
        tinygltf::Node node;
        node.name = name_;
        node.mesh = 0;
        model_.nodes.push_back(std::move(node));
        tinygltf::Scene scene;
        scene.nodes = {0};
        model_.scenes.push_back(std::move(scene));
        model_.defaultScene = 0;
    }

    bool needs_tangents() const {
        return material_.normal_texture ||
               std::any_of(material_.layers.begin(), material_.layers.end(),
                           [](const WrittenExtension& layer) { return layer.name == kAnisotropy; });
    }

    void add_bounds(tinygltf::Accessor& accessor) const {
        glm::vec3 low = mesh_.vertices[0].position, high = low;
        for (const Vertex& vertex : mesh_.vertices) {
            low = glm::min(low, vertex.position);
            high = glm::max(high, vertex.position);
        }
        accessor.minValues = {low.x, low.y, low.z};
        accessor.maxValues = {high.x, high.y, high.z};
    }

    // One texture for each picture, all with one sampler. Texture coordinates are from 0 to 1, so nothing repeats.
    void add_pictures() {
        for (const WrittenPicture& picture : pictures_) {
            tinygltf::Image image;
            image.name = picture.name;
            image.mimeType = "image/png";
            image.bufferView = add_view(picture.png.data(), picture.png.size(), 0);
            model_.images.push_back(std::move(image));
            tinygltf::Texture texture;
            texture.source = int(model_.images.size() - 1);
            texture.sampler = 0;
            model_.textures.push_back(std::move(texture));
        }
        if (pictures_.empty()) return;
        tinygltf::Sampler sampler;
        sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        model_.samplers.push_back(std::move(sampler));
    }

    // --- the material

    void use(tinygltf::Material& made, const char* extension, Object values) {
        made.extensions[extension] = Value(std::move(values));
        model_.extensionsUsed.emplace_back(extension);
    }

    void add_material() {
        tinygltf::Material made;
        made.name = material_.name;
        made.doubleSided = material_.is_double_sided;
        if (material_.alpha == WrittenMaterial::Alpha::Mask) {
            made.alphaMode = "MASK";
            made.alphaCutoff = short_number(material_.cutoff);
        }
        if (material_.alpha == WrittenMaterial::Alpha::Blend) made.alphaMode = "BLEND";
        tinygltf::PbrMetallicRoughness& pbr = made.pbrMetallicRoughness;
        pbr.baseColorFactor = numbers(material_.base_color);
        if (material_.base_color_texture) pbr.baseColorTexture.index = int(*material_.base_color_texture);
        pbr.metallicFactor = short_number(material_.metallic);
        pbr.roughnessFactor = short_number(material_.roughness);
        if (material_.is_unlit) {
            use(made, kUnlit, {});
        } else {
            add_lit(made);
        }
        model_.materials.push_back(std::move(made));
    }

    void add_lit(tinygltf::Material& made) {
        if (const WrittenTexture& texture = material_.metallic_roughness_texture)
            made.pbrMetallicRoughness.metallicRoughnessTexture.index = int(*texture);
        if (material_.normal_texture) made.normalTexture.index = int(*material_.normal_texture);
        if (material_.occlusion_texture) {
            made.occlusionTexture.index = int(*material_.occlusion_texture);
            made.occlusionTexture.strength = short_number(material_.occlusion_strength);
        }
        made.emissiveFactor = numbers(material_.emission);
        if (material_.emission_texture) made.emissiveTexture.index = int(*material_.emission_texture);
        if (material_.emissive_strength != 1)
            use(made, kStrength, {{"emissiveStrength", Value(short_number(material_.emissive_strength))}});
        if (material_.specular_glossiness) add_specular(made, *material_.specular_glossiness);
        for (const WrittenExtension& layer : material_.layers) add_layer(made, layer);
    }

    void add_layer(tinygltf::Material& made, const WrittenExtension& layer) {
        Object values;
        for (const auto& [name, given] : layer.numbers) {
            Value::Array all;
            for (const double number : given) all.emplace_back(short_number(number));
            values[name] = all.size() == 1 ? all[0] : Value(all);
        }
        for (const auto& [name, texture] : layer.textures) values[name] = texture_info(texture);
        use(made, layer.name.c_str(), std::move(values));
    }

    void add_specular(tinygltf::Material& made, const WrittenMaterial::SpecularGlossiness& from) {
        Object values{{"diffuseFactor", number_array(from.diffuse)},
                      {"specularFactor", number_array(from.specular)},
                      {"glossinessFactor", Value(short_number(from.glossiness))}};
        if (from.diffuse_texture) values["diffuseTexture"] = texture_info(*from.diffuse_texture);
        if (from.texture) values["specularGlossinessTexture"] = texture_info(*from.texture);
        use(made, kSpecularGlossiness, std::move(values));
    }

    const std::string& name_;
    const Mesh& mesh_;
    const WrittenMaterial& material_;
    std::span<const WrittenPicture> pictures_;
    tinygltf::Model model_{};
};

}  // namespace

Outcome<std::string> write_glb(const std::string& name, const Mesh& mesh, const WrittenMaterial& material,
                               std::span<const WrittenPicture> pictures) {
    if (mesh.vertices.empty() || mesh.indices.empty()) return Failure{"the mesh has no triangles"};
    return Writing(name, mesh, material, pictures).run();
}

}  // namespace patina::runtime

#include "runtime/gltf/gltf_draco.h"

#include <draco/compression/decode.h>

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

namespace patina::runtime {
namespace {

constexpr const char* kName = "KHR_draco_mesh_compression";

struct Failed {
    std::string what;
};

int number_of(const tinygltf::Value& object, const std::string& key) {
    if (!object.Has(key) || !object.Get(key).IsInt()) throw Failed{"it has no number '" + key + "'"};
    return object.Get(key).GetNumberAsInt();
}

tinygltf::Accessor& accessor_at(tinygltf::Model& model, int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
        throw Failed{"there is no accessors[" + std::to_string(index) + "]"};
    return model.accessors[static_cast<std::size_t>(index)];
}

std::unique_ptr<draco::Mesh> decoded(const tinygltf::Model& model, int view_index) {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model.bufferViews.size())
        throw Failed{"there is no bufferViews[" + std::to_string(view_index) + "]"};
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
        throw Failed{"there is no buffers[" + std::to_string(view.buffer) + "]"};
    const std::vector<unsigned char>& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        throw Failed{"its bytes are outside of the buffer"};
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data() + view.byteOffset), view.byteLength);
    const auto type = draco::Decoder::GetEncodedGeometryType(&buffer);
    if (!type.ok() || type.value() != draco::TRIANGULAR_MESH) throw Failed{"its bytes are not a Draco mesh"};
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) throw Failed{std::string("its bytes cannot be decoded: ") + mesh.status().error_msg()};
    return std::move(mesh).value();
}

// Appends the numbers as a buffer with one view, and lets the accessor read them.
template <class Number>
void give(tinygltf::Model& model, tinygltf::Accessor& accessor, const std::vector<Number>& numbers, int component_type,
          std::size_t count) {
    tinygltf::Buffer buffer;
    buffer.data.resize(numbers.size() * sizeof(Number));
    if (!numbers.empty()) std::memcpy(buffer.data.data(), numbers.data(), buffer.data.size());
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model.buffers.size());
    view.byteLength = buffer.data.size();
    model.buffers.push_back(std::move(buffer));
    accessor.bufferView = static_cast<int>(model.bufferViews.size());
    model.bufferViews.push_back(view);
    accessor.byteOffset = 0;
    accessor.componentType = component_type;
    accessor.normalized = false;
    accessor.count = count;
}

std::vector<float> values_of(const draco::Mesh& mesh, const draco::PointAttribute& attribute) {
    const auto width = static_cast<std::size_t>(attribute.num_components());
    if (width > 4) throw Failed{"an attribute has " + std::to_string(width) + " numbers"};
    std::vector<float> values;
    values.reserve(mesh.num_points() * width);
    for (draco::PointIndex i(0); i < mesh.num_points(); ++i) {
        std::array<float, 4> value{};
        if (!attribute.ConvertValue<float>(attribute.mapped_index(i), static_cast<std::int8_t>(width), value.data()))
            throw Failed{"a value of an attribute cannot be read"};
        values.insert(values.end(), value.begin(), value.begin() + static_cast<std::ptrdiff_t>(width));
    }
    return values;
}

void expand(tinygltf::Model& model, tinygltf::Primitive& primitive, const tinygltf::Value& extension) {
    const std::unique_ptr<draco::Mesh> mesh = decoded(model, number_of(extension, "bufferView"));
    if (!extension.Has("attributes") || !extension.Get("attributes").IsObject()) throw Failed{"it has no attributes"};
    for (const std::string& name : extension.Get("attributes").Keys()) {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) continue;
        const int id = number_of(extension.Get("attributes"), name);
        const draco::PointAttribute* attribute =
            id < 0 ? nullptr : mesh->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (!attribute) throw Failed{"its bytes have no attribute " + std::to_string(id) + ", for " + name};
        tinygltf::Accessor& accessor = accessor_at(model, found->second);
        if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != attribute->num_components())
            throw Failed{name + " has " + std::to_string(attribute->num_components()) + " numbers in its bytes"};
        give(model, accessor, values_of(*mesh, *attribute), TINYGLTF_COMPONENT_TYPE_FLOAT, mesh->num_points());
    }
    if (!extension.Has("indices")) return;
    primitive.indices = number_of(extension, "indices");
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * std::size_t(mesh->num_faces()));
    for (draco::FaceIndex i(0); i < mesh->num_faces(); ++i) {
        for (const draco::PointIndex& corner : mesh->face(i)) indices.push_back(corner.value());
    }
    const std::size_t count = indices.size();
    give(model, accessor_at(model, primitive.indices), indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, count);
    primitive.mode = TINYGLTF_MODE_TRIANGLES;  // strips are decoded to triangles
}

}  // namespace

std::string without_draco_indices(std::string_view text) {
    if (text.find(kName) == text.npos) return std::string(text);
    nlohmann::json file = nlohmann::json::parse(text, nullptr, false);
    if (!file.is_object() || !file.contains("meshes") || !file["meshes"].is_array()) return std::string(text);
    for (nlohmann::json& mesh : file["meshes"]) {
        if (!mesh.is_object() || !mesh.contains("primitives") || !mesh["primitives"].is_array()) continue;
        for (nlohmann::json& primitive : mesh["primitives"]) {
            const bool is_compressed = primitive.is_object() && primitive.contains("indices") &&
                                       primitive.contains("extensions") && primitive["extensions"].is_object() &&
                                       primitive["extensions"].contains(kName) &&
                                       primitive["extensions"][kName].is_object();
            if (!is_compressed) continue;
            primitive["extensions"][kName]["indices"] = primitive["indices"];
            primitive.erase("indices");
        }
    }
    return file.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string expand_draco(tinygltf::Model& model) {
    for (std::size_t i = 0; i < model.meshes.size(); ++i) {
        for (std::size_t k = 0; k < model.meshes[i].primitives.size(); ++k) {
            tinygltf::Primitive& primitive = model.meshes[i].primitives[k];
            const auto extension = primitive.extensions.find(kName);
            if (extension == primitive.extensions.end()) continue;
            try {
                expand(model, primitive, extension->second);
            } catch (const Failed& failed) {
                return "meshes[" + std::to_string(i) + "].primitives[" + std::to_string(k) + "].extensions." + kName +
                       ": " + failed.what;
            }
        }
    }
    return {};
}

}  // namespace patina::runtime

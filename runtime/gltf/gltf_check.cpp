// Checks what a glTF file says before anything reads by it: a file may come from anywhere.
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/gltf/gltf_file.h"

namespace patina::runtime {
namespace {

// Extensions that a file may require: others change what the core of the file means.
constexpr std::string_view kRead[] = {"KHR_draco_mesh_compression",
                                      "KHR_lights_punctual",
                                      "KHR_texture_transform",
                                      "KHR_mesh_quantization",
                                      "KHR_materials_anisotropy",
                                      "KHR_materials_clearcoat",
                                      "KHR_materials_diffuse_transmission",
                                      "KHR_materials_dispersion",
                                      "KHR_materials_emissive_strength",
                                      "KHR_materials_ior",
                                      "KHR_materials_iridescence",
                                      "KHR_materials_pbrSpecularGlossiness",
                                      "KHR_materials_sheen",
                                      "KHR_materials_specular",
                                      "KHR_materials_transmission",
                                      "KHR_materials_unlit",
                                      "KHR_materials_variants",
                                      "KHR_materials_volume"};

std::string place(std::string_view list, std::size_t index) {
    return std::string(list) + "[" + std::to_string(index) + "]";
}

std::string number(std::size_t count) {
    return std::to_string(count);
}

class Check {
public:
    explicit Check(const tinygltf::Model& model) : model_(model) {}

    std::string run() {
        version();
        extensions();
        for (std::size_t i = 0; i < model_.bufferViews.size(); ++i) view(i);
        for (std::size_t i = 0; i < model_.accessors.size(); ++i) accessor(i);
        for (std::size_t i = 0; i < model_.meshes.size(); ++i) mesh(i);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) node(i);
        trees();
        for (std::size_t i = 0; i < model_.skins.size(); ++i) skin(i);
        for (std::size_t i = 0; i < model_.cameras.size(); ++i) camera(i);
        for (std::size_t i = 0; i < model_.textures.size(); ++i) texture(i);
        for (std::size_t i = 0; i < model_.lights.size(); ++i) {
            if (!(model_.lights[i].intensity >= 0))
                wrong("extensions.KHR_lights_punctual." + place("lights", i) + ".intensity", "is less than 0");
        }
        return first_;
    }

private:
    void wrong(const std::string& where, const std::string& what) {
        if (first_.empty()) first_ = where + ": " + what;
    }

    // True if an index is one of a list; -1 is "none".
    bool is_there(const std::string& where, int index, std::size_t count, std::string_view list,
                  bool may_lack = false) {
        if (index == -1 && may_lack) return false;
        if (index >= 0 && static_cast<std::size_t>(index) < count) return true;
        wrong(where, "names " + place(list, 0).substr(0, list.size()) + "[" + std::to_string(index) +
                         "], and the file has " + number(count));
        return false;
    }

    // A later 2.x may be read, unless the file says that it must not.
    void version() {
        const tinygltf::Asset& asset = model_.asset;
        const bool needs_more = !asset.minVersion.empty() && asset.minVersion != "2.0";
        if (!asset.version.starts_with("2.") || needs_more)
            wrong(needs_more ? "asset.minVersion" : "asset.version",
                  "version '" + (needs_more ? asset.minVersion : asset.version) + "' is not read, only 2.0");
    }

    void extensions() {
        for (const std::string& name : model_.extensionsRequired) {
            if (std::find(std::begin(kRead), std::end(kRead), name) == std::end(kRead))
                wrong("extensionsRequired", "'" + name + "' is not supported");
        }
    }

    void view(std::size_t i) {
        const tinygltf::BufferView& view = model_.bufferViews[i];
        const std::string where = place("bufferViews", i);
        if (!is_there(where + ".buffer", view.buffer, model_.buffers.size(), "buffers")) return;
        const std::size_t size = model_.buffers[static_cast<std::size_t>(view.buffer)].data.size();
        if (view.byteOffset > size || view.byteLength > size - view.byteOffset)
            wrong(where, number(view.byteLength) + " bytes from byte " + number(view.byteOffset) + " on, and " +
                             place("buffers", static_cast<std::size_t>(view.buffer)) + " has " + number(size));
    }

    // True if `count` elements lie in the view.
    bool fits(const std::string& where, int view_index, std::size_t offset, std::size_t count, std::size_t element,
              std::size_t stride, std::size_t unit) {
        if (!is_there(where + ".bufferView", view_index, model_.bufferViews.size(), "bufferViews")) return false;
        const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
        if (stride < element) {
            wrong(where,
                  "its elements have " + number(element) + " bytes, and the view's byteStride is " + number(stride));
            return false;
        }
        if ((offset + view.byteOffset) % unit != 0 || stride % unit != 0) {
            wrong(where, "its numbers do not begin at multiples of their size");
            return false;
        }
        const bool is_inside = offset <= view.byteLength && view.byteLength - offset >= element &&
                               (view.byteLength - offset - element) / stride >= count - 1;
        if (!is_inside)
            wrong(where, number(count) + " elements from byte " + number(offset) + " on do not fit into " +
                             place("bufferViews", static_cast<std::size_t>(view_index)) + ", which has " +
                             number(view.byteLength) + " bytes");
        return is_inside;
    }

    void accessor(std::size_t i) {
        const tinygltf::Accessor& accessor = model_.accessors[i];
        const std::string where = place("accessors", i);
        const int unit = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
        const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
        if (unit <= 0 || accessor.componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE ||
            accessor.componentType == TINYGLTF_COMPONENT_TYPE_INT)
            return wrong(where + ".componentType", "there is no type " + std::to_string(accessor.componentType));
        if (width <= 0) return wrong(where + ".type", "there is no such type");
        if (accessor.count == 0) return wrong(where + ".count", "an accessor has at least one element");
        if (accessor.count > std::numeric_limits<std::uint32_t>::max())
            return wrong(where + ".count", "there are at most 4294967295 elements");
        const auto element = static_cast<std::size_t>(unit * width);
        if (accessor.bufferView >= 0) {
            std::size_t stride = element;
            if (is_there(where + ".bufferView", accessor.bufferView, model_.bufferViews.size(), "bufferViews")) {
                const auto& view = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
                if (view.byteStride != 0) stride = view.byteStride;
            }
            fits(where, accessor.bufferView, accessor.byteOffset, accessor.count, element, stride,
                 static_cast<std::size_t>(unit));
        } else if (!accessor.sparse.isSparse || accessor.count > kMostZeros) {
            wrong(where, "it has no bufferView");
        }
        if (accessor.sparse.isSparse) sparse(accessor, where, element, static_cast<std::size_t>(unit));
    }

    void sparse(const tinygltf::Accessor& accessor, const std::string& where, std::size_t element, std::size_t unit) {
        const auto& sparse = accessor.sparse;
        if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > accessor.count)
            return wrong(where + ".sparse.count", "is not between 1 and the accessor's count");
        const int index_type = sparse.indices.componentType;
        const bool is_index = index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                              index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                              index_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
        if (!is_index) return wrong(where + ".sparse.indices.componentType", "is not a type of indices");
        const auto size =
            static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(index_type)));
        const auto count = static_cast<std::size_t>(sparse.count);
        if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
            return wrong(where + ".sparse", "has an offset below 0");
        fits(where + ".sparse.indices", sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
             count, size, size, size);
        fits(where + ".sparse.values", sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
             count, element, element, unit);
    }

    // The count of an attribute's accessor.
    void attribute(const std::string& where, const std::string& name, int index, std::size_t& count) {
        if (!is_there(where, index, model_.accessors.size(), "accessors")) return;
        const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
        if (count == 0) count = accessor.count;
        if (accessor.count != count)
            wrong(where, "has " + number(accessor.count) + " elements, and other attributes have " + number(count));
        const auto has_width = [&](int least, int most) {
            const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
            if (width < least || width > most || accessor.type > 32 * 2)
                wrong(where, "has " + std::to_string(width) + " numbers, not " + std::to_string(least) +
                                 (least == most ? "" : " or " + std::to_string(most)));
        };
        check_type(where, name, accessor);
        if (name == "POSITION" || name == "NORMAL") has_width(3, 3);
        if (name == "TANGENT") has_width(3, 4);
        if (name.starts_with("TEXCOORD_")) has_width(2, 2);
        if (name.starts_with("COLOR_")) has_width(3, 4);
        if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) has_width(4, 4);
    }

    // The core of glTF has floats, and for some attributes shares of the largest whole number (section 3.7.2.1).
    void check_type(const std::string& where, const std::string& name, const tinygltf::Accessor& accessor) {
        const auto names = [](const std::vector<std::string>& extensions) {
            return std::find(extensions.begin(), extensions.end(), "KHR_mesh_quantization") != extensions.end();
        };
        const bool is_quantized = names(model_.extensionsUsed) || names(model_.extensionsRequired);
        const bool is_float = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
        if (is_quantized || is_float) return;
        const bool is_share = accessor.normalized && (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                                      accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT);
        const bool needs_float = name == "POSITION" || name == "NORMAL" || name == "TANGENT";
        if (needs_float || (name.starts_with("TEXCOORD_") && !is_share))
            wrong(where,
                  "has whole numbers, which only the extension KHR_mesh_quantization allows: name it in "
                  "extensionsUsed, or write floats");
    }

    void mesh(std::size_t i) {
        const tinygltf::Mesh& mesh = model_.meshes[i];
        for (std::size_t k = 0; k < mesh.primitives.size(); ++k) {
            const tinygltf::Primitive& primitive = mesh.primitives[k];
            const std::string where = place("meshes", i) + "." + place("primitives", k);
            if (!primitive.attributes.contains("POSITION")) wrong(where, "has no attribute POSITION");
            std::size_t count = 0;
            for (const auto& [name, index] : primitive.attributes)
                attribute(where + ".attributes." + name, name, index, count);
            for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
                for (const auto& [name, index] : primitive.targets[t])
                    attribute(where + "." + place("targets", t) + "." + name, name, index, count);
            }
            is_there(where + ".material", primitive.material, model_.materials.size(), "materials", true);
            if (is_there(where + ".indices", primitive.indices, model_.accessors.size(), "accessors", true)) {
                const tinygltf::Accessor& indices = model_.accessors[static_cast<std::size_t>(primitive.indices)];
                const bool is_whole = indices.type == TINYGLTF_TYPE_SCALAR &&
                                      (indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                       indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                       indices.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
                if (!is_whole) wrong(where + ".indices", "are not whole numbers of 1, 2 or 4 bytes");
            }
            if (primitive.mode < -1 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
                wrong(where + ".mode", "there is no mode " + std::to_string(primitive.mode));
        }
    }

    static bool is_finite(const std::vector<double>& numbers) {
        return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
    }

    void node(std::size_t i) {
        const tinygltf::Node& node = model_.nodes[i];
        const std::string where = place("nodes", i);
        is_there(where + ".mesh", node.mesh, model_.meshes.size(), "meshes", true);
        is_there(where + ".camera", node.camera, model_.cameras.size(), "cameras", true);
        is_there(where + ".skin", node.skin, model_.skins.size(), "skins", true);
        for (const int child : node.children) is_there(where + ".children", child, model_.nodes.size(), "nodes");
        const auto has = [&](const std::vector<double>& numbers, std::size_t count, std::string_view name) {
            if (!numbers.empty() && (numbers.size() != count || !is_finite(numbers)))
                wrong(where + "." + std::string(name), "is not " + number(count) + " numbers");
        };
        has(node.translation, 3, "translation");
        has(node.rotation, 4, "rotation");
        has(node.scale, 3, "scale");
        has(node.matrix, 16, "matrix");
        if (const auto found = node.extensions.find("KHR_lights_punctual"); found != node.extensions.end()) {
            const int light = found->second.Has("light") && found->second.Get("light").IsInt()
                                  ? found->second.Get("light").GetNumberAsInt()
                                  : -2;
            is_there(where + ".extensions.KHR_lights_punctual.light", light, model_.lights.size(), "lights");
        }
    }

    // A node has one parent at most, and no node is its own ancestor.
    void trees() {
        if (!first_.empty()) return;
        std::vector<int> parent(model_.nodes.size(), -1);
        for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
            for (const int child : model_.nodes[i].children) {
                int& known = parent[static_cast<std::size_t>(child)];
                if (known >= 0)
                    return wrong(place("nodes", i) + ".children", place("nodes", static_cast<std::size_t>(child)) +
                                                                      " is also a child of " +
                                                                      place("nodes", static_cast<std::size_t>(known)));
                known = static_cast<int>(i);
            }
        }
        std::vector<int> root(parent.size(), -1);  // which walk has passed the node
        for (std::size_t i = 0; i < parent.size(); ++i) {
            for (int at = static_cast<int>(i); at >= 0; at = parent[static_cast<std::size_t>(at)]) {
                int& passed = root[static_cast<std::size_t>(at)];
                if (passed == static_cast<int>(i))
                    return wrong(place("nodes", static_cast<std::size_t>(at)), "is its own ancestor");
                if (passed >= 0) break;
                passed = static_cast<int>(i);
            }
        }
        is_there("scene", model_.defaultScene, model_.scenes.size(), "scenes", true);
        for (std::size_t i = 0; i < model_.scenes.size(); ++i) {
            for (const int node : model_.scenes[i].nodes) {
                if (is_there(place("scenes", i) + ".nodes", node, model_.nodes.size(), "nodes") &&
                    parent[static_cast<std::size_t>(node)] >= 0)
                    wrong(place("scenes", i) + ".nodes",
                          place("nodes", static_cast<std::size_t>(node)) + " is a child of another node");
            }
        }
    }

    void skin(std::size_t i) {
        const tinygltf::Skin& skin = model_.skins[i];
        const std::string where = place("skins", i);
        if (skin.joints.empty()) wrong(where, "has no joints");
        for (const int joint : skin.joints) is_there(where + ".joints", joint, model_.nodes.size(), "nodes");
        const std::string matrices = where + ".inverseBindMatrices";
        if (!is_there(matrices, skin.inverseBindMatrices, model_.accessors.size(), "accessors", true)) return;
        const auto& accessor = model_.accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
        if (accessor.type != TINYGLTF_TYPE_MAT4 || accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT)
            wrong(matrices, "are not matrices of 16 floats");
        if (accessor.count < skin.joints.size())
            wrong(matrices,
                  "are " + number(accessor.count) + ", and there are " + number(skin.joints.size()) + " joints");
    }

    void camera(std::size_t i) {
        const tinygltf::Camera& camera = model_.cameras[i];
        const std::string where = place("cameras", i);
        if (camera.type == "perspective") {
            if (!(camera.perspective.yfov > 0 && camera.perspective.yfov < 3.14159))
                wrong(where + ".perspective.yfov", "is not between 0 and pi");
            if (!(camera.perspective.znear > 0)) wrong(where + ".perspective.znear", "is not greater than 0");
        } else if (camera.type == "orthographic") {
            if (!(camera.orthographic.ymag != 0)) wrong(where + ".orthographic.ymag", "is 0");
            if (!(camera.orthographic.zfar > camera.orthographic.znear))
                wrong(where + ".orthographic.zfar", "is not greater than znear");
        } else {
            wrong(where + ".type", "is neither 'perspective' nor 'orthographic'");
        }
    }

    void texture(std::size_t i) {
        const tinygltf::Texture& texture = model_.textures[i];
        is_there(place("textures", i) + ".source", texture.source, model_.images.size(), "images", true);
        is_there(place("textures", i) + ".sampler", texture.sampler, model_.samplers.size(), "samplers", true);
    }

    // An accessor without bytes is zeros; its count is only a claim.
    static constexpr std::size_t kMostZeros = 1 << 24;

    const tinygltf::Model& model_;
    std::string first_;
};

}  // namespace

std::string mistake_in(const tinygltf::Model& model) {
    return Check(model).run();
}

}  // namespace patina::runtime

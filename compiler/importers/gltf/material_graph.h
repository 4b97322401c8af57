// A graph in the making for one glTF material: properties for what the material states, a node for each texture that it
// reads, and inputs of the surface.
//
//   MaterialGraph graph(context, pictures, "Paint");
//   Term roughness = graph.scalar(pbr, {.factor = "roughnessFactor", .texture = "metallicRoughnessTexture",
//                                       .slot = "metallicRoughness", .channel = "g", .property = "_Roughness"});
//   graph.set("roughness", roughness);
#pragma once

#include <array>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "compiler/importers/gltf/gltf_pictures.h"
#include "compiler/importers/imported_graph.h"
#include "compiler/importers/patterns.h"

namespace patina::importers::gltf {

using namespace terms;

// Where a number or a colour of glTF is: a factor, times some channels of a texture.
struct Slot {
    std::string_view factor{}, texture{};
    std::string_view slot{};      // of the texture: the node's id, "baseColor"
    std::string_view channel{};   // "g", "rgb"
    std::string_view property{};  // "_Roughness"
    double otherwise = 1;         // if the factor is not stated
    double high = 1;              // the factor's range begins at 0
    bool shares_texture = false;  // with another value of its owner, which says what the texture does
};

class MaterialGraph {
public:
    MaterialGraph(const Context& context, Pictures& pictures, std::string name)
        : graph(name), context_(&context), pictures_(&pictures), name_(std::move(name)) {}

    // Factor times texture, with remarks for both.
    Term scalar(Object& from, const Slot& slot);
    Term color(Object& from, const Slot& slot);
    // The node that samples a texture; white if there is none. `usage`: "color", "data" or "normal".
    Term texel(Object& from, std::string_view key, std::string_view slot, std::string_view usage);
    // A node with a normal in tangent space; a constant if there is none.
    Term normal(Object& from, std::string_view key, std::string_view slot, std::string_view scale_property);
    // A property with a range from `low` to `high`; "$_Roughness". A default beyond it widens the range.
    Term number_property(std::string_view name, double value, double low, double high);
    Term color_property(std::string_view name, const std::vector<double>& value);
    void node(ImportedNode node);
    void set(std::string_view input, const Term& term);

    const Context& context() const { return *context_; }
    ImportedGraph graph;
    std::map<std::size_t, std::vector<std::string>> packed{};  // texture -> the numbers that the material reads of it
    std::array<bool, 4> lacks_coordinates{};  // by set: a mesh that shows the material has no such coordinates

private:
    bool is_zero(Object& from, const Slot& slot, double factor);
    std::string name_of(std::size_t texture, std::string_view slot, std::string_view usage) const;
    Term coordinates(Object& info);
    std::string texture_property(std::size_t texture, std::string_view slot, std::string_view usage);

    const Context* context_;
    Pictures* pictures_;
    std::string name_;                                                       // that pictures without a name begin with
    std::map<std::pair<std::size_t, std::string>, std::string> textures_{};  // property
    std::map<std::tuple<std::string, std::string, std::string>, std::string> samples_{};  // node, by property and uv
    std::map<std::string, std::string> coordinates_{};                                    // node, by expression
};

}  // namespace patina::importers::gltf

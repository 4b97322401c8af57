#include "compiler/importers/gltf/material_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "compiler/importers/values.h"

namespace patina::importers::gltf {
namespace {

// As the files of most programs have them: 0.8, not 0.800000011920929.
GraphValue short_number(double value) {
    return static_cast<float>(value);
}

GraphValue short_list(const std::vector<double>& values) {
    const std::vector<float> floats(values.begin(), values.end());
    return list_of(floats);
}

// "_BaseColorMap" of "baseColor".
std::string map_name(std::string_view slot) {
    std::string name = "_" + std::string(slot) + "Map";
    name[1] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[1])));
    return name;
}

template <class Part>
bool has_name(const std::vector<Part>& parts, std::string Part::*name, const std::string& wanted) {
    return std::any_of(parts.begin(), parts.end(), [&](const Part& part) { return part.*name == wanted; });
}

// The name, or if it is taken, the name with the first number from 2 that is free.
template <class IsTaken>
std::string free_name(const std::string& wanted, const IsTaken& is_taken) {
    std::string name = wanted;
    for (int i = 2; is_taken(name); ++i) name = wanted + std::to_string(i);
    return name;
}

}  // namespace

void MaterialGraph::node(ImportedNode node) {
    graph.nodes.push_back(std::move(node));
}

void MaterialGraph::set(std::string_view input, const Term& term) {
    const bool is_color = term.is_constant() && term.numbers.size() > 1;
    graph.surface.push_back({std::string(input), is_color ? short_list(term.numbers) : term.value()});
}

Term MaterialGraph::number_property(std::string_view name, double value, double low, double high) {
    graph.properties.push_back({.name = std::string(name),
                                .type = "float",
                                .value = short_number(value),
                                .more = {{"range", GraphValue::list({short_number(std::min(low, value)),
                                                                     short_number(std::max(high, value))})}}});
    return link("$" + std::string(name), Type::Float);
}

Term MaterialGraph::color_property(std::string_view name, const std::vector<double>& value) {
    ImportedProperty property{.name = std::string(name), .type = "color", .value = short_list(value)};
    const double largest = *std::max_element(value.begin(), value.end());
    if (largest > 1) property.more.push_back({"range", GraphValue::list({0.0, short_number(largest)})});
    graph.properties.push_back(std::move(property));
    return color_link("$" + std::string(name));
}

std::string MaterialGraph::texture_property(std::size_t texture, std::string_view slot, std::string_view usage) {
    const auto [found, is_new] = textures_.try_emplace({texture, std::string(usage)});
    if (!is_new) return found->second;
    const TextureFile& file = pictures_->texture(texture, fmt::format("{}_{}", name_, slot));
    if (file.file.empty()) return {};
    const std::string name = free_name(map_name(slot), [&](const std::string& wanted) {
        return has_name(graph.properties, &ImportedProperty::name, wanted);
    });
    ImportedProperty property{.name = name, .type = "texture2d", .value = file.file};
    property.more.push_back({"usage", usage});
    if (!file.sampler.empty()) property.more.push_back({"sampler", GraphValue::object(file.sampler)});
    graph.properties.push_back(std::move(property));
    return found->second = name;
}

// A transform becomes a node, which textures with the same transform share.
Term MaterialGraph::coordinates(Object& info) {
    Object transform = info.extension("KHR_texture_transform");
    double set = info.number("texCoord", 0, 1e6).value_or(0);
    info.taken("texCoord", fmt::format("@uv{}", set));
    if (const auto other = transform.number("texCoord", 0, 1e6)) {
        set = *other;
        transform.taken("texCoord", fmt::format("@uv{}", set));
    }
    if (set > 3) {
        const std::string why = "@uv3: there are four sets of texture coordinates";
        info.changed("texCoord", why);
        transform.changed("texCoord", why);
    }
    const std::size_t read = std::min<std::size_t>(static_cast<std::size_t>(set), 3);
    if (lacks_coordinates[read])
        context().report.add(
            Remark::Kind::Changed, info.path(),
            fmt::format("a mesh that shows it has no TEXCOORD_{}: there the texture is read at (0, 0)", read),
            info.json());
    const Term uv = link(fmt::format("@uv{}", read), Type::Float2);
    constexpr double kFar = 1e6;
    const auto scale = transform.numbers("scale", 2, -kFar, kFar);
    const auto offset = transform.numbers("offset", 2, -kFar, kFar);
    const double angle = transform.number("rotation", -kFar, kFar).value_or(0);
    const std::vector<double> tiling = scale.value_or(std::vector<double>{1, 1});
    const std::vector<double> move = offset.value_or(std::vector<double>{0, 0});
    const bool is_scaled = tiling[0] != 1 || tiling[1] != 1, is_moved = move[0] != 0 || move[1] != 0;
    Term made = computed("a * b", {uv, constant(tiling)}, Type::Float2);
    // glTF turns counter-clockwise as the picture is seen, so from v, which grows downwards, to u.
    if (angle != 0) made = computed("Rotate(a, b, float2(0, 0))", {made, number_term(-angle)}, Type::Float2);
    made = computed("a + b", {made, constant(move)}, Type::Float2);
    const auto take_all = [&](const std::string& text) {
        for (const std::string_view key : {"offset", "rotation", "scale"}) transform.taken(key, text);
        transform.rest();
    };
    if (made.is_link()) {
        take_all("it changes nothing");
        return uv;
    }
    const auto [found, is_new] = coordinates_.try_emplace(made.text());
    if (is_new) {
        found->second = coordinates_.size() == 1 ? "uv" : fmt::format("uv{}", coordinates_.size());
        if (angle == 0) {
            ImportedNode tiled{.id = found->second, .node = "TilingOffset"};
            if (read != 0) tiled.inputs.push_back({"uv", uv.value()});
            if (is_scaled) tiled.inputs.push_back({"tiling", short_list(tiling)});
            if (is_moved) tiled.inputs.push_back({"offset", short_list(move)});
            node(std::move(tiled));
        } else {
            node({.id = found->second, .expression = made.text()});
        }
    }
    take_all(fmt::format("the node '{}'", found->second));
    return link(found->second, Type::Float2);
}

// One texture often holds several values in its channels. A node that reads them is named by all: "occlusionThickness".
std::string MaterialGraph::name_of(std::size_t texture, std::string_view slot, std::string_view usage) const {
    const auto found = packed.find(texture);
    if (usage != "data" || found == packed.end() || found->second.size() < 2) return std::string(slot);
    const std::vector<std::string>& held = found->second;
    constexpr std::size_t kLongest = 24;
    const bool has_prefix = held[1].starts_with(held[0]);  // "clearcoat" is of both of its numbers
    if (held.size() > 2) return "packed";
    if (held[0] == "metallicRoughness" && held[1] == "occlusion") return "orm";
    if (!has_prefix && held[0].size() + held[1].size() > kLongest) return "packed";
    std::string second = held[1];
    second[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(second[0])));
    return has_prefix ? held[0] : held[0] + second;
}

Term MaterialGraph::texel(Object& from, std::string_view key, std::string_view own_slot, std::string_view usage) {
    Object info = from.child(key);
    const auto texture = info.index("index", "textures", count_of(context(), "textures"));
    if (!texture) {
        if (info) context().report.wrong(info.path(), "has no 'index'", info.json());
        return white();
    }
    const std::string slot = name_of(*texture, own_slot, usage);
    const std::string property = texture_property(*texture, slot, usage);
    if (property.empty()) {
        info.left_out("index", "its texture cannot be read: the factor alone is used");
        info.all_taken("without its texture it has no effect");
        return white();
    }
    const Term uv = coordinates(info);
    const bool is_normal = usage == "normal";
    const auto [found, is_new] = samples_.try_emplace({property, uv.text(), std::string(usage)});
    if (is_new) {
        // A texture that is read at two places has two nodes: the second one is named by what it is read for.
        const auto is_node = [&](const std::string& id) { return has_name(graph.nodes, &ImportedNode::id, id); };
        found->second = free_name(is_node(slot) ? std::string(own_slot) : slot, is_node);
        ImportedNode sample{.id = found->second, .node = is_normal ? "SampleNormalMap" : "SampleTexture2D"};
        sample.inputs.push_back({"texture", "$" + property});
        if (uv.text() != "@uv0") sample.inputs.push_back({"uv", uv.value()});
        node(std::move(sample));
    }
    info.taken("index", fmt::format("the property '{}', read by the node '{}'", property, found->second));
    // Their owner reads them.
    for (const std::string_view own : {"scale", "strength"}) {
        if (info.has(own))
            info.taken(own, own == "scale" ? "the strength of the bumps" : "the strength of the occlusion");
    }
    info.rest();
    return is_normal ? link(found->second, Type::Float3) : color_link(found->second);
}

Term MaterialGraph::normal(Object& from, std::string_view key, std::string_view slot, std::string_view scale_property) {
    Term made = texel(from, key, slot, "normal");
    Object info = from.child(key);
    const double scale = info.number("scale", -1e6, 1e6).value_or(1);
    if (made.is_constant() || scale == 1) return made;
    const std::string strong = std::string(slot) + "Scaled";
    node({.id = strong,
          .node = "NormalStrength",
          .inputs = {{"normal", made.value()}, {"strength", number_property(scale_property, scale, 0, 2).value()}}});
    return link(strong, Type::Float3);
}

// A texture is multiplied by its factor, so beside 0 it has no effect.
bool MaterialGraph::is_zero(Object& from, const Slot& slot, double factor) {
    if (factor != 0 || !from.has(slot.texture)) return false;
    const std::string why = fmt::format("it has no effect: '{}' is 0", slot.factor);
    from.taken(slot.factor, "0, whatever the texture holds");
    if (slot.shares_texture) return true;
    Object info = from.child(slot.texture);
    info.all_taken(why);
    info.rest();
    return true;
}

Term MaterialGraph::scalar(Object& from, const Slot& slot) {
    const auto factor = from.number(slot.factor, 0, slot.high);
    const double value = factor.value_or(slot.otherwise);
    if (is_zero(from, slot, value)) return number_term(0);
    const Term read = texel(from, slot.texture, slot.slot, "data");
    Term scale = number_term(value);
    if (factor && (value != 1 || read.is_constant())) {
        scale = number_property(slot.property, value, 0, std::min(slot.high, std::max(1.0, value)));
        from.taken(slot.factor, fmt::format("the property '{}'", slot.property));
    }
    from.taken(slot.factor, "1: the texture alone");
    return product({swizzled(read, slot.channel), scale});
}

Term MaterialGraph::color(Object& from, const Slot& slot) {
    const auto factor = from.numbers(slot.factor, 3, 0, slot.high);
    const std::vector<double> value = factor.value_or(std::vector<double>(3, slot.otherwise));
    const bool is_black = value == std::vector<double>(3, 0);
    if (is_zero(from, slot, is_black ? 0 : 1)) return constant(value);
    const Term read = texel(from, slot.texture, slot.slot, "color");
    Term scale = constant(value);
    if (factor && (!scale.is_all(1) || read.is_constant())) {
        scale = swizzled(color_property(slot.property, value), "rgb");
        from.taken(slot.factor, fmt::format("the property '{}'", slot.property));
    }
    from.taken(slot.factor, "white: the texture alone");
    return product({swizzled(read, slot.channel), scale});
}

}  // namespace patina::importers::gltf

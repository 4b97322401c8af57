// Pictures and normal maps. The coordinates of MaterialX count from the lower left corner of a picture, and those of a
// graph from the upper left one.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {
namespace {

// What a texture without a file has.
std::vector<double> color_of(const std::string& word, TextureUsage usage) {
    const double grey = usage == TextureUsage::Color ? 0.21404114 : 0.5;  // as a file's, which is decoded
    if (word == "black") return {0, 0, 0, 1};
    if (word == "gray") return {grey, grey, grey, 1};
    if (word == "bump") return {0.5, 0.5, 1, 1};
    return {1, 1, 1, 1};
}

// "@uv0 * scale + shift".
struct Place {
    std::uint32_t index = 0;
    std::array<double, 2> scale{1, 1}, shift{0, 0};
};
std::optional<Place> place_of(const NodeWriter& writer, ir::Value value) {
    const ir::Inst& inst = writer[value];
    const std::string_view semantic = writer.semantic(value);
    if (semantic == "uv0" || semantic == "uv1") return Place{.index = semantic == "uv1"};
    const bool is_product = inst.op == ir::Op::Mul, is_sum = inst.op == ir::Op::Add;
    if (!is_product && !is_sum) return std::nullopt;
    const auto args = writer.function().args(value);
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const auto numbers = writer.constant(args[1 - i]);
        auto place = numbers ? place_of(writer, args[i]) : std::nullopt;
        if (!place) continue;
        for (std::size_t each = 0; each < 2; ++each) {
            if (is_product) place->scale[each] *= (*numbers)[each];
            if (is_product) place->shift[each] *= (*numbers)[each];
            if (is_sum) place->shift[each] += (*numbers)[each];
        }
        return place;
    }
    return std::nullopt;
}

}  // namespace

Ref NodeWriter::turned(const Ref& coordinates) {
    if (const auto known = turned_.find(coordinates.name); known != turned_.end()) return known->second;
    const Ref across = component(coordinates, 0), down = component(coordinates, 1);
    wanted_ = coordinates.name + "_v";
    const Ref v = combine("subtract", {.numbers = {1}}, down);
    wanted_ = coordinates.name + "_turned";
    const Ref made = join({across, v});
    wanted_.clear();
    if (!made.is_number()) turned_[made.name] = coordinates;
    return made;
}

Argument NodeWriter::picture_input(const resolve::MaterialProperty& property) {
    const format::Property& own = *property.property;
    const std::string colorspace = own.usage == TextureUsage::Color ? "srgb_texture" : "";
    Ref& known = inputs_[own.name];
    if (!known.name.empty()) return {.name = "file", .value = known, .type = known.type, .colorspace = colorspace};
    namespace fs = std::filesystem;
    std::string file;
    if (property.is_file) {
        std::error_code wrong;
        const fs::path picture = fs::absolute(property.texture_path, wrong).lexically_normal();
        const fs::path folder = fs::absolute(folder_.empty() ? "." : folder_, wrong).lexically_normal() / "";
        file = picture.lexically_relative(folder).generic_string();
        if (file.empty()) file = picture.generic_string();
    }
    known = {.kind = Ref::Kind::Input, .name = names_.unique(own.name), .type = "filename"};
    Element input{.category = "input"};
    input.add("name", known.name).add("type", "filename").add("value", file);
    if (!colorspace.empty()) input.add("colorspace", colorspace);
    describe(input, own);
    const auto first_node = std::find_if(graph_.children.begin(), graph_.children.end(),
                                         [](const Element& each) { return each.category != "input"; });
    graph_.children.insert(first_node, std::move(input));
    return {.name = "file", .value = known, .type = known.type, .colorspace = colorspace};
}

// The picture of a texture at coordinates of the graph.
Ref NodeWriter::picture(ir::Value texture, ir::Value at, std::string type) {
    const ir::Inst& inst = function_[texture];
    const resolve::MaterialProperty* property = nullptr;
    if (inst.op == ir::Op::Global)
        for (std::size_t i = 0; i < lowered_.property_globals.size(); ++i)
            if (lowered_.property_globals[i].texture && lowered_.property_globals[i].texture.index == inst.data)
                property = &material_.properties[i];
    if (!property || inst.type.kind != ir::Kind::Texture2D) {
        refuse(at, inst.op == ir::Op::Global && !property
                       ? fmt::format("the texture '{}'", module_.globals[inst.data].name)
                       : "a texture that is no picture of two dimensions, or is chosen by a condition");
        return {.numbers = {0, 0, 0, 0}};
    }
    const format::Property& own = *property->property;
    if (own.tiling) differs(own.name_span, fmt::format("'{}' has no tiling of its own", own.name));
    const Sampler& sampler = own.sampler;
    if (type.empty()) type = own.usage == TextureUsage::Color ? "color4" : "vector4";
    const bool repeats = sampler.wrap == Wrap::Repeat;
    std::vector<Argument> arguments = {picture_input(*property)};
    std::vector<std::pair<std::string, std::string>> words;
    std::string category = "image";
    const ir::Value before = current_;
    if (const auto place = place_of(*this, at);
        place && (repeats || (place->scale == std::array{1.0, 1.0} && place->shift == std::array{0.0, 0.0}))) {
        if (place->index != 0)
            arguments.push_back({.name = "texcoord", .value = coordinates(place->index), .type = "vector2"});
        // The offset is subtracted, and whole pictures do not count.
        std::vector<double> offset = {-place->shift[0], place->shift[1] + place->scale[1] - 1};
        for (double& each : offset) each -= std::floor(each + 1e-7);
        for (double& each : offset) each = std::abs(each) < 1e-7 ? 0 : each;
        const bool is_scaled = place->scale != std::array{1.0, 1.0};
        const bool is_moved = offset[0] != 0 || offset[1] != 0;
        if (is_scaled || is_moved) category = "tiledimage";
        if (is_scaled)
            arguments.push_back(
                {.name = "uvtiling", .value = {.numbers = {place->scale[0], place->scale[1]}}, .type = "vector2"});
        if (is_moved) arguments.push_back({.name = "uvoffset", .value = {.numbers = offset}, .type = "vector2"});
    } else {
        const Ref coordinates = value(at);
        current_ = {};
        arguments.push_back({.name = "texcoord", .value = turned(coordinates), .type = "vector2"});
    }
    current_ = before;
    if (!property->is_file) {
        std::vector<double> color = color_of(property->texture_path, own.usage);
        color.resize(width_of(type));
        arguments.push_back({.name = "default", .value = {.numbers = color}, .type = type});
    }
    if (!repeats) {
        const std::string word = sampler.wrap == Wrap::Clamp ? "clamp" : "mirror";
        words.emplace_back("uaddressmode", word);
        words.emplace_back("vaddressmode", word);
    }
    if (sampler.filter == Filter::Nearest) words.emplace_back("filtertype", "closest");
    return node(category, type, std::move(arguments), std::move(words));
}

Ref NodeWriter::sampled(ir::Value value) {
    const auto args = function_.args(value);
    if (function_[value].op != ir::Op::Sample)
        differs(span_of(value), "the level of a picture is the renderer's choice");
    return picture(args[0], args[2], {});
}

Ref NodeWriter::unpacked_normal(ir::Value value) {
    const auto args = function_.args(value);
    const Ref texel = this->value(args[0]), scale = this->value(args[1]);
    const auto centred = [&](unsigned index) {
        const Ref doubled = combine("multiply", component(texel, index), {.numbers = {2}});
        return combine("multiply", combine("subtract", doubled, {.numbers = {1}}), scale);
    };
    const Ref x = centred(0), y = centred(1);
    const Ref squares = combine("add", combine("multiply", x, x), combine("multiply", y, y));
    const Ref rest = node("clamp", "float",
                          {{.name = "in", .value = combine("subtract", {.numbers = {1}}, squares), .type = "float"}});
    return join({x, y, node("sqrt", "float", {{.name = "in", .value = rest, .type = "float"}})});
}

std::optional<Ref> NodeWriter::tangent_normal(ir::Value world) {
    if (callee(world) != kToWorld || semantic(function_.args(world)[1]) != "geometryNormalWS") return std::nullopt;
    return value(function_.args(world)[0]);
}

Ref NodeWriter::world_normal(ir::Value value) {
    const auto args = function_.args(value);
    if (semantic(args[1]) != "geometryNormalWS" || semantic(args[2]) != "tangentWS" ||
        semantic(args[3]) != "bitangentWS") {
        refuse(value, "a normal in a frame that is not the mesh's");
        return {.numbers = {0, 0, 1}};
    }
    std::vector<Argument> arguments;
    if (callee(args[0]) == kUnpackNormal && function_[function_.args(args[0])[0]].op == ir::Op::Sample) {
        const auto unpacked = function_.args(args[0]);
        const auto sample = function_.args(unpacked[0]);
        current_ = args[0];
        arguments.push_back({.name = "in", .value = picture(sample[0], sample[2], "vector3"), .type = "vector3"});
        const Ref scale = this->value(unpacked[1]);
        if (!scale.is_all(1)) arguments.push_back({.name = "scale", .value = scale, .type = "float"});
    } else {
        const Ref half = combine("multiply", as(this->value(args[0]), "vector3"), {.numbers = {0.5}});
        arguments.push_back({.name = "in", .value = combine("add", half, {.numbers = {0.5}}), .type = "vector3"});
    }
    current_ = value;
    return node("normalmap", "vector3", std::move(arguments));
}

}  // namespace patina::exporters::mtlx

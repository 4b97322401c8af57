// Nodes that no row of the table can say, by a list of functions.
#include "compiler/importers/mtlx/special_nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/mtlx/noise.h"

namespace patina::importers::mtlx {
namespace {

struct At {
    GraphMaker& maker;
    Scope& scope;
    const Element& node;
    std::string_view output;

    Term input(std::string_view name, std::string_view type, std::string_view otherwise,
               bool may_stay_number = false) const {
        return maker.input(scope, node,
                           {.name = std::string(name), .type = std::string(type), .otherwise = std::string(otherwise)},
                           may_stay_number);
    }
    bool is_set(std::string_view name) const { return maker.is_set(scope, node, name); }
    std::string word(std::string_view name) const { return maker.word_of(scope, node, name); }
    Type type() const { return type_of_word(node.type()); }
};

// A texel, in the type of the node.
Term texel_as(const Term& texel, std::string_view type) {
    if (texel.is_constant()) return terms::converted(texel, type_of_word(type));
    switch (type_of_word(type)) {
        case Type::Float: return terms::swizzled(texel, "r");
        case Type::Float2: return terms::swizzled(texel, "rg");
        case Type::Float3: return terms::swizzled(texel, "rgb");
        case Type::None:
        case Type::Bool:
        case Type::Float4:
        case Type::Matrix3:
        case Type::Matrix4: break;
    }
    return texel;
}

Term without_file(const At& at) {
    Term made = at.input("default", at.node.type(), "0");
    at.maker.approximate(at.node, "it names no picture: its default value");
    return made;
}

Term image(const At& at) {
    if (at.word("file").empty()) return without_file(at);
    return texel_as(at.maker.sampled(at.scope, at.node, at.input("texcoord", "vector2", "@UV0")), at.node.type());
}

Term tiledimage(const At& at) {
    if (at.word("file").empty()) return without_file(at);
    return texel_as(at.maker.sampled(at.scope, at.node, tiled_coordinates(at.maker, at.scope, at.node)),
                    at.node.type());
}

// Channels are outputs: "r", "rgb", "outcolor".
Term channel_of(const Term& value, std::string_view output, std::string_view type) {
    if (output == "rgba") return value;
    if (output == "outcolor") return terms::swizzled(value, "rgb");
    if (output == "outa") return terms::swizzled(value, "a");
    if (output == "out" || output.empty()) return texel_as(value, type);
    return terms::swizzled(value, output);
}

Term usd_texture(const At& at) {
    Term made = at.maker.sampled(at.scope, at.node, at.input("st", "vector2", "@UV0"), "file", "wrapS", "wrapT");
    const Term scale = at.input("scale", "color4", "1"), bias = at.input("bias", "color4", "0");
    if (!scale.is_all(1) || !bias.is_all(0)) {
        std::string text = made.text();
        if (!scale.is_all(1)) text += " * " + terms::at_least(scale.text(), terms::kUnary);
        if (!bias.is_all(0)) text += " + " + terms::at_least(bias.text(), terms::kProduct);
        Term whole = terms::expression(text, Type::Float4);
        whole.sources = made.sources;
        whole.name = terms::camel_case(at.node.name());
        whole.is_color = true;
        made = at.maker.named(whole);
    }
    return channel_of(made, at.output, at.node.type());
}

Term gltf_image(const At& at) {
    if (at.word("file").empty()) return without_file(at);
    const bool is_second = at.word("uvindex") == "1";
    Term coordinates = at.maker.geometry(is_second ? "UV1" : "UV0", Type::Float2);
    if (at.is_set("scale") || at.is_set("offset") || at.is_set("rotate")) {
        // As KHR_texture_transform, with v from the top.
        const Term scale = at.input("scale", "vector2", "1"), offset = at.input("offset", "vector2", "0"),
                   turn = at.input("rotate", "float", "0");
        std::string text = coordinates.from_top;
        if (!scale.is_all(1)) text += " * " + terms::at_least(scale.text(), terms::kUnary);
        if (!turn.is_all(0)) text = fmt::format("Rotate({}, -radians({}), 0)", text, turn.text());
        if (!offset.is_all(0)) text += " + " + terms::at_least(offset.text(), terms::kProduct);
        Term moved = terms::expression(text, Type::Float2);
        moved.name = terms::camel_case(at.node.name()) + "Uv";
        coordinates = terms::flipped(coordinates);
        coordinates = at.maker.named(moved);
        coordinates.from_top = coordinates.base;
        at.maker.approximate(at.node, "its coordinates are moved as glTF says");
    }
    const Term texel = at.maker.sampled(at.scope, at.node, coordinates);
    if (at.node.category != "gltf_colorimage") return texel_as(texel, at.node.type());
    Term made = texel;
    for (const std::string_view factor : {"color", "geomcolor"}) {
        if (!at.is_set(factor)) continue;
        const Term value = at.input(factor, "color4", "1");
        made = terms::expression(fmt::format("{} * {}", made.text(), terms::at_least(value.text(), terms::kUnary)),
                                 Type::Float4);
        made.is_color = true;
    }
    made.sources = texel.sources;
    made.name = terms::camel_case(at.node.name()) + "Color";
    return channel_of(made.is_link() ? made : at.maker.named(made), at.output, at.node.type());
}

Term triplanar(const At& at) {
    if (at.word("filex").empty()) return without_file(at);
    const std::string texture = at.maker.texture(at.scope, at.node, "filex", "repeat", "linear");
    if (texture.empty()) return at.maker.magenta(at.node, at.type(), "its picture cannot be read");
    if (at.word("filey") != at.word("filex") || at.word("filez") != at.word("filex"))
        at.maker.approximate(at.node, "one picture for all sides");
    at.maker.approximate(at.node, "the sides are blended by their angles");
    GraphNode made{.id = {}, .node = "Triplanar"};
    const Term position = at.input("position", "vector3", "@Pobject"),
               normal = at.input("normal", "vector3", "@Nobject");
    made.inputs = {{"texture", text(texture)}, {"position", position.value()}, {"normal", normal.value()}};
    Term term = terms::link(at.maker.add_node(at.node, std::move(made)), Type::Float4);
    term.is_color = true;
    return texel_as(term, at.node.type());
}

Term texcoord(const At& at) {
    const std::string index = at.word("index");
    if (!index.empty() && index != "0" && index != "1")
        at.maker.approximate(at.node, "the second coordinates: a mesh has two");
    return terms::converted(at.maker.geometry(index.empty() || index == "0" ? "UV0" : "UV1", Type::Float2), at.type());
}

// Values of the mesh by the names that programs give them.
Term mesh_value(const At& at) {
    const std::string name = at.word(at.node.category == "UsdPrimvarReader" ? "varname" : "geomprop");
    const auto is_one_of = [&](std::initializer_list<std::string_view> words) {
        return std::ranges::find(words, name) != words.end();
    };
    if (is_one_of({"st", "st0", "uv", "UV0", "UVMap", "map1", "uv0", "texcoord", "i_geomprop_UVMap"}))
        return terms::converted(at.maker.geometry("UV0", Type::Float2), at.type());
    if (is_one_of({"st1", "uv1", "UV1", "map2"}))
        return terms::converted(at.maker.geometry("UV1", Type::Float2), at.type());
    if (is_one_of({"displayColor", "Cd", "color", "Color", "geomcolor", "Col"})) {
        Term color = terms::link("@vertexColor", Type::Float4);
        color.is_color = true;
        return texel_as(color, at.node.type());
    }
    for (const std::string_view known : {"Pobject", "Pworld", "Nobject", "Nworld", "Tobject", "Tworld", "Bworld"})
        if (name == known) return terms::converted(at.maker.geometry(known, Type::Float3), at.type());
    if (at.is_set("default") || at.is_set("fallback")) {
        at.maker.approximate(at.node, fmt::format("a mesh has no value '{}': the default of the node", name));
        return at.input(at.is_set("default") ? "default" : "fallback", at.node.type(), "0");
    }
    return at.maker.magenta(at.node, at.type(), fmt::format("a mesh has no value '{}'", name));
}

Term convert(const At& at) {
    const Term value = at.input("in", "float", "0");
    // A grey has an alpha of 1.
    if (at.node.type() == "color4" && terms::width(value.type) == 1)
        return terms::converted(terms::converted(value, Type::Float3), Type::Float4);
    const Term made = terms::converted(value, at.type());
    return made.type == Type::None
               ? at.maker.magenta(at.node, at.type(),
                                  fmt::format("{} cannot become {}", terms::word(value.type), at.node.type()))
               : made;
}

Term swizzle(const At& at) {
    const std::string channels = at.word("channels");
    if (channels.empty() || channels.size() > 4 || channels.find_first_not_of("rgbaxyzw01") != channels.npos)
        return at.maker.magenta(at.node, at.type(), fmt::format("'{}' are no channels", channels));
    Term value = at.input("in", "color3", "0");
    if (channels.size() > 1 && !value.is_short()) value = at.maker.named(value);
    return terms::converted(terms::swizzled(value, channels), at.type());
}

Term extract(const At& at) {
    Term value = at.input("in", "vector3", "0");
    const std::string index = at.word("index");
    const std::string_view components = "xyzw";
    const std::size_t count = std::max<std::size_t>(terms::width(value.type), 1);
    if (!at.is_set("index") || !index.empty()) {
        const std::size_t at_index =
            index.empty() ? 0 : std::min<std::size_t>(static_cast<std::size_t>(index[0] - '0'), 3);
        if (value.is_color)
            return terms::swizzled(value, std::string_view("rgba").substr(std::min(at_index, count - 1), 1));
        return terms::swizzled(value, components.substr(std::min(at_index, count - 1), 1));
    }
    value = at.maker.named(value);
    const Term which = at.maker.named(at.input("index", "float", "0"));
    std::string text;
    for (std::size_t i = 0; i + 1 < count; ++i)
        text += fmt::format("{} < {} ? {} : ", which.text(), static_cast<double>(i) + 0.5,
                            terms::swizzled(value, components.substr(i, 1)).text());
    Term made = terms::expression(text + terms::swizzled(value, components.substr(count - 1, 1)).text(), Type::Float);
    made.sources = value.sources;
    return made;
}

Term switched(const At& at) {
    const std::string stated = at.word("which");
    if (!stated.empty() || !at.is_set("which")) {
        const int index = stated.empty() ? 0 : std::clamp(std::atoi(stated.c_str()), 0, 9);
        return at.input(fmt::format("in{}", index + 1), at.node.type(), "0");
    }
    Term which = at.maker.named(at.input("which", "float", "0"));
    int last = 1;
    for (int i = 1; i <= 10; ++i)
        if (at.is_set(fmt::format("in{}", i))) last = i;
    std::string text;
    Term holds;
    for (int i = 1; i <= last; ++i) {
        const Term value = at.maker.named(at.input(fmt::format("in{}", i), at.node.type(), "0"));
        holds.sources.insert(value.sources.begin(), value.sources.end());
        text += i < last ? fmt::format("{} < {} ? {} : ", which.text(), i, value.text()) : value.text();
    }
    Term made = terms::expression(text, at.type());
    made.sources.insert(holds.sources.begin(), holds.sources.end());
    made.sources.insert(which.sources.begin(), which.sources.end());
    return made;
}

// The world's form of a normal in tangent space, which it remembers.
Term to_world(const At& at, Term tangent) {
    tangent.name = terms::camel_case(at.node.name());
    tangent = at.maker.named(tangent);
    Term made = terms::expression(fmt::format("NormalTangentToWorld({})", tangent.text()), Type::Float3);
    made.tangent = tangent.text();
    made.sources = tangent.sources;
    return made;
}

Term normalmap(const At& at) {
    if (at.is_set("normal") || at.is_set("tangent") || at.is_set("bitangent"))
        at.maker.approximate(at.node, "the frame is that of the mesh");
    const bool is_object = at.word("space") == "object";
    if (const auto texture = is_object ? std::nullopt : normal_map_of(at.maker, at.scope, at.node, "in")) {
        Term made = at.maker.sampled_normal(at.node, *texture, at.input("scale", "float", "1", true));
        return to_world(at, std::move(made));
    }
    Term value = at.input("in", "vector3", "0.5,0.5,1");
    const Term scale = at.input("scale", "float", "1");
    if (value.is_constant() && value.numbers == std::vector<double>{0.5, 0.5, 1})
        return at.maker.geometry("Nworld", Type::Float3);
    std::string text = terms::at_least(value.text(), terms::kProduct) + " * 2 - 1";
    if (is_object) {
        Term made = terms::expression(fmt::format("Transform({}, Object, World, Normal, true)", text), Type::Float3);
        made.sources = value.sources;
        return made;
    }
    if (!scale.is_all(1))
        text = fmt::format("({}) * {}", text,
                           terms::width(scale.type) == 2 ? fmt::format("float3({}, 1)", scale.text())
                                                         : fmt::format("float3({0}, {0}, 1)", scale.text()));
    Term made = terms::expression(fmt::format("normalize({})", text), Type::Float3);
    made.sources = value.sources;
    return to_world(at, std::move(made));
}

Term gltf_normalmap(const At& at) {
    if (at.word("file").empty()) return at.maker.geometry("Nworld", Type::Float3);
    Term texel = terms::link("", Type::Float4);
    const std::string texture = at.maker.texture(at.scope, at.node, "file", "repeat", "normal");
    if (texture.empty()) return at.maker.geometry("Nworld", Type::Float3);
    texel.base = texture;
    texel.from_top = at.word("uvindex") == "1" ? "@uv1" : "@uv0";
    if (at.is_set("scale") || at.is_set("offset") || at.is_set("rotate"))
        at.maker.approximate(at.node, "its coordinates are not moved");
    return to_world(at, at.maker.sampled_normal(at.node, texel, terms::number_term(1)));
}

using Make = Term (*)(const At&);
struct Row {
    std::string_view category;
    Make make;
};
constexpr Row kRows[] = {
    {"image", image},
    {"tiledimage", tiledimage},
    {"UsdUVTexture", usd_texture},
    {"UsdUvTexture", usd_texture},
    {"gltf_image", gltf_image},
    {"gltf_colorimage", gltf_image},
    {"gltf_normalmap", gltf_normalmap},
    {"triplanarprojection", triplanar},
    {"texcoord", texcoord},
    {"geompropvalue", mesh_value},
    {"geompropvalueuniform", mesh_value},
    {"UsdPrimvarReader", mesh_value},
    {"convert", convert},
    {"swizzle", swizzle},
    {"extract", extract},
    {"switch", switched},
    {"normalmap", normalmap},
};

}  // namespace

std::optional<Term> apply_special(GraphMaker& maker, Scope& scope, const Element& node, std::string_view output) {
    for (const std::string_view noise : {"noise2d", "noise3d", "fractal2d", "fractal3d", "cellnoise2d", "cellnoise3d",
                                         "worleynoise2d", "worleynoise3d"})
        if (node.category == noise) return make_noise(maker, scope, node);
    const auto row = std::ranges::find(kRows, node.category, &Row::category);
    if (row == std::end(kRows)) return {};
    return row->make({maker, scope, node, output});
}

std::vector<std::string_view> special_nodes() {
    std::vector<std::string_view> made;
    for (const Row& row : kRows) made.push_back(row.category);
    return made;
}

}  // namespace patina::importers::mtlx

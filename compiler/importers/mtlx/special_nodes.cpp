// Nodes that no row of the table can say, by a list of functions.
#include "compiler/importers/mtlx/special_nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/mtlx/noise.h"
#include "compiler/importers/patterns.h"

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
    const Type wanted = type_of_word(type);
    if (texel.is_constant()) return terms::converted(texel, wanted);
    const bool is_part = terms::is_vector(wanted) && wanted != Type::Float4;
    return is_part ? terms::swizzled(texel, std::string_view("rgb").substr(0, terms::width(wanted))) : texel;
}

bool has_texture(const At& at, bool is_normal = false) {
    return !at.word("file").empty() || !at.maker.shown_without_file(at.scope, at.node, "file", is_normal).empty();
}

Term without_file(const At& at) {
    Term made = at.input("default", at.node.type(), "0");
    at.maker.approximate(at.node, "it names no picture: its default value");
    return made;
}

Term image(const At& at) {
    if (!has_texture(at)) return without_file(at);
    return texel_as(at.maker.sampled(at.scope, at.node, at.input("texcoord", "vector2", "@UV0")), at.node.type());
}

Term tiledimage(const At& at) {
    if (!has_texture(at)) return without_file(at);
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
        Term whole = terms::computed("a * b + c", {made, scale, bias}, Type::Float4);
        whole.name = terms::camel_case(at.node.name());
        whole.is_color = true;
        made = at.maker.named(whole);
    }
    return channel_of(made, at.output, at.node.type());
}

// Coordinates as KHR_texture_transform moves them, with v from the top.
Term gltf_coordinates(const At& at) {
    Term coordinates = at.is_set("texcoord")
                           ? at.input("texcoord", "vector2", "@UV0")
                           : at.maker.geometry(at.word("uvindex") == "1" ? "UV1" : "UV0", Type::Float2);
    const Term scale = at.input("scale", "vector2", "1"), offset = at.input("offset", "vector2", "0"),
               turn = at.input("rotate", "float", "0");
    if (scale.is_all(1) && offset.is_all(0) && turn.is_all(0)) return coordinates;
    Term flipped = terms::flipped(coordinates);
    flipped.add_nodes(coordinates);
    Term moved = terms::computed("a * b", {flipped, scale}, Type::Float2);
    if (!turn.is_all(0)) moved = terms::computed("Rotate(a, -radians(b), 0)", {moved, turn}, Type::Float2);
    moved = terms::computed("a + b", {moved, offset}, Type::Float2);
    moved.name = terms::camel_case(at.node.name()) + "Uv";
    moved = at.maker.named(moved);
    moved.from_top = moved.tree;
    if (at.is_set("pivot") || at.is_set("operationorder"))
        at.maker.approximate(at.node, "its coordinates are moved as glTF says, about the upper left corner");
    return moved;
}

Term gltf_image(const At& at) {
    if (!has_texture(at)) return without_file(at);
    const Term texel = at.maker.sampled(at.scope, at.node, gltf_coordinates(at));
    const bool is_color = at.node.category == "gltf_colorimage";
    Term made = is_color ? texel : texel_as(texel, at.node.type());
    for (const std::string_view factor : {"factor", "color", "geomcolor"}) {
        if (!at.is_set(factor) || is_color == (factor == "factor")) continue;
        const Term value = at.input(factor, is_color ? "color4" : at.node.type(), "1");
        made = terms::computed("a * b", {made, value}, made.type);
        made.is_color = true;
    }
    if (!is_color) return made;
    made.name = terms::camel_case(at.node.name()) + "Color";
    return channel_of(made.is_link() ? made : at.maker.named(made), at.output, at.node.type());
}

Term triplanar(const At& at) {
    if (at.word("filex").empty()) return without_file(at);
    const std::string texture = at.maker.texture(at.scope, at.node, "filex", at.maker.sampling_of(at.scope, at.node));
    if (texture.empty()) return at.maker.magenta(at.node, at.type(), "its picture cannot be read");
    if (at.word("filey") != at.word("filex") || at.word("filez") != at.word("filex"))
        at.maker.approximate(at.node, "one picture for all sides");
    at.maker.approximate(at.node, "the sides are blended by their angles");
    ImportedNode made{.id = {}, .node = "Triplanar"};
    const Term position = at.input("position", "vector3", "@Pobject"),
               normal = at.input("normal", "vector3", "@Nobject");
    made.inputs = {{"texture", texture}, {"position", position.value()}, {"normal", normal.value()}};
    return texel_as(terms::color_link(at.maker.add_node(at.node, std::move(made))), at.node.type());
}

// A node that blends turned pieces of a picture; its texture, or nothing.
std::optional<ImportedNode> hexagons(const At& at, std::string_view node, bool is_normal) {
    Sampling sampling = at.maker.sampling_of(at.scope, at.node);
    sampling.is_normal = is_normal;
    const std::string texture = at.maker.texture(at.scope, at.node, "file", sampling);
    if (texture.empty()) return {};
    at.maker.approximate(at.node, "other hexagons, which are all of one size");
    Term place = terms::flipped(at.input("texcoord", "vector2", "@UV0"));
    const Term tiling = at.input("tiling", "vector2", "1", true), turn = at.input("rotation", "float", "1");
    place = terms::computed("a * b", {place, tiling}, Type::Float2);
    ImportedNode made{.id = {}, .node = std::string(node), .inputs = {{"texture", texture}}};
    if (place.text() != "@uv0") made.inputs.push_back({"uv", place.value()});
    made.inputs.push_back({"density", 3.4641016F});  // in each repetition, 2 sqrt(3)
    const Term largest = terms::computed("a * 3.1415927", {turn}, Type::Float);
    made.inputs.push_back({"rotation", largest.value()});
    at.maker.written(place, "the node of the hexagons");
    at.maker.written(turn, "the node of the hexagons");
    return made;
}

Term hextiledimage(const At& at) {
    if (!has_texture(at)) return without_file(at);
    auto made = hexagons(at, "HexTiling", false);
    if (!made) return at.maker.magenta(at.node, at.type(), "its picture cannot be read");
    const Term contrast = at.input("falloffcontrast", "float", "0.5");
    made->inputs.push_back({"contrast", contrast.value()});
    at.maker.written(contrast, "the node of the hexagons");
    return texel_as(terms::color_link(at.maker.add_node(at.node, std::move(*made))), at.node.type());
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
    if (is_one_of({"displayColor", "Cd", "color", "Color", "geomcolor", "Col"}))
        return texel_as(terms::color_link("@vertexColor"), at.node.type());
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
    // A grey has an alpha of 1, before version 1.39.
    if (at.node.type() == "color4" && terms::width(value.type) == 1 && at.maker.import().document.version < 1.385)
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
    Term made = terms::swizzled(value, components.substr(count - 1, 1));
    for (std::size_t i = count - 1; i-- > 0;)
        made = terms::computed("a < b ? c : d",
                               {which, terms::number_term(static_cast<double>(i) + 0.5),
                                terms::swizzled(value, components.substr(i, 1)), made},
                               Type::Float);
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
    Term made;
    for (int i = last; i > 0; --i) {
        const Term value = at.maker.named(at.input(fmt::format("in{}", i), at.node.type(), "0"));
        made = i == last ? value
                         : terms::computed("a < b ? c : d", {which, terms::number_term(i), value, made}, at.type());
    }
    made.add_nodes(which);
    return made;
}

// The world's form of a normal in tangent space, which it remembers.
Term to_world(const At& at, Term tangent) {
    tangent.name = terms::camel_case(at.node.name());
    tangent = at.maker.named(tangent);
    Term made = terms::computed("NormalTangentToWorld(a)", {tangent}, Type::Float3);
    made.tangent = tangent.expression();
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
    if (is_object) return terms::computed("Transform(a * 2 - 1, Object, World, Normal, true)", {value}, Type::Float3);
    const std::string_view scaled = scale.is_all(1)                 ? "normalize(a * 2 - 1)"
                                    : terms::width(scale.type) == 2 ? "normalize((a * 2 - 1) * float3(b, 1))"
                                                                    : "normalize((a * 2 - 1) * float3(b, b, 1))";
    Term made = terms::computed(scaled, {value, scale}, Type::Float3);
    return to_world(at, std::move(made));
}

Term hextilednormalmap(const At& at) {
    if (!has_texture(at, true)) return at.maker.geometry("Nworld", Type::Float3);
    auto made = hexagons(at, "HexTilingNormal", true);
    if (!made) return at.maker.magenta(at.node, at.type(), "its picture cannot be read");
    const Term strength = at.input("strength", "float", "1");
    if (!strength.is_all(1)) made->inputs.push_back({"strength", strength.value()});
    at.maker.written(strength, "the node of the hexagons");
    return to_world(at, terms::link(at.maker.add_node(at.node, std::move(*made)), Type::Float3));
}

Term gltf_normalmap(const At& at) {
    if (!has_texture(at, true)) return at.maker.geometry("Nworld", Type::Float3);
    Sampling sampling = at.maker.sampling_of(at.scope, at.node);
    sampling.is_normal = true;
    const std::string texture = at.maker.texture(at.scope, at.node, "file", sampling);
    if (texture.empty()) return at.maker.geometry("Nworld", Type::Float3);
    Term texel = terms::link(texture, Type::Float4);
    texel.from_top = terms::flipped(gltf_coordinates(at)).expression();
    return to_world(at, at.maker.sampled_normal(at.node, texel, terms::number_term(1)));
}

// Steps that change nothing are left out.
Term colorcorrect(const At& at) {
    const bool has_alpha = at.type() == Type::Float4;
    const Term whole = at.input("in", at.node.type(), has_alpha ? "1,1,1,0" : "1");
    Term made = has_alpha ? terms::swizzled(whole, "rgb") : whole;
    const auto number = [&](std::string_view name, std::string_view otherwise) {
        return at.input(name, "float", otherwise);
    };
    // The pattern has "a" where the colour so far stands, and then the terms.
    const auto step = [&](bool changes, std::string_view pattern, std::initializer_list<Term> of) {
        if (!changes) return;
        made.name = terms::camel_case(at.node.name());
        const bool is_read_twice = pattern.starts_with("lerp") || pattern.starts_with("sign");
        std::vector<Term> terms = {is_read_twice ? at.maker.named(made) : made};
        terms.insert(terms.end(), of);
        const std::set<std::size_t> nodes = made.nodes;
        made = terms::computed(pattern, terms, Type::Float3);
        made.nodes.insert(nodes.begin(), nodes.end());
    };
    const Term hue = number("hue", "0"), saturation = number("saturation", "1"), gamma = number("gamma", "1"),
               lift = number("lift", "0"), gain = number("gain", "1"), contrast = number("contrast", "1"),
               pivot = number("contrastpivot", "0.5"), exposure = number("exposure", "0");
    step(!hue.is_all(0), "HsvAdjust(a, b, 1, 1)", {hue});
    step(!saturation.is_all(1), "lerp(float3(dot(a, float3(0.2722287, 0.6740818, 0.0536895))), a, b)", {saturation});
    step(!gamma.is_all(1), "sign(a) * pow(abs(a), 1 / b)", {gamma});
    step(!lift.is_all(0), "a * (1 - b) + b", {lift});
    step(!gain.is_all(1), "a * b", {gain});
    step(!contrast.is_all(1), "(a - c) * b + c", {contrast, pivot});
    step(!exposure.is_all(0), "a * exp2(b)", {exposure});
    if (!has_alpha) return made;
    Term joined = terms::computed("float4(a, b)", {made, terms::swizzled(whole, "a")}, Type::Float4);
    joined.is_color = true;
    return joined;
}

// A chain: each interval goes from the colours before it to its own.
Term ramp(const At& at) {
    const std::string kind = at.word("type"), how = at.word("interpolation");
    const int count = std::clamp(std::atoi(at.is_set("num_intervals") ? at.word("num_intervals").c_str() : "2"), 1, 10);
    Term coordinates = at.input("texcoord", "vector2", "@UV0");
    Term made, place;
    place.type = Type::Float;
    if (kind.empty() || kind == "0") {
        place = terms::swizzled(coordinates, "x");
    } else {
        coordinates = at.maker.named(coordinates);
        const std::string_view pattern = kind == "2"   ? "1.414 * distance(a, 0.5)"
                                         : kind == "3" ? "2 * max(abs(a.x - 0.5), abs(a.y - 0.5))"
                                                       : "atan2(a.x - 0.5, a.y - 0.5) / 6.28319 + 0.5";
        place = terms::computed(pattern, {coordinates}, Type::Float);
    }
    place.name = terms::camel_case(at.node.name()) + "At";
    place = at.maker.named(place);
    const auto color = [&](int i) {
        return at.input(fmt::format("color{}", i), "color4", i == 1 ? "0,0,0,1" : "1,1,1,1");
    };
    const auto interval = [&](int i) { return at.input(fmt::format("interval{}", i), "float", i == 1 ? "0" : "1"); };
    made = color(1);
    for (int i = 2; i <= count; ++i) {
        const Term low = interval(i - 1), high = interval(i), next = color(i);
        const std::string_view pattern = how == "0"   ? "lerp(a, b, saturate((e - c) / (d - c)))"
                                         : how == "2" ? "lerp(a, b, step(d, e))"
                                                      : "lerp(a, b, smoothstep(c, d, e))";
        if (i > 2) {
            made.name = terms::camel_case(at.node.name());
            made = at.maker.named(made);
        }
        made = terms::computed(pattern, {made, next, low, high, place}, Type::Float4);
        made.is_color = true;
    }
    return made;
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
    {"hextiledimage", hextiledimage},
    {"hextilednormalmap", hextilednormalmap},
    {"texcoord", texcoord},
    {"geompropvalue", mesh_value},
    {"geompropvalueuniform", mesh_value},
    {"UsdPrimvarReader", mesh_value},
    {"convert", convert},
    {"swizzle", swizzle},
    {"extract", extract},
    {"switch", switched},
    {"normalmap", normalmap},
    {"colorcorrect", colorcorrect},
    {"ramp", ramp},
};

}  // namespace

std::optional<Term> apply_special(GraphMaker& maker, Scope& scope, const Element& node, std::string_view output) {
    if (is_noise(node.category)) return make_noise(maker, scope, node);
    // A turn by 0 changes nothing.
    const At at{maker, scope, node, output};
    if ((node.category == "rotate2d" || node.category == "rotate3d") && at.input("amount", "float", "0").is_all(0))
        return at.input("in", node.type(), "0");
    const auto row = std::ranges::find(kRows, node.category, &Row::category);
    if (row == std::end(kRows)) return {};
    return row->make(at);
}

std::vector<std::string_view> special_nodes() {
    std::vector<std::string_view> made;
    for (const Row& row : kRows) made.push_back(row.category);
    return made;
}

}  // namespace patina::importers::mtlx

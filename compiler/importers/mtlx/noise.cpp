// Noise: nodes of the library, whose values are those of MaterialX.
#include "compiler/importers/mtlx/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "compiler/importers/patterns.h"

namespace patina::importers::mtlx {
namespace {

// The library's nodes that have the values of MaterialX (nodes/procedural/perlin.node.hlsl, lookup3, points).
struct Row {
    std::string_view category, node;
};
constexpr Row kNodes[] = {
    {"noise2d", "PerlinNoise2D"},       {"noise3d", "PerlinNoise3D"},       {"fractal2d", "PerlinFractal2D"},
    {"fractal3d", "PerlinFractal3D"},   {"cellnoise2d", "CellNoise2D"},     {"cellnoise3d", "CellNoise3D"},
    {"worleynoise2d", "WorleyNoise2D"}, {"worleynoise3d", "WorleyNoise3D"},
};

// Empty: it is no noise.
std::string_view node_name(std::string_view category) {
    const auto row = std::ranges::find(kNodes, category, &Row::category);
    return row == std::end(kNodes) ? std::string_view() : row->node;
}

Port position_port(bool is_flat) {
    if (is_flat) return {.name = "texcoord", .type = "vector2", .otherwise = "@UV0"};
    return {.name = "position", .type = "vector3", .otherwise = "@Pobject"};
}

// A computed number at an int port.
GraphValue whole(const Term& term) {
    const nodelang::Expr& expr = *term.expression();
    const bool is_property = expr.kind == nodelang::Expr::Kind::Call && expr.text == "float" &&
                             expr.args[0]->kind == nodelang::Expr::Kind::Property;
    return is_property ? printed(*expr.args[0]) : "= int(" + printed(expr) + ")";
}

class Noise {
public:
    Noise(GraphMaker& maker, Scope& scope, const Element& node)
        : maker_(maker), scope_(scope), node_(node), is_flat_(node.category.ends_with("2d")) {}

    Term make() {
        const std::size_t count = std::max<std::size_t>(terms::width(type_of_word(node_.type())), 1);
        const bool is_worley = node_.category.starts_with("worley"), is_cell = node_.category.starts_with("cell");
        Term position = maker_.input(scope_, node_, position_port(is_flat_));
        nodes_ = position.nodes;
        if (is_worley) {
            Term made = call("", position, 3);
            return terms::swizzled(made, std::string_view("xyz").substr(0, std::min<std::size_t>(count, 3)));
        }
        Term made;
        if (is_cell || count == 1) {
            made = call("", position, 1);
        } else if (count == 2 && node_.category.starts_with("noise")) {
            made = terms::swizzled(call("Vector", position, 3), "xy");
        } else if (count == 2) {
            const Term first = maker_.named(position);
            made = terms::computed("float2(a, b)", {call("", first, 1), call("", elsewhere(first), 1)}, Type::Float2);
        } else {
            const Term first = count == 4 ? maker_.named(position) : position;
            made = call("Vector", first, 3);
            if (count == 4) made = terms::computed("float4(a, b)", {made, call("", elsewhere(first), 1)}, Type::Float4);
        }
        made.nodes.insert(nodes_.begin(), nodes_.end());
        if (is_cell) return terms::converted(made, type_of_word(node_.type()));
        return scaled(made);
    }

private:
    // What the second half of the channels reads.
    Term elsewhere(const Term& position) {
        const bool is_fractal = node_.category.starts_with("fractal");
        const std::string_view shifted = is_fractal ? (is_flat_ ? "a + float2(19, 193)" : "a + float3(19, 193, 17)")
                                                    : (is_flat_ ? "a + float2(19, 73)" : "a + float3(19, 73, 29)");
        return terms::computed(shifted, {position}, position.type);
    }

    Term call(std::string_view kind, const Term& position, std::size_t components) {
        ImportedNode made{.id = {}, .node = fmt::format("{}{}", node_name(node_.category), kind)};
        if (position.text() != (is_flat_ ? "@uv0" : "@positionOS"))
            made.inputs.push_back({"position", position.value()});
        if (node_.category.starts_with("fractal")) {
            const Term lacunarity = input("lacunarity", "float", "2"), diminish = input("diminish", "float", "0.5");
            add_octaves(made);
            if (!lacunarity.is_all(2)) made.inputs.push_back({"lacunarity", lacunarity.value()});
            if (!diminish.is_all(0.5)) made.inputs.push_back({"gain", diminish.value()});
        }
        if (node_.category.starts_with("worley"))
            if (const Term jitter = input("jitter", "float", "1"); !jitter.is_all(1))
                made.inputs.push_back({"jitter", jitter.value()});
        if (node_.category.starts_with("worley") && maker_.word_of(scope_, node_, "style") == "1")
            made.inputs.push_back({"style", node_.type() == "float" ? "Cell" : "CellVector"});
        const std::string id = maker_.add_node(node_, std::move(made));
        Term all;
        all.nodes = nodes_;
        maker_.written(all, fmt::format("the node '{}'", id));
        return terms::link(id, terms::vector_type(components));
    }

    // The code computes 16 at most.
    void add_octaves(ImportedNode& made) {
        constexpr double kMost = 16;
        const Term octaves = input("octaves", "integer", "3");
        if (!octaves.is_constant()) {
            made.inputs.push_back({"octaves", whole(octaves)});
            const auto stated = read_number(maker_.word_of(scope_, node_, "octaves"));
            if (!stated || *stated > kMost) maker_.approximate(node_, fmt::format("it has {} octaves at most", kMost));
            return;
        }
        const double stated = octaves.numbers[0], count = std::clamp(std::floor(stated), 0.0, kMost);
        if (count != stated)
            maker_.approximate(node_, fmt::format("it has {} octaves, and not {}", count, shortest(stated)));
        if (count != 3) made.inputs.push_back({"octaves", count});
    }

    Term input(std::string_view name, std::string_view type, std::string_view otherwise) {
        Term made = maker_.input(
            scope_, node_, {.name = std::string(name), .type = std::string(type), .otherwise = std::string(otherwise)},
            true);
        nodes_.insert(made.nodes.begin(), made.nodes.end());
        return made;
    }

    // amplitude * noise + pivot
    Term scaled(Term noise) {
        const std::string type(node_.type());
        const Term amplitude = input("amplitude", maker_.is_set(scope_, node_, "amplitude") ? "" : "float", "1"),
                   pivot = input("pivot", "float", "0");
        Term made = terms::computed("a * b + c", {noise, amplitude, pivot}, type_of_word(type));
        made.nodes.insert(nodes_.begin(), nodes_.end());
        return made;
    }

    GraphMaker& maker_;
    Scope& scope_;
    const Element& node_;
    bool is_flat_;
    std::set<std::size_t> nodes_{};
};

}  // namespace

bool is_noise(std::string_view category) {
    return !node_name(category).empty();
}

Term make_noise(GraphMaker& maker, Scope& scope, const Element& node) {
    return Noise(maker, scope, node).make();
}

}  // namespace patina::importers::mtlx

// Noise: a node of a file beside the graph, whose values are those of MaterialX.
#include "compiler/importers/mtlx/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/importers/mtlx/graph_maker.h"
#include "compiler/importers/mtlx/noise_code.h"

namespace patina::importers::mtlx {
namespace {

struct Code {
    std::string_view kind, file;
    std::initializer_list<std::string_view> parts;
};
const Code kCode[] = {
    {"noise2d", "noise2d", {kHash, kFade, kGradient2, kNoise2}},
    {"noise2d vector", "noise2d-vector", {kHash, kFade, kGradient2, kNoise2Vector}},
    {"noise3d", "noise3d", {kHash, kFade, kGradient3, kNoise3}},
    {"noise3d vector", "noise3d-vector", {kHash, kFade, kGradient3, kNoise3Vector}},
    {"fractal2d", "fractal2d", {kHash, kFade, kGradient2, kFractal2}},
    {"fractal2d vector", "fractal2d-vector", {kHash, kFade, kGradient2, kFractal2Vector}},
    {"fractal3d", "fractal3d", {kHash, kFade, kGradient3, kFractal3}},
    {"fractal3d vector", "fractal3d-vector", {kHash, kFade, kGradient3, kFractal3Vector}},
    {"cellnoise2d", "cellnoise2d", {kHash, kFraction, kCell2}},
    {"cellnoise3d", "cellnoise3d", {kHash, kFraction, kCell3}},
    {"worleynoise2d", "worleynoise2d", {kHash, kFraction, kWorley2}},
    {"worleynoise3d", "worleynoise3d", {kHash, kHash4, kFraction, kWorley3}},
};

Port position_port(bool is_flat) {
    if (is_flat) return {.name = "texcoord", .type = "vector2", .otherwise = "@UV0"};
    return {.name = "position", .type = "vector3", .otherwise = "@Pobject"};
}

// The whole of an int port.
Value whole(const Term& term) {
    if (term.is_constant()) return number(std::floor(term.numbers[0]));
    const std::string whole = term.text();
    if (whole.starts_with("float($") && whole.find(')') + 1 == whole.size())
        return text(whole.substr(6, whole.size() - 7));
    return text("= int(" + whole + ")");
}

class Noise {
public:
    Noise(GraphMaker& maker, Scope& scope, const Element& node)
        : maker_(maker), scope_(scope), node_(node), is_flat_(node.category.ends_with("2d")) {}

    Term make() {
        const std::size_t count = std::max<std::size_t>(terms::width(type_of_word(node_.type())), 1);
        const bool is_worley = node_.category.starts_with("worley"), is_cell = node_.category.starts_with("cell");
        Term position = maker_.input(scope_, node_, position_port(is_flat_));
        sources_ = position.sources;
        if (is_worley) {
            if (maker_.word_of(scope_, node_, "style") == "1")
                maker_.approximate(node_, "the distances to the nearest points, not the numbers of their cells");
            Term made = call("", position, 3);
            return terms::swizzled(made, std::string_view("xyz").substr(0, std::min<std::size_t>(count, 3)));
        }
        Term made;
        if (is_cell || count == 1) {
            made = call("", position, 1);
        } else if (count == 2 && node_.category.starts_with("noise")) {
            made = terms::swizzled(call(" vector", position, 3), "xy");
        } else if (count == 2) {
            const Term first = maker_.named(position);
            made = terms::expression(
                fmt::format("float2({}, {})", call("", first, 1).text(), call("", elsewhere(first), 1).text()),
                Type::Float2);
        } else {
            const Term first = count == 4 ? maker_.named(position) : position;
            made = call(" vector", first, 3);
            if (count == 4)
                made = terms::expression(
                    fmt::format("float4({}, {})", made.text(), call("", elsewhere(first), 1).text()), Type::Float4);
        }
        made.sources.insert(sources_.begin(), sources_.end());
        if (is_cell) return terms::converted(made, type_of_word(node_.type()));
        return scaled(made);
    }

private:
    // What the second half of the channels reads.
    Term elsewhere(const Term& position) {
        Term made = position;
        made.swizzle.clear();
        made.numbers.clear();
        made.parts.clear();
        made.from_top.clear();
        const bool is_fractal = node_.category.starts_with("fractal");
        const std::string_view shift = is_fractal ? (is_flat_ ? "float2(19, 193)" : "float3(19, 193, 17)")
                                                  : (is_flat_ ? "float2(19, 73)" : "float3(19, 73, 29)");
        made.base = fmt::format("{} + {}", terms::at_least(position.text(), terms::kSum), shift);
        return made;
    }

    Term call(std::string_view kind, const Term& position, std::size_t components) {
        const std::string what = std::string(node_.category) + std::string(kind);
        GraphNode made{.id = {}, .node = "./" + maker_.noise_file(what)};
        made.inputs.push_back({"position", position.value()});
        if (node_.category.starts_with("fractal")) {
            const Term octaves = input("octaves", "integer", "3"), lacunarity = input("lacunarity", "float", "2"),
                       diminish = input("diminish", "float", "0.5");
            if (!octaves.is_all(3)) made.inputs.push_back({"octaves", whole(octaves)});
            if (!lacunarity.is_all(2)) made.inputs.push_back({"lacunarity", lacunarity.value()});
            if (!diminish.is_all(0.5)) made.inputs.push_back({"diminish", diminish.value()});
            if (octaves.is_constant() && octaves.numbers[0] > 16) maker_.approximate(node_, "it has 16 octaves");
        }
        if (node_.category.starts_with("worley"))
            if (const Term jitter = input("jitter", "float", "1"); !jitter.is_all(1))
                made.inputs.push_back({"jitter", jitter.value()});
        const std::string id = maker_.add_node(node_, std::move(made));
        Term all;
        all.sources = sources_;
        maker_.written(all, fmt::format("the node '{}'", id));
        return terms::link(id, terms::vector_type(components));
    }

    Term input(std::string_view name, std::string_view type, std::string_view otherwise) {
        Term made = maker_.input(
            scope_, node_, {.name = std::string(name), .type = std::string(type), .otherwise = std::string(otherwise)},
            true);
        sources_.insert(made.sources.begin(), made.sources.end());
        return made;
    }

    // amplitude * noise + pivot
    Term scaled(Term noise) {
        const std::string type(node_.type());
        const Term amplitude = input("amplitude", maker_.is_set(scope_, node_, "amplitude") ? "" : "float", "1"),
                   pivot = input("pivot", "float", "0");
        std::string text = terms::at_least(noise.text(), terms::kProduct);
        if (!amplitude.is_all(1)) text += " * " + terms::at_least(amplitude.text(), terms::kUnary);
        if (!pivot.is_all(0)) text += " + " + terms::at_least(pivot.text(), terms::kProduct);
        if (text == noise.text()) return noise;
        Term made = terms::expression(text, type_of_word(type));
        made.parts.clear();
        made.sources = sources_;
        made.sources.insert(noise.sources.begin(), noise.sources.end());
        return made;
    }

    GraphMaker& maker_;
    Scope& scope_;
    const Element& node_;
    bool is_flat_;
    std::set<std::size_t> sources_{};
};

}  // namespace

std::string GraphMaker::noise_file(std::string_view kind) {
    std::string& file = import_.node_files[std::string(kind)];
    if (!file.empty()) return file;
    const auto code = std::ranges::find(kCode, kind, &Code::kind);
    file = import_.file_names.unique(code->file, "noise") + ".node.hlsl";
    std::string text =
        "// Noise of MaterialX: Perlin 2002 and Worley 1996 over the hash lookup3 of Bob Jenkins, 2006.\n";
    for (const std::string_view part : code->parts) text += part;
    import_.files.push_back({.name = file, .text = std::move(text)});
    return file;
}

Term make_noise(GraphMaker& maker, Scope& scope, const Element& node) {
    return Noise(maker, scope, node).make();
}

}  // namespace patina::importers::mtlx

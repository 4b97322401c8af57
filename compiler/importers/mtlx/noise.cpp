// Noise: a node of a file beside the graph, whose values are those of MaterialX.
#include "compiler/importers/mtlx/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "compiler/importers/mtlx/noise_code.h"

namespace patina::importers::mtlx {
namespace {

// `tests`: what a template does not say, for the function's own numbers.
struct Code {
    std::string_view kind, file;
    std::initializer_list<std::string_view> parts;
    std::string_view tests{};
};
const Code kCode[] = {
    {"noise2d",
     "noise2d",
     {kHash, kFade, kGradient2, kNoise},
     "/// test: MaterialXNoise2D(float2(0.3, 0.45)) == 0.162413265756003\n"
     "/// test: MaterialXNoise2D(float2(-1.25, 7.75)) == -0.4147391876220703\n"},
    {"noise2d vector",
     "noise2d-vector",
     {kHash, kFade, kGradient2, kNoise},
     "/// test: MaterialXNoise2DVector(float2(-1.25, 7.75)) == float3(-0.4147391876220703, -0.14888044281005858, "
     "-0.5882948593139649)\n"},
    {"noise3d",
     "noise3d",
     {kHash, kFade, kGradient3, kNoise},
     "/// test: MaterialXNoise3D(float3(0.3, 0.45, 0.7)) == 0.2226468976867436\n"
     "/// test: MaterialXNoise3D(float3(-1.25, 7.75, 2.5)) == -0.03380419921875\n"},
    {"noise3d vector",
     "noise3d-vector",
     {kHash, kFade, kGradient3, kNoise},
     "/// test: MaterialXNoise3DVector(float3(-1.25, 7.75, 2.5)) == float3(-0.03380419921875, -0.35291280555725096, "
     "0.31253197765350343)\n"},
    {"fractal2d",
     "fractal2d",
     {kHash, kFade, kGradient2, kFractal},
     "/// test: MaterialXFractal2D(float2(0.3, 0.45), 3, 2, 0.5) == 0.26213917358883493\n"},
    {"fractal2d vector",
     "fractal2d-vector",
     {kHash, kFade, kGradient2, kFractal},
     "/// test: MaterialXFractal2DVector(float2(0.3, 0.45), 3, 2, 0.5) == float3(0.26213917358883493, "
     "0.9559134228479428, "
     "-0.41040932322394513)\n"},
    {"fractal3d",
     "fractal3d",
     {kHash, kFade, kGradient3, kFractal},
     "/// test: MaterialXFractal3D(float3(0.3, 0.45, 0.7), 4, 2, 0.5) == 0.29472767090639446\n"},
    {"fractal3d vector",
     "fractal3d-vector",
     {kHash, kFade, kGradient3, kFractal},
     "/// test: MaterialXFractal3DVector(float3(0.3, 0.45, 0.7), 3, 2, 0.5) == float3(0.2960960272982469, "
     "-0.8020272276767495, -0.05610100081413897)\n"},
    {"cellnoise2d",
     "cellnoise2d",
     {kHash, kFraction, kCell},
     "/// test: MaterialXCellNoise2D(float2(-1.25, 7.75)) == 0.06009313721677594\n"},
    {"cellnoise3d",
     "cellnoise3d",
     {kHash, kFraction, kCell},
     "/// test: MaterialXCellNoise3D(float3(-1.25, 7.75, 2.5)) == 0.4837402348601586\n"},
    {"worleynoise2d", "worleynoise2d", {kHash, kFraction, kWorley2}},
    {"worleynoise3d", "worleynoise3d", {kHash, kHash4, kFraction, kWorley3}},
};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
        text.replace(at, what.size(), by);
}

// The gradient noise at a place, in each channel of a vector another one.
std::string noise_at(std::string_view place, std::string_view dimensions, bool is_vector) {
    std::string made;
    for (const int shift : {0, 8, 16})
        if (is_vector || shift == 0)
            made += fmt::format("{}Gradient{}({}, {}u)", shift > 0 ? ", " : "", dimensions, place, shift);
    return is_vector ? "float3(" + made + ")" : made;
}

std::string text_of(const Code& code) {
    std::string text =
        "// Noise of MaterialX: Perlin 2002 and Worley 1996 over the hash lookup3 of Bob Jenkins, 2006.\n";
    for (const std::string_view part : code.parts) text += part;
    const bool is_vector = code.kind.ends_with(" vector");
    const std::string_view dimensions = code.kind.find("2d") != code.kind.npos ? "2" : "3";
    replace_all(text, "<noise(position)>", noise_at("position", dimensions, is_vector));
    replace_all(text, "<noise(at)>", noise_at("at", dimensions, is_vector));
    replace_all(text, "<tests>", code.tests);
    replace_all(text, "<each>", is_vector ? ", another one in each channel" : "");
    replace_all(text, "<cell>",
                dimensions == "2" ? "int(cell.x), int(cell.y)" : "int(cell.x), int(cell.y), int(cell.z)");
    replace_all(text, "<N>", dimensions);
    replace_all(text, "<T>", is_vector ? "float3" : "float");
    replace_all(text, "<V>", is_vector ? "Vector" : "");
    replace_all(text, "< V>", is_vector ? " Vector" : "");
    return text;
}

Port position_port(bool is_flat) {
    if (is_flat) return {.name = "texcoord", .type = "vector2", .otherwise = "@UV0"};
    return {.name = "position", .type = "vector3", .otherwise = "@Pobject"};
}

// A computed number at an int port.
Value whole(const Term& term) {
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
        nodes_ = position.nodes;
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
            made = terms::parsed(
                fmt::format("float2({}, {})", call("", first, 1).text(), call("", elsewhere(first), 1).text()),
                Type::Float2);
        } else {
            const Term first = count == 4 ? maker_.named(position) : position;
            made = call(" vector", first, 3);
            if (count == 4)
                made = terms::parsed(fmt::format("float4({}, {})", made.text(), call("", elsewhere(first), 1).text()),
                                     Type::Float4);
        }
        made.nodes.insert(nodes_.begin(), nodes_.end());
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
            const Term lacunarity = input("lacunarity", "float", "2"), diminish = input("diminish", "float", "0.5");
            add_octaves(made);
            if (!lacunarity.is_all(2)) made.inputs.push_back({"lacunarity", lacunarity.value()});
            if (!diminish.is_all(0.5)) made.inputs.push_back({"diminish", diminish.value()});
        }
        if (node_.category.starts_with("worley"))
            if (const Term jitter = input("jitter", "float", "1"); !jitter.is_all(1))
                made.inputs.push_back({"jitter", jitter.value()});
        const std::string id = maker_.add_node(node_, std::move(made));
        Term all;
        all.nodes = nodes_;
        maker_.written(all, fmt::format("the node '{}'", id));
        return terms::link(id, terms::vector_type(components));
    }

    // The code computes 16 at most.
    void add_octaves(GraphNode& made) {
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
        if (count != 3) made.inputs.push_back({"octaves", number(count)});
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
        std::string text = terms::at_least(noise.text(), terms::kProduct);
        if (!amplitude.is_all(1)) text += " * " + terms::at_least(amplitude.text(), terms::kUnary);
        if (!pivot.is_all(0)) text += " + " + terms::at_least(pivot.text(), terms::kProduct);
        if (text == noise.text()) return noise;
        Term made = terms::parsed(text, type_of_word(type));
        made.parts.clear();
        made.nodes = nodes_;
        made.add_nodes(noise);
        return made;
    }

    GraphMaker& maker_;
    Scope& scope_;
    const Element& node_;
    bool is_flat_;
    std::set<std::size_t> nodes_{};
};

}  // namespace

std::string GraphMaker::noise_file(std::string_view kind) {
    std::string& file = import_.node_files[std::string(kind)];
    if (!file.empty()) return file;
    const auto code = std::ranges::find(kCode, kind, &Code::kind);
    file = import_.file_names.unique(code->file, "noise") + ".node.hlsl";
    import_.files.push_back({.name = file, .text = text_of(*code)});
    return file;
}

Term make_noise(GraphMaker& maker, Scope& scope, const Element& node) {
    return Noise(maker, scope, node).make();
}

}  // namespace patina::importers::mtlx

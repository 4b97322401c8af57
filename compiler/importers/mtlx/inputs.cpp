// What a node's inputs say that is not understood: words, inputs that the node does not have, interfaces that are not
// there.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {
namespace {

constexpr std::string_view kPicture = "file default texcoord uaddressmode vaddressmode filtertype",
                           kFrames = "framerange frameoffset frameendaction",
                           kPlaced =
                               "file default texcoord uvindex uaddressmode vaddressmode filtertype factor color "
                               "geomcolor pivot scale rotate offset operationorder",
                           kHexagons =
                               "file default texcoord tiling rotation rotationrange scale scalerange offset "
                               "offsetrange falloff falloffcontrast lumacoeffs strength flip_g normal tangent "
                               "bitangent",
                           kNoise = "amplitude pivot octaves lacunarity diminish jitter style texcoord position";

// The inputs of nodes that are not in the table of nodes, and those that the table does not read.
struct Known {
    std::string_view nodes, inputs, more{};
};
constexpr Known kKnown[] = {
    {"image", kPicture, "layer framerange frameoffset frameendaction"},
    {"tiledimage", kPicture, "layer uvtiling uvoffset realworldimagesize realworldtilesize"},
    {"tiledimage", kFrames},
    {"UsdUVTexture UsdUvTexture", "file st wrapS wrapT fallback scale bias"},
    {"gltf_image gltf_colorimage gltf_normalmap", kPlaced},
    {"triplanarprojection", "filex filey filez layerx layery layerz default position normal upaxis blend", kFrames},
    {"triplanarprojection", "filtertype"},
    {"hextiledimage hextilednormalmap", kHexagons},
    {"texcoord geomcolor tangent bitangent", "index"},
    {"geompropvalue geompropvalueuniform", "geomprop default"},
    {"UsdPrimvarReader", "varname fallback"},
    {"convert", "in"},
    {"swizzle", "in channels"},
    {"extract", "in index"},
    {"switch", "in1 in2 in3 in4 in5 in6 in7 in8 in9 in10 which"},
    {"normalmap", "in scale normal tangent bitangent space"},
    {"colorcorrect", "in hue saturation gamma lift gain contrast contrastpivot exposure"},
    {"ramp", "texcoord type interpolation num_intervals interval1 interval2 interval3 interval4 interval5 interval6",
     "interval7 interval8 interval9 interval10 color1 color2 color3 color4 color5 color6 color7 color8 color9 color10"},
    {"noise2d noise3d fractal2d fractal3d cellnoise2d cellnoise3d worleynoise2d worleynoise3d", kNoise},
    {"dot", "note"},
    {"bump", "normal tangent bitangent"},
    {"heighttonormal", "texcoord"},
    {"time", "fps"},
    {"blur", "size filtertype"},
    {"ambientocclusion", "coneangle maxdistance"},
    {"layer", "top base"},
    {"surface", "bsdf edf opacity thin_walled"},
};

// The words of a string, and what stands for all others. Without nodes: of all.
struct Words {
    std::string_view nodes, input, words, text;
};
constexpr std::string_view kUsual = "the default stands for it";
constexpr Words kWords[] = {
    {"position normal tangent bitangent viewdirection", "space", "model object world", kUsual},
    {"normalmap", "space", "tangent object", kUsual},
    {"transformpoint transformvector transformnormal", "fromspace", "model object world tangent", kUsual},
    {"transformpoint transformvector transformnormal", "tospace", "model object world tangent", kUsual},
    {"", "uaddressmode", "constant clamp periodic mirror", kUsual},
    {"", "vaddressmode", "constant clamp periodic mirror", kUsual},
    {"", "wrapS", "black clamp periodic repeat mirror useMetadata", kUsual},
    {"", "wrapT", "black clamp periodic repeat mirror useMetadata", kUsual},
    {"image tiledimage gltf_image gltf_colorimage gltf_normalmap triplanarprojection", "filtertype",
     "closest linear cubic", kUsual},
    {"place2d", "operationorder", "0 1", kUsual},
    {"ramp", "type", "0 1 2 3", kUsual},
    {"ramp", "interpolation", "0 1 2", kUsual},
    {"UsdPreviewSurface", "opacityMode", "0 1 transparent presence", kUsual},
    {"UsdPreviewSurface", "useSpecularWorkflow", "0 1 false true", kUsual},
    {"geomcolor tangent bitangent", "index", "0", "a mesh has one set of them"},
};

bool is_one_of(std::string_view word, std::string_view words) {
    return std::ranges::any_of(split(words, " "), [&](std::string_view each) { return each == word; });
}

}  // namespace

void GraphMaker::check_inputs(Scope& scope, const Element& node) {
    const Element* definition = nullptr;
    implementation(node, definition);
    bool is_known_node = definition || is_in_table(node.category);
    for (const Known& each : kKnown) is_known_node |= is_one_of(node.category, each.nodes);
    const auto has_input = [&](std::string_view name) {
        const auto is_of = [&](const Known& each) {
            return is_one_of(node.category, each.nodes) && (is_one_of(name, each.inputs) || is_one_of(name, each.more));
        };
        return (definition && input_of(*definition, name)) || reads_input(node.category, name) ||
               std::ranges::any_of(kKnown, is_of);
    };
    for (const Element& each : node.children) {
        if (!is_input(each)) continue;
        const std::string part = fmt::format("input '{}'", each.name());
        if (is_known_node && !surface_rule(node.category) && !has_input(each.name()))
            remark(Remark::Kind::Changed, part, fmt::format("'{}' has no such input", node.category), each);
        if (each.has("interfacename") && !source_of(scope, node, each.name()).input)
            remark(Remark::Kind::LeftOut, part,
                   fmt::format("it reads '{}', which is no input of the node graph around: the default stands for it",
                               each.attribute("interfacename")),
                   each);
    }
    for (const Words& each : kWords) {
        if (!each.nodes.empty() && !is_one_of(node.category, each.nodes)) continue;
        const Element* const stated = input_of(node, each.input);
        const std::string word = stated ? word_of(scope, node, each.input) : std::string();
        if (word.empty() || is_one_of(word, each.words)) continue;
        std::string words;
        for (const std::string_view known : split(each.words, " "))
            words += fmt::format("{}'{}'", words.empty() ? "" : ", ", known);
        remark(Remark::Kind::Changed, fmt::format("input '{}'", each.input),
               fmt::format("'{}' is {} {}: {}", word.substr(0, 40), each.words.size() == 1 ? "not" : "none of", words,
                           each.text),
               *stated);
    }
}

}  // namespace patina::importers::mtlx

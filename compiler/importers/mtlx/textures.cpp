// Pictures: the property that shows a file, and the node that samples it. Coordinates of MaterialX begin at the lower
// left corner of a picture, and those of a graph at the upper left one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/base/disk/disk.h"
#include "compiler/importers/mtlx/colors.h"
#include "compiler/importers/mtlx/special_nodes.h"
#include "compiler/importers/patterns.h"

namespace patina::importers::mtlx {
namespace {

namespace fs = std::filesystem;

std::string wrap_word(std::string_view mode) {
    if (mode == "clamp" || mode == "constant" || mode == "black") return "clamp";
    return mode == "mirror" ? "mirror" : "repeat";
}

// Only colours have a colour space, whatever the elements around say.
Colorspace space_of(const Element& node, const Element& input) {
    const std::string_view type = node.type();
    return type == "float" || type.starts_with("vector") ? Colorspace{} : colorspace_of(input.colorspace);
}

}  // namespace

Sampling GraphMaker::sampling_of(Scope& scope, const Element& node, std::string_view wrap_input,
                                 std::string_view other_wrap_input) {
    const std::string mode = word_of(scope, node, wrap_input), other = word_of(scope, node, other_wrap_input);
    const std::string wrap = wrap_word(mode), filter = word_of(scope, node, "filtertype");
    if (wrap != wrap_word(other)) approximate(node, fmt::format("'{}' along v, too: a sampler has one word", wrap));
    if (mode == "constant" || mode == "black")
        approximate(node, "outside of the picture, the colour of its edge goes on");
    if (filter == "cubic") approximate(node, "the filter is linear");
    return {.wrap = wrap, .filter = filter == "closest" ? "nearest" : "linear"};
}

std::string GraphMaker::shown_without_file(Scope& scope, const Element& node, std::string_view file_input,
                                           bool is_normal) {
    const Source source = source_of(scope, node, file_input);
    if (!source.is_interface || !source.input->attribute("value").empty()) return {};
    if (is_normal) return "bump";
    const std::string_view name = is_set(scope, node, "fallback") ? "fallback" : "default";
    const Term otherwise = input(scope, node, {.name = std::string(name), .otherwise = "0"});
    // A file's grey is decoded, as a colour.
    const double grey = space_of(node, *source.input).is_color ? 0.21404114 : 0.5;
    const std::pair<std::string_view, std::vector<double>> shown[] = {
        {"white", {1, 1, 1}}, {"black", {0, 0, 0}}, {"gray", {grey, grey, grey}}, {"bump", {0.5, 0.5, 1}}};
    for (const auto& [word, color] : shown) {
        bool is_same = otherwise.is_constant();
        for (std::size_t i = 0; i < otherwise.numbers.size(); ++i) {
            const bool is_unset_alpha = i == 3 && !is_set(scope, node, name);
            is_same &= is_unset_alpha || std::abs(otherwise.numbers[i] - (i == 3 ? 1 : color[i])) < 1e-6;
        }
        if (is_same) return std::string(word);
    }
    return {};
}

std::string GraphMaker::texture(Scope& scope, const Element& node, std::string_view file_input,
                                const Sampling& sampling) {
    const Source source = source_of(scope, node, file_input);
    if (!source.input) return {};
    const std::string stated = source.input->fileprefix + std::string(source.input->attribute("value"));
    if (stated.find('<') != stated.npos || stated.find("%0") != stated.npos || stated.find('{') != stated.npos) {
        refuse(node, fmt::format("'{}' stands for several pictures", stated));
        return {};
    }
    const bool is_normal = sampling.is_normal;
    const Colorspace space = space_of(node, *source.input);
    if (!is_normal) {
        if (!space.is_known)
            approximate(node, fmt::format("the colour space '{}' is not known: its numbers are taken as linear",
                                          source.input->colorspace));
        else if (space.is_color && space.gamma != 0)
            approximate(node, fmt::format("'{}' is decoded as sRGB", source.input->colorspace));
        if (space.matrix)
            approximate(node, fmt::format("the primaries of '{}' are those of sRGB", source.input->colorspace));
    }
    Texture& texture =
        textures_[fmt::format("{}\n{}\n{}\n{}\n{}\n{}", stated, sampling.wrap, sampling.filter, is_normal,
                              space.is_color, source.is_interface ? source.input->name() : "")];
    if (!texture.property.empty()) return "$" + texture.property;

    const fs::path name(stated);
    std::vector<fs::path> candidates = {fs::path(source.input->folder) / name};
    for (const std::string& folder : import_.folders) candidates.push_back(fs::path(folder) / name);
    std::string file;
    std::error_code wrong;
    for (const fs::path& each : candidates) {
        if (!file.empty() || !is_on_disk(each.string())) continue;
        const fs::path output = fs::absolute(import_.folder.empty() ? "." : import_.folder, wrong).lexically_normal();
        const fs::path picture = fs::absolute(each, wrong).lexically_normal();
        file = (picture.parent_path().lexically_relative(output) / picture.filename()).generic_string();
        if (!file.starts_with("../") && !file.starts_with("./")) file = "./" + file;
    }
    std::string wanted =
        terms::pascal_case(source.is_interface ? std::string(source.input->name()) : name.stem().string());
    texture.property = file_.property_names.unique("_" + wanted, "_texture");
    texture.is_normal = is_normal;
    ImportedProperty made{.name = texture.property, .type = "texture2d"};
    const std::string shown = shown_without_file(scope, node, file_input, is_normal);
    made.value = !shown.empty()  ? std::string_view(shown)
                 : !file.empty() ? std::string_view(file)
                 : is_normal     ? std::string_view("bump")
                                 : std::string_view("white");
    if (is_normal)
        made.more.push_back({"usage", "normal"});
    else if (!space.is_color)
        made.more.push_back({"usage", "data"});
    GraphMembers sampler;
    if (sampling.wrap != "repeat") sampler.push_back({"wrap", sampling.wrap});
    if (sampling.filter == "nearest") sampler.push_back({"filter", "nearest"});
    if (!sampler.empty()) made.more.push_back({"sampler", GraphValue::object(sampler)});
    if (source.is_interface) {
        describe(*source.input, made);
        import_.reached.insert(source.input);
        remark(Remark::Kind::Taken, fmt::format("input '{}'", source.input->name()),
               fmt::format("the property '{}'", made.name), *source.input);
    }
    if (file.empty() && shown.empty()) {
        made.comment = fmt::format("The picture '{}' was not found.", stated);
        approximate(node, fmt::format("the picture '{}' is not there: the texture is {}", stated,
                                      is_normal ? "flat" : "white"));
    }
    file_.properties.push_back(std::move(made));
    property_places_.push_back(source.input);
    return "$" + texture.property;
}

Term GraphMaker::sampled(Scope& scope, const Element& node, Term coordinates, std::string_view file_input,
                         std::string_view wrap_input, std::string_view other_wrap_input) {
    const Sampling sampling = sampling_of(scope, node, wrap_input, other_wrap_input);
    for (const std::string_view each : {"layer", "framerange"})
        if (!word_of(scope, node, each).empty()) approximate(node, fmt::format("its '{}' is not read", each));
    const std::string property = texture(scope, node, file_input, sampling);
    if (property.empty())
        return magenta(node, Type::Float4,
                       fmt::format("'{}' is no picture that can be read", word_of(scope, node, file_input)));
    if (!coordinates.from_top && !coordinates.is_short()) coordinates = named(coordinates);
    Term place = terms::flipped(coordinates);
    place.nodes = coordinates.nodes;
    std::string& id = samples_[property + " " + place.text()];
    if (id.empty()) {
        ImportedNode made{.id = {}, .node = "SampleTexture2D", .inputs = {{"texture", property}}};
        if (place.text() != "@uv0") made.inputs.push_back({"uv", place.value()});
        const std::string wanted = terms::camel_case(std::string_view(property).substr(2));
        id = add_node(node, std::move(made), wanted);
    }
    written(coordinates, fmt::format("the node '{}'", id));
    Term read;
    read.nodes.insert(number_of(node));
    written(read, fmt::format("the node '{}'", id));
    return terms::color_link(id);
}

Term GraphMaker::sampled_normal(const Element& node, const Term& texel, const Term& scale) {
    const std::string texture = texel.text(), place = printed(*texel.from_top);
    std::string& id = samples_[fmt::format("{} {} {}", texture, place, scale.text())];
    if (id.empty()) {
        ImportedNode made{.id = {}, .node = "SampleNormalMap", .inputs = {{"texture", texture}}};
        if (place != "@uv0") made.inputs.push_back({"uv", place});
        if (!scale.is_all(1)) made.inputs.push_back({"scale", scale.value()});
        id = add_node(node, std::move(made), terms::camel_case(std::string_view(texture).substr(2)));
    }
    written(texel, fmt::format("the node '{}'", id));
    written(scale, fmt::format("the node '{}'", id));
    Term made = terms::link(id, Type::Float3);
    made.nodes = texel.nodes;
    return made;
}

std::optional<Term> normal_map_of(GraphMaker& maker, Scope& scope, const Element& node, std::string_view input) {
    const Source source = maker.source_of(scope, node, input);
    if (!source.input || !source.input->has("nodename") || source.input->has("channels")) return {};
    const Element* const found = maker.find(*source.scope, source.input->attribute("nodename"));
    if (!found || maker.uses(*source.scope, *found) > 1) return {};
    const bool is_tiled = found->category == "tiledimage", is_usd = found->category == "UsdUVTexture";
    if (found->category != "image" && !is_tiled && !is_usd) return {};
    if (type_of_word(found->type()) != Type::Float3 && !is_usd) return {};
    if (maker.word_of(*source.scope, *found, "file").empty() &&
        maker.shown_without_file(*source.scope, *found, "file", true).empty())
        return {};
    if (is_usd) {
        const Term scale = maker.input(*source.scope, *found, {.name = "scale", .type = "color4", .otherwise = "1"});
        const Term bias = maker.input(*source.scope, *found, {.name = "bias", .type = "color4", .otherwise = "0"});
        if (!scale.is_constant() || !bias.is_constant()) return {};
        const bool is_decoded = scale.numbers[0] == 2 && bias.numbers[0] == -1;
        // A normal map's own node decodes; the surface of USD takes what the texture has decoded.
        if (is_decoded != (node.category == "UsdPreviewSurface")) return {};
    } else if (node.category == "UsdPreviewSurface") {
        return {};
    }
    Sampling sampling =
        maker.sampling_of(*source.scope, *found, is_usd ? "wrapS" : "uaddressmode", is_usd ? "wrapT" : "vaddressmode");
    sampling.is_normal = true;
    const std::string texture = maker.texture(*source.scope, *found, "file", sampling);
    if (texture.empty()) return {};
    Term made = terms::link(texture, Type::Float4);
    Term coordinates = is_tiled
                           ? tiled_coordinates(maker, *source.scope, *found)
                           : maker.input(*source.scope, *found,
                                         {.name = is_usd ? "st" : "texcoord", .type = "vector2", .otherwise = "@UV0"});
    Term place = terms::flipped(coordinates);
    if (!place.is_link()) {
        place.name = terms::camel_case(found->name()) + "Uv";
        place = maker.named(place);
    }
    made.from_top = place.expression();
    made.nodes = coordinates.nodes;
    made.nodes.insert(maker.note(*found));
    return made;
}

// texcoord * uvtiling - uvoffset, in tiles of the real size.
Term tiled_coordinates(GraphMaker& maker, Scope& scope, const Element& node) {
    const auto port = [&](std::string_view name, std::string_view otherwise) {
        return maker.input(scope, node,
                           {.name = std::string(name), .type = "vector2", .otherwise = std::string(otherwise)});
    };
    Term at = port("texcoord", "@UV0");
    const Term tiling = port("uvtiling", "1"), offset = port("uvoffset", "0"),
               image_size = port("realworldimagesize", "1"), tile_size = port("realworldtilesize", "1");
    std::set<std::size_t> nodes = at.nodes;
    for (const Term* each : {&tiling, &offset, &image_size, &tile_size})
        nodes.insert(each->nodes.begin(), each->nodes.end());
    if (at.from_top && tiling.is_constant() && offset.is_constant() && image_size.is_constant() &&
        tile_size.is_constant()) {
        // Counted from the top, the picture begins elsewhere; a whole number of tiles is no difference.
        double scale[2], shift[2];
        for (std::size_t i = 0; i < 2; ++i) {
            const double real = image_size.numbers[i] == 0 ? 1 : tile_size.numbers[i] / image_size.numbers[i];
            scale[i] = tiling.numbers[i] * real;
            shift[i] = i == 0 ? -offset.numbers[i] * real : 1 - scale[i] + offset.numbers[i] * real;
            shift[i] -= std::floor(shift[i] + 1e-9);
            if (std::abs(shift[i]) < 1e-6) shift[i] = 0;
        }
        const Term from_top{.type = Type::Float2, .tree = at.from_top};
        const Term factor = scale[0] == scale[1] ? terms::number_term(scale[0]) : terms::constant({scale[0], scale[1]});
        Term sampled =
            terms::computed("a * b + c", {from_top, factor, terms::constant({shift[0], shift[1]})}, Type::Float2);
        if (sampled.text() == from_top.text()) return at;
        // As it is sampled: flipped() gives it back.
        sampled.name = terms::camel_case(node.name()) + "Uv";
        sampled.nodes = nodes;
        sampled = maker.named(sampled);
        Term made = terms::flipped(sampled);
        made.from_top = sampled.tree;
        made.nodes = nodes;
        return made;
    }
    const Term tiled = terms::computed("a * b - c", {at, tiling, offset}, Type::Float2);
    Term made = image_size.is_all(1) && tile_size.is_all(1)
                    ? tiled
                    : terms::computed("a / b * c", {tiled, image_size, tile_size}, Type::Float2);
    if (made.text() == at.text()) return at;
    made.nodes = nodes;
    made.name = terms::camel_case(node.name()) + "Uv";
    return maker.named(made);
}

}  // namespace patina::importers::mtlx

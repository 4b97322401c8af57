// Textures: which file a property shows and how it is decoded, which in a graph of Patina belongs to the texture and
// not to the node that samples it. Samplers: the names of their states.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

namespace fs = std::filesystem;

struct Picture {
    std::string file{};     // relative to the output folder; empty: there is none
    std::string missing{};  // GUID of one that was not found
};

// The picture that the JSON in a string names: {"texture":{"fileID":2800000,"guid":"..."}}
Picture picture_of(Project& project, const Json* holder) {
    if (!holder) return {};
    std::string guid;
    for (const std::string_view key : {"m_SerializedTexture", "m_SerializedCubemap"})
        if (guid.empty()) guid = guid_in(text_of(holder, key));
    if (guid.empty()) guid = text_of(holder, "m_Guid");
    if (guid.empty()) return {};
    const auto found = project.assets.find(guid, "", kPictures);
    if (!found) return {.missing = guid};
    const std::string file = path_from(project.folder, found->path);
    return {.file = file, .missing = file.empty() ? guid : std::string()};
}

std::string_view type_word(Type type) {
    if (type == Type::Texture3D) return "texture3d";
    if (type == Type::Cubemap) return "textureCube";
    return type == Type::Texture2DArray ? "texture2dArray" : "texture2d";
}

// 0 white, 1 black, 2 grey, 3 normal map, 4 linear grey, 5 red
std::string_view default_word(int kind) {
    static constexpr std::string_view kWords[] = {"white", "black", "gray", "bump", "gray", "white"};
    return kWords[kind];
}

}  // namespace

Term GraphMaker::texture_constant(std::size_t index, Type type, const Json* holder, std::string_view key,
                                  int default_type) {
    const Picture picture = picture_of(project_, member(holder, key));
    std::string& name =
        texture_names_[fmt::format("{} {} {} {}", static_cast<int>(type), picture.file + picture.missing, default_type,
                                   picture.file.empty() && picture.missing.empty() ? std::to_string(index) : "")];
    if (name.empty()) {
        std::string wanted =
            picture.file.empty() ? camel_case(node(index).name) : camel_case(fs::path(picture.file).stem().string());
        if (wanted.empty()) wanted = "texture";
        name = property_names_.unique("_" + wanted, "_texture");
        GraphProperty made{.name = name, .type = std::string(type_word(type))};
        made.value = text(picture.file.empty() ? default_word(default_type) : std::string_view(picture.file));
        if (!picture.missing.empty()) {
            made.comment = fmt::format("The picture with the GUID {} was not found.", picture.missing);
            approximate(index, fmt::format("its picture has the GUID {}, which no file in {} has: the texture is {}",
                                           picture.missing, project_.assets.folders(), default_word(default_type)));
        }
        file_.properties.push_back(std::move(made));
        if (type == Type::Texture2D) {
            textures_[name].is_normal = default_type == 3;
            textures_[name].is_linear = default_type == 4;
        }
    }
    return link("$" + name, type);
}

void GraphMaker::sample(const Term& texture, TextureMeaning meaning) {
    const auto found = textures_.find(texture.base.substr(1));
    if (found == textures_.end()) {
        for (SubgraphPorts::Input& input : ports_.inputs)
            if (meaning == TextureMeaning::Normal && "$" + input.name == texture.base) input.is_normal_map = true;
        return;
    }
    TextureUse& use = found->second;
    use.is_normal |= meaning == TextureMeaning::Normal;
    use.is_color |= meaning == TextureMeaning::Color;
    use.is_data |= meaning == TextureMeaning::Data;
}

std::optional<Term> GraphMaker::linked_sampler(std::size_t index) const {
    for (const Slot& slot : node(index).slots) {
        if (!slot.is_input || type_of_slot(slot.kind).type != Type::Sampler) continue;
        auto linked = linked_term(index, slot.id);
        if (linked && linked->type == Type::Sampler) return linked;
    }
    return {};
}

NearestSampler nearest_sampler(int filter, int wrap, int anisotropy) {
    NearestSampler made;
    Sampler wanted;
    wanted.wrap = wrap == 1 ? Wrap::Clamp : wrap == 2 || wrap == 3 ? Wrap::Mirror : Wrap::Repeat;
    wanted.filter = filter == 1 ? Filter::Nearest : Filter::Linear;
    // A sampler that takes the nearest texel has no use for it.
    if (filter != 1 && anisotropy > 0) wanted.anisotropy = anisotropy <= 2 ? 4 : 16;
    if (wrap == 3) made.difference = "a texture is mirrored again and again, not once";
    if (filter != 1 && (anisotropy == 1 || anisotropy == 3))
        made.difference += fmt::format("{}its anisotropy is {}, not {}", made.difference.empty() ? "" : "; ",
                                       wanted.anisotropy, wanted.anisotropy / 2);
    made.name = name_of(wanted);
    return made;
}

void GraphMaker::finish_textures() {
    for (auto& [name, use] : textures_) {
        const auto made = std::ranges::find(file_.properties, name, &GraphProperty::name);
        if (made == file_.properties.end()) continue;
        std::string difference;
        const Property* source = nullptr;
        for (const Property& each : graph_.properties)
            if (property_name(each) == name) source = &each;
        if (source && made->type.empty()) {
            const Type type = type_of_property(source->kind);
            const int default_type = type == Type::Texture2D ? whole_in(source->json, "m_DefaultType", 0, 0, 5) : 0;
            const Picture picture = picture_of(project_, member(source->json, "m_Value"));
            made->type = type_word(type);
            made->value = text(picture.file.empty() ? default_word(default_type) : std::string_view(picture.file));
            if (!picture.missing.empty()) {
                made->comment = fmt::format("The picture with the GUID {} was not found.", picture.missing);
                difference = fmt::format("its picture has the GUID {}, which no file in {} has", picture.missing,
                                         project_.assets.folders());
            }
            if (type == Type::Texture2D) use.is_normal |= default_type == 3;
            use.is_linear |= default_type == 4;
            if (default_type == 5) difference = "it is white without a picture, not red";
            if (flag_of(source->json, "useTilingAndOffset"))
                made->more.push_back({"tiling", patina::importers::flag(true)});
            if (source->name != name && !source->name.empty()) made->more.push_back({"label", text(source->name)});
            if (!source->group.empty()) made->more.push_back({"group", text(source->group)});
        }
        const bool is_data = use.is_linear || (use.is_data && !use.is_color);
        if (made->type == "texture2d" && (use.is_normal || is_data))
            made->more.push_back({"usage", text(use.is_normal ? "normal" : "data")});
        if (const std::string wrong = (source ? source->misread : "") + take_misreads(); !wrong.empty())
            difference += (difference.empty() ? "" : "; ") + wrong;
        if (source)
            remark(difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
                   fmt::format("property '{}'", source->name),
                   difference.empty() ? fmt::format("the property '{}'", name)
                                      : fmt::format("the property '{}': {}", name, difference),
                   source->place);
    }
}

}  // namespace patina::importers::shadergraph

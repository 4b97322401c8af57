// Textures: which file a property shows and how it is decoded, which in a graph of Patina belongs to the texture and
// not to the node that samples it. Samplers: the names of their states.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

namespace fs = std::filesystem;

// The GUID of the picture that the JSON in a string names: {"texture":{"fileID":2800000,"guid":"..."}}
std::string guid_of(const Json* holder) {
    std::string guid;
    if (!holder) return guid;
    for (const std::string_view key : {"m_SerializedTexture", "m_SerializedCubemap"})
        if (guid.empty()) guid = guid_in(text_of(holder, key));
    return guid.empty() ? std::string(text_of(holder, "m_Guid")) : guid;
}

const Picture* picture_of(Project& project, const std::string& guid) {
    return guid.empty() ? nullptr : &project.pictures.find(guid);
}

bool is_missing(const Picture* picture) {
    return picture && picture->file.empty();
}

GraphValue texture_value(const Picture* picture, std::string_view otherwise) {
    return picture && !picture->file.empty() ? std::string_view(picture->file) : otherwise;
}

std::string missing_comment(const std::string& guid) {
    return fmt::format("The picture with the GUID {} was not found.", guid);
}

void append(std::string& differences, std::string_view another) {
    if (!another.empty()) differences += (differences.empty() ? "" : "; ") + std::string(another);
}

// What the import settings of its picture say of the texture. They decide how texels are decoded, whatever reads them.
void add_picture_settings(ImportedProperty& made, const Picture& picture, bool is_normal, std::string& difference) {
    for (const std::string& each : picture.differences) append(difference, each);
    if (!picture.has_settings) return;
    if (!is_normal) made.more.push_back({"usage", picture.is_srgb ? "color" : "data"});
    if (is_normal && picture.flips_green) made.more.push_back({"handedness", "directx"});
    made.more.insert(made.more.end(), picture.more.begin(), picture.more.end());
    if (made.type == "texture2dArray" || made.type == "texture3d")
        made.more.insert(made.more.end(), picture.layers.begin(), picture.layers.end());
    if (made.type != "texture2d" || is_normal == picture.is_normal_map) return;
    append(difference, is_normal ? "it is not imported as a normal map, and is read as one"
                                 : "it is imported as a normal map, and is not read as one");
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
    const std::string guid = guid_of(member(holder, key));
    const Picture* picture = picture_of(project_, guid);
    std::string& name = texture_names_[fmt::format("{} {} {} {}", static_cast<int>(type), guid, default_type,
                                                   guid.empty() ? std::to_string(index) : "")];
    if (name.empty()) {
        std::string wanted = !picture || is_missing(picture) ? camel_case(node(index).name)
                                                             : camel_case(fs::path(picture->file).stem().string());
        if (wanted.empty()) wanted = "texture";
        name = file_.property_names.unique("_" + wanted, "_texture");
        ImportedProperty made{.name = name, .type = std::string(type_word(type))};
        made.value = texture_value(picture, default_word(default_type));
        if (is_missing(picture)) {
            made.comment = missing_comment(guid);
            approximate(index, fmt::format("its picture has the GUID {}, which no file in {} has: the texture is {}",
                                           guid, project_.assets.folders(), default_word(default_type)));
        }
        file_.properties.push_back(std::move(made));
        TextureUse& use = textures_[name];
        use.is_normal = type == Type::Texture2D && default_type == 3;
        use.is_linear = type == Type::Texture2D && default_type == 4;
        use.picture = picture;
        use.node = index;
    }
    return link("$" + name, type);
}

void GraphMaker::sample(const Term& texture, TextureMeaning meaning) {
    const auto found = textures_.find(std::string(texture.expression()->text));
    if (found == textures_.end()) {
        for (SubgraphPorts::Input& input : ports_.inputs)
            if (meaning == TextureMeaning::Normal && input.name == texture.expression()->text)
                input.is_normal_map = true;
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

// A property that was left open until it was known how it is sampled.
void GraphMaker::declare_texture(ImportedProperty& made, TextureUse& use, const Property& source,
                                 std::string& difference) {
    const Type type = type_of_property(source.kind);
    const int default_type = type == Type::Texture2D ? whole_in(source.json, "m_DefaultType", 0, 0, 5) : 0;
    const std::string guid = guid_of(member(source.json, "m_Value"));
    use.picture = picture_of(project_, guid);
    made.type = type_word(type);
    made.value = texture_value(use.picture, default_word(default_type));
    if (is_missing(use.picture)) {
        made.comment = missing_comment(guid);
        difference =
            fmt::format("its picture has the GUID {}, which no file in {} has", guid, project_.assets.folders());
    }
    if (type == Type::Texture2D) use.is_normal |= default_type == 3;
    use.is_linear |= default_type == 4;
    if (default_type == 5) difference = "it is white without a picture, not red";
    append(difference, use.renamed);
    append(difference, scope_difference(source));
    append(difference, hidden_difference(source));
    if (flag_of(source.json, "useTilingAndOffset")) made.more.push_back({"tiling", true});
    if (source.name != made.name && !source.name.empty()) made.more.push_back({"label", source.name});
    if (!source.group.empty()) made.more.push_back({"group", source.group});
}

void GraphMaker::finish_textures() {
    for (auto& [name, use] : textures_) {
        const auto made = std::ranges::find(file_.properties, name, &ImportedProperty::name);
        if (made == file_.properties.end()) continue;
        std::string difference;
        const Property* source = nullptr;
        for (const Property& each : graph_.properties)
            if (property_name(each) == name) source = &each;
        if (source && made->type.empty()) declare_texture(*made, use, *source, difference);
        const bool has_settings = use.picture && use.picture->has_settings;
        const bool is_data = !has_settings && (use.is_linear || (use.is_data && !use.is_color));
        if (made->type == "texture2d" && (use.is_normal || is_data))
            made->more.push_back({"usage", use.is_normal ? "normal" : "data"});
        if (use.picture) add_picture_settings(*made, *use.picture, use.is_normal, difference);
        if (!source && !difference.empty()) approximate(use.node, fmt::format("its picture: {}", difference));
        append(difference, (source ? source->misread : "") + take_misreads());
        if (source)
            remark(difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
                   fmt::format("property '{}'", source->name),
                   fmt::format("the property '{}'{}{}", name, difference.empty() ? "" : ": ", difference),
                   source->place);
    }
}

}  // namespace patina::importers::shadergraph

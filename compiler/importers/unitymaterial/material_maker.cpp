#include "compiler/importers/unitymaterial/material_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/importers/values.h"

namespace patina::importers::unitymaterial {
namespace {

GraphValue short_number(double value) {
    return static_cast<float>(value);
}

// "#ff8000", "#ff800080"; empty if a channel has no eight bits.
std::string hex_color(const std::array<double, 4>& channels) {
    std::string made = "#";
    const std::size_t count = channels[3] == 1 ? 3 : 4;
    for (std::size_t i = 0; i < count; ++i) {
        const double byte = channels[i] * 255;
        if (byte < 0 || byte > 255 || std::abs(byte - std::round(byte)) > 1e-3) return {};
        made += fmt::format("{:02x}", static_cast<int>(std::round(byte)));
    }
    return made;
}

bool is_white(const std::array<double, 4>& color) {
    return color[0] == 1 && color[1] == 1 && color[2] == 1;
}

// Settings of which a graph says nothing, because they change nothing in it.
struct Known {
    std::string_view key, text;
};
constexpr Known kKnown[] = {
    {"m_LightmapFlags", "it concerns lightmaps alone"},
    {"m_DoubleSidedGI", "it concerns lightmaps alone"},
    {"m_EnableInstancingVariants", "it concerns the engine's way of drawing alone"},
    {"stringTagMap", "it concerns the choice of shaders by tags alone"},
};
constexpr std::string_view kEditor[] = {"serializedVersion", "m_ObjectHideFlags",   "m_CorrespondingSourceObject",
                                        "m_PrefabInstance",  "m_PrefabAsset",       "m_PrefabParentObject",
                                        "m_PrefabInternal",  "m_LockedProperties",  "m_ModifiedSerializedProperties",
                                        "m_AllowLocking",    "m_BuildTextureStacks"};

std::string listed(const std::vector<std::string>& names) {
    std::string made;
    for (const std::string& each : names) made += (made.empty() ? "" : ", ") + each;
    return made;
}

}  // namespace

double decoded(double channel) {
    if (channel <= 0.04045) return channel / 12.92;
    // Beyond white, where sRGB has no meaning. The limit keeps the result within 32 bits.
    return channel < 1 ? std::pow((channel + 0.055) / 1.055, 2.4) : std::pow(std::min(channel, 1e15), 2.2);
}

GraphValue shown_color(const std::array<double, 4>& color, bool is_hdr) {
    const std::string hex = is_hdr ? std::string() : hex_color(color);
    if (!hex.empty()) return hex;
    std::vector<float> channels;
    for (std::size_t i = 0; i < 3; ++i) channels.push_back(static_cast<float>(is_hdr ? color[i] : decoded(color[i])));
    if (color[3] != 1) channels.push_back(static_cast<float>(color[3]));
    return list_of(channels);
}

MaterialMaker::MaterialMaker(const MaterialFile& source, const Shader& shader, Pictures& pictures,
                             const std::string& name)
    : graph(name), source_(source), shader_(shader), pictures_(pictures) {
    for (const auto& [texture, saved] : source_.textures)
        if (!saved.picture.is_none() && !pictures_.find(saved.picture.guid, saved.picture.file).repeats)
            all_repeat_ = false;
}

// --- what the material says

bool MaterialMaker::keyword(const std::string& name, const std::string& what_it_does, const std::string& texture) {
    const bool is_on = std::ranges::find(source_.keywords, name, &SavedKeyword::name) != source_.keywords.end();
    if (is_on) note_keyword(name, Remark::Kind::Taken, what_it_does);
    return is_on || (shader_.is_guessed && !texture.empty() && has_picture(texture));
}

bool MaterialMaker::has_picture(const std::string& texture) const {
    const auto found = source_.textures.find(texture);
    return found != source_.textures.end() && !found->second.picture.is_none();
}

double MaterialMaker::number(const std::string& property, double otherwise) const {
    const auto found = source_.numbers.find(property);
    return found == source_.numbers.end() ? otherwise : found->second.value;
}

std::array<double, 4> MaterialMaker::color(const std::string& property, std::array<double, 4> otherwise) const {
    const auto found = source_.colors.find(property);
    return found == source_.colors.end() ? otherwise : found->second.value;
}

// --- what becomes of it

void MaterialMaker::note(const std::string& property, Remark::Kind kind, const std::string& text) {
    properties_.try_emplace(property, Outcome{kind, text});
}

void MaterialMaker::idle(std::initializer_list<const char*> properties, const std::string& why) {
    for (const char* each : properties) taken(each, "it has no effect: " + why);
}

void MaterialMaker::note_keyword(const std::string& name, Remark::Kind kind, const std::string& text) {
    keywords_.try_emplace(name, Outcome{kind, text});
}

void MaterialMaker::change_keyword(const std::string& name, const std::string& text) {
    keywords_[name] = {Remark::Kind::Changed, text};
}

void MaterialMaker::note_setting(const std::string& key, Remark::Kind kind, const std::string& text) {
    settings_.try_emplace(key, Outcome{kind, text});
}

// --- parts of the graph

Term MaterialMaker::number_property(const std::string& name, double otherwise, double low, double high) {
    const double value = number(name, otherwise);
    if (std::ranges::find(graph.properties, name, &ImportedProperty::name) == graph.properties.end())
        graph.properties.push_back({.name = name,
                                    .type = "float",
                                    .value = short_number(value),
                                    .more = {{"range", GraphValue::list({short_number(std::min(low, value)),
                                                                         short_number(std::max(high, value))})}}});
    properties_[name] = {Remark::Kind::Taken, fmt::format("the property '{}'", name)};
    return link("$" + name, Type::Float);
}

Term MaterialMaker::color_property(const std::string& name, std::array<double, 4> otherwise) {
    return add_color(name, color(name, otherwise), false, fmt::format("the property '{}'", name));
}

Term MaterialMaker::light_property(const std::string& name, std::array<double, 4> color,
                                   const std::string& difference) {
    color[3] = 1;
    const Term made = add_color(name, color, true, {});
    properties_[name] = {Remark::Kind::Changed, fmt::format("the property '{}': {}", name, difference)};
    return made;
}

Term MaterialMaker::add_color(const std::string& name, std::array<double, 4> color, bool is_linear,
                              const std::string& remark) {
    if (std::ranges::find(graph.properties, name, &ImportedProperty::name) == graph.properties.end()) {
        ImportedProperty made{.name = name, .type = "color", .value = shown_color(color, is_linear)};
        for (std::size_t i = 0; i < 3 && !is_linear; ++i) color[i] = decoded(color[i]);
        const auto [least, most] = std::minmax_element(color.begin(), color.begin() + 3);
        if (*least < 0 || *most > 1)
            made.more.push_back(
                {"range", GraphValue::list({short_number(std::min(*least, 0.0)), short_number(*most)})});
        graph.properties.push_back(std::move(made));
    }
    properties_[name] = {Remark::Kind::Taken, remark};
    return color_link("$" + name);
}

Term MaterialMaker::tiled(const std::string& texture, const Term& base, const std::string& id) {
    tiled_.insert(texture);
    const auto found = source_.textures.find(texture);
    if (found == source_.textures.end() || !found->second.is_moved()) return base;
    const SavedTexture& saved = found->second;
    ImportedNode made{.id = id, .node = "TilingOffset"};
    if (base.text() != "@uv0") made.inputs.push_back({"uv", base.value()});
    const auto pair = [](double x, double y) { return GraphValue::list({short_number(x), short_number(y)}); };
    if (saved.scale != std::array{1.0, 1.0}) made.inputs.push_back({"tiling", pair(saved.scale[0], saved.scale[1])});
    // Unity counts v from the bottom of the picture.
    double down = 1 - saved.scale[1] - saved.offset[1];
    if (all_repeat_) down -= std::floor(down);
    if (saved.offset[0] != 0 || down != 0) made.inputs.push_back({"offset", pair(saved.offset[0], down)});
    if (made.inputs.empty()) return base;  // moved by whole pictures
    node(std::move(made));
    return link(id, Type::Float2);
}

Term MaterialMaker::sample(const std::string& texture, const std::string& id, std::string_view usage,
                           std::string_view fallback, const Term& uv, const Term& scale) {
    const bool is_normal = usage == "normal";
    ImportedProperty property{.name = texture, .type = "texture2d", .value = fallback};
    std::string remark = fmt::format("the property '{}', read by the node '{}'", texture, id), difference;
    std::string_view own_usage = usage;
    GraphMembers more;
    if (has_picture(texture)) {
        const AssetId& asset = source_.textures.at(texture).picture;
        const Picture& picture = pictures_.find(asset.guid, asset.file);
        if (picture.file.empty()) {
            property.comment = fmt::format("The picture with the GUID {} was not found.", asset.guid);
            difference = fmt::format("{}: the texture is {}", picture.missing, fallback);
        } else {
            property.value = picture.file;
            if (picture.has_settings && !is_normal) own_usage = picture.is_srgb ? "color" : "data";
            if (picture.has_settings && is_normal != picture.is_normal_map)
                difference = is_normal ? "it is not imported as a normal map, and is read as one"
                                       : "it is imported as a normal map, and is not read as one";
            for (const std::string& each : picture.differences) difference += (difference.empty() ? "" : "; ") + each;
            if (is_normal && picture.flips_green) more.push_back({"handedness", "directx"});
            more.insert(more.end(), picture.more.begin(), picture.more.end());
        }
    }
    property.more.push_back({"usage", own_usage});
    property.more.insert(property.more.end(), more.begin(), more.end());
    graph.properties.push_back(std::move(property));
    ImportedNode made{
        .id = id, .node = is_normal ? "SampleNormalMap" : "SampleTexture2D", .inputs = {{"texture", "$" + texture}}};
    if (uv.text() != "@uv0") made.inputs.push_back({"uv", uv.value()});
    if (!scale.is_all(1)) made.inputs.push_back({"scale", scale.value()});
    node(std::move(made));
    note(texture, difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
         difference.empty() ? remark : remark + ": " + difference);
    return is_normal ? link(id, Type::Float3) : color_link(id);
}

Term MaterialMaker::tinted(const Term& sample, const std::string& name, std::array<double, 4> otherwise) {
    if (!sample.is_constant() && is_white(color(name, otherwise))) {
        taken(name, "white: the texture alone");
        return swizzled(sample, "rgb");
    }
    return computed("a.rgb * b.rgb", {sample, color_property(name, otherwise)}, Type::Float3);
}

Term MaterialMaker::alpha(const Term& sample, const std::string& name, std::array<double, 4> otherwise) {
    if (color(name, otherwise)[3] == 1) return swizzled(sample, "a");
    return computed("a.a * b.a", {sample, color_property(name, otherwise)}, Type::Float);
}

void MaterialMaker::emission(const Term& uv, bool is_hdr) {
    const std::string why = "the keyword _EMISSION is off";
    if (!keyword("_EMISSION", "the input 'emission'", "_EmissionMap")) {
        idle({"_EmissionColor", "_EmissionMap"}, why);
        return;
    }
    std::array<double, 4> light = color("_EmissionColor", {0, 0, 0, 1});
    light[3] = 1;
    if (light == std::array{0.0, 0.0, 0.0, 1.0}) {
        idle({"_EmissionColor", "_EmissionMap"}, "the colour is black");
        return;
    }
    Term glow = white(), tint = glow;
    if (has_picture("_EmissionMap"))
        glow = sample("_EmissionMap", "glow", "color", "white", uv);
    else
        taken("_EmissionMap", "none: the colour alone");
    if (!glow.is_constant() && is_white(light)) {
        taken("_EmissionColor", "white: the texture alone");
    } else {
        for (std::size_t i = 0; i < 3 && !is_hdr; ++i) light[i] = decoded(light[i]);
        tint = add_color("_EmissionColor", light, true,
                         is_hdr ? "the property '_EmissionColor'"
                                : "the property '_EmissionColor', decoded as in linear colour space");
    }
    set("emission", computed("a.rgb * b.rgb", {glow, tint}, Type::Float3));
}

void MaterialMaker::coverage(const RenderState& state, const Term& alpha, const std::string& limit_name) {
    if (!state.is_clipped) taken(limit_name, "it has no effect: nothing is cut out");
    const bool has_use = state.is_clipped || state.kind == "fade" || state.kind == "transparent";
    if (has_use && !alpha.is_all(1)) set("alpha", alpha);
    if (state.is_clipped) set("alphaClip", number_property(limit_name, 0.5, 0, 1));
}

// --- the report

void MaterialMaker::report_settings(std::vector<Remark>& remarks) {
    std::vector<std::string> of_editor;
    for (const Setting& each : source_.settings) {
        const std::string part = fmt::format("setting '{}'", each.key);
        const auto add = [&](Remark::Kind kind, std::string text) {
            remarks.push_back({.kind = kind,
                               .part = part,
                               .text = std::move(text),
                               .line = each.place.line,
                               .column = each.place.column});
        };
        if (const auto found = settings_.find(each.key); found != settings_.end()) {
            add(found->second.kind, found->second.text);
        } else if (const auto known = std::ranges::find(kKnown, each.key, &Known::key); known != std::end(kKnown)) {
            add(Remark::Kind::Taken, std::string(known->text));
        } else if (each.key == "disabledShaderPasses") {
            if (each.words.empty()) add(Remark::Kind::Taken, "no pass is off");
            for (const std::string& pass : each.words) {
                if (small_letters(pass) == "shadowcaster")
                    add(Remark::Kind::Changed, "the pass 'ShadowCaster' is off: it casts shadows");
                else
                    add(Remark::Kind::Taken, fmt::format("the pass '{}' is off: graphs do not have it", pass));
            }
        } else if (std::ranges::find(kEditor, each.key) != std::end(kEditor)) {
            of_editor.push_back(each.key);
        } else {
            add(Remark::Kind::Changed, "this importer does not know it");
        }
    }
    if (!of_editor.empty())
        remarks.push_back({.part = "settings " + listed(of_editor), .text = "they concern the editor alone"});
}

std::vector<Remark> MaterialMaker::finish() {
    std::vector<Remark> remarks;
    const auto add = [&](Remark::Kind kind, std::string part, std::string text, Place place) {
        remarks.push_back({.kind = kind,
                           .part = std::move(part),
                           .text = std::move(text),
                           .line = place.line,
                           .column = place.column});
    };
    std::vector<std::string> unread;
    const auto add_keyword = [&](const SavedKeyword& each) {
        const auto found = keywords_.find(each.name);
        if (found == keywords_.end())
            unread.push_back(each.name);
        else
            add(found->second.kind, fmt::format("keyword '{}'", each.name), found->second.text, each.place);
    };
    for (const SavedKeyword& each : source_.keywords) add_keyword(each);
    for (const SavedKeyword& each : source_.invalid_keywords) unread.push_back(each.name);
    if (!unread.empty()) add(Remark::Kind::Taken, "keywords " + listed(unread), "not read by this shader", {});

    unread.clear();
    const auto add_property = [&](const std::string& name, Place place, const SavedTexture* texture) {
        const auto found = properties_.find(name);
        if (found == properties_.end()) {
            unread.push_back(name);
            return;
        }
        std::string text = found->second.text;
        const bool is_sampled =
            std::ranges::find(graph.properties, name, &ImportedProperty::name) != graph.properties.end();
        if (texture && is_sampled && texture->is_moved() && !tiled_.contains(name))
            text += "; the shader does not read its tiling";
        const auto origin = source_.origins.find(name);
        add(found->second.kind,
            origin == source_.origins.end() ? fmt::format("property '{}'", name)
                                            : fmt::format("property '{}' of '{}'", name, origin->second),
            text, place);
    };
    for (const auto& [name, saved] : source_.textures) add_property(name, saved.place, &saved);
    for (const auto& [name, saved] : source_.numbers) add_property(name, saved.place, nullptr);
    for (const auto& [name, saved] : source_.colors) add_property(name, saved.place, nullptr);
    if (!unread.empty()) add(Remark::Kind::Taken, "properties " + listed(unread), "not read by this shader", {});
    report_settings(remarks);
    return remarks;
}

}  // namespace patina::importers::unitymaterial

#include "compiler/importers/gltf/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/gltf/gltf_layers.h"

namespace patina::importers::gltf {
namespace {

// The base colour, or the diffuse colour of the older workflow, and its alpha.
struct Base {
    Term color, alpha;
};

Base base_of(MaterialGraph& graph, Object& from, const Slot& slot, bool has_alpha, bool has_colors) {
    const Term texel = graph.texel(from, slot.texture, slot.slot, "color");
    const auto factor = from.numbers(slot.factor, 4, 0, 1);
    const std::vector<double> value = factor.value_or(std::vector<double>(4, 1));
    const std::vector<double> rgb(value.begin(), value.begin() + 3);
    std::vector<Term> colors = {swizzled(texel, "rgb")}, alphas = {swizzled(texel, "a")};
    const bool is_alone = texel.is_constant() && !has_colors;
    const bool has_color = rgb != std::vector<double>(3, 1) || (factor && is_alone);
    const bool scales_alpha = has_alpha && value[3] != 1;
    if (has_color || scales_alpha) {
        const Term property = graph.color_property(slot.property, scales_alpha ? value : rgb);
        if (has_color) colors.push_back(swizzled(property, "rgb"));
        if (scales_alpha) alphas.push_back(swizzled(property, "a"));
        from.taken(slot.factor, fmt::format("the property '{}'", slot.property));
        if (!has_alpha && value[3] != 1) from.taken(slot.factor, "its alpha has no effect: the alpha mode is OPAQUE");
    }
    from.taken(slot.factor, "white: it changes nothing");
    if (has_colors) {
        colors.push_back(swizzled(color_link("@vertexColor"), "rgb"));
        alphas.push_back(swizzled(color_link("@vertexColor"), "a"));
    }
    return {.color = product(colors), .alpha = product(alphas)};
}

// OPAQUE, MASK or BLEND: the surface kind, and whether alpha counts.
struct Alpha {
    std::string_view surface{};  // empty: opaque, the default
    std::optional<double> cutoff{};
};

Alpha alpha_of(Object& material) {
    const std::string mode = material.word("alphaMode").value_or("OPAQUE");
    if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
        material.changed("alphaMode",
                         fmt::format("'{}' is not a mode of the specification: the surface is opaque", mode));
    const auto cutoff = material.number("alphaCutoff", 0, 1e6);
    if (mode == "MASK") {
        material.taken("alphaMode", "\"surface\": \"cutout\"");
        return {.surface = "cutout", .cutoff = cutoff};
    }
    material.taken("alphaCutoff", "it has no effect: the alpha mode is not MASK");
    if (mode == "BLEND") return {.surface = "fade"};
    material.taken("alphaMode", "an opaque surface, the default");
    return {};
}

// Nothing shows through an alpha of 1, and an opaque surface needs no order of drawing.
void settle_blend(Object& material, Alpha& alpha, const Term& value) {
    if (alpha.surface != "fade") return;
    if (value.is_all(1)) alpha.surface = {};
    material.taken("alphaMode",
                   value.is_all(1) ? "an opaque surface: its alpha is 1 everywhere" : "\"surface\": \"fade\"");
}

void set_render(MaterialGraph& graph, Object& material, const Alpha& alpha) {
    GraphMembers render;
    if (!alpha.surface.empty()) render.push_back({"surface", alpha.surface});
    const bool is_double = material.flag("doubleSided").value_or(false);
    if (is_double) render.push_back({"cull", "off"});
    material.taken("doubleSided", is_double ? "\"cull\": \"off\"" : "back faces are culled, the default");
    if (!render.empty()) graph.graph.more.push_back({"render", GraphValue::object(render)});
}

void set_alpha(MaterialGraph& graph, Object& material, const Alpha& alpha, const Term& value) {
    if (alpha.surface.empty()) return;
    if (!value.is_all(1)) graph.set("alpha", value);
    if (!alpha.cutoff) return;
    // No alpha is above 1, so a greater cutoff hides all.
    graph.set("alphaClip", graph.number_property("_AlphaCutoff", *alpha.cutoff, 0, 1));
    material.taken("alphaCutoff", "the property '_AlphaCutoff'");
}

// --- one of three kinds of material

// Occlusion, roughness and metallic often are the channels of one picture.
std::string_view slot_of_roughness(Object& material, Object& metal) {
    const Json* occlusion = material.has("occlusionTexture") ? material.json()->find("occlusionTexture") : nullptr;
    const Json* rough =
        metal.has("metallicRoughnessTexture") ? metal.json()->find("metallicRoughnessTexture") : nullptr;
    const Json* first = occlusion ? occlusion->find("index") : nullptr;
    const Json* second = rough ? rough->find("index") : nullptr;
    return first && second && first->number == second->number ? "orm" : "metallicRoughness";
}

Term set_metal(MaterialGraph& graph, Object& material, Object& metal, bool has_alpha, const MaterialUse& use) {
    const Base base = base_of(
        graph, metal,
        {.factor = "baseColorFactor", .texture = "baseColorTexture", .slot = "baseColor", .property = "_BaseColor"},
        has_alpha, use.has_colors);
    graph.set("baseColor", base.color);
    const std::string_view slot = slot_of_roughness(material, metal);
    const Term metallic = graph.scalar(metal, {.factor = "metallicFactor",
                                               .texture = "metallicRoughnessTexture",
                                               .slot = slot,
                                               .channel = "b",
                                               .property = "_Metallic",
                                               .shares_texture = true});
    graph.set("metallic", metallic);
    const Term roughness = graph.scalar(metal, {.factor = "roughnessFactor",
                                                .texture = "metallicRoughnessTexture",
                                                .slot = slot,
                                                .channel = "g",
                                                .property = "_Roughness",
                                                .shares_texture = true});
    graph.set("roughness", roughness);
    if (metallic.is_all(0) && roughness.is_all(0))
        metal.child("metallicRoughnessTexture").all_taken("it has no effect: both factors are 0");
    metal.rest();
    return base.alpha;
}

Term set_specular(MaterialGraph& graph, Object& gloss, bool has_alpha, const MaterialUse& use) {
    graph.graph.workflow = "specular-glossiness";
    const Base base =
        base_of(graph, gloss,
                {.factor = "diffuseFactor", .texture = "diffuseTexture", .slot = "diffuse", .property = "_Diffuse"},
                has_alpha, use.has_colors);
    const Slot slot{.factor = "specularFactor",
                    .texture = "specularGlossinessTexture",
                    .slot = "specularGlossiness",
                    .channel = "rgb",
                    .property = "_Specular",
                    .shares_texture = true};
    const Term specular = graph.color(gloss, slot);
    const Term texel = graph.texel(gloss, slot.texture, slot.slot, "color");
    const auto factor = gloss.number("glossinessFactor", 0, 1);
    Term scale = number_term(1);
    if (factor && (*factor != 1 || texel.is_constant())) {
        scale = graph.number_property("_Glossiness", *factor, 0, 1);
        gloss.taken("glossinessFactor", "the property '_Glossiness'");
    }
    gloss.taken("glossinessFactor", "1: the texture alone");
    graph.set("baseColor", base.color);
    graph.set("specular", specular);
    graph.set("glossiness", product({swizzled(texel, "a"), scale}));
    gloss.rest();
    return base.alpha;
}

void set_normal(MaterialGraph& graph, Object& material) {
    const Term normal = graph.normal(material, "normalTexture", "normal", "_NormalScale");
    if (!normal.is_constant()) graph.set("normalTS", normal);
}

void set_occlusion(MaterialGraph& graph, Object& material) {
    const Term texel = graph.texel(material, "occlusionTexture", "occlusion", "data");
    if (texel.is_constant()) return;
    const double strength = material.child("occlusionTexture").number("strength", 0, 1).value_or(1);
    if (strength == 1) return graph.set("occlusion", swizzled(texel, "r"));
    const Term property = graph.number_property("_OcclusionStrength", strength, 0, 1);
    graph.set("occlusion", computed("lerp(1, a.r, b)", {texel, property}, Type::Float));
}

void set_emission(MaterialGraph& graph, Object& material) {
    Object extension = material.extension("KHR_materials_emissive_strength");
    const auto factor = material.numbers("emissiveFactor", 3, 0, 1);
    const bool is_dark = !factor || *factor == std::vector<double>(3, 0);
    if (is_dark) {
        material.taken("emissiveFactor", "black: the surface emits nothing");
        material.taken("emissiveTexture", "it has no effect: 'emissiveFactor' is black");
        extension.all_taken("it has no effect: 'emissiveFactor' is black");
        return extension.rest();
    }
    graph.set("emission", graph.color(material, {.factor = "emissiveFactor",
                                                 .texture = "emissiveTexture",
                                                 .slot = "emissive",
                                                 .channel = "rgb",
                                                 .property = "_Emission"}));
    constexpr double kBrightest = 1e6;
    if (const auto strength = extension.number("emissiveStrength", 0, kBrightest); strength && *strength != 1) {
        graph.set("emissiveStrength", graph.number_property("_EmissiveStrength", *strength, 0, 10));
        extension.taken("emissiveStrength", "the property '_EmissiveStrength'");
    }
    extension.taken("emissiveStrength", "1 changes nothing");
    extension.rest();
}

Term set_unlit(MaterialGraph& graph, Object& material, Object& metal, bool has_alpha, const MaterialUse& use) {
    graph.graph.workflow = "unlit";
    const Base base = base_of(
        graph, metal,
        {.factor = "baseColorFactor", .texture = "baseColorTexture", .slot = "baseColor", .property = "_BaseColor"},
        has_alpha, use.has_colors);
    graph.set("color", base.color);
    metal.all_taken("it has no effect: the material is unlit");
    metal.rest();
    for (const std::string_view key : {"normalTexture", "occlusionTexture", "emissiveTexture", "emissiveFactor"})
        material.taken(key, "it has no effect: the material is unlit");
    Object strength = material.extension("KHR_materials_emissive_strength");
    strength.all_taken("it has no effect: the material is unlit");
    strength.rest();
    return base.alpha;
}

// Which numbers, "occlusion" or "thickness", a material's textures hold: those that are neither colours nor normals.
void find_packed(const Json& object, std::map<std::size_t, std::vector<std::string>>& packed) {
    constexpr std::string_view kEnding = "Texture";
    for (const json::JsonMember& member : object.members) {
        const std::string& key = member.key;
        if (member.value.kind != Json::Kind::Object) continue;
        const Json* index = member.value.find("index");
        std::string name = key.ends_with(kEnding) ? key.substr(0, key.size() - kEnding.size()) : std::string();
        const bool is_number = !name.empty() && !name.ends_with("olor") && !name.ends_with("ormal") &&
                               name != "emissive" && name != "diffuse" && name != "specularGlossiness";
        if (is_number && index && index->kind == Json::Kind::Number && index->number >= 0)
            packed[static_cast<std::size_t>(index->number)].push_back(std::move(name));
        find_packed(member.value, packed);
    }
}

}  // namespace

ImportedGraph material_graph(const Context& context, Pictures& pictures, std::size_t index, const MaterialUse& use) {
    MaterialGraph graph(context, pictures, use.name);
    graph.lacks_coordinates = use.lacks_coordinates;
    Object material = element(context, "materials", index);
    if (material) find_packed(*material.json(), graph.packed);
    for (auto& [texture, held] : graph.packed) std::sort(held.begin(), held.end());
    graph.graph.name = material.word("name").value_or(use.name);
    graph.graph.workflow = "metallic-roughness";
    material.taken("name", "the graph's name");
    Alpha alpha = alpha_of(material);
    Term opacity;
    const bool has_alpha = !alpha.surface.empty();
    Object metal = material.child("pbrMetallicRoughness");
    Object unlit = material.extension("KHR_materials_unlit");
    Object gloss = material.extension("KHR_materials_pbrSpecularGlossiness");
    if (unlit) {
        context.report.add(Remark::Kind::Taken, unlit.path(), "the workflow 'unlit'", unlit.json());
        unlit.rest();
        opacity = set_unlit(graph, material, metal, has_alpha, use);
        leave_layers(material, "it has no effect: the material is unlit");
    } else {
        graph.graph.lighting = "gltf";
        if (gloss) {
            metal.all_taken("it has no effect: the material has KHR_materials_pbrSpecularGlossiness");
            metal.rest();
            context.report.add(Remark::Kind::Taken, gloss.path(), "the workflow 'specular-glossiness'", gloss.json());
        }
        opacity =
            gloss ? set_specular(graph, gloss, has_alpha, use) : set_metal(graph, material, metal, has_alpha, use);
        set_normal(graph, material);
        set_occlusion(graph, material);
        set_emission(graph, material);
        if (gloss)
            leave_layers(material, "the specular-glossiness workflow has no layers");
        else
            set_layers(graph, material, use);
    }
    settle_blend(material, alpha, opacity);
    set_alpha(graph, material, alpha, opacity);
    set_render(graph, material, alpha);
    material.rest();
    return std::move(graph.graph);
}

}  // namespace patina::importers::gltf

#include "compiler/importers/gltf/gltf_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace patina::importers::gltf {
namespace {

constexpr std::array<std::string_view, 10> kLayers = {
    "KHR_materials_clearcoat",    "KHR_materials_sheen",
    "KHR_materials_specular",     "KHR_materials_ior",
    "KHR_materials_anisotropy",   "KHR_materials_iridescence",
    "KHR_materials_transmission", "KHR_materials_volume",
    "KHR_materials_dispersion",   "KHR_materials_diffuse_transmission"};

constexpr double kAny = 1e6;

// Without its factor, a layer is off; `is_off` says so of all of its properties.
bool is_off(Object& layer, std::string_view factor) {
    const Json* value = layer ? layer.json()->find(factor) : nullptr;
    if (!layer || (value && (value->kind != Json::Kind::Number || value->number != 0))) return !layer;
    layer.taken(factor, "0 leaves the layer out");
    layer.all_taken(fmt::format("it has no effect: '{}' is 0", factor));
    layer.rest();
    return true;
}

// A number that is a property; nothing if it is not stated, or says what is the default.
void set_number(MaterialGraph& graph, Object& layer, std::string_view key, std::string_view input,
                std::string_view property, double otherwise, double low, double high) {
    const auto value = layer.number(key, 0, kAny);
    if (value && *value != otherwise) {
        graph.set(input, graph.number_property(property, *value, low, high));
        layer.taken(key, fmt::format("the property '{}'", property));
    }
    layer.taken(key, "the default");
}

// Leaves out what is the input's default.
void set_unless(MaterialGraph& graph, std::string_view input, const Term& term, double otherwise) {
    if (!term.is_all(otherwise)) graph.set(input, term);
}

void set_clearcoat(MaterialGraph& graph, Object coat) {
    if (is_off(coat, "clearcoatFactor")) return;
    graph.set("clearcoat", graph.scalar(coat, {.factor = "clearcoatFactor",
                                               .texture = "clearcoatTexture",
                                               .slot = "clearcoat",
                                               .channel = "r",
                                               .property = "_Clearcoat"}));
    set_unless(graph, "clearcoatRoughness",
               graph.scalar(coat, {.factor = "clearcoatRoughnessFactor",
                                   .texture = "clearcoatRoughnessTexture",
                                   .slot = "clearcoatRoughness",
                                   .channel = "g",
                                   .property = "_ClearcoatRoughness",
                                   .otherwise = 0}),
               0);
    const Term normal = graph.normal(coat, "clearcoatNormalTexture", "clearcoatNormal", "_ClearcoatNormalScale");
    if (!normal.is_constant()) {
        graph.node(
            {.id = "clearcoatNormalWS", .node = "NormalTangentToWorld", .inputs = {{"normalTS", normal.value()}}});
        graph.set("clearcoatNormalWS", link("clearcoatNormalWS", Type::Float3));
    }
    coat.rest();
}

void set_sheen(MaterialGraph& graph, Object sheen) {
    if (!sheen) return;
    const auto factor = sheen.numbers("sheenColorFactor", 3, 0, kAny);
    if (!factor || *factor == std::vector<double>(3, 0)) {
        sheen.taken("sheenColorFactor", "black leaves the layer out");
        sheen.all_taken("it has no effect: 'sheenColorFactor' is black");
        return sheen.rest();
    }
    graph.set("sheenColor", graph.color(sheen, {.factor = "sheenColorFactor",
                                                .texture = "sheenColorTexture",
                                                .slot = "sheenColor",
                                                .channel = "rgb",
                                                .property = "_SheenColor"}));
    set_unless(graph, "sheenRoughness",
               graph.scalar(sheen, {.factor = "sheenRoughnessFactor",
                                    .texture = "sheenRoughnessTexture",
                                    .slot = "sheenRoughness",
                                    .channel = "a",
                                    .property = "_SheenRoughness",
                                    .otherwise = 0}),
               0);
    sheen.rest();
}

void set_specular(MaterialGraph& graph, Object specular) {
    set_unless(graph, "specularFactor",
               graph.scalar(specular, {.factor = "specularFactor",
                                       .texture = "specularTexture",
                                       .slot = "specular",
                                       .channel = "a",
                                       .property = "_Specular"}),
               1);
    set_unless(graph, "specularColor",
               graph.color(specular, {.factor = "specularColorFactor",
                                      .texture = "specularColorTexture",
                                      .slot = "specularColor",
                                      .channel = "rgb",
                                      .property = "_SpecularColor",
                                      .high = kAny}),
               1);
    specular.rest();
}

void set_anisotropy(MaterialGraph& graph, Object layer) {
    if (is_off(layer, "anisotropyStrength")) return;
    graph.set("anisotropy", graph.scalar(layer, {.factor = "anisotropyStrength",
                                                 .texture = "anisotropyTexture",
                                                 .slot = "anisotropy",
                                                 .channel = "b",
                                                 .property = "_Anisotropy",
                                                 .otherwise = 0}));
    const Term texel = graph.texel(layer, "anisotropyTexture", "anisotropy", "data");
    const double rotation = layer.number("anisotropyRotation", -kAny, kAny).value_or(0);
    Term angle = number_term(0);
    if (rotation != 0) {
        angle = graph.number_property("_AnisotropyRotation", rotation, -3.1415927, 3.1415927);
        layer.taken("anisotropyRotation", "the property '_AnisotropyRotation'");
    }
    layer.taken("anisotropyRotation", "0 changes nothing");
    const std::string_view direction = angle.is_constant()   ? "a.rg * 2 - 1"
                                       : texel.is_constant() ? "float2(cos(b), sin(b))"
                                                             : "Rotate(a.rg * 2 - 1, b, float2(0, 0))";
    if (!texel.is_constant() || !angle.is_constant())
        graph.set("anisotropyDirection", computed(direction, {texel, angle}, Type::Float2));
    layer.rest();
}

void set_iridescence(MaterialGraph& graph, Object film) {
    if (is_off(film, "iridescenceFactor")) return;
    graph.set("iridescence", graph.scalar(film, {.factor = "iridescenceFactor",
                                                 .texture = "iridescenceTexture",
                                                 .slot = "iridescence",
                                                 .channel = "r",
                                                 .property = "_Iridescence",
                                                 .otherwise = 0}));
    set_number(graph, film, "iridescenceIor", "iridescenceIor", "_IridescenceIor", 1.3, 1, 3);
    const Term texel = graph.texel(film, "iridescenceThicknessTexture", "iridescenceThickness", "data");
    const double least = film.number("iridescenceThicknessMinimum", 0, kAny).value_or(100);
    const double most = film.number("iridescenceThicknessMaximum", 0, kAny).value_or(400);
    if (texel.is_constant()) {
        film.taken("iridescenceThicknessMinimum", "it has no effect without 'iridescenceThicknessTexture'");
        set_number(graph, film, "iridescenceThicknessMaximum", "iridescenceThickness", "_IridescenceThickness", 400, 0,
                   1200);
        return film.rest();
    }
    const Term low = graph.number_property("_IridescenceThicknessMinimum", least, 0, 1200);
    const Term high = graph.number_property("_IridescenceThicknessMaximum", most, 0, 1200);
    graph.set("iridescenceThickness", computed("lerp(a, b, c.g)", {low, high, texel}, Type::Float));
    film.taken("iridescenceThicknessMinimum", "the property '_IridescenceThicknessMinimum'");
    film.taken("iridescenceThicknessMaximum", "the property '_IridescenceThicknessMaximum'");
    film.rest();
}

// The thickness is in the space of the mesh, and shrinks and grows with it; the attenuation is in that of the world.
void set_volume(MaterialGraph& graph, Object volume, const MaterialUse& use, bool is_seen_through) {
    if (!volume) return;
    if (!is_seen_through) {
        volume.all_taken("it has no effect: no light passes through the surface");
        return volume.rest();
    }
    if (is_off(volume, "thicknessFactor")) return;
    const Term thickness = graph.scalar(volume, {.factor = "thicknessFactor",
                                                 .texture = "thicknessTexture",
                                                 .slot = "thickness",
                                                 .channel = "g",
                                                 .property = "_Thickness",
                                                 .otherwise = 0,
                                                 .high = kAny});
    const Term scale =
        expression(use.is_stretched ? "dot(@objectScale, float3(1, 1, 1) / 3)" : "@objectScale.x", Type::Float);
    graph.set("thickness", use.is_scaled ? product({thickness, scale}) : thickness);
    if (use.is_stretched) {
        volume.changed("thicknessFactor",
                       "the thickness grows with the mean of the object's three scales, whatever way the light takes");
    }
    const auto distance = volume.number("attenuationDistance", 0, 1e12);
    const auto color = volume.numbers("attenuationColor", 3, 0, 1);
    if (distance && *distance > 0 && color) {
        graph.set("attenuationDistance",
                  graph.number_property("_AttenuationDistance", *distance, 0, std::max(10.0, *distance)));
        graph.set("attenuationColor", swizzled(graph.color_property("_AttenuationColor", *color), "rgb"));
        volume.taken("attenuationDistance", "the property '_AttenuationDistance'");
        volume.taken("attenuationColor", "the property '_AttenuationColor'");
    }
    volume.taken("attenuationDistance", "it has no effect without a colour");
    volume.taken("attenuationColor", "it has no effect without a distance");
    volume.rest();
}

// True if light passes.
bool set_transmission(MaterialGraph& graph, Object layer) {
    if (is_off(layer, "transmissionFactor")) return false;
    graph.set("transmission", graph.scalar(layer, {.factor = "transmissionFactor",
                                                   .texture = "transmissionTexture",
                                                   .slot = "transmission",
                                                   .channel = "r",
                                                   .property = "_Transmission",
                                                   .otherwise = 0}));
    layer.rest();
    return true;
}

bool set_diffuse_transmission(MaterialGraph& graph, Object layer) {
    if (is_off(layer, "diffuseTransmissionFactor")) return false;
    graph.set("diffuseTransmission", graph.scalar(layer, {.factor = "diffuseTransmissionFactor",
                                                          .texture = "diffuseTransmissionTexture",
                                                          .slot = "diffuseTransmission",
                                                          .channel = "a",
                                                          .property = "_DiffuseTransmission",
                                                          .otherwise = 0}));
    set_unless(graph, "diffuseTransmissionColor",
               graph.color(layer, {.factor = "diffuseTransmissionColorFactor",
                                   .texture = "diffuseTransmissionColorTexture",
                                   .slot = "diffuseTransmissionColor",
                                   .channel = "rgb",
                                   .property = "_DiffuseTransmissionColor",
                                   .high = kAny}),
               1);
    layer.rest();
    return true;
}

}  // namespace

void set_layers(MaterialGraph& graph, Object& material, const MaterialUse& use) {
    set_specular(graph, material.extension("KHR_materials_specular"));
    Object ior = material.extension("KHR_materials_ior");
    set_number(graph, ior, "ior", "ior", "_Ior", 1.5, 1, 3);
    ior.rest();
    set_anisotropy(graph, material.extension("KHR_materials_anisotropy"));
    set_iridescence(graph, material.extension("KHR_materials_iridescence"));
    set_sheen(graph, material.extension("KHR_materials_sheen"));
    set_clearcoat(graph, material.extension("KHR_materials_clearcoat"));
    const bool is_clear = set_transmission(graph, material.extension("KHR_materials_transmission"));
    const bool is_translucent =
        set_diffuse_transmission(graph, material.extension("KHR_materials_diffuse_transmission"));
    set_volume(graph, material.extension("KHR_materials_volume"), use, is_clear || is_translucent);
    Object dispersion = material.extension("KHR_materials_dispersion");
    if (is_clear) set_number(graph, dispersion, "dispersion", "dispersion", "_Dispersion", 0, 0, 1);
    dispersion.taken("dispersion", "it has no effect: no light passes through the surface");
    dispersion.rest();
}

void leave_layers(Object& material, const std::string& why) {
    for (const std::string_view name : kLayers) {
        Object layer = material.extension(name);
        layer.all_taken(why);
        layer.rest();
    }
}

}  // namespace patina::importers::gltf

// What the surface shader of a material gets: the inputs of the graph's surface, and its render state.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/special_nodes.h"

namespace patina::importers::mtlx {
namespace {

bool reads(const std::string& text, std::string_view input) {
    return std::ranges::count(inputs_in(text), input) > 0;
}

bool is_grey(const Term& color) {
    if (color.is_constant()) return color.is_all(color.numbers[0]);
    const std::string_view components = color.components();
    if (!components.empty()) return components.find_first_not_of(components[0]) == std::string::npos;
    return color.expression()->kind == nodelang::Expr::Kind::Call && color.expression()->text == "float3" &&
           color.expression()->args.size() == 1;  // of one number
}

}  // namespace

void GraphMaker::add_to_surface(const std::string& key, const Term& value) {
    file_.surface.push_back({key, value.value()});
    file_.types["surface." + key] = value.type;
}

// A weight that is 0 is none, and neither is an angle.
bool GraphMaker::has_effect(Scope& scope, const Element& shader, const Port& port) {
    return is_set(scope, shader, port.name) && (port.type != "float" || !input(scope, shader, port).is_all(0));
}

bool GraphMaker::is_default(Scope& scope, const Element& shader, const SurfaceRule::Ignored& ignored) {
    const Source source = source_of(scope, shader, ignored.input);
    const bool is_geometry = ignored.otherwise.starts_with('@');
    // What would be computed for it would be in the graph.
    if (source.is_interface || (!is_geometry && !source.input->has("value"))) return false;
    const std::string type = type_of(scope, shader, ignored.input);
    const Port port{.name = std::string(ignored.input), .type = type};
    const Term usual =
        is_geometry ? geometry(ignored.otherwise.substr(1), Type::Float3) : literal(Element{}, type, ignored.otherwise);
    return input(scope, shader, port).text() == usual.text();
}

void GraphMaker::make_surface(Scope& scope, const Element& shader) {
    scope_ = &scope;
    std::string kind(shader.category);
    if (kind == "UsdPreviewSurface") {
        const std::string word = word_of(scope, shader, "useSpecularWorkflow");
        if (word == "1" || word == "true") kind += " specular";
    }
    const SurfaceRule* const surface = surface_rule(kind);
    if (!surface) {
        file_.workflow = "unlit";
        const Term color =
            magenta(shader, Type::Float3, fmt::format("'{}' is no surface shader that this importer knows", kind));
        add_to_surface("color", color);
        return;
    }
    check_inputs(scope, shader);
    file_.workflow = surface->workflow;
    file_.lighting = surface->lighting;
    std::map<std::string, std::size_t> counts;
    std::set<std::string> carried = {"alpha",       "alpha_mode",         "alpha_cutoff", "opacityThreshold",
                                     "opacityMode", "useSpecularWorkflow"};
    for (const Statement& each : surface->rule.statements)
        for (const std::string& name : inputs_in(each.text)) ++counts[name];
    Term alpha;
    const auto say = [&](std::string_view input, Remark::Kind of, std::string what) {
        carried.insert(std::string(input));
        if (const Element* const stated = shader.child("", input))
            remark(of, fmt::format("{} input '{}'", kind, input), std::move(what), *stated);
    };
    const auto say_constant_normal = [&](const Term& value, const std::vector<std::string>& inputs) {
        const bool is_usual =
            value.text() == "float3(0, 0, 1)" || value.text() == "float3(0.5, 0.5, 1)" || value.is_all(0);
        for (const std::string& input : inputs)
            say(input, is_usual ? Remark::Kind::Taken : Remark::Kind::Changed,
                is_usual ? "the mesh's own normal" : "the mesh's own normal stands for a constant direction");
    };
    for (const Statement& each : surface->rule.statements) {
        std::vector<std::string> inputs;
        for (const Port& port : surface->rule.inputs)
            if (reads(each.text, port.name) && is_set(scope, shader, port.name)) inputs.push_back(port.name);
        if (!each.only_if.empty() && !has_effect(scope, shader, *surface->rule.input(each.only_if))) continue;
        Type type = Type::Float;
        for (const Port& port : surface->rule.inputs)
            if (reads(each.text, port.name) && !each.text.ends_with(".x}") &&
                terms::width(type_of_word(port.type)) > terms::width(type))
                type = type_of_word(port.type);
        Term value;
        std::string key = each.output;
        const auto texture = key == "normalTS" ? normal_map_of(*this, scope, shader, "normal") : std::nullopt;
        value = texture ? sampled_normal(shader, *texture, terms::number_term(1))
                        : filled(scope, shader, surface->rule, each.text, type, counts);
        if (texture) written(value, "'surface.normalTS'");
        if (key == "normal" && (value.text() == "@normalWS" || value.type == Type::None)) continue;
        if (key == "normal" || key.ends_with("NormalWS")) {
            // A constant direction in the world is what programs write for a default.
            if (value.is_constant()) {
                say_constant_normal(value, inputs);
                for (const std::string& input : inputs) carried.insert(input);
                continue;
            }
            if (key == "normal") key = value.tangent ? "normalTS" : "normalWS";
            if (key == "normalTS") value = value.with(value.tangent, Type::Float3);
            if (key == "clearcoatNormalWS" && value.text() == "@normalWS") continue;
            if (key == "coatNormalWS" && value.text() == "@normalWS") continue;
        }
        if (key == "normalTS" && value.is_constant()) {
            say_constant_normal(value, inputs);
            continue;
        }
        written(value, fmt::format("'surface.{}'", key));
        for (const std::string& input : inputs) {
            if (!carried.insert(input).second) continue;
            if (const Element* stated = shader.child("", input))
                remark(Remark::Kind::Taken, fmt::format("{} input '{}'", kind, input), fmt::format("'surface.{}'", key),
                       *stated);
        }
        if (const auto otherwise = read_number(each.otherwise); otherwise && value.is_all(*otherwise)) continue;
        if (key == "alpha") {
            alpha = value;
            continue;
        }
        add_to_surface(key, value);
    }

    // How alpha is used.
    std::string mode;
    Term cutoff;
    if (shader.category == "gltf_pbr") {
        const std::string stated = word_of(scope, shader, "alpha_mode");
        if (!stated.empty() && stated != "0" && stated != "1" && stated != "2")
            say("alpha_mode", Remark::Kind::Changed, fmt::format("'{}' is no mode: the surface is opaque", stated));
        if (stated == "1" || stated == "2") {
            mode = stated == "1" ? "cutout" : "fade";
            alpha = input(scope, shader, {.name = "alpha", .type = "float", .otherwise = "1"});
            if (stated == "1")
                cutoff = input(scope, shader, {.name = "alpha_cutoff", .type = "float", .otherwise = "0.5"});
        }
    } else if (alpha.type != Type::None) {
        // "presence": where the surface is; else it is glass, whose highlights stay.
        const bool is_usd = shader.category == "UsdPreviewSurface";
        const std::string usd_mode = word_of(scope, shader, "opacityMode");
        mode = is_usd && usd_mode != "1" && usd_mode != "presence" ? "transparent" : "fade";
        if (is_usd && is_set(scope, shader, "opacityThreshold")) {
            cutoff = input(scope, shader, {.name = "opacityThreshold", .type = "float", .otherwise = "0"});
            if (!cutoff.is_all(0)) mode = "cutout";
        }
        if (shader.category == "standard_surface" && is_set(scope, shader, "opacity") &&
            !is_grey(input(scope, shader, {.name = "opacity", .type = "color3"})))
            approximate(shader, "its opacity is that of red, in all channels");
    }
    if (mode == "fade" && alpha.is_all(1)) mode.clear();
    const std::string is_drawn = fmt::format("the surface is {}", mode.empty() ? "opaque" : fmt::format("'{}'", mode));
    const std::string alpha_mode = word_of(scope, shader, "alpha_mode");
    if (alpha_mode.size() == 1 && alpha_mode <= "2") say("alpha_mode", Remark::Kind::Taken, is_drawn);
    for (const std::string_view each : {"alpha", "opacityMode"})
        say(each, Remark::Kind::Taken, each == "alpha" && !mode.empty() ? "'surface.alpha'" : is_drawn);
    for (const std::string_view each : {"alpha_cutoff", "opacityThreshold"})
        say(each, Remark::Kind::Taken, mode == "cutout" ? "'surface.alphaClip'" : is_drawn);
    say("useSpecularWorkflow", Remark::Kind::Taken, fmt::format("the workflow '{}'", file_.workflow));
    if (!mode.empty()) {
        written(alpha, "'surface.alpha'");
        if (!alpha.is_all(1)) add_to_surface("alpha", alpha);
        if (mode == "cutout" && cutoff.type != Type::None && !cutoff.is_all(0.5)) {
            written(cutoff, "'surface.alphaClip'");
            add_to_surface("alphaClip", cutoff);
        }
        file_.more.push_back({"render", GraphValue::object({{"surface", mode}})});
    }
    for (const SurfaceRule::Ignored& each : surface->ignored) {
        carried.insert(std::string(each.input));
        if (!is_set(scope, shader, each.input)) continue;
        if (const Element* const stated = shader.child("", each.input))
            remark(is_default(scope, shader, each) ? Remark::Kind::Taken : Remark::Kind::Changed,
                   fmt::format("{} input '{}'", kind, each.input),
                   is_default(scope, shader, each) ? "its default" : std::string(each.text), *stated);
    }
    for (const Element& each : shader.children) {
        const bool is_missing = each.has("interfacename") && !source_of(scope, shader, each.name()).input;
        if (!is_input(each) || is_missing || carried.contains(std::string(each.name()))) continue;
        if (surface->rule.input(each.name()))
            remark(Remark::Kind::Taken, fmt::format("{} input '{}'", kind, each.name()),
                   "it has no effect without the layer that reads it", each);
        else
            remark(Remark::Kind::Changed, fmt::format("{} input '{}'", kind, each.name()),
                   "the shader has no such input", each);
    }
    Term all;
    all.nodes.insert(number_of(shader));
    written(all, fmt::format("the surface, lit by '{}'", file_.lighting.empty() ? file_.workflow : file_.lighting));
}

}  // namespace patina::importers::mtlx

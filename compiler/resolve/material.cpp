#include "compiler/resolve/material.h"

#include <algorithm>
#include <set>

#include "compiler/base/file_names.h"
#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/nodelang/parse.h"
#include "compiler/resolve/meanings.h"

namespace patina::resolve {

using nodelang::Expr;

namespace {

template <class Map>
std::vector<std::string_view> keys(const Map& map) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : map) names.push_back(name);
    return names;
}

}  // namespace

const CheckedGraph* find_workflow(Session& session, const format::Graph& graph) {
    const auto& workflows = session.library.workflows;
    if (graph.workflow.empty() && session.diagnostics.has_errors()) return nullptr;  // it is missing: reported already
    const auto found = workflows.find(graph.workflow);
    if (found == workflows.end()) {
        session.diagnostics
            .report(Code::UnknownWord, graph.workflow_span ? graph.workflow_span : graph.span, graph.workflow,
                    "a workflow")
            .note(Diagnostics::suggestion(graph.workflow, keys(workflows)));
        return nullptr;
    }
    return check_graph(session, found->second.get());
}

const format::LightingUse& lighting_of(const format::Graph& graph, const format::Graph& workflow) {
    return graph.lighting.present && workflow.is_lit() ? graph.lighting : workflow.lighting;
}

const CheckedGraph* find_lighting(Session& session, const format::Graph& graph, const format::LightingUse& use,
                                  std::string& name, const Shown& shown) {
    if (use.inlined) {
        name = use.inlined->name;
        return check_graph(session, use.inlined, shown);
    }
    name = use.use;
    if (is_file_name(use.use)) {
        const std::string path = require_source(session, use.use, graph.path, use.span);
        if (path.empty()) return nullptr;
        name = file_stem(path);
        return load_graph(session, path, format::GraphKind::Lighting, use.span, shown);
    }
    if (use.use.empty() && session.diagnostics.has_errors()) return nullptr;  // reported already
    const auto& models = session.library.lighting_models;
    const auto found = models.find(use.use);
    if (found == models.end()) {
        session.diagnostics.report(Code::UnknownWord, use.span, use.use, "a lighting model")
            .note(Diagnostics::suggestion(use.use, keys(models)))
            .note("name a lighting graph of your own by its file: \"./toon.lighting.json\"");
        return nullptr;
    }
    return check_graph(session, found->second.get(), shown);
}

namespace {

// Makes the rows of a matrix, a gradient or a curve the property's default; false if the value is none.
bool set_array_default(format::Property& property, const Expr& value) {
    const bool is_object = value.kind == Expr::Kind::Object;
    const std::string_view wanted = property.type == PropertyType::Gradient ? "Gradient"
                                    : property.type == PropertyType::Curve  ? "Curve"
                                                                            : "";
    if (value.text != wanted || (!is_object && value.kind != Expr::Kind::List)) return false;
    std::vector<double> numbers;
    for (const Expr* row : (is_object ? *value.args[0] : value).args) {
        for (const Expr* number : row->args) numbers.push_back(number->number);
    }
    if (numbers.size() != property.numbers.size()) return false;
    property.numbers = std::move(numbers);
    return true;
}

// Makes a number, colour or word the property's default; false if it is not a constant.
bool set_default(Session& session, format::Property& property, const Expr& value) {
    const bool negative = value.kind == Expr::Kind::Unary && value.text == "-";
    const Expr& literal = negative ? *value.args[0] : value;
    if (property.type == PropertyType::Enum && value.kind == Expr::Kind::Name) {
        const auto found = std::find(property.values.begin(), property.values.end(), value.text);
        if (found == property.values.end()) {
            std::vector<std::string_view> known(property.values.begin(), property.values.end());
            session.diagnostics
                .report(Code::UnknownEnumerator, value.span, value.text, fmt::format("'{}'", property.name))
                .note(Diagnostics::suggestion(value.text, known));
        } else {
            property.value[0] = static_cast<double>(found - property.values.begin());
        }
        return true;
    }
    if (literal.kind == Expr::Kind::Number || literal.kind == Expr::Kind::Bool) {
        const bool is_vector = property.type == PropertyType::Float2 || property.type == PropertyType::Float3 ||
                               property.type == PropertyType::Float4 || property.type == PropertyType::Color;
        if (property.type == PropertyType::Enum || property.type == PropertyType::Sampler ||
            is_texture(property.type) || is_array(property.type))
            return false;
        property.value.fill(0);
        for (std::size_t i = 0; i < (is_vector ? 4u : 1u); ++i)
            property.value[i] = negative ? -literal.number : literal.number;
        return true;
    }
    if (is_array(property.type)) return set_array_default(property, value);
    if (property.type == PropertyType::Sampler) {
        const NamedSampler* const named = value.kind == Expr::Kind::Name ? find_sampler(value.text) : nullptr;
        if (named) property.sampler = named->sampler, property.shared_sampler = named->name;
        return named != nullptr;
    }
    const std::size_t size = property.type == PropertyType::Float2 ? 2 : property.type == PropertyType::Float3 ? 3 : 4;
    const bool is_list = value.kind == Expr::Kind::List || value.kind == Expr::Kind::Color;
    const bool fits =
        is_list && (value.args.size() == size || (property.type == PropertyType::Color && value.args.size() == 3));
    if (!fits) return false;
    property.value[3] = 1;
    for (std::size_t i = 0; i < value.args.size(); ++i) property.value[i] = value.args[i]->number;
    return true;
}

// Binds a lighting graph's property whose value is known when the graph is compiled. The value is its default, a
// constant of the material, or a keyword of the material with the same values.
void bind_variant(Session& session, Material& material, const format::Property& property,
                  const format::PortValue* input) {
    const Expr* value = input ? input->value : nullptr;
    if (const MaterialProperty* keyword = value ? keyword_named(material, *value) : nullptr) {
        if (keyword->property->type == property.type && keyword->property->values == property.values) {
            material.lighting_inputs.push_back(*input);
            return;
        }
        session.diagnostics
            .report(Code::TypeMismatch, input->value_span, fmt::format("'{}'", keyword->property->name),
                    values_text(*keyword->property), values_text(property))
            .note(keyword->property->name_span, "it is declared here");
        material.variants[&property] = property.value[0];
        return;
    }
    if (const std::optional<double> chosen = chosen_value(session, material, property)) {
        material.variants[&property] = *chosen;
        return;
    }
    format::Property bound = property;
    const bool is_word = value && value->kind == Expr::Kind::Name && !material.graph->by_id.contains(value->text);
    if (is_word && property.type == PropertyType::Bool) {
        session.diagnostics
            .report(Code::UnknownEnumerator, value->span, value->text, fmt::format("'{}'", property.name))
            .note(Diagnostics::suggestion(value->text, keyword_words(property)));
    } else if (value && !set_default(session, bound, *value)) {
        session.diagnostics.report(Code::NotConstant, input->value_span, fmt::format("'{}'", property.name))
            .note("give it a constant, or a property of the material that is a variant or a specialization constant");
    }
    material.variants[&property] = bound.value[0];
}

// Applies "lighting": { "in": ... }. A constant is another default of the lighting graph's property, which can still be
// set. Any other value replaces the property, which the material then does not have.
void bind_lighting_properties(Session& session, Material& material, std::span<const format::PortValue> inputs) {
    const std::vector<format::Property>& own = material.lighting->graph->properties;
    for (const format::Property& property : own) {
        const auto input = std::find_if(inputs.begin(), inputs.end(),
                                        [&](const format::PortValue& p) { return p.name == property.name; });
        if (property.binding == Binding::Variant) {
            bind_variant(session, material, property, input == inputs.end() ? nullptr : &*input);
            continue;
        }
        if (input == inputs.end()) {
            join_property(session, material, property, {.from = material.lighting->graph->path});
            continue;
        }
        if (!input->value) continue;
        const std::size_t ranged = property.type == PropertyType::Color ? 3 : 4;
        if (property.range) check_range(session, *input->value, *property.range, property.hard, property.name, ranged);
        format::Property bound = property;
        bound.default_span = input->value_span;
        const bool is_file = is_texture(property.type) && input->value->kind == Expr::Kind::File;
        if (is_file) {
            bound.texture = std::string(input->value->text);
        }
        if (is_file || set_default(session, bound, *input->value)) {
            // A file name is relative to the graph that states it.
            const std::string& from = is_file ? material.graph->graph->path : material.lighting->graph->path;
            session.file_properties.push_back(std::move(bound));
            join_property(session, material, session.file_properties.back(),
                          {.from = from, .said_at = input->name_span});
        } else {
            material.lighting_inputs.push_back(*input);
        }
    }
    for (const format::PortValue& port : inputs) {
        if (std::any_of(own.begin(), own.end(), [&](const format::Property& p) { return p.name == port.name; }))
            continue;
        std::vector<std::string_view> names;
        for (const format::Property& property : own) names.push_back(property.name);
        session.diagnostics.report(Code::UnknownPort, port.name_span, material.lighting_name, "property", port.name)
            .note(names.empty() ? "the lighting model has no properties" : Diagnostics::suggestion(port.name, names));
    }
}

// A variant of the lighting graph is not a property of the material, so both cannot have the same name.
void check_lighting_variants(Session& session, const Material& material, const format::LightingUse& use) {
    for (const format::Property& property : material.lighting->graph->properties) {
        const auto found = material.property_index.find(property.name);
        if (property.binding != Binding::Variant || found == material.property_index.end()) continue;
        const bool is_given = std::any_of(use.inputs.begin(), use.inputs.end(),
                                          [&](const format::PortValue& input) { return input.name == property.name; });
        if (is_given) continue;
        const format::Property& other = *material.properties[found->second].property;
        DiagnosticRecord& record =
            session.diagnostics.report(Code::DuplicateId, other.name_span, "property", property.name)
                .note(property.name_span, "the lighting graph has a variant of this name");
        if (!use.inlined) {
            record.note(
                fmt::format("set it with \"lighting\": {{ \"use\": \"{}\", \"in\": {{ \"{}\": ... }} }}, to a value or "
                            "to a property of the material that has the same values",
                            use.use.empty() ? material.lighting_name : use.use, property.name));
        }
    }
}

void check_surface(Session& session, const Material& material) {
    const std::vector<const format::Input*> inputs = material.surface_inputs();
    const format::Graph& graph = *material.graph->graph;
    std::map<std::string_view, const format::PortValue*> said;
    for (const format::PortValue& port : graph.surface) {
        const auto found =
            std::find_if(inputs.begin(), inputs.end(), [&](const format::Input* i) { return i->name == port.name; });
        if (found == inputs.end()) {
            std::vector<std::string_view> names;
            for (const format::Input* input : inputs) names.push_back(input->name);
            // With a lighting model of the command line, the file does not say where the input is missing.
            const std::string has = session.options.lighting.empty()
                                        ? "has"
                                        : fmt::format("and the lighting model '{}' have", material.lighting_name);
            DiagnosticRecord& record =
                session.diagnostics.report(Code::UnknownSurfaceInput, port.name_span, graph.workflow, has, port.name);
            if (const std::string_view near = nearest(port.name, names); !near.empty()) {
                record.note(fmt::format("did you mean '{}'?", near));
            }
            record.note(fmt::format("its inputs are {}", enumerate(names)));
            continue;
        }
        const std::string_view gives = (*found)->gives.empty() ? (*found)->name : (*found)->gives;
        const auto [first, is_new] = said.emplace(gives, &port);
        if (!is_new && first->second->name != port.name) {
            session.diagnostics.report(Code::ConflictingInputs, port.name_span, port.name, first->second->name)
                .note(first->second->name_span, "the other one is here");
        }
        if (port.value && (*found)->range) {
            check_range(session, *port.value, *(*found)->range, (*found)->hard, port.name);
        }
    }
}

void check_vertex(Session& session, const format::Graph& graph) {
    std::vector<std::string_view> names;
    for (const paths::SemanticDecl& semantic : session.paths->semantics) {
        if (semantic.is_vertex_output) names.push_back(semantic.name);
    }
    for (const format::PortValue& port : graph.vertex) {
        if (std::find(names.begin(), names.end(), port.name) != names.end()) continue;
        session.diagnostics.report(Code::UnknownPort, port.name_span, "the vertex stage", "output", port.name)
            .note(Diagnostics::suggestion(port.name, names));
    }
}

// Resolves everything but the graph itself. False after errors that leave nothing to continue with.
bool resolve_rest(Session& session, Material& material) {
    const format::Graph& graph = *material.graph->graph;
    material.workflow = find_workflow(session, graph);
    if (!material.workflow) return false;
    const format::LightingUse& lighting = lighting_of(graph, *material.workflow->graph);
    material.lighting = find_lighting(session, graph, lighting, material.lighting_name, material.shown_in_lighting);
    if (!material.lighting) return false;
    const std::size_t known = material.properties.size();
    join_graph(session, material, *material.graph);
    check_listed(session, material);
    choose_keywords(session, material, known);
    const std::size_t own = material.properties.size();
    bind_lighting_properties(session, material, lighting.inputs);
    join_graph(session, material, *material.lighting);
    choose_keywords(session, material, own);
    check_lighting_variants(session, material, lighting);
    check_surface(session, material);
    check_vertex(session, graph);
    return true;
}

}  // namespace

namespace {

// True if both names mean one file on a file system that ignores case.
bool is_same_file(std::string_view a, std::string_view b) {
    return small_letters(std::string(a)) == small_letters(std::string(b));
}

}  // namespace

void warn_unused(Session& session, const Material& material) {
    if (material.is_preview) return;
    const format::Graph& graph = *material.graph->graph;
    std::vector<format::PortValue> roots;
    const auto add_roots = [&](const format::Graph& of) {
        roots.insert(roots.end(), of.surface.begin(), of.surface.end());
        roots.insert(roots.end(), of.vertex.begin(), of.vertex.end());
        roots.insert(roots.end(), of.lighting.inputs.begin(), of.lighting.inputs.end());
    };
    add_roots(graph);
    for (const format::ExtraPass& pass : graph.passes) add_roots(*pass.graph);
    const std::vector<bool> used = material.graph->reachable(roots);
    for (std::size_t i = 0; i < used.size(); ++i) {
        const format::Node& node = graph.nodes[i];
        const bool is_part = node.span == graph.span;  // the node represents the whole file (part.h)
        if (used[i] || is_part) continue;
        session.diagnostics.report(Code::UnusedNode, node.id_span, node.id).at(node.id);
    }
    warn_unheeded(session, material);
    check_meanings(session, material);
}

const format::PortValue* Material::given_by_workflow(const format::Input& input) const {
    const std::vector<format::PortValue>& given = workflow->graph->surface;
    const auto found = std::find_if(given.begin(), given.end(), [&](const auto& p) { return p.name == input.name; });
    return found == given.end() ? nullptr : &*found;
}

std::vector<const format::Input*> Material::surface_inputs() const {
    std::vector<const format::Input*> inputs;
    for (const format::Input& input : workflow->graph->inputs) inputs.push_back(&input);
    if (lighting) {
        for (const format::Input& input : lighting->graph->inputs)
            if (!given_by_workflow(input)) inputs.push_back(&input);
    }
    return inputs;
}

std::unique_ptr<Material> resolve_material(Session& session, std::shared_ptr<format::Graph> graph,
                                           const std::optional<std::string>& preview) {
    auto material = std::make_unique<Material>();
    material->is_preview = preview.has_value();
    Shown shown;
    if (material->is_preview && !make_preview(session, *graph, *preview, *material, shown)) return nullptr;
    material->graph = check_graph(session, graph, shown);
    if (!resolve_rest(session, *material)) return nullptr;
    return material;
}

std::vector<std::unique_ptr<Material>> resolve_passes(Session& session, Material& material) {
    std::vector<std::unique_ptr<Material>> passes;
    if (material.is_preview) return passes;
    for (const format::ExtraPass& pass : material.graph->graph->passes) {
        for (const paths::PassDecl& known : session.paths->passes) {
            if (!is_same_file(known.name, pass.name)) continue;
            session.diagnostics.report(Code::DuplicateId, pass.name_span, "pass", pass.name)
                .note(known.name == pass.name ? fmt::format("the first is a pass of the path '{}'", known.path)
                                              : fmt::format("the path '{}' has '{}', and some file systems cannot "
                                                            "distinguish files named after the two passes",
                                                            known.path, known.name));
            break;
        }
        for (const format::ExtraPass& other : material.graph->graph->passes) {
            if (&other == &pass) break;
            if (other.name == pass.name || !is_same_file(other.name, pass.name)) continue;
            session.diagnostics.report(Code::DuplicateId, pass.name_span, "pass", pass.name)
                .note(other.name_span,
                      "the first is here; some file systems cannot distinguish files named after the two passes");
        }
        auto made = std::make_unique<Material>();
        made->pass = &pass;
        made->properties = material.properties;
        made->property_index = material.property_index;
        // The pass uses the material's nodes, which have been checked.
        CheckedGraph& checked = session.checked.emplace_back(*material.graph);
        checked.graph = pass.graph;
        made->graph = &checked;
        if (!resolve_rest(session, *made)) continue;
        material.properties = made->properties;
        material.property_index = made->property_index;
        passes.push_back(std::move(made));
    }
    for (const std::unique_ptr<Material>& pass : passes) {
        pass->properties = material.properties;
        pass->property_index = material.property_index;
    }
    return passes;
}

}  // namespace patina::resolve

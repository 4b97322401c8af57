#include "compiler/resolve/smallest_material.h"

#include <algorithm>

#include "compiler/format/words.h"

namespace patina::resolve {

using nodelang::Expr;

namespace {

// The first workflow that shows a single value, or the first one that does not.
std::string workflow_name(const Library& library, bool shows_value) {
    for (const auto& [name, workflow] : library.workflows) {
        if (workflow.get() && workflow.get()->preview_input.empty() != shows_value) return name;
    }
    return {};
}

// Some value of the type, for an input that has no default.
const Expr* any_value(Session& session, format::Graph& material, const format::Input& input) {
    Expr& expr = session.ast.exprs.emplace_back();
    expr.span = expr.name_span = input.name_span;
    if (input.type == "bool") {
        expr.kind = Expr::Kind::Bool;
    } else if (const std::optional<PropertyType> type = from_word<PropertyType>(input.type);
               type && (is_texture(*type) || is_array(*type) || *type == PropertyType::Sampler)) {
        format::Property& property = material.properties.emplace_back();
        property.name = "_" + input.name;
        property.name_span = property.span = input.name_span;
        property.type = *type;
        if (is_texture(*type)) property.texture = "white";
        if (*type == PropertyType::Sampler) property.shared_sampler = name_of(property.sampler);
        if (is_array(*type)) property.numbers.assign(component_count(*type), 1);
        expr.kind = Expr::Kind::Property;
        expr.text = session.ast.texts.emplace_back(property.name);
    }
    return &expr;
}

}  // namespace

std::shared_ptr<format::Graph> material_around(Session& session, std::shared_ptr<format::Graph> part) {
    if (part->kind == format::GraphKind::Material) return part;
    auto material = std::make_shared<format::Graph>();
    material->path = part->path;
    material->name = part->name;
    material->span = part->span;
    material->workflow = workflow_name(session.library, part->kind == format::GraphKind::Subgraph);
    if (part->kind == format::GraphKind::Lighting) {
        material->lighting.inlined = part;
        material->lighting.span = part->span;
        material->lighting.present = true;
        return material;
    }
    if (part->kind == format::GraphKind::Workflow) {
        session.diagnostics.report(Code::UnknownWord, part->span, "workflow", "a graph that can be checked on its own");
        return nullptr;
    }
    format::Node& node = material->nodes.emplace_back();
    node.id = "part";
    node.id_span = node.span = node.type_span = part->span;
    node.type = "./" + part->path.substr(part->path.find_last_of('/') + 1);
    for (const format::Input& input : part->inputs) {
        if (input.value) continue;
        node.inputs.push_back({.name = input.name,
                               .name_span = input.name_span,
                               .value_span = input.name_span,
                               .value = any_value(session, *material, input)});
    }
    return material;
}

}  // namespace patina::resolve

#include "compiler/importers/imported_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/format/canonical_form.h"
#include "compiler/importers/source_text.h"
#include "compiler/importers/values.h"
#include "runtime/lighting/studio_lights.h"

namespace patina::importers {
namespace {

bool has_value(const GraphValue& value) {
    return value.kind() != GraphValue::Kind::Number || std::isfinite(value.number());
}

GraphMembers with_values(const GraphMembers& members) {
    GraphMembers made;
    for (const GraphMember& each : members)
        if (has_value(each.value)) made.push_back(each);
    return made;
}

// With the comment above.
GraphMembers commented(const GraphMembers& members, const std::string& comment) {
    GraphMembers made = with_values(members);
    if (!comment.empty()) made.push_back({"//", comment});
    return made;
}

std::string printable_lines(std::string_view text) {
    std::string made;
    for (std::string_view line : split(text, "\n")) {
        if (line.ends_with('\r')) line.remove_suffix(1);
        made += (made.empty() ? "" : "\n") + printable(line);
    }
    return made;
}

}  // namespace

const Compiler& library() {
    static const Compiler made;
    return made;
}

GraphBuilder ImportedGraph::builder(const std::string& path) const {
    GraphBuilder made(path);
    if (!comment.empty()) made.set("//", printable_lines(comment));
    made.set("kind", kind);
    if (!name.empty()) made.set("name", name);
    if (!workflow.empty()) made.set("workflow", workflow);
    if (!lighting.empty() && lighting_inputs.empty()) made.set("lighting", lighting);
    if (!lighting_inputs.empty())
        made.set("lighting",
                 GraphValue::object({{"use", lighting}, {"in", GraphValue::object(with_values(lighting_inputs))}}));
    for (const GraphMember& each : with_values(more)) made.set(each.key, each.value);
    for (const ImportedProperty& each : properties) {
        GraphMembers members = commented(each.more, printable_lines(each.comment));
        const std::optional<PropertyType> type = from_word<PropertyType>(each.type);
        // Of a word that is no type there is no graph: no key may stand twice.
        if (!type) members.push_back({"type", each.type});
        made.property(each.name, type.value_or(PropertyType::Float),
                      each.value && has_value(*each.value) ? each.value : std::nullopt, std::move(members));
    }
    for (const ImportedProperty& each : inputs) {
        GraphMembers members = with_values(each.more);
        if (each.value) members.insert(members.begin(), {"default", *each.value});
        made.input(each.name, each.type, std::move(members));
    }
    for (const ImportedNode& each : nodes) {
        GraphMembers members = commented(each.more, printable_lines(each.comment));
        if (each.node.empty())
            made.expression(each.id, each.expression, std::move(members));
        else
            made.node(each.id, each.node, with_values(each.inputs), std::move(members));
    }
    for (const GraphMember& each : with_values(vertex)) made.vertex(each.key, each.value);
    for (const GraphMember& each : with_values(surface)) made.surface(each.key, each.value);
    for (const GraphMember& each : with_values(outputs)) made.output(each.key, each.value);
    // A material says its surface, even if all of it is the default.
    if (kind == "material" && with_values(surface).empty()) made.set("surface", GraphValue::object({}));
    return made;
}

std::string ImportedGraph::text() const {
    return in_canonical_form(builder(name).text());
}

std::string ImportedGraph::add(ImportedNode node, std::set<std::size_t> its_owners) {
    const std::string where = fmt::format("the node '{}'", node.id);
    for (const std::size_t each : its_owners) taken(each, where);
    std::string id = node.id;
    owners[id] = std::move(its_owners);
    nodes.push_back(std::move(node));
    return id;
}

terms::Term ImportedGraph::named(const terms::Term& term, const std::function<std::string()>& id,
                                 std::set<std::size_t> its_owners, GraphMembers its_more) {
    const std::string whole = printed(*term.whole());
    const auto [found, is_new] = named_.try_emplace(whole);
    if (is_new) {
        const std::string own =
            add({.id = id(), .expression = whole, .more = std::move(its_more)}, std::move(its_owners));
        types[own] = term.whole_width > 0 ? terms::vector_type(term.whole_width) : term.type;
        found->second = terms::link(own, term.type);
        found->second.owner = term.owner;
        written(term, fmt::format("the node '{}'", own));
    }
    terms::Term made = found->second;
    if (term.whole_width > 0) made.tree = nodelang::member(made.tree, term.components());
    made.type = term.type;
    made.whole_width = term.whole_width;
    made.is_color = term.is_color;
    made.from_top = term.from_top;
    made.tangent = term.tangent;
    made.name = term.name;
    return made;
}

void ImportedGraph::taken(std::size_t part, std::string where) {
    Outcome& outcome = outcomes[part];
    if (outcome.where.empty()) outcome.where = std::move(where);
}

void ImportedGraph::written(const terms::Term& term, std::string_view where) {
    for (const std::size_t each : term.nodes) taken(each, std::string(where));
}

void ImportedGraph::approximate(std::size_t part, const std::string& difference) {
    Outcome& outcome = outcomes[part];
    if (outcome.kind == Remark::Kind::Taken) outcome.kind = Remark::Kind::Changed;
    if (outcome.text.find(difference) == outcome.text.npos)
        outcome.text += (outcome.text.empty() ? "" : "; ") + difference;
}

std::string in_canonical_form(std::string text) {
    SourceMap sources;
    Diagnostics diagnostics;
    const std::uint32_t begin = sources.add("graph", std::move(text));
    return format::format_graph(sources, begin, diagnostics).text;
}

GraphValue default_lights() {
    std::vector<GraphValue> lights;
    for (const runtime::StudioLight& each : runtime::kStudioLights)
        lights.push_back(GraphValue::object(
            {{"type", "directional"}, {"direction", list_of(each.direction)}, {"color", list_of(each.color)}}));
    return GraphValue::list(std::move(lights));
}

std::string write_scene(const GraphMembers& members) {
    GraphBuilder made("scene");
    made.set("kind", "scene");
    for (const GraphMember& each : with_values(members)) made.set(each.key, each.value);
    return in_canonical_form(made.text());
}

}  // namespace patina::importers

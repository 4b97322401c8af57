#include "compiler/importers/mtlx/mtlx_importer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/base/letters.h"
#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers {
namespace {

using namespace mtlx;

bool recognises(const importers::Source& source) {
    const std::string ending = small_letters(std::filesystem::path(source.path).extension().string());
    return ending == ".mtlx";
}

struct Material {
    const Element* element = nullptr;  // that names it
    const Element* shader = nullptr;   // null: it was not found
    std::string scope{};               // the node graph that the shader stands in; empty: the document
};

bool is_shader(const Element& element) {
    return element.type() == "surfaceshader" && element.category != "output" && element.category != "input" &&
           element.category != "nodedef";
}

// The shader that an input reads: a node, or an output of a node graph.
void find_shader(const Element& root, const Element& input, Material& made) {
    const Element* at = &input;
    for (int steps = 0; at && steps < 100; ++steps) {
        if (at->has("nodegraph")) {
            const Element* const graph = root.child("nodegraph", at->attribute("nodegraph"));
            if (!graph) return;
            const Element* output = at->has("output") ? graph->child("output", at->attribute("output")) : nullptr;
            for (const Element& each : graph->children)
                if (!output && each.category == "output" && each.type() == "surfaceshader") output = &each;
            made.scope = graph->name();
            at = output;
            continue;
        }
        const Element* const around = made.scope.empty() ? &root : root.child("nodegraph", made.scope);
        const std::string_view name = at->has("nodename") ? at->attribute("nodename") : at->attribute("output");
        const Element* const found = around ? around->child("", name) : nullptr;
        if (!found) return;
        if (found->category != "output") {
            made.shader = found;
            return;
        }
        at = found;
    }
}

std::vector<Material> materials_of(const Element& root) {
    std::vector<Material> made;
    for (const Element& each : root.children) {
        if (each.category == "surfacematerial" || (each.category == "material" && each.children.size() > 0)) {
            Material material{.element = &each};
            for (const Element& child : each.children) {
                if (child.category == "shaderref") {  // of 1.36 and 1.37: the inputs are children
                    if (!material.shader) material.shader = &child;
                } else if (child.name() == "surfaceshader") {
                    find_shader(root, child, material);
                }
            }
            made.push_back(std::move(material));
        }
    }
    if (!made.empty()) return made;
    for (const Element& each : root.children)
        if (is_shader(each)) made.push_back({.element = &each, .shader = &each});
    for (const Element& graph : root.children)
        if (made.empty() && graph.category == "nodegraph" && !graph.has("nodedef"))
            for (const Element& each : graph.children)
                if (is_shader(each))
                    made.push_back({.element = &each, .shader = &each, .scope = std::string(graph.name())});
    return made;
}

// A shader whose definition is in the document, as the one inside of it.
std::pair<const Element*, Scope*> inner_shader(GraphMaker& maker, const Element* shader, Scope* scope) {
    for (int depth = 0; depth < 20 && !surface_rule(shader->category); ++depth) {
        const Element* definition = nullptr;
        const Element* const graph = maker.implementation(*shader, definition);
        if (!graph) break;
        Scope& inner = maker.scope_of(*graph, maker.document_scope(), definition, shader, scope);
        const Element* found = nullptr;
        for (const Element& each : graph->children)
            if (each.category == "output" && each.type() == "surfaceshader")
                found = graph->child("", each.attribute("nodename"));
        if (!found) break;
        shader = found;
        scope = &inner;
    }
    return {shader, scope};
}

// Nodes that no material reads.
void report_unread(Import& import, const Element& around, const std::string& label) {
    for (const Element& each : around.children) {
        const bool is_other = each.category == "nodedef" || each.category == "output" || each.category == "input" ||
                              each.category == "implementation";
        const bool is_interface = mtlx::is_input(each) && around.category == "nodegraph" && !around.has("nodedef");
        if (each.category == "token") {
            import.remarks.push_back(
                {.kind = Remark::Kind::Taken,
                 .part = fmt::format("{}token '{}'", label, each.name()),
                 .text = each.is_in_names ? "its text is in names of files" : "no name of a file has it",
                 .line = each.line,
                 .column = each.column});
        } else if (each.category == "nodegraph") {
            report_unread(import, each, std::string(each.name()) + "/");
        } else if (is_interface && !import.reached.contains(&each)) {
            import.remarks.push_back({.kind = Remark::Kind::Taken,
                                      .part = fmt::format("{}input '{}'", label, each.name()),
                                      .text = "no material reads it",
                                      .line = each.line,
                                      .column = each.column});
        } else if (!is_other && !each.type().empty() && !import.reached.contains(&each)) {
            import.remarks.push_back({.kind = Remark::Kind::Taken,
                                      .part = fmt::format("{}{} '{}'", label, each.category, each.name()),
                                      .text = "no material reads it",
                                      .line = each.line,
                                      .column = each.column});
        } else if (each.category == "variantset") {
            import.remarks.push_back({.kind = Remark::Kind::Changed,
                                      .part = fmt::format("variantset '{}'", each.name()),
                                      .text = "a graph has no sets of values: the inputs keep their own",
                                      .line = each.line,
                                      .column = each.column});
        } else if (each.category == "look" || each.category == "propertyset" || each.category == "geominfo" ||
                   each.category == "collection") {
            import.remarks.push_back({.kind = Remark::Kind::Changed,
                                      .part = fmt::format("{} '{}'", each.category, each.name()),
                                      .text = "a graph does not say which objects it is for",
                                      .line = each.line,
                                      .column = each.column});
        }
    }
}

Imported read(const importers::Source& source, const Options& options) {
    Document document;
    Imported made;
    made.error = read_document(source.path, options.include_dirs, document);
    if (!made.error.empty()) return made;
    const std::vector<Material> materials = materials_of(document.root);
    if (materials.empty())
        return {.error = fmt::format("{}:1:1: the document has no material and no surface shader", source.path)};
    Import import{
        .document = document,
        .path = source.path,
        .folder = options.folder.empty() ? std::filesystem::path(source.path).parent_path().string() : options.folder,
        .folders = options.include_dirs};
    for (const Document::Problem& each : document.problems) {
        import.has_refused |= each.is_lost;
        import.remarks.push_back({.kind = each.is_lost ? Remark::Kind::LeftOut : Remark::Kind::Changed,
                                  .part = each.part,
                                  .text = each.text,
                                  .line = each.line,
                                  .column = each.column});
    }
    std::vector<TextFile> graphs;
    for (const Material& each : materials) {
        std::string wanted(each.element->name());
        std::erase_if(wanted, [](char c) { return !is_word_letter(c) && c != '-'; });
        if (materials.size() == 1 && !options.name.empty()) wanted = options.name;
        const std::string name = import.file_names.unique(wanted, std::filesystem::path(source.path).stem().string());
        GraphMaker maker(import, name);
        const Element* shader = each.shader;
        Element legacy;
        if (!shader) {
            import.has_refused = true;
            import.remarks.push_back({.kind = Remark::Kind::LeftOut,
                                      .part = fmt::format("{} '{}'", each.element->category, each.element->name()),
                                      .text = "it has no surface shader that is there",
                                      .line = each.element->line,
                                      .column = each.element->column});
            shader = each.element;
        } else if (shader->category == "shaderref") {
            legacy = *shader;
            legacy.category = shader->attribute("node");
            legacy.attributes.emplace_back("type", "surfaceshader");
            shader = &legacy;
        }
        Scope* scope = &maker.document_scope();
        if (!each.scope.empty()) scope = &maker.scope_of(*document.root.child("nodegraph", each.scope), *scope);
        const auto [inner, at] = inner_shader(maker, shader, scope);
        maker.make(*each.element, *inner, *at);
        if (!import.error.empty()) return {.error = import.error};
        for (const Element& child : each.element->children)
            if ((child.has("nodename") || child.has("nodegraph")) &&
                (child.name() == "displacementshader" || child.name() == "volumeshader" ||
                 child.name() == "backsurfaceshader"))
                import.remarks.push_back({.kind = Remark::Kind::LeftOut,
                                          .part = fmt::format("'{}'", child.name()),
                                          .text = "it is not imported: the surface alone is",
                                          .line = child.line,
                                          .column = child.column});
        const std::string json = maker.file().text();
        if (json.empty()) return {.error = fmt::format("{}: the graph '{}' cannot be written", source.path, name)};
        graphs.push_back({.name = name + ".graph.json", .text = json});
    }
    report_unread(import, document.root, "");
    const auto is_left_out = [](const Remark& each) { return each.kind == Remark::Kind::LeftOut; };
    import.has_refused |= std::ranges::any_of(import.remarks, is_left_out);
    std::ranges::stable_sort(import.remarks, {}, [](const Remark& each) { return std::pair(each.line, each.column); });
    made.graphs = std::move(graphs);
    made.remarks = std::move(import.remarks);
    made.has_refused = import.has_refused;
    return made;
}

}  // namespace

Importer mtlx_importer() {
    return {.name = "materialx",
            .reads = "MaterialX documents (.mtlx)",
            .example = "patina import wood.mtlx -o wood --report",
            .makes_pictures = false,
            .keeps_report = true,
            .recognises = recognises,
            .read = read};
}

}  // namespace patina::importers

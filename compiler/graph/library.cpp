#include "compiler/graph/library.h"

#include <algorithm>

#include "compiler/graph/json.h"
#include "compiler/graph/read_graph.h"
#include "compiler/nodelang/parse.h"

namespace patina::graph {
namespace {

void collect_variables(Library& library) {
    for (const nodelang::VariableDecl& v : library.ast.variables) {
        SemanticDecl semantic{.name = v.name, .variable = &v};
        semantic.is_vertex_output = v.attribute("vertex_output") != nullptr;
        if (v.attribute("attribute")) {
            semantic.source = Source::Attribute;
        } else if (v.attribute("builtin")) {
            semantic.source = Source::Builtin;
        } else if (v.attribute("given")) {
            semantic.source = Source::Given;
        } else if (v.attribute("extern") && v.attribute("semantic")) {
            semantic.source = Source::Extern;
        } else {
            continue;
        }
        library.semantics.push_back(semantic);
    }
}

void collect_recipes(Library& library) {
    for (const nodelang::FunctionDecl& f : library.ast.functions) {
        const nodelang::Attribute* attribute = f.attribute("semantic");
        if (!attribute) continue;
        const std::string_view rate = nodelang::attribute_text(*attribute);
        SemanticDecl semantic{.name = f.name, .function = &f};
        if (rate == "vertex") {
            semantic.source = Source::Vertex;
        } else if (rate == "pixel") {
            semantic.source = Source::Pixel;
        } else if (rate == "uniform") {
            semantic.source = Source::Uniform;
        } else {
            library.diagnostics.report(Code::BadAttribute, attribute->span, "semantic",
                                       "takes vertex, pixel or uniform");
            continue;
        }
        library.semantics.push_back(semantic);
    }
}

void collect_passes(Library& library) {
    for (const nodelang::FunctionDecl& f : library.ast.functions) {
        const nodelang::Attribute* attribute = f.attribute("pass");
        if (!attribute) continue;
        const std::string_view name = nodelang::attribute_text(*attribute);
        auto pass = std::find_if(library.passes.begin(), library.passes.end(),
                                 [&](const PassDecl& p) { return p.name == name; });
        if (pass == library.passes.end()) pass = library.passes.insert(pass, PassDecl{.name = name});
        (f.attribute("vertex") ? pass->vertex : pass->fragment) = &f;
    }
}

// Models go by their file's stem, as users name them: "unity-brdf1".
void add_graph(Library& library, std::uint32_t base, std::string_view path) {
    const std::size_t slash = path.rfind('/') + 1;
    auto& graphs = path.ends_with(".workflow.json") ? library.workflows : library.lighting_models;
    graphs.try_emplace(std::string(path.substr(slash, path.find('.', slash) - slash)), library.sources, base,
                       std::string(path));
}

}  // namespace

const std::shared_ptr<Graph>& LibraryGraph::get() const {
    std::call_once(once_, [this] {
        const std::unique_ptr<Json> json = parse_json(sources_, base_, diagnostics_);
        if (json) graph_ = read_graph(*json, path_, sources_, ast_, diagnostics_, {});
    });
    return graph_;
}

std::unique_ptr<Library> load_library(std::span<const nodelang::EmbeddedFile> files) {
    auto library = std::make_unique<Library>();
    std::vector<std::pair<std::uint32_t, std::string_view>> graphs;
    for (const nodelang::EmbeddedFile& file : files) {
        const std::uint32_t base = library->sources.add(std::string(file.path), std::string(file.text));
        if (file.path.ends_with(".json")) {
            graphs.emplace_back(base, file.path);
        } else {
            nodelang::parse_file({.text = library->sources.file_text(base), .base = base}, library->ast,
                                 library->diagnostics, nodelang::Bodies::WhenAsked);
        }
    }
    nodelang::index_declarations(library->ast, library->declarations, library->diagnostics);
    collect_variables(*library);
    collect_recipes(*library);
    collect_passes(*library);
    for (std::uint32_t i = 0; i < library->semantics.size(); ++i) {
        library->semantic_index.emplace(library->semantics[i].name, i);
    }
    for (const auto& [base, path] : graphs) add_graph(*library, base, path);
    return library;
}

}  // namespace patina::graph

#include "patina/export_mtlx.h"

#include <algorithm>

#include "compiler/api/compilation.h"
#include "compiler/api/compiler_impl.h"
#include "compiler/api/report.h"
#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/surface.h"
#include "compiler/seam/seam.h"

namespace patina {
namespace {

using namespace exporters::mtlx;

// The function that computes the graph's surface (lower/lower_surface.cpp).
const ir::Function* surface_of(const ir::Module& module) {
    for (const ir::Function& each : module.functions)
        if (each.name == "surface" && each.result.kind == ir::Kind::Struct && each.params.empty() &&
            module.structs[each.result.ref].name == "Surface")
            return &each;
    return nullptr;
}

std::string document(resolve::Session& session, Compilation& compilation, const std::string& folder) {
    lower::Lowered& lowered = compilation.lowered.front();
    const resolve::Material& material = *compilation.materials.front();
    const format::Graph& graph = *material.graph->graph;
    const ir::Function* const surface = surface_of(lowered.module);
    const auto function = surface ? flatten(lowered, *surface) : std::nullopt;
    if (!function) {
        session.diagnostics.report(Code::NoCounterpart, graph.span, "so long a graph");
        return {};
    }
    Names names;
    const std::string name = names.unique(graph.name);
    const std::string graph_name = names.unique("NG_" + name), shader_name = names.unique("SR_" + name);
    NodeWriter writer(session, material, lowered, *function, folder);
    SurfaceParts parts = write_surface(session, material, lowered.module, writer, graph_name, shader_name);

    Element root{.category = "materialx", .attributes = {{"version", "1.39"}, {"colorspace", "lin_rec709"}}};
    Element nodes = std::move(writer.graph());
    nodes.category = "nodegraph";
    nodes.attributes = {{"name", graph_name}};
    // The inputs, which stand first, are in the order of the properties.
    const auto place_of = [&](const Element& element) {
        std::size_t at = 0;
        if (element.category != "input") return material.properties.size();
        while (at < material.properties.size() &&
               material.properties[at].property->name != element.attributes[0].second)
            ++at;
        return at;
    };
    std::stable_sort(nodes.children.begin(), nodes.children.end(),
                     [&](const Element& a, const Element& b) { return place_of(a) < place_of(b); });
    for (Element& each : parts.outputs) nodes.children.push_back(std::move(each));
    if (!parts.outputs.empty()) root.children.push_back(std::move(nodes));
    root.children.push_back(std::move(parts.shader));
    Element shown{.category = "surfacematerial", .attributes = {{"name", name}, {"type", "material"}}};
    shown.children.push_back(
        {"input", {{"name", "surfaceshader"}, {"type", "surfaceshader"}, {"nodename", shader_name}}});
    root.children.push_back(std::move(shown));
    return write_document(root);
}

MtlxExport write(const Compiler& compiler, const std::string& path, const MtlxOptions& options, Trail& trail) {
    CompileOptions own;
    own.request = CompileOptions::Functions{"Mtlx"};  // no pass decides what the surface may read
    own.include_dirs = options.include_dirs;
    own.files = options.files;
    resolve::Session session(CompilerAccess::library(compiler), own);
    const TrailGuard guard(trail, session.diagnostics);
    MtlxExport made;
    Result result;
    ShortName pass;
    resolve::until_stopped(session, [&] {
        const std::optional<std::uint32_t> base = resolve::load_source(session, path, {});
        if (!base) return;
        Compilation compilation{.session = session, .source = *base, .path = path, .result = result, .pass = pass};
        if (accept(compilation) && read_material(compilation) && lower_material(compilation))
            made.text = document(session, compilation, options.folder);
    });
    made.diagnostics = to_public(session.diagnostics, session.sources);
    made.dependencies = std::move(session.dependencies);
    made.missing.assign(session.missing.begin(), session.missing.end());
    made.ok = !session.diagnostics.has_errors();
    if (!made.ok) made.text.clear();
    return made;
}

}  // namespace

MtlxExport export_mtlx(const Compiler& compiler, const std::string& path, const MtlxOptions& options) {
    return guarded<MtlxExport>(path, [&](Trail& trail) { return write(compiler, path, options, trail); });
}

}  // namespace patina

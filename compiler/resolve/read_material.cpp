// Reads a material: text -> Json -> Graph -> Material, with its extra passes.
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "compiler/resolve/material.h"
#include "compiler/resolve/smallest_material.h"

namespace patina::resolve {

MaterialFile read_material(Session& session, std::uint32_t base, const std::string& path) {
    const std::unique_ptr<json::Json> json = json::parse_json(session.sources, base, session.diagnostics);
    if (!json || must_stop(session)) return {};
    const bool any_kind = session.options.accept_parts;
    std::shared_ptr<format::Graph> graph =
        format::read_graph(*json, path, session.sources, session.ast, session.diagnostics,
                           any_kind ? std::nullopt : std::optional(format::GraphKind::Material));
    if (graph && any_kind) graph = material_around(session, std::move(graph));
    if (!graph) return {};
    choose_lighting(session, *graph);
    add_surface_choices(session, *graph);
    MaterialFile file{.material = resolve_material(session, std::move(graph), session.request.preview), .passes = {}};
    if (!file.material) return {};
    if (session.pass_file) {
        std::vector<std::string_view> inputs;
        if (const CheckedGraph* lighting = file.material->lighting) {
            for (const format::Input& input : lighting->graph->inputs) inputs.push_back(input.name);
        }
        const PassFile& passes = *session.pass_file;
        paths::check_members(passes.ast, passes.declarations, passes.paths, inputs, session.diagnostics);
    }
    file.passes = resolve_passes(session, *file.material);
    return file;
}

}  // namespace patina::resolve

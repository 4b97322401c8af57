// patina check of a scene: everything that rendering it would complain about, without drawing.
#include "compiler/cli/commands/commands.h"
#include "runtime/render/prepare_material.h"
#include "runtime/render/render_world.h"
#include "runtime/scene/world_file.h"

namespace patina::cli {

bool check_scene(const Console& console, const Compiler& compiler, const std::string& scene,
                 const CompileOptions& options, const MaterialCheck& check_material) {
    const runtime::WorldFile file = runtime::read_world(compiler, scene, options);
    report(console, file.diagnostics);
    if (!file.ok) return false;
    const runtime::RenderOptions how{
        .path = options.passes()->path, .switches = options.switches, .include_dirs = options.include_dirs};
    const runtime::RenderOutcome outcome = runtime::check_world(compiler, file.world, how);
    report(console, outcome.diagnostics);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    bool ok = outcome.ok;
    for (const runtime::WorldMaterial& material : file.world.materials) {
        if (!outcome.ok) break;
        CompileOptions wanted = runtime::compile_options(how);
        wanted.targets = {{"", "glsl"}};
        ok &= check_material(material.graph, runtime::compile_material(compiler, material, std::move(wanted)));
    }
    return ok;
}

}  // namespace patina::cli

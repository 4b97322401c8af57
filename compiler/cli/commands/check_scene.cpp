// patina check of a scene: everything that rendering it would complain about, without drawing.
#include "compiler/cli/commands/commands.h"
#include "runtime/render/render_world.h"
#include "runtime/scene/world_file.h"

namespace patina::cli {

bool check_scene(const Console& console, const Compiler& compiler, const std::string& scene,
                 const CompileOptions& options) {
    const runtime::WorldFile file = runtime::read_world(compiler, scene, options);
    report(console, file.diagnostics);
    if (!file.ok) return false;
    const runtime::RenderOutcome outcome = runtime::check_world(
        compiler, file.world,
        {.path = options.passes()->path, .switches = options.switches, .include_dirs = options.include_dirs});
    report(console, outcome.diagnostics);
    if (!outcome.error.empty()) complain(console, Complaint::CannotRender, {outcome.error});
    return outcome.ok;
}

}  // namespace patina::cli

// The subcommands, one function and one file each. `patina` holds those that touch no pictures; `render`, `snapshot`,
// `trace`, `import` and the `check` of scenes live in a second program, `patina-render`, which `patina` turns into when
// they are asked for: the image library that they load takes longer to start than a whole compilation.
#pragma once

#include "compiler/cli/program.h"

namespace patina::cli {

void add_compile(Program& program);
// How scenes are checked; false: something is wrong with one, and it is said.
using SceneCheck = bool (*)(const Console&, const Compiler&, const std::string& scene, const CompileOptions&);
void add_check(Program& program, SceneCheck check_scene);
bool check_scene(const Console& console, const Compiler& compiler, const std::string& scene,
                 const CompileOptions& options);
inline bool is_scene(std::string_view file) {
    return file.ends_with(".scene.json");
}
void add_new(Program& program);
void add_fmt(Program& program);
void add_eval(Program& program);
void add_nodes(Program& program);
void add_node(Program& program);
void add_models(Program& program);
void add_model(Program& program);
void add_paths(Program& program);
void add_docs(Program& program);
void add_schema(Program& program);

void add_render(Program& program);
void add_snapshot(Program& program);
void add_trace(Program& program);
void add_import(Program& program);

inline constexpr const char* kSummary =
    "Patina compiles material node graphs to readable GLSL and HLSL.\n"
    "Exit codes: 0 done, 1 the input is wrong, 2 the command line is wrong, 3 the machine lacks something.";
inline constexpr const char* kRenderSummary = "Render graphs and scenes to pictures";
inline constexpr const char* kSnapshotSummary = "Compare renders with reference pictures";
inline constexpr const char* kTraceSummary = "Show what every node is worth at one pixel";
inline constexpr const char* kImportSummary = "Make graphs of what was made elsewhere: measured materials";

}  // namespace patina::cli

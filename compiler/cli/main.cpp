// The `patina` command.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "compiler/cli/commands/commands.h"

namespace {

using namespace patina::cli;

// Turns into patina-render, which lies beside this program. Returns only if that fails.
int become_renderer(char** argv) {
    std::error_code failure;
    std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure) self = argv[0];
    const std::string renderer = (self.parent_path() / "patina-render").string();
    execv(renderer.c_str(), argv);
    complain(open_console(), "missing-program",
             "cannot start '" + renderer + "', which 'patina " + argv[1] + "' needs");
    return static_cast<int>(Exit::Machine);
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const bool has_scene = std::any_of(argv, argv + argc, [](const char* word) { return is_scene(word); });
    if (first == "check" && has_scene) return become_renderer(argv);
    if (first == "render" || first == "snapshot" || first == "trace" || first == "import") return become_renderer(argv);

    Program program(kSummary);
    add_compile(program);
    add_check(program, nullptr);  // scenes are the other program's
    program.app.add_subcommand("render", kRenderSummary);
    program.app.add_subcommand("trace", kTraceSummary);
    program.app.add_subcommand("snapshot", kSnapshotSummary);
    program.app.add_subcommand("import", kImportSummary);
    add_new(program);
    add_fmt(program);
    add_eval(program);
    add_nodes(program);
    add_node(program);
    add_models(program);
    add_model(program);
    add_paths(program);
    add_docs(program);
    add_schema(program);
    program.app.footer("'patina COMMAND --help' shows options and examples.");
    return run(program, argc, argv);
}

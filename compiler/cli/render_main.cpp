// The subcommands of `patina` that need Vulkan and OpenImageIO, and the check of scenes; `patina` becomes this program
// when they are asked for.
#include "compiler/cli/commands/commands.h"

int main(int argc, char** argv) {
    using namespace patina::cli;
    Program program(kSummary);
    add_render(program);
    add_check(program, check_scene);
    add_snapshot(program);
    add_trace(program);
    add_import(program);
    return run(program, argc, argv);
}

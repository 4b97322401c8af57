// patina-render: the commands that need Vulkan and OpenImageIO, and the check of scenes. `patina` turns into it.
#include "compiler/cli/commands/commands.h"

int main(int argc, char** argv) {
    using namespace patina::cli;
    Program program;
    program.check_scene = check_scene;
    add_check(program);
#define COMMAND(name, home, summary) \
    if constexpr (Home::home == Home::Render) add_##name(program);
#include "compiler/cli/commands/commands.def"
#undef COMMAND
    return run(program, argc, argv);
}

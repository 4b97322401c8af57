// patina-import: `patina import` and `patina env`, which read and write pictures. It loads OpenImageIO but not Vulkan.
// `patina` turns into it.
#include "compiler/cli/commands/commands.h"

int main(int argc, char** argv) {
    using namespace patina::cli;
    Program program;
    add_env(program);
    add_import(program);
    return run(program, argc, argv);
}

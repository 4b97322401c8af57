// patina-import: `patina import`, without pictures to write: OpenImageIO takes longer to load than most imports.
// `patina` turns into it.
#include "compiler/cli/commands/commands.h"

int main(int argc, char** argv) {
    using namespace patina::cli;
    return run(argc, argv, [](Program& program, int, char**) -> std::optional<Exit> {
        add_import(program);
        return {};
    });
}

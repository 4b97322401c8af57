// patina-render: the commands that need Vulkan and OpenImageIO, the check of scenes, pictures of `patina diff`, and
// imports that write pictures. `patina` turns into it.
#include "compiler/cli/commands/commands.h"
#include "compiler/cli/diff/report.h"
#include "runtime/picture/image.h"
#include "runtime/picture/picture_bounds.h"

namespace {

using namespace patina::cli;

std::optional<Exit> set_up(Program& program, int, char**) {
    program.check_scene = check_scene;
    program.compare_pictures = compare_pictures;
    program.encode_picture = patina::runtime::encode_image;
    program.limit_pixels = patina::runtime::limit_pixels;
    add_check(program);
    add_diff(program);
    add_import(program);
#define COMMAND(name, home, summary) \
    if constexpr (Home::home == Home::Render) add_##name(program);
#include "compiler/cli/commands/commands.def"
#undef COMMAND
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, set_up);
}

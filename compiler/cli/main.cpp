// The `patina` command. For some subcommands it turns into patina-import or patina-render; commands/commands.def says
// for which, and why.
#include <algorithm>
#include <filesystem>
#include <string_view>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/licences/licences.h"

namespace {

using namespace patina::cli;

// Scenes are checked by patina-render. A folder or a list may hold some.
bool may_name_scenes(std::string_view word) {
    std::error_code ignored;
    return is_scene(word) || word.starts_with("--files") || std::filesystem::is_directory(word, ignored);
}

bool asks_for_picture(std::string_view word) {
    return word.starts_with("--picture");
}

std::optional<Exit> set_up(Program& program, int argc, char** argv) {
    const std::string_view first = argc > 1 ? argv[1] : "";
    const CommandInfo* command = find_command(first);
    Home home = command ? command->home : Home::Patina;
    if (first == "check" && std::any_of(argv, argv + argc, may_name_scenes)) home = Home::Render;
    if (first == "diff" && std::any_of(argv, argv + argc, asks_for_picture)) home = Home::Render;
    if (home != Home::Patina) return turn_into(home, argv);
    add_licences_option(program);
    if (first == "--licences" || first == "--licenses") return {};  // 'fmt' is a library there, and no command
#define COMMAND(name, home, summary)                \
    if constexpr (Home::home == Home::Patina) {     \
        add_##name(program);                        \
    } else {                                        \
        program.app.add_subcommand(#name, summary); \
    }
#include "compiler/cli/commands/commands.def"
#undef COMMAND
    program.app.footer("'patina COMMAND --help' shows options and examples.");
    return {};
}

}  // namespace

int main(int argc, char** argv) {
    return run(argc, argv, set_up);
}

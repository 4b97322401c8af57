// patina engines: what shaders can be made for, and in which languages.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"

namespace patina::cli {
namespace {

// "glsl, hlsl; a file for each stage"
std::string summary(const EngineInfo& engine) {
    std::string text =
        fmt::format("{}; {}", fmt::join(engine.languages, ", "),
                    engine.is_one_file ? engine.file + ", one file a material" : "a file for each stage");
    if (engine.has_own_passes) text += fmt::format("; passes of its own, --path {}", fmt::join(engine.paths, " or "));
    return text;
}

// "-t glsl and -t hlsl", "-t unity"
std::string target_of(const EngineInfo& engine) {
    return engine.is_default ? fmt::format("-t {}", fmt::join(engine.languages, " or -t ")) : "-t " + engine.name;
}

Exit list_engines(const Console& console, bool json) {
    const Compiler compiler;
    if (json) {
        print(to_json(compiler.engines()));
        return Exit::Ok;
    }
    for (const EngineInfo& engine : compiler.engines()) {
        if (&engine != &compiler.engines().front()) print("\n");
        print(fmt::format("{}{}\n  {}\n  {}\n  compile with {}\n", heading(console, engine.name),
                          engine.is_default ? " (default)" : "", engine.doc, summary(engine), target_of(engine)));
    }
    return Exit::Ok;
}

}  // namespace

void add_engines(Program& program) {
    CLI::App& command = add_command(program, "engines", {"patina engines", "patina engines --json"});
    auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "Print everything about each engine as JSON");
    set_work(program, command, [json](const Console& console) { return list_engines(console, *json); });
}

}  // namespace patina::cli

// The room `cli/commands` holds a file for each subcommand of `patina`, and the list of all subcommands (commands.def).
// A command uses public headers only.
//
// To add one: write commands/NAME.cpp with add_NAME(), or render/NAME.cpp if it draws, and a row in commands.def. A
// command reads its options, calls the library, and prints or writes the result. The code that formats output is in
// ../pages; the computations of `patina eval` are in ../eval.
//
//   void add_schema(Program& program) {
//       CLI::App& command = add_command(program, "schema", {"patina schema > patina.schema.json"});
//       set_work(program, command, [](const Console& console) { ...; return Exit::Ok; });
//   }
#pragma once

#include "compiler/cli/program.h"

namespace patina::cli {

#define COMMAND(name, home, summary) void add_##name(Program& program);
#include "compiler/cli/commands/commands.def"
#undef COMMAND

// What patina-render makes Program::check_scene. The check of a scene draws nothing, but it loads meshes and pictures.
bool check_scene(const Console& console, const Compiler& compiler, const std::string& scene,
                 const CompileOptions& options, const MaterialCheck& check_material);

}  // namespace patina::cli

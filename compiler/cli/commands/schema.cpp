// patina schema: the JSON Schema of the graph format, with the nodes of the library, or of reflections.
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"

namespace patina::cli {

void add_schema(Program& program) {
    struct Arguments {
        std::string output;
        bool is_of_reflection = false;
    };
    CLI::App& command =
        add_command(program, "schema",
                    {"patina schema > patina.schema.json", "patina schema -o .vscode/patina.schema.json",
                     "patina schema --reflection -o reflection.schema.json"});
    auto arguments = std::make_shared<Arguments>();
    command.add_flag("--reflection", arguments->is_of_reflection,
                     "The schema of NAME.reflect.json, which compile writes, instead of that of graphs");
    command.add_option("-o,--output", arguments->output, "File to write; default, and -: print the schema")
        ->type_name("FILE");

    set_work(program, command, [arguments](const Console& console) {
        const std::string& output = arguments->output;
        std::string schema = arguments->is_of_reflection ? Reflection::schema() : Compiler().schema();
        if (!schema.ends_with('\n')) schema += '\n';
        if (output.empty()) {
            print(schema);
            return Exit::Ok;
        }
        OutputFiles files;
        files.add(output, std::move(schema));
        if (!Outputs(console).write("schema", files)) return Exit::Wrong;
        say(console, files);
        return Exit::Ok;
    });
}

}  // namespace patina::cli

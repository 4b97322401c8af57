// patina schema: the JSON Schema of the graph format, with the nodes of the library.
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/outputs.h"

namespace patina::cli {

void add_schema(Program& program) {
    CLI::App& command = add_command(
        program, "schema", {"patina schema > patina.schema.json", "patina schema -o .vscode/patina.schema.json"});
    auto output = std::make_shared<std::string>();
    command.add_option("-o,--output", *output, "File to write; default, and -: print the schema")->type_name("FILE");

    set_work(program, command, [output](const Console& console) {
        const Compiler compiler;
        std::string schema = compiler.schema();
        if (!schema.ends_with('\n')) schema += '\n';
        if (output->empty()) {
            print(schema);
            return Exit::Ok;
        }
        OutputFiles files;
        files.add(*output, std::move(schema));
        if (!Outputs(console).write("schema", files)) return Exit::Wrong;
        say(console, files);
        return Exit::Ok;
    });
}

}  // namespace patina::cli

// patina fmt: the canonical text of graphs.
#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/failures/failures.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> files;
    bool check = false;
};

Exit format_standard_input(const Console& console, const Compiler& compiler) {
    std::string error;
    std::optional<std::string> text = read_file("-", error);
    if (!text) {
        complain(console, Complaint::CannotRead, {"standard input", error});
        return Exit::Wrong;
    }
    const Compiler::Formatted formatted = compiler.format("<stdin>", std::move(*text));
    if (!formatted.ok) {
        report(console, formatted.diagnostics);
        return Exit::Wrong;
    }
    print(formatted.text);
    return Exit::Ok;
}

Exit format_file(const Console& console, const Compiler& compiler, const Arguments& arguments,
                 const std::string& path) {
    if (is_stream(path)) {
        complain(console, Complaint::NotAFile, {path});
        return Exit::Wrong;
    }
    std::string error;
    const std::optional<std::string> text = read_file(path, error);
    if (!text) {
        complain(console, Complaint::CannotRead, {path, error});
        return Exit::Wrong;
    }
    const Compiler::Formatted formatted = compiler.format(path, *text);
    report(console, formatted.diagnostics);
    if (!formatted.ok) return Exit::Wrong;
    if (formatted.text == *text) return Exit::Ok;
    if (arguments.check) {
        complain(console, Complaint::NotFormatted, {path});
        return Exit::Wrong;
    }
    OutputFiles files;
    files.add(path, formatted.text);
    if (!Outputs(console).write(path, files)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace

void add_fmt(Program& program) {
    CLI::App& command = add_command(program, "fmt",
                                    {"patina fmt art/*.json", "patina fmt --check art/*.json",
                                     "patina fmt - < rust.graph.json | diff rust.graph.json -"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("FILE", arguments->files, "Graphs; - reads standard input and prints the result")
        ->required()
        ->type_name(" ");
    add_root_option(command);
    command.add_flag("--check", arguments->check, "Change nothing; exit 1 if a file is not in canonical form");
    set_check(command, [arguments] {
        const bool standard_input = std::ranges::find(arguments->files, "-") != arguments->files.end();
        if (standard_input && (arguments->files.size() > 1 || arguments->check)) {
            throw CLI::ValidationError("FILE", "'-' cannot be combined with other files or with --check");
        }
    });

    set_work(program, command, [arguments](const Console& console) {
        const Compiler compiler;
        if (arguments->files.front() == "-") return format_standard_input(console, compiler);
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->files.size(); ++i) {
            show_progress(console, i, arguments->files.size(), arguments->files[i]);
            const std::string& file = arguments->files[i];
            exit =
                worse(exit, guarded(console, file, [&] { return format_file(console, compiler, *arguments, file); }));
        }
        return exit;
    });
}

}  // namespace patina::cli

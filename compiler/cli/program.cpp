#include "compiler/cli/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "compiler/base/disk/disk.h"
#include "compiler/base/letters.h"
#include "compiler/cli/failures/failures.h"
#include "patina/name_value.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

constexpr const char* kSummary =
    "Patina compiles material node graphs to readable GLSL and HLSL.\n"
    "Exit codes: 0 done, 1 the input is wrong, 2 the command line is wrong, 3 the machine lacks something (a GPU, a "
    "program, memory), 4 a bug in Patina: please report it.";

constexpr CommandInfo kCommands[] = {
#define COMMAND(name, home, summary) {#name, Home::home, summary},
#include "compiler/cli/commands/commands.def"
#undef COMMAND
};

// "; did you mean 'compile'?", or nothing.
std::string advice(const std::string& word, const std::vector<std::string>& known) {
    const std::string text = suggestion(word, known);
    return text.empty() ? text : "; " + text;
}

std::vector<std::string> command_names(CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

// What is wrong with the words that no option and no argument took. CLI11's own message has no suggestion.
std::string explain_extras(CLI::App& app, const CLI::App* command) {
    const std::vector<std::string> words = app.remaining(true);
    const std::string word = words.empty() ? std::string() : words.front();
    if (word.starts_with("-")) {
        const std::string name(split_name_value(word).name);
        return "unknown option '" + name + "'" + advice(name, option_names(command ? *command : app));
    }
    if (!command) return "there is no command '" + word + "'" + advice(word, command_names(app));
    return "unexpected argument '" + word + "'";
}

int complain_of_usage(const CLI::App* command, std::string_view message) {
    const std::string name = command ? "patina " + command->get_name() : "patina";
    std::fprintf(stderr, "%s: %.*s\ntry '%s --help'\n", name.c_str(), static_cast<int>(message.size()), message.data(),
                 name.c_str());
    return static_cast<int>(Exit::Usage);
}

}  // namespace

Exit turn_into(Home home, char** argv) {
    const std::string name = home == Home::Import ? "patina-import" : "patina-render";
    std::error_code failure;
    std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure) self = argv[0];
    execv((self.parent_path() / name).c_str(), argv);
    complain(open_console(), Complaint::MissingProgram, {name, argv[1]});
    return Exit::Machine;
}

const CommandInfo* find_command(std::string_view name) {
    const auto found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                    [&](const CommandInfo& command) { return command.name == name; });
    return found == std::end(kCommands) ? nullptr : found;
}

Program::Program() : app(kSummary, "patina"), console(open_console()) {
    app.set_version_flag("--version", "patina " + std::string(version()), "Print the version and exit");
    app.add_flag_callback(
        "--commands",
        [] {
            for (const CommandInfo& command : kCommands) print(std::string(command.name) + "\n");
            throw CLI::Success();
        },
        "Print the names of the commands, one a line, and exit");
    app.get_formatter()->column_width(32);
    app.get_formatter()->label("OPTIONS", "options");
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("REQUIRED", "");
    app.set_help_flag("-h,--help", "Print this help and exit");
}

CLI::App& add_command(Program& program, std::string name, const std::vector<std::string_view>& examples) {
    std::string summary(find_command(name)->summary);
    CLI::App& command = *program.app.add_subcommand(std::move(name), std::move(summary));
    std::string footer = "Examples:";
    for (std::string_view example : examples) footer += "\n  " + std::string(example);
    command.footer(footer);
    command.add_flag("-q,--quiet", program.console.quiet, "Print errors only")->group("Common");
    command
        .add_option_function<std::string>(
            "--diagnostics", [&program](const std::string& form) { program.console.json = form == "json"; },
            "Form of the messages: text on stderr, or json, one object a line on stdout")
        ->type_name("text|json")
        ->check(one_of("a form of diagnostics", {"text", "json"}))
        ->group("Common");
    return command;
}

void set_check(CLI::App& command, std::function<void()> check) {
    // An unknown option is reported as such, and not by what its words look like as arguments.
    command.parse_complete_callback([&command, check = std::move(check)] {
        if (command.remaining_size() == 0) check();
    });
}

void set_work(Program& program, CLI::App& command, std::function<Exit(const Console&)> work) {
    program.commands.push_back({&command, std::move(work)});
}

void add_include_option(CLI::App& command, std::vector<std::string>& folders) {
    command
        .add_option("-I,--include", folders,
                    "Also search this folder for sub-graphs, lighting graphs, nodes and textures")
        ->type_name("DIR")
        ->check(is_folder)
        ->allow_extra_args(false);
    add_root_option(command);
}

void add_root_option(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--root", confine_disk,
            "Read nothing outside of this folder, and write nothing through a link in it that leads outside: for "
            "untrusted graphs. The files of the command line must be in it, too")
        ->type_name("DIR")
        ->check(is_folder);
}

void add_pixels_option(Program& program, CLI::App& command) {
    command
        .add_option_function<std::size_t>(
            "--max-pixels",
            [&program](std::size_t most) {
                if (program.limit_pixels) program.limit_pixels(most);
            },
            "Refuse pictures of more pixels before they are decoded; default: 67108864, which is 8192 x 8192")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 28));
}

std::vector<std::pair<std::string, std::string>> PathOptions::switches() const {
    std::vector<std::pair<std::string, std::string>> made;
    for (const std::string& define : defines) {
        const auto [name, value] = split_name_value(define);
        made.emplace_back(name, value.value_or(""));
    }
    return made;
}

void add_path_options(CLI::App& command, PathOptions& options) {
    command
        .add_option(
            "--path", options.path,
            "Rendering path: a name ('patina paths' lists them) or a file of your own, x.pass.hlsl; default: forward")
        ->type_name("PATH");
    add_define_option(command, options.defines);
}

void add_define_option(CLI::App& command, std::vector<std::string>& defines) {
    command
        .add_option(
            "-D,--define", defines,
            "Turn on a part of the path (shadows, fog, ...), or set a variant or specialization constant of the graph: "
            "_WET, _Mode=Wet. -D and --set cannot give one name two values")
        ->type_name("NAME[=VALUE]")
        ->allow_extra_args(false)
        ->check([values = std::make_shared<std::map<std::string, std::string>>()](const std::string& define) {
            if (define.empty() || define.front() == '=' || define.back() == '=')
                return "'" + define + "' is not of the form NAME or NAME=VALUE";
            const auto [name, value] = split_name_value(define);
            return set_once(*values, std::string(name), std::string(value.value_or("")));
        });
}

std::string set_once(std::map<std::string, std::string>& values, const std::string& name, std::string value) {
    if (value.empty()) value = "true";
    const auto [there, is_new] = values.emplace(name, value);
    if (is_new || there->second == value) return {};
    return "'" + name + "' is '" + there->second + "' already, and cannot be '" + value + "' too";
}

CLI::Option* add_words_option(CLI::App& command, std::string name, std::vector<std::string>& words, std::string help,
                              std::function<std::string(std::string)> check) {
    const std::string long_name = name.substr(name.rfind("--"));
    const auto take = [&words, long_name, check = std::move(check)](const std::vector<std::string>& given) {
        words.clear();
        for (const std::string& text : given) {
            for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
                end = text.find(',', begin);
                words.push_back(text.substr(begin, end == text.npos ? end : end - begin));
                if (std::string error = check(words.back()); !error.empty())
                    throw CLI::ValidationError(long_name, error);
            }
        }
    };
    return command.add_option_function<std::vector<std::string>>(std::move(name), take, std::move(help))
        ->allow_extra_args(false);
}

std::function<std::string(std::string)> one_of(std::string what, std::vector<std::string> words) {
    return [what = std::move(what), words = std::move(words)](const std::string& word) -> std::string {
        for (const std::string& known : words) {
            if (word == known) return {};
        }
        return "'" + word + "' is not " + what + advice(word, words);
    };
}

std::function<std::string(std::string)> within(double low, double high) {
    return [low, high](const std::string& word) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(word, number) && number >= low && number <= high) return {};
        return fmt::format("'{}' is not a number from {} to {}", word, low, high);
    };
}

std::string is_folder(const std::string& word) {
    std::error_code ignored;
    return std::filesystem::is_directory(word, ignored) ? std::string() : "there is no folder '" + word + "'";
}

std::vector<EqualOutputs> find_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending,
                                             std::string_view verb) {
    std::vector<EqualOutputs> equal;
    std::map<std::string, std::size_t> seen;  // by name in lower case
    for (std::size_t i = 0; i < graphs.size(); ++i) {
        const std::string name = output_name(graphs[i]), file = name + std::string(ending);
        const auto [found, is_new] = seen.emplace(small_letters(name), i);
        if (is_new) continue;
        const std::string& other = graphs[found->second];
        const std::string other_name = output_name(other);
        const std::string both = other_name == name ? "would both write " + file
                                                    : "would write " + other_name + std::string(ending) + " and " +
                                                          file + ", which are one for some file systems";
        equal.push_back({.first = found->second,
                         .second = i,
                         .why = "'" + other + "' and '" + graphs[i] + "' " + both + ": " + std::string(verb) +
                                " them into different folders"});
    }
    return equal;
}

void refuse_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending, std::string_view verb) {
    const std::vector<EqualOutputs> equal = find_equal_outputs(graphs, ending, verb);
    if (!equal.empty()) throw CLI::ValidationError("GRAPH", equal.front().why);
}

namespace {

int run_command(Program& program, int argc, char** argv) {
    program.argv = argv;
    CLI::App& app = program.app;
    auto chosen = [&]() -> const CLI::App* {
        const std::vector<CLI::App*> parsed = app.get_subcommands();
        return parsed.empty() ? nullptr : parsed.front();
    };
    Exit exit = Exit::Usage;
    try {
        app.parse(argc, argv);
        for (const Program::Command& command : program.commands) {
            if (command.app == chosen()) exit = command.work(program.console);
        }
    } catch (const CLI::ExtrasError&) {
        return complain_of_usage(chosen(), explain_extras(app, chosen()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
        return complain_of_usage(chosen(), error.what());
    }
    if (!chosen()) {
        std::fputs(app.help().c_str(), stderr);
        return static_cast<int>(exit);
    }
    end_progress(program.console);
    exit = worse(exit, exit_of_reports());
    if (output_failed()) {
        std::fputs("patina: cannot write to standard output\n", stderr);
        exit = worse(exit, Exit::Wrong);
    }
    return static_cast<int>(exit);
}

// What has been printed comes before the message.
Exit end_with_message(const Console& console) noexcept {
    std::fflush(stdout);
    return report_exception(console);
}

}  // namespace

int run(int argc, char** argv, SetUp set_up) noexcept {
    try {
        Program program;
        try {
            if (const std::optional<Exit> exit = set_up(program, argc, argv)) return static_cast<int>(*exit);
            return run_command(program, argc, argv);
        } catch (...) {
            return static_cast<int>(end_with_message(program.console));
        }
    } catch (...) {
        return static_cast<int>(end_with_message(open_console()));
    }
}

}  // namespace patina::cli

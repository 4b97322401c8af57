#include "compiler/cli/program.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>

#include "compiler/base/text.h"
#include "compiler/cli/files.h"
#include "patina/name_value.h"

namespace patina::cli {
namespace {

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
    const std::vector<std::string_view> views(candidates.begin(), candidates.end());
    const std::string_view near = nearest(word, views);
    return near.empty() ? std::string() : "; did you mean '" + std::string(near) + "'?";
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

// The words that nothing took, in our words rather than CLI11's.
std::string explain_extras(CLI::App& app, const CLI::App* command) {
    const std::vector<std::string> words = app.remaining(true);
    const std::string word = words.empty() ? std::string() : words.front();
    if (word.starts_with("-")) {
        const std::string name(split_name_value(word).name);
        return "unknown option '" + name + "'" + suggestion(name, option_names(command ? *command : app));
    }
    if (!command) return "there is no command '" + word + "'" + suggestion(word, command_names(app));
    return "unexpected argument '" + word + "'";
}

int complain_of_usage(const CLI::App* command, std::string_view message) {
    const std::string name = command ? "patina " + command->get_name() : "patina";
    std::fprintf(stderr, "%s: %.*s\ntry '%s --help'\n", name.c_str(), static_cast<int>(message.size()), message.data(),
                 name.c_str());
    return static_cast<int>(Exit::Usage);
}

}  // namespace

Program::Program(std::string description) : app(std::move(description), "patina"), console(open_console()) {
    app.set_version_flag("--version", "patina " + std::string(version()), "Print the version and exit");
    app.get_formatter()->column_width(32);
    app.get_formatter()->label("OPTIONS", "options");
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("REQUIRED", "");
    app.set_help_flag("-h,--help", "Print this help and exit");
}

CLI::App& add_command(Program& program, std::string name, std::string summary,
                      std::initializer_list<std::string_view> examples) {
    CLI::App& command = *program.app.add_subcommand(std::move(name), std::move(summary));
    std::string footer = "Examples:";
    for (std::string_view example : examples) footer += "\n  " + std::string(example);
    command.footer(footer);
    command.add_flag("-q,--quiet", program.console.quiet, "Print errors only")->group("Common");
    command
        .add_option_function<std::string>(
            "--diagnostics", [&program](const std::string& form) { program.console.json = form == "json"; },
            "text on stderr, or json: one object a line on stdout")
        ->type_name("text|json")
        ->check(one_of("a form of diagnostics", {"text", "json"}))
        ->group("Common");
    return command;
}

void set_work(Program& program, CLI::App& command, std::function<Exit(const Console&)> work) {
    program.commands.push_back({&command, std::move(work)});
}

void add_include_option(CLI::App& command, std::vector<std::string>& folders) {
    command.add_option("-I,--include", folders, "Look here too for sub-graphs, lighting graphs, nodes and textures")
        ->type_name("DIR")
        ->allow_extra_args(false);
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
            "Rendering path: forward, forward-add, vertex, deferred, ... ('patina paths' lists them), or a file "
            "of your own, x.pass.hlsl (forward)")
        ->type_name("PATH");
    add_define_option(command, options.defines);
}

void add_define_option(CLI::App& command, std::vector<std::string>& defines) {
    command
        .add_option(
            "-D,--define", defines,
            "Turn a part of the path on (shadows, fog, ...), or give a variant or specialization constant of the "
            "graph a value: _WET, _Mode=Wet; a name has one value, here and in --set")
        ->type_name("NAME[=VALUE]")
        ->allow_extra_args(false)
        ->check([said = std::make_shared<std::map<std::string, std::string>>()](const std::string& define) {
            if (define.empty() || define.front() == '=' || define.back() == '=')
                return "'" + define + "' is not of the form NAME or NAME=VALUE";
            const auto [name, value] = split_name_value(define);
            return say_once(*said, std::string(name), std::string(value.value_or("")));
        });
}

std::string say_once(std::map<std::string, std::string>& values, const std::string& name, std::string value) {
    if (value.empty()) value = "true";
    const auto [said, is_new] = values.emplace(name, value);
    if (is_new || said->second == value) return {};
    return "'" + name + "' is '" + said->second + "' already, and cannot be '" + value + "' too";
}

CLI::Option* add_words_option(CLI::App& command, std::string name, std::vector<std::string>& words, std::string help,
                              std::function<std::string(std::string)> check) {
    const std::string told = name.substr(name.rfind("--"));
    const auto take = [&words, told, check = std::move(check)](const std::vector<std::string>& given) {
        words.clear();
        for (const std::string& text : given) {
            for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
                end = text.find(',', begin);
                words.push_back(text.substr(begin, end == text.npos ? end : end - begin));
                if (std::string error = check(words.back()); !error.empty()) throw CLI::ValidationError(told, error);
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
        const std::vector<std::string_view> views(words.begin(), words.end());
        std::string message = "'" + word + "' is not " + what;
        const std::string hint = suggestion(word, words);
        return message + (hint.empty() ? ": use one of " + enumerate(views) : hint);
    };
}

void refuse_equal_outputs(const std::vector<std::string>& graphs, std::string_view ending, std::string_view verb) {
    std::map<std::string, std::string> seen;  // by names for which case does not count
    for (const std::string& graph : graphs) {
        const std::string name = stem(graph), file = name + std::string(ending);
        std::string folded = name;
        std::ranges::transform(folded, folded.begin(), [](unsigned char c) { return std::tolower(c); });
        const auto [found, is_new] = seen.emplace(folded, graph);
        if (is_new) continue;
        const std::string& other = found->second;
        const std::string both = stem(other) == name ? "would both write " + file
                                                     : "would write " + stem(other) + std::string(ending) + " and " +
                                                           file + ", which are one for some file systems";
        throw CLI::ValidationError("GRAPH", "'" + other + "' and '" + graph + "' " + both + ": " + std::string(verb) +
                                                " them into different folders");
    }
}

int run(Program& program, int argc, char** argv) {
    CLI::App& app = program.app;
    auto chosen = [&]() -> const CLI::App* {
        const std::vector<CLI::App*> parsed = app.get_subcommands();
        return parsed.empty() ? nullptr : parsed.front();
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        return complain_of_usage(chosen(), explain_extras(app, chosen()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
        return complain_of_usage(chosen(), error.what());
    }
    for (const Program::Command& command : program.commands) {
        if (command.app != chosen()) continue;
        Exit exit = command.work(program.console);
        end_progress(program.console);
        if (output_failed()) {
            std::fputs("patina: cannot write to standard output\n", stderr);
            exit = worse(exit, Exit::Wrong);
        }
        return static_cast<int>(exit);
    }
    std::fputs(app.help().c_str(), stderr);
    return static_cast<int>(Exit::Usage);
}

}  // namespace patina::cli

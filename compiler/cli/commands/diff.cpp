// patina diff: what changed in meaning between two versions of a graph or a scene, also as git's external diff.
#include <algorithm>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/diff/report.h"
#include "compiler/cli/files.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

struct Arguments {
    std::vector<std::string> files;
    std::string name, target = "glsl";
    bool git = false, json = false, without_shaders = false;
    PictureWish picture;
    PathOptions path;
    std::vector<std::string> include_dirs;
};

constexpr Exit kDifferent = Exit::Wrong;
constexpr Exit kTrouble = Exit::Usage;

// Git's arguments: path old-file old-hex old-mode new-file new-hex new-mode, and for a renamed file the other name and
// a line about it. Of a file with conflicts: the path alone.
constexpr std::size_t kGitWords = 7, kGitWordsOfRename = 9;

struct Both {
    Version before, after;                // their paths: for the files that they name
    std::string before_name, after_name;  // for messages
};

bool read_both(const Console& console, const Arguments& arguments, Both& both) {
    const bool git = arguments.git;
    const std::string& name = git ? arguments.files[0] : arguments.name;
    const std::string old_file = arguments.files[git ? 1 : 0], new_file = arguments.files[git ? 4 : 1];
    const std::string new_name = arguments.files.size() == kGitWordsOfRename ? arguments.files[7] : name;
    const auto read = [&](const std::string& file, const std::string& path, Version& version) {
        std::string error;
        // This is how git names the side that has no file.
        std::optional<std::string> text = git && file == "/dev/null" ? std::string() : read_file(file, error);
        if (!text) {
            complain(console, Complaint::CannotRead, {file, error});
            return false;
        }
        version = {.path = path.empty() ? file : path, .text = std::move(*text)};
        return true;
    };
    if (!read(old_file, name, both.before) || !read(new_file, new_name, both.after)) return false;
    both.before_name = name.empty() ? old_file : name + " (before)";
    both.after_name = name.empty() ? new_file : new_name + " (after)";
    return true;
}

CompileOptions options_of(const Arguments& arguments, const Compiler& compiler) {
    CompileOptions options;
    options.targets = compiler.targets(arguments.target);
    options.include_dirs = arguments.include_dirs;
    options.request = CompileOptions::Passes{.path = arguments.path.path};
    options.switches = arguments.path.switches();
    return options;
}

// A file that is no graph still has lines that changed.
Exit show_lines(const Both& both) {
    std::string text = both.before_name + " -> " + both.after_name + "\n";
    for (const DiffLine& line : differences(both.before.text, both.after.text)) {
        const bool is_gap = line.kind == DiffLine::Kind::Gap;
        text += is_gap ? std::string("...") : std::string(1, " -+"[static_cast<int>(line.kind)]) + line.text;
        text += '\n';
    }
    print(text);
    return Exit::Ok;
}

Exit compare(const Console& console, const Arguments& arguments, PictureComparison compare_pictures) {
    if (arguments.git && arguments.files.size() == 1) {
        print(arguments.files.front() + ": has conflicts\n");
        return Exit::Ok;
    }
    Both both;
    if (!read_both(console, arguments, both)) return kTrouble;
    DiffReport found{.before = both.before_name, .after = both.after_name};
    found.same_text = both.before.text == both.after.text;
    found.graph = diff_graphs({both.before_name, both.before.text}, {both.after_name, both.after.text});
    report(console, found.graph.diagnostics);
    if (!found.graph.ok) return arguments.git ? show_lines(both) : kTrouble;

    const bool is_there = !both.before.text.empty() && !both.after.text.empty();
    bool trouble = false;
    if (is_there && !arguments.without_shaders && !is_scene(both.after.path)) {
        const Compiler compiler;
        std::vector<Diagnostic> diagnostics;
        trouble =
            !add_shader_changes(compiler, both.before, both.after, options_of(arguments, compiler), found, diagnostics);
        report(console, diagnostics);
    }
    if (is_there && !trouble && !arguments.picture.output.empty()) {  // else it would report the same errors
        found.picture = compare_pictures(console, both.before, both.after, arguments.picture);
        trouble |= !found.picture;
    }
    print(arguments.json ? report_json(found) : report_text(found, console.output_colors));
    trouble |= output_failed();
    if (arguments.git) return Exit::Ok;  // git takes any other code as a failure
    return trouble ? kTrouble : found.differs() ? kDifferent : Exit::Ok;
}

void check_arguments(const Arguments& arguments) {
    const std::size_t count = arguments.files.size();
    if (arguments.git) {
        if (count != 1 && count != kGitWords && count != kGitWordsOfRename)
            throw CLI::ValidationError("--git", "git gives 1, 7 or 9 words, not " + std::to_string(count));
    } else if (count != 2) {
        throw CLI::ValidationError("FILE", "name two files, not " + std::to_string(count));
    }
    if (arguments.git && !arguments.name.empty())
        throw CLI::ValidationError("--name", "with --git, the name comes from git");
}

}  // namespace

void add_diff(Program& program) {
    CLI::App& command = add_command(program, "diff",
                                    {"patina diff old.graph.json rust.graph.json",
                                     "patina diff old.graph.json rust.graph.json --picture change.png",
                                     "patina diff old.graph.json rust.graph.json --json",
                                     "git show HEAD:rust.graph.json | patina diff - rust.graph.json",
                                     "GIT_EXTERNAL_DIFF='patina diff --git' git diff rust.graph.json",
                                     "git difftool -x 'patina diff --name \"$MERGED\"' rust.graph.json",
                                     "Exit codes: 0 nothing changed in meaning, 1 something did, 2 trouble"});
    add_pixels_option(program, command);
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("FILE", arguments->files,
                    "Two versions of a graph or a scene; an empty file: there was none; -: standard input")
        ->required()
        ->type_name(" ");
    command
        .add_option("--name", arguments->name,
                    "Both files are versions of this one: files that they name are searched from there")
        ->type_name("PATH");
    command.add_flag("--git", arguments->git,
                     "The words are those of GIT_EXTERNAL_DIFF; exit 0 also if something changed");
    command.add_flag("--json", arguments->json, "Print the changes as JSON");
    command.add_flag("--no-shaders", arguments->without_shaders, "Do not compile the two and compare their shaders");
    command.add_option("-t,--target", arguments->target, "Compare the shaders of this target; default: glsl")
        ->type_name("TARGET")
        ->check([](const std::string& word) {
            return Compiler().targets(word).empty() ? "'" + word + "' is not a target" : std::string();
        });
    command
        .add_option("--picture", arguments->picture.output,
                    "Draw both, and write a picture of them and of their difference")
        ->type_name("FILE.png");
    command.add_option("--size", arguments->picture.size, "Of the picture: pixels of each side; default: 256")
        ->type_name("N")
        ->check(CLI::Range(1, 2048));
    add_path_options(command, arguments->path);
    add_include_option(command, arguments->include_dirs);
    set_check(command, [arguments] { check_arguments(*arguments); });
    set_work(program, command, [arguments, compare_pictures = program.compare_pictures](const Console& console) {
        CompileOptions& options = arguments->picture.options;
        options.request = CompileOptions::Passes{.path = arguments->path.path};
        options.switches = arguments->path.switches();
        options.include_dirs = arguments->include_dirs;
        return compare(console, *arguments, compare_pictures);
    });
}

}  // namespace patina::cli

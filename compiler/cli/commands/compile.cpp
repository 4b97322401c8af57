// patina compile: turns graphs into shader files and their reflection.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/compile/compiled.h"
#include "compiler/cli/compile/depfile.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "patina/output_name.h"

namespace patina::cli {
namespace {

// Which graph has made the shader that an engine lists under a name.
using ShaderNames = std::map<std::string, std::string, std::less<>>;

// In an engine's list of shaders, two of one name are one. False if there are such, which has been reported.
bool has_own_names(const Console& console, const std::string& graph, std::span<const Shader> shaders,
                   ShaderNames& shader_names) {
    for (const Shader& shader : shaders) {
        if (shader.listed_as.empty()) continue;
        const auto [found, is_new] = shader_names.emplace(shader.listed_as, graph);
        if (is_new || found->second == graph) continue;
        complain(console, Complaint::TakenName, {found->second, graph, shader.listed_as});
        return false;
    }
    return true;
}

// What the graphs of one command share.
struct Run {
    const Console& console;
    const CompileArguments& arguments;
    const Compiler& compiler;
    Outputs outputs{console};
    ShaderNames shader_names{};
    std::vector<std::string> written{};               // the paths of all outputs
    std::set<std::string> dependencies{}, missing{};  // of all graphs
};

std::vector<std::string> listed(const std::set<std::string>& paths) {
    return {paths.begin(), paths.end()};
}

// Adds the file that says when `target` is to be made again. False: it cannot, which has been reported.
bool add_depfile(Run& run, OutputFiles& files, const std::string& path, const std::string& target,
                 std::span<const std::string> dependencies) {
    runtime::Outcome<std::string> rule = make_rule(target, dependencies);
    if (!rule) {
        complain(run.console, Complaint::CannotWrite, {rule.error});
        return false;
    }
    files.add(path, std::move(rule.value));
    return true;
}

Exit write(Run& run, const Input& input, const std::string& target, const FilesRead& read, OutputFiles files) {
    if (run.arguments.depfile && run.arguments.output_list.empty()) {
        const std::string folder = folder_of(run.arguments, input);
        std::vector<std::string> dependencies = read.dependencies;
        std::ranges::move(folders_to_watch(read.missing, {}, {&folder, 1}), std::back_inserter(dependencies));
        const std::string name = output_name(input.path) + run.arguments.kind + ".d";
        if (!add_depfile(run, files, join_path(folder, name), target, dependencies)) return Exit::Wrong;
    }
    if (!run.outputs.write(input.path, files, read.dependencies)) return Exit::Wrong;
    for (const runtime::OutputFile& file : files.files) run.written.push_back(file.path);
    run.dependencies.insert(read.dependencies.begin(), read.dependencies.end());
    run.missing.insert(read.missing.begin(), read.missing.end());
    say(run.console, files);
    return Exit::Ok;
}

Exit compile_variants(Run& run, const Input& input) {
    const CompileArguments& arguments = run.arguments;
    OutputFiles files;
    FilesRead read;
    const std::string folder = folder_of(arguments, input);
    const Exit exit = make_variants(
        run.console, run.compiler, input.path, arguments.variants, options_of(arguments), folder,
        [&](const Shader& shader, OutputFiles& made) {
            std::vector<Diagnostic> diagnostics;
            const bool ok = add_shader(arguments, folder, shader, made, diagnostics);
            report(run.console, diagnostics);
            return ok && has_own_names(run.console, input.path, std::span(&shader, 1), run.shader_names);
        },
        files, read);
    if (exit != Exit::Ok) return exit;
    const std::string manifest = files.files.back().path;
    return write(run, input, manifest, read, std::move(files));
}

Exit finish(Run& run, const Input& input, Compiled& made) {
    report(run.console, made.result.diagnostics);
    for (const Dump& dump : made.result.dumps)
        print("// " + input.path + ": " + dump.stage + "\n" + dump.text + (dump.text.ends_with('\n') ? "" : "\n"));
    if (!made.ok || !has_own_names(run.console, input.path, made.result.shaders, run.shader_names)) return Exit::Wrong;
    if (!run.arguments.writes()) return Exit::Ok;
    const FilesRead read{.dependencies = std::move(made.result.dependencies),
                         .missing = std::move(made.result.missing)};
    return write(run, input, made.reflection, read, std::move(made.files));
}

// The dependencies of the list of all outputs: the files that were read, a list of graphs, and the folders in which a
// graph or another file may appear. If a build asks for it, also the outputs: the list is younger than they are.
std::vector<std::string> dependencies_of_list(Run& run, const Inputs& inputs) {
    const InputArguments& arguments = run.arguments.inputs;
    std::set<std::string> all = run.dependencies;
    if (!arguments.list.empty() && arguments.list != "-") all.insert(arguments.list);
    std::set<std::string> written = {std::filesystem::path(run.arguments.output_list).parent_path().string()};
    for (const Input& input : inputs.files) written.insert(folder_of(run.arguments, input));
    std::ranges::move(folders_to_watch(listed(run.missing), inputs.folders, listed(written)),
                      std::inserter(all, all.end()));
    if (run.arguments.depends_on_outputs)
        std::ranges::copy_if(run.written, std::inserter(all, all.end()),
                             [](const std::string& path) { return !is_stream(path); });
    return listed(all);
}

Exit write_list(Run& run, const Inputs& inputs) {
    const std::string& path = run.arguments.output_list;
    OutputFiles list;
    std::string text;
    for (const std::string& file : run.written) text += file + "\n";
    list.files.push_back({.path = path, .bytes = std::move(text), .is_stamp = true});
    if (run.arguments.depfile && !add_depfile(run, list, path + ".d", path, dependencies_of_list(run, inputs)))
        return Exit::Wrong;
    std::vector<std::string> graphs;
    for (const Input& input : inputs.files) graphs.push_back(input.path);
    return run.outputs.write(path, list, graphs) ? Exit::Ok : Exit::Wrong;
}

Exit compile_all(Run& run, Inputs& inputs) {
    const CompileArguments& arguments = run.arguments;
    Exit exit = worse(inputs.exit, take_out_equal_outputs(run.console, inputs.files, ".*", "compile"));
    if (arguments.variants.wanted.empty()) {
        exit = worse(exit, work_on(
                               run.console, inputs.files, arguments.inputs.jobs,
                               [&](const Input& input) { return compile_graph(arguments, run.compiler, input); },
                               [&](const Input& input, Compiled& made) { return finish(run, input, made); }));
    } else {
        for (const Input& input : inputs.files) exit = worse(exit, compile_variants(run, input));
    }
    return exit != Exit::Ok || arguments.output_list.empty() ? exit : write_list(run, inputs);
}

}  // namespace

void add_compile(Program& program) {
    CLI::App& command = add_command(
        program, "compile",
        {"patina compile rust.graph.json -o out", "patina compile *.graph.json -t glsl --validate -o out",
         "patina compile art -o out --jobs 4 --list-outputs out/all.txt   # out has the folders of art",
         "git ls-files -z '*.graph.json' | patina compile --files - -o out",
         "patina compile rust.graph.json -t spirv -o out --depfile",
         "patina compile upload/rust.graph.json --root upload -o out   # an untrusted graph reads nothing else",
         "patina compile art -o out --list-outputs out/all.txt --depfile --depend-on-outputs   # a step of a build",
         "patina compile rust.graph.json -t unity -o Assets/Shaders   # 'patina engines' lists what there is",
         "patina compile rust.graph.json --path deferred -D shadows -o out",
         "patina compile rust.graph.json -D _Mode=Wet -o out", "patina compile rust.graph.json --variants all -o out",
         "patina compile rust.graph.json --functions Rust_ -o out", "patina compile rust.graph.json --dump tidy"});
    auto arguments = std::make_shared<CompileArguments>();
    add_input_options(command, arguments->inputs, "Material graphs (JSON)");
    add_target_options(command, *arguments);
    command.add_flag("--validate", arguments->validate, "Check the shaders with glslang and spirv-val");
    CLI::Option* cost =
        command.add_flag("--cost", arguments->cost, "Measure what each pass costs, and add it to the reflection");
    CLI::Option* depfile = command.add_flag(
        "--depfile", arguments->depfile,
        "Write the files from which the outputs were made, for make and ninja: NAME.d next to NAME.reflect.json, or "
        "with --list-outputs FILE one list for all, FILE.d. It also names folders in which a file may appear");
    CLI::Option* list =
        command.add_option("--list-outputs", arguments->output_list,
                           "At the end, write the paths of all outputs to this file, one a line. Outputs that did not "
                           "change keep their time; this file always gets a new one");
    list->type_name("FILE");
    command
        .add_flag("--depend-on-outputs", arguments->depends_on_outputs,
                  "In FILE.d, also name the outputs, so that a build makes an output again that was deleted or edited; "
                  "a rule for Ninja needs 'restat = 1'")
        ->needs(depfile)
        ->needs(list);
    add_words_option(command, "--dump", arguments->dump,
                     "Print the result of a step: graph, ir, linked, tidy, rates; files are written only with -o",
                     one_of("a step", {"graph", "ir", "linked", "tidy", "rates"}))
        ->type_name("STEP");
    add_path_options(command, arguments->path);
    CLI::Option* variants =
        command
            .add_option("--variants", arguments->variants.wanted,
                        "Compile the graph's variants. all: every combination; listed: the combinations under "
                        "\"variants\"; reachable: without choices that change nothing. Equal shaders are written once; "
                        "NAME.variants.json lists the shaders of each combination")
            ->type_name("all|listed|reachable")
            ->check(one_of("a choice of variants", {"all", "listed", "reachable"}));
    command
        .add_option("--variants-limit", arguments->variants.limit,
                    fmt::format("Refuse a graph with more combinations; default: {}", kVariantLimit))
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, kMostVariants))
        ->needs(variants);
    CLI::Option* functions =
        command
            .add_option("--functions", arguments->functions,
                        "Write functions for shaders of your own instead of whole shaders; every name in them begins "
                        "with PREFIX")
            ->type_name("PREFIX")
            ->check([](const std::string& prefix) { return prefix.empty() ? "it needs a prefix" : ""; });
    functions->excludes(command.get_option("--path"));
    functions->excludes(variants);
    cost->excludes(functions)->excludes(variants);
    variants->excludes(command.get_option("--dump"));
    add_include_option(command, arguments->include_dirs);
    set_check(command, [arguments] { require_inputs(arguments->inputs); });

    set_work(program, command, [arguments](const Console& console) {
        if (is_mixed(console, !arguments->dump.empty(), "--dump")) return Exit::Usage;
        if (!arguments->functions.empty() && arguments->wants("spirv")) {
            complain(console, Complaint::FunctionsAsSpirv, {});
            return Exit::Usage;
        }
        Inputs inputs = find_inputs(console, arguments->inputs, {".graph.json"});
        const Compiler compiler;
        if (const std::string why = settle(*arguments, compiler); !why.empty()) {
            complain(console, Complaint::Usage, {why});
            return Exit::Usage;
        }
        Run run{console, *arguments, compiler};
        return compile_all(run, inputs);
    });
}

}  // namespace patina::cli

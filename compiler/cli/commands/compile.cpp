// patina compile: turns graphs into shader files and their reflection.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/commands/compile_variants.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "patina/output_name.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

constexpr std::string_view kSpirv = "spirv";

struct Arguments {
    std::vector<std::string> graphs;
    std::vector<std::string> targets = {"glsl", "hlsl"};
    std::vector<std::string> include_dirs;
    std::vector<std::string> dump;
    std::string folder;
    PathOptions path;
    std::string functions;
    VariantOptions variants;
    bool validate = false;
    bool depfile = false;

    bool wants(std::string_view target) const { return std::ranges::find(targets, target) != targets.end(); }
    // Whose files are written. SPIR-V is made from GLSL, which may not be among them.
    std::vector<Target> written;
    // What tells the reflection of this kind of output from those of others: "", ".deferred", ".functions".
    std::string kind;
    // --dump alone is for looking, not for writing.
    bool writes() const { return dump.empty() || !folder.empty(); }
};

bool contains(const std::vector<Target>& targets, const Target& target) {
    return std::find(targets.begin(), targets.end(), target) != targets.end();
}

// Reads the words of -t. Throws the usage error if there is no such target.
void read_targets(Arguments& arguments, const Compiler& compiler) {
    std::vector<std::string> known;
    for (const EngineInfo& engine : compiler.engines()) {
        if (engine.is_default) known.insert(known.begin(), engine.languages.begin(), engine.languages.end());
        known.push_back(engine.name);
    }
    known.emplace_back(kSpirv);
    for (const std::string& word : arguments.targets) {
        if (const std::string wrong = one_of("a target", known)(word); !wrong.empty())
            throw CLI::ValidationError("--target", wrong);
    }
    // In the order of the engines and their languages, whatever the order of the words.
    for (const EngineInfo& engine : compiler.engines()) {
        for (const Target& target : compiler.targets(engine.name)) {
            const std::string_view word = engine.is_default ? target.language : engine.name;
            if (arguments.wants(word) || arguments.wants(engine.name)) arguments.written.push_back(target);
        }
    }
}

CompileOptions options_of(const Arguments& arguments) {
    CompileOptions options;
    options.targets = arguments.written;
    if (arguments.wants(kSpirv) && !contains(options.targets, Target::Glsl))
        options.targets.insert(options.targets.begin(), Target::Glsl);
    options.include_dirs = arguments.include_dirs;
    options.dump = arguments.dump;
    options.path = arguments.path.path;
    options.switches = arguments.path.switches();
    options.functions = arguments.functions;
    return options;
}

// "deferred", "./mine.pass.hlsl" -> "deferred", "mine"
std::string name_of_path(const std::string& path) {
    std::string name = std::filesystem::path(path).filename().string();
    if (const std::string_view ending = ".pass.hlsl"; name.ends_with(ending)) name.resize(name.size() - ending.size());
    return name;
}

// True if the engine draws the path: by the library's passes, or by its own.
bool has_path_of(const EngineInfo& engine, const std::string& path) {
    return !engine.has_own_passes || std::ranges::find(engine.paths, path) != engine.paths.end();
}

// What the names of the reflection, its dependency file and its manifest hold besides the graph: nothing for the
// default engine and path.
std::string kind_of(const Arguments& arguments, const Compiler& compiler) {
    // The reflection is that of the first engine that draws the library's paths, if there is one.
    const auto is_wanted = [&](const EngineInfo& engine) {
        const auto is_its_target = [&](const Target& target) {
            return engine.is_default ? target.engine.empty() : target.engine == engine.name;
        };
        return std::ranges::any_of(options_of(arguments).targets, is_its_target);
    };
    const EngineInfo* described = nullptr;
    for (const EngineInfo& engine : compiler.engines()) {
        if (!is_wanted(engine)) continue;
        if (!described || (described->has_own_passes && !engine.has_own_passes)) described = &engine;
    }
    std::string kind;
    if (described && !described->is_default) kind += "." + described->name;
    if (!arguments.functions.empty()) return kind + ".functions";
    const bool has_path = !described || has_path_of(*described, arguments.path.path);
    if (has_path && arguments.path.path != PathOptions{}.path) kind += "." + name_of_path(arguments.path.path);
    return kind;
}

// What was asked for and a wanted engine's files do not have; empty: nothing.
std::string not_for_engine(const Arguments& arguments, const Compiler& compiler) {
    for (const EngineInfo& engine : compiler.engines()) {
        if (!arguments.wants(engine.name)) continue;
        if (engine.is_one_file && !arguments.functions.empty())
            return fmt::format("--functions cannot be written for {}, whose file holds whole passes", engine.title);
        if (engine.is_one_file && arguments.validate)
            return fmt::format("--validate cannot check a file of {}: remove it from --target, or leave out --validate",
                               engine.title);
        if (arguments.targets.size() > 1) continue;
        if (!has_path_of(engine, arguments.path.path))
            return fmt::format("{} has passes of its own: --path can be {}, but not '{}'", engine.title,
                               fmt::join(engine.paths, " or "), arguments.path.path);
    }
    return {};
}

std::string as_bytes(const std::vector<std::uint32_t>& words) {
    return std::string(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t));
}

// "rust.forward.vert.glsl" -> "rust.forward.vert.spv"
std::string spirv_name(const Shader& shader) {
    return shader.file_name.substr(0, shader.file_name.rfind('.')) + ".spv";
}

// Adds the shader's files. False: glslang or spirv-val refuses it, and that has been reported.
bool add_shader(const Console& console, const Arguments& arguments, const Shader& shader, OutputFiles& files) {
    if (contains(arguments.written, shader.target)) {
        files.add(join_path(arguments.folder, shader.file_name), shader.text);
    }
    const bool wants_spirv = arguments.wants(kSpirv) && shader.target == Target::Glsl;
    const bool is_stage = shader.has_main || !arguments.functions.empty();
    if ((!arguments.validate && !wants_spirv) || !is_stage) return true;
    const Validated validated = validate(shader);
    report(console, validated.diagnostics);
    if (wants_spirv) files.add(join_path(arguments.folder, spirv_name(shader)), as_bytes(validated.spirv));
    return validated.ok;
}

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
    const Arguments& arguments;
    const Compiler& compiler;
    Outputs outputs{console};
    ShaderNames shader_names{};
};

Exit write(Run& run, const std::string& graph, const std::string& target, std::span<const std::string> dependencies,
           OutputFiles files) {
    if (run.arguments.depfile) {
        const std::string name = output_name(graph) + run.arguments.kind + ".d";
        files.add(join_path(run.arguments.folder, name), make_rule(target, dependencies));
    }
    if (!run.outputs.write(graph, files, dependencies)) return Exit::Wrong;
    say(run.console, files);
    return Exit::Ok;
}

Exit compile_variants(Run& run, const std::string& graph) {
    const Arguments& arguments = run.arguments;
    OutputFiles files;
    std::vector<std::string> dependencies;
    const Exit exit = make_variants(
        run.console, run.compiler, graph, arguments.variants, options_of(arguments), arguments.folder,
        [&](const Shader& shader, OutputFiles& made) {
            return add_shader(run.console, arguments, shader, made) &&
                   has_own_names(run.console, graph, std::span(&shader, 1), run.shader_names);
        },
        files, dependencies);
    if (exit != Exit::Ok) return exit;
    const std::string manifest = files.files.back().path;
    return write(run, graph, manifest, dependencies, std::move(files));
}

Exit compile_graph(Run& run, const std::string& graph) {
    const Arguments& arguments = run.arguments;
    const Result result = run.compiler.compile_file(graph, options_of(arguments));
    report(run.console, result.diagnostics);
    for (const Dump& dump : result.dumps) {
        print("// " + graph + ": " + dump.stage + "\n" + dump.text + (dump.text.ends_with('\n') ? "" : "\n"));
    }
    if (!result.ok) return Exit::Wrong;

    OutputFiles files;
    bool ok = true;
    for (const Shader& shader : result.shaders) ok &= add_shader(run.console, arguments, shader, files);
    if (!ok || !has_own_names(run.console, graph, result.shaders, run.shader_names)) return Exit::Wrong;
    if (!arguments.writes()) return Exit::Ok;

    const std::string reflection = join_path(arguments.folder, output_name(graph) + arguments.kind + ".reflect.json");
    files.add(reflection, result.reflection.to_json());
    return write(run, graph, reflection, result.dependencies, std::move(files));
}

}  // namespace

void add_compile(Program& program) {
    CLI::App& command = add_command(
        program, "compile",
        {"patina compile rust.graph.json -o out", "patina compile *.graph.json -t glsl --validate -o out",
         "patina compile rust.graph.json -t spirv -o out --depfile",
         "patina compile rust.graph.json -t unity -o Assets/Shaders   # 'patina engines' lists what there is",
         "patina compile rust.graph.json --path deferred -D shadows -o out",
         "patina compile rust.graph.json -D _Mode=Wet -o out", "patina compile rust.graph.json --variants all -o out",
         "patina compile rust.graph.json --functions Rust_ -o out", "patina compile rust.graph.json --dump tidy"});
    auto arguments = std::make_shared<Arguments>();
    command.add_option("GRAPH", arguments->graphs, "Material graphs (JSON)")->required()->type_name(" ");
    add_words_option(command, "-t,--target", arguments->targets,
                     "glsl, hlsl, spirv, or an engine; several with commas between; default: glsl,hlsl",
                     [](const std::string&) { return std::string(); })
        ->type_name("TARGETS");
    command
        .add_option("-o,--output", arguments->folder,
                    "Folder to write to, which is made if it is missing; default: the current folder")
        ->type_name("DIR")
        ->check(is_folder_name);
    command.add_flag("--validate", arguments->validate, "Check the shaders with glslang and spirv-val");
    command.add_flag("--depfile", arguments->depfile,
                     "Write NAME.d next to NAME.reflect.json, a list of the files that this was made from, for ninja");
    add_words_option(command, "--dump", arguments->dump,
                     "Print the result of a step: graph, ir, linked, tidy, rates; files are written only with -o",
                     one_of("a step", {"graph", "ir", "linked", "tidy", "rates"}))
        ->type_name("STEP");
    add_path_options(command, arguments->path);
    CLI::Option* variants =
        command
            .add_option("--variants", arguments->variants.wanted,
                        "Compile the graph's variants. all: every combination; listed: those under \"variants\"; "
                        "reachable: without choices that change nothing. Each different shader is written once; "
                        "NAME.variants.json says which belongs to which combination")
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
    variants->excludes(command.get_option("--dump"));
    add_include_option(command, arguments->include_dirs);
    set_check(command, [arguments] { refuse_equal_outputs(arguments->graphs, ".*", "compile"); });

    set_work(program, command, [arguments](const Console& console) {
        if (console.json && !arguments->dump.empty()) {
            complain(console, Complaint::MixedOutput, {"--dump"});
            return Exit::Usage;
        }
        if (!arguments->functions.empty() && arguments->wants("spirv")) {
            complain(console, Complaint::FunctionsAsSpirv, {});
            return Exit::Usage;
        }
        const Compiler compiler;
        read_targets(*arguments, compiler);
        if (const std::string why = not_for_engine(*arguments, compiler); !why.empty()) {
            complain(console, Complaint::Usage, {why});
            return Exit::Usage;
        }
        arguments->kind = arguments->variants.kind = kind_of(*arguments, compiler);
        Run run{console, *arguments, compiler};
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size(); ++i) {
            show_progress(console, i, arguments->graphs.size(), arguments->graphs[i]);
            const auto compile = arguments->variants.wanted.empty() ? compile_graph : compile_variants;
            exit = worse(exit, compile(run, arguments->graphs[i]));
        }
        return exit;
    });
}

}  // namespace patina::cli

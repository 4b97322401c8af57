// patina compile: turns graphs into shader files and their reflection.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/commands/compile_variants.h"
#include "compiler/cli/files.h"
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

// What was asked for and a wanted engine's files do not have; empty: nothing.
std::string not_for_engine(const Arguments& arguments, const Compiler& compiler) {
    for (const EngineInfo& engine : compiler.engines()) {
        if (!arguments.wants(engine.name)) continue;
        if (engine.is_one_file && !arguments.functions.empty())
            return fmt::format("--functions cannot be written for {}, whose file holds whole passes", engine.title);
        if (arguments.targets.size() > 1) continue;
        if (engine.is_one_file && arguments.validate)
            return fmt::format("--validate cannot prove a file of {}; it proves glsl, hlsl and spirv", engine.title);
        if (engine.has_own_passes && arguments.path.path != PathOptions{}.path)
            return fmt::format("--path has no effect for {}, which has passes of its own", engine.title);
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

Exit write(const Console& console, const Arguments& arguments, const std::string& graph, const std::string& target,
           std::span<const std::string> dependencies, OutputFiles files) {
    if (arguments.depfile) files.add(join_path(arguments.folder, stem(graph)) + ".d", make_rule(target, dependencies));
    if (std::string error = commit(files); !error.empty()) {
        complain(console, Complaint::CannotWrite, {error});
        return Exit::Wrong;
    }
    for (const OutputFile& file : files.files) say(console, file.path);
    return Exit::Ok;
}

Exit compile_variants(const Console& console, const Arguments& arguments, const Compiler& compiler,
                      const std::string& graph, ShaderNames& shader_names) {
    OutputFiles files;
    std::vector<std::string> dependencies;
    const Exit exit = make_variants(
        console, compiler, graph, arguments.variants, options_of(arguments), arguments.folder,
        [&](const Shader& shader, OutputFiles& made) {
            return add_shader(console, arguments, shader, made) &&
                   has_own_names(console, graph, std::span(&shader, 1), shader_names);
        },
        files, dependencies);
    if (exit != Exit::Ok) return exit;
    const std::string manifest = files.files.back().path;
    return write(console, arguments, graph, manifest, dependencies, std::move(files));
}

Exit compile_graph(const Console& console, const Arguments& arguments, const Compiler& compiler,
                   const std::string& graph, ShaderNames& shader_names) {
    const Result result = compiler.compile_file(graph, options_of(arguments));
    report(console, result.diagnostics);
    for (const Dump& dump : result.dumps) {
        print("// " + graph + ": " + dump.stage + "\n" + dump.text + (dump.text.ends_with('\n') ? "" : "\n"));
    }
    if (!result.ok) return Exit::Wrong;

    OutputFiles files;
    bool ok = true;
    for (const Shader& shader : result.shaders) ok &= add_shader(console, arguments, shader, files);
    if (!ok || !has_own_names(console, graph, result.shaders, shader_names)) return Exit::Wrong;
    if (!arguments.writes()) return Exit::Ok;

    const std::string name = join_path(arguments.folder, stem(graph));
    const std::string reflection = name + ".reflect.json";
    files.add(reflection, result.reflection.to_json());
    return write(console, arguments, graph, reflection, result.dependencies, std::move(files));
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
        ->type_name("DIR");
    command.add_flag("--validate", arguments->validate, "Check the shaders with glslang and spirv-val");
    command.add_flag("--depfile", arguments->depfile,
                     "Write NAME.d, a list of the files that NAME.reflect.json was made from, for ninja");
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
    command.parse_complete_callback([arguments] { refuse_equal_outputs(arguments->graphs, ".*", "compile"); });

    set_work(program, command, [arguments](const Console& console) {
        if (console.json && !arguments->dump.empty()) {
            complain(console, Complaint::MixedOutput, {});
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
        ShaderNames shader_names;
        Exit exit = Exit::Ok;
        for (std::size_t i = 0; i < arguments->graphs.size(); ++i) {
            show_progress(console, i, arguments->graphs.size(), arguments->graphs[i]);
            const auto compile = arguments->variants.wanted.empty() ? compile_graph : compile_variants;
            exit = worse(exit, compile(console, *arguments, compiler, arguments->graphs[i], shader_names));
        }
        return exit;
    });
}

}  // namespace patina::cli

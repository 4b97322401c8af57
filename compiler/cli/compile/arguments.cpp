#include "compiler/cli/compile/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/cli/outputs.h"

namespace patina::cli {
namespace {

constexpr std::string_view kSpirv = "spirv";

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

}  // namespace

bool CompileArguments::wants(std::string_view target) const {
    return std::ranges::find(targets, target) != targets.end();
}

bool CompileArguments::wants_spirv() const {
    return wants(kSpirv);
}

bool contains(const std::vector<Target>& targets, const Target& target) {
    return std::find(targets.begin(), targets.end(), target) != targets.end();
}

void add_target_options(CLI::App& command, CompileArguments& arguments) {
    add_words_option(command, "-t,--target", arguments.targets,
                     "glsl, hlsl, spirv, or an engine; several with commas between; default: glsl,hlsl",
                     [](const std::string&) { return std::string(); })
        ->type_name("TARGETS");
    command
        .add_option("-o,--output", arguments.folder,
                    "Folder to write to, which is made if it does not exist. It gets the same sub-folders as a folder "
                    "of graphs. Default: the current folder")
        ->type_name("DIR")
        ->check(is_folder_name);
    command.add_flag("--file-hashes", arguments.file_hashes,
                     "List each file with the hash of its bytes in the reflection. With the hashes, a reader without a "
                     "lock on the folder sees whether all files are from one run");
}

CompileOptions options_of(const CompileArguments& arguments) {
    CompileOptions options;
    options.targets = arguments.written;
    if (arguments.wants_spirv() && !contains(options.targets, Target::Glsl))
        options.targets.insert(options.targets.begin(), Target::Glsl);
    options.include_dirs = arguments.include_dirs;
    options.dump = arguments.dump;
    if (arguments.functions.empty())
        options.request = CompileOptions::Passes{.path = arguments.path.path};
    else
        options.request = CompileOptions::Functions{.prefix = arguments.functions};
    options.switches = arguments.path.switches();
    return options;
}

namespace {

// Throws the usage error if there is no such target.
void read_targets(CompileArguments& arguments, const Compiler& compiler) {
    if (arguments.targets.empty()) {
        arguments.names_no_target = true;
        arguments.targets = {"glsl", "hlsl"};
    }
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
    // In the order of the engines and their languages, not in the order of the words.
    for (const EngineInfo& engine : compiler.engines()) {
        for (const Target& target : compiler.targets(engine.name)) {
            const std::string_view word = engine.is_default ? target.language : engine.name;
            if (arguments.wants(word) || arguments.wants(engine.name)) arguments.written.push_back(target);
        }
    }
}

std::string kind_of(const CompileArguments& arguments, const Compiler& compiler) {
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

std::string not_for_engine(const CompileArguments& arguments, const Compiler& compiler) {
    for (const EngineInfo& engine : compiler.engines()) {
        if (!arguments.wants(engine.name)) continue;
        if (engine.is_one_file && !arguments.functions.empty())
            return fmt::format("--functions cannot be written for {}, whose file holds whole passes", engine.title);
        if (engine.is_one_file && arguments.validate)
            return fmt::format("--validate cannot check a file of {}: remove it from --target, or leave out --validate",
                               engine.title);
        if (!engine.is_default && arguments.cost && arguments.targets.size() == 1)
            return fmt::format("--cost measures the shaders of Vulkan: add glsl to --target for {}", engine.title);
        if (arguments.targets.size() > 1) continue;
        if (!has_path_of(engine, arguments.path.path))
            return fmt::format("{} has passes of its own: --path can be {}, but not '{}'", engine.title,
                               fmt::join(engine.paths, " or "), arguments.path.path);
    }
    return {};
}

}  // namespace

std::string settle(CompileArguments& arguments, const Compiler& compiler) {
    const std::string& list = arguments.output_list;
    if (arguments.depfile && !list.empty() && (is_stream(list) || is_standard_output(list)))
        return fmt::format(
            "--depfile: '{}' is not a file, so no dependency file can be next to it: name a file with --list-outputs",
            list);
    read_targets(arguments, compiler);
    arguments.kind = arguments.variants.kind = kind_of(arguments, compiler);
    arguments.variants.file_hashes = arguments.file_hashes;
    return not_for_engine(arguments, compiler);
}

}  // namespace patina::cli

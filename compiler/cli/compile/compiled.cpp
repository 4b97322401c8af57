#include "compiler/cli/compile/compiled.h"

#include <algorithm>
#include <iterator>

#include "compiler/cli/cost/foreign.h"
#include "compiler/cli/files.h"
#include "patina/output_name.h"
#include "patina/validate.h"

namespace patina::cli {
namespace {

std::string as_bytes(const std::vector<std::uint32_t>& words) {
    return std::string(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t));
}

const std::string kSpirvWord = "spirv", kSpirvEnding = ".spv";

// "rust.forward.vert.glsl" -> "rust.forward.vert.spv"
std::string spirv_name(const Shader& shader) {
    return shader.file_name.substr(0, shader.file_name.rfind('.')) + kSpirvEnding;
}

// Into the reflection. If glslang refuses a stage, that is an error.
void add_costs(Compiled& made) {
    measure_once(made);
    for (const MeasuredPass& measured : *made.costs)
        for (Pass& pass : made.result.reflection.passes)
            if (pass.name == measured.name) pass.cost = measured.cost;
    std::vector<Diagnostic> refused = refusals(made.result, *made.costs);
    made.ok = refused.empty();
    std::ranges::move(refused, std::back_inserter(made.result.diagnostics));
}

}  // namespace

bool add_shader(const CompileArguments& arguments, const std::string& folder, const Shader& shader, OutputFiles& files,
                std::vector<Diagnostic>& diagnostics) {
    if (contains(arguments.written, shader.target)) files.add(join_path(folder, shader.file_name), shader.text);
    const bool wants_spirv = arguments.wants_spirv() && shader.target == Target::Glsl;
    const bool is_stage = shader.has_main || !arguments.functions.empty();
    if ((!arguments.validate && !wants_spirv) || !is_stage) return true;
    const Validated validated = validate(shader);
    diagnostics.insert(diagnostics.end(), validated.diagnostics.begin(), validated.diagnostics.end());
    if (wants_spirv) files.add(join_path(folder, spirv_name(shader)), as_bytes(validated.spirv));
    return validated.ok;
}

std::vector<WrittenFile> written_files(const OutputFiles& files, bool has_hashes) {
    std::vector<WrittenFile> written;
    for (const runtime::OutputFile& file : files.files)
        written.push_back({.file = file.path.substr(file.path.rfind('/') + 1),
                           .hash = has_hashes ? file_hash(file.bytes) : std::string()});
    return written;
}

void list_files(Reflection& reflection, const Shader& shader, std::string_view compiled,
                std::span<const WrittenFile> written) {
    std::ranges::copy_if(written, std::back_inserter(reflection.files),
                         [](const WrittenFile& each) { return !each.hash.empty(); });
    for (Pass& pass : reflection.passes) {
        const auto found = std::ranges::find(pass.shaders, compiled, &ShaderFile::file);
        if (found == pass.shaders.end()) continue;
        std::vector<ShaderFile> files;
        for (const WrittenFile& each : written) {
            const std::string& language = each.file.ends_with(kSpirvEnding) ? kSpirvWord : shader.target.language;
            files.push_back({.stage = shader.stage, .language = language, .file = each.file});
        }
        pass.shaders.insert(pass.shaders.erase(found), files.begin(), files.end());
    }
}

void measure_once(Compiled& made) {
    if (made.ok && !made.costs) made.costs = measure(made.result);
}

std::string folder_of(const CompileArguments& arguments, const Input& input) {
    return join_path(arguments.folder, input.folder);
}

Compiled compile_graph(const CompileArguments& arguments, const Compiler& compiler, const Input& input) {
    const CompileOptions options = options_of(arguments);
    Compiled made{.result = arguments.names_no_target ? compile_if_foreign(compiler, input.path, options)
                                                      : compiler.compile_file(input.path, options)};
    name_graph(made.result.diagnostics, input.path);
    made.ok = made.result.ok;
    if (!made.ok) return made;
    const std::string folder = folder_of(arguments, input);
    for (const Shader& shader : made.result.shaders) {
        OutputFiles files;
        made.ok &= add_shader(arguments, folder, shader, files, made.result.diagnostics);
        list_files(made.result.reflection, shader, shader.file_name, written_files(files, arguments.file_hashes));
        std::ranges::move(files.files, std::back_inserter(made.files.files));
    }
    if (made.ok && arguments.cost) add_costs(made);
    made.reflection = join_path(folder, output_name(input.path) + arguments.kind + ".reflect.json");
    made.files.add(made.reflection, made.result.reflection.to_json());
    return made;
}

}  // namespace patina::cli

// The result of `patina compile` for one graph, before anything is printed or written. `patina watch` makes the same.
//
//   Compiled made = compile_graph(arguments, compiler, input);
//   report(console, made.result.diagnostics);
//   if (made.ok) outputs.write(input.path, made.files, made.result.dependencies);
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/cli/compile/arguments.h"
#include "compiler/cli/outputs.h"
#include "patina/cost.h"

namespace patina::cli {

struct Compiled {
    Result result{};
    std::string reflection{};  // the path of its file
    OutputFiles files{};
    std::optional<std::vector<MeasuredPass>> costs{};  // nothing: nobody has asked yet
    bool ok = false;
};

// Measures what the passes cost, which takes glslang some time. Only stages in GLSL or HLSL of the default engine have
// a cost.
void measure_once(Compiled& made);

// Any number of threads may do so with one compiler.
Compiled compile_graph(const CompileArguments& arguments, const Compiler& compiler, const Input& input);

// Adds the files of one shader to `files`. False: glslang or spirv-val refuses it, and `diagnostics` say why.
bool add_shader(const CompileArguments& arguments, const std::string& folder, const Shader& shader, OutputFiles& files,
                std::vector<Diagnostic>& diagnostics);

// As reflections list files: without their folders, with their hashes if these are wanted.
std::vector<WrittenFile> written_files(const OutputFiles& files, bool has_hashes);

// Lists in the reflection the files that were written for a shader, instead of the compiled file, and other files with
// hashes.
void list_files(Reflection& reflection, const Shader& shader, std::string_view compiled,
                std::span<const WrittenFile> written);

// Where the files of a graph go.
std::string folder_of(const CompileArguments& arguments, const Input& input);

}  // namespace patina::cli

// The room `cli/compile` has the parts of `patina compile` besides the command itself: its words, and its variants.
//
// The words of `patina compile`, and what they mean for the library's engines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/cli/compile/variants.h"
#include "compiler/cli/inputs.h"
#include "compiler/cli/program.h"

namespace patina::cli {

struct CompileArguments {
    InputArguments inputs;
    std::vector<std::string> targets{};
    bool names_no_target = false;  // then `targets` are the usual ones, as far as they can take the graph's code
    std::vector<std::string> include_dirs;
    std::vector<std::string> dump;
    std::string folder;
    PathOptions path;
    std::string functions;
    VariantOptions variants;
    std::string output_list;  // --list-outputs; its --depfile is one for all
    bool validate = false;
    bool cost = false;         // in the reflection
    bool file_hashes = false;  // in the reflection
    bool depfile = false;
    bool depends_on_outputs = false;  // in the dependency file of the list

    bool wants(std::string_view target) const;
    bool wants_spirv() const;
    // Whose files are written. SPIR-V is made from GLSL, which may not be among them. settle() finds them.
    std::vector<Target> written;
    // The part after the graph's name in the names of the reflection, its dependency file and its manifest. Empty for
    // the default engine and path, else ".deferred", ".functions". settle() finds it.
    std::string kind;
    // --dump alone is for looking, not for writing.
    bool writes() const { return dump.empty() || !folder.empty(); }
};

bool contains(const std::vector<Target>& targets, const Target& target);

// -t, -o and --file-hashes.
void add_target_options(CLI::App& command, CompileArguments& arguments);
// Reads the words of -t, and what follows from them. Throws the usage error if there is no such target. Returns what
// was asked for and a wanted engine's files do not have; empty: nothing.
std::string settle(CompileArguments& arguments, const Compiler& compiler);

CompileOptions options_of(const CompileArguments& arguments);

}  // namespace patina::cli

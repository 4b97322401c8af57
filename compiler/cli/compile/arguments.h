// The room `cli/compile` is what `patina compile` needs beside its command: its words, and its variants.
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
    std::vector<std::string> targets = {"glsl", "hlsl"};
    std::vector<std::string> include_dirs;
    std::vector<std::string> dump;
    std::string folder;
    PathOptions path;
    std::string functions;
    VariantOptions variants;
    std::string output_list;  // --list-outputs
    bool validate = false;
    bool depfile = false;

    bool wants(std::string_view target) const;
    bool wants_spirv() const;
    // Whose files are written. SPIR-V is made from GLSL, which may not be among them. read_targets() finds them.
    std::vector<Target> written;
    // What tells the reflection of this kind of output from those of others: "", ".deferred", ".functions".
    std::string kind;
    // --dump alone is for looking, not for writing.
    bool writes() const { return dump.empty() || !folder.empty(); }
};

bool contains(const std::vector<Target>& targets, const Target& target);

// Reads the words of -t. Throws the usage error if there is no such target.
void read_targets(CompileArguments& arguments, const Compiler& compiler);

CompileOptions options_of(const CompileArguments& arguments);

// What the names of the reflection, its dependency file and its manifest hold besides the graph: nothing for the
// default engine and path.
std::string kind_of(const CompileArguments& arguments, const Compiler& compiler);

// What was asked for and a wanted engine's files do not have; empty: nothing.
std::string not_for_engine(const CompileArguments& arguments, const Compiler& compiler);

}  // namespace patina::cli

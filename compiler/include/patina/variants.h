// All that a material can be compiled to: the combinations of its variants' values, planned first, so that their number
// is known before any work is done, and compiled so that each different shader is there once.
//
//   patina::VariantPlan plan = compiler.plan_variants("rust.graph.json", patina::VariantsWanted::All, options);
//   patina::VariantSet set = compiler.compile_variants("rust.graph.json", plan, options);
//   const patina::VariantProgram& program = set.programs[set.program_of[3]];   // what plan.combination(3) runs
#pragma once

#include "patina/patina.h"

namespace patina {

// A variant that CompileOptions::switches give no value, and its values: "false" and "true", or an enum's words.
struct VariantAxis {
    std::string property;
    std::vector<std::string> values;
    std::size_t otherwise = 0;  // the default: index into `values`
    bool is_bool = false;       // else an enum
};
// Property and value, in the order of the axes.
using VariantValues = std::vector<std::pair<std::string, std::string>>;

enum class VariantsWanted {
    All,       // every value with every other
    Listed,    // what the graph lists under "variants"; what an entry leaves out has its default
    Reachable  // a property counts only where its values make different shaders beside the values of the others
};
std::string_view to_string(VariantsWanted wanted);  // "all", "listed", "reachable"

inline constexpr std::size_t kVariantLimit = 1024;
inline constexpr std::size_t kMostVariants = 1'000'000;  // that any limit can allow

struct VariantPlan {
    bool ok = false;
    std::vector<Diagnostic> diagnostics;
    std::vector<VariantAxis> axes;
    std::size_t fixed = 0;  // variants that the options give a value
    std::size_t count = 0;  // of combinations
    // Listed, Reachable: the combinations. All: none, they follow from the axes.
    std::vector<VariantValues> picked;

    // With a value for every axis; Reachable: for those that count, and exactly one combination fits any choice of
    // values.
    VariantValues combination(std::size_t index) const;
};
// Of all axes together; may be more than any plan holds.
double combinations_of(const std::vector<VariantAxis>& axes);

// What one or more combinations run: the first of them, compiled.
struct VariantProgram {
    std::string hash;  // of all passes: 32 hexadecimal digits, whatever things are called in the graph
    Result result;     // with hashes; its variants' values in the reflection are the graph's defaults
};

struct VariantSet {
    bool ok = false;
    std::vector<Diagnostic> diagnostics;  // each once
    std::vector<VariantProgram> programs;
    std::vector<std::size_t> program_of;    // by VariantPlan::combination
    std::vector<std::string> dependencies;  // files that were read, the graph first
};

}  // namespace patina

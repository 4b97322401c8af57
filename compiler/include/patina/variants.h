// Compiles all combinations of a material's variants. They are planned first, so that their number is known before the
// work begins. Combinations with equal shaders share one program.
//
//   patina::VariantPlan plan = compiler.plan_variants("rust.graph.json", patina::VariantsWanted::All, options,
//                                                    patina::kVariantLimit);
//   patina::VariantSet set = compiler.compile_variants("rust.graph.json", plan, options);
//   const patina::VariantProgram& program = set.programs[set.program_of[3]];   // what plan.combination(3) runs
#pragma once

#include "patina/patina.h"

namespace patina {

// A variant that CompileOptions::switches leave open, and its values: "false" and "true", or an enum's words.
struct VariantAxis {
    std::string property;             // its name in the graph: "_Mode"
    std::vector<std::string> values;  // in the order of the graph
    std::size_t otherwise = 0;        // the default: index into `values`
    bool is_bool = false;             // otherwise an enum
};
// Property and value, in the order of the axes.
using VariantValues = std::vector<std::pair<std::string, std::string>>;

// Which combinations are compiled.
enum class VariantsWanted {
    All,       // every value with every other
    Listed,    // the combinations that the graph lists under "variants"; missing values are the defaults
    Reachable  // only properties that make different shaders, given the values of the others
};
// The word of `wanted`: "all", "listed", "reachable".
PATINA_API std::string_view to_string(VariantsWanted wanted);

inline constexpr std::size_t kVariantLimit = 1024;       // the usual limit of their number
inline constexpr std::size_t kMostVariants = 1'000'000;  // the highest limit that can be set

// The combinations of a material, before they are compiled.
struct PATINA_API VariantPlan {
    bool ok = false;                      // there are no errors; more combinations than the limit are one
    std::vector<Diagnostic> diagnostics;  // of the graph; for too many combinations, how each variant adds to them
    std::vector<VariantAxis> axes;        // in the order of the graph
    std::size_t fixed = 0;                // number of variants that the options give a value
    std::size_t count = 0;                // number of combinations; 0 if not ok
    // Listed, Reachable: the combinations. All: empty, because they follow from the axes.
    std::vector<VariantValues> picked;

    // The values of one combination, 0 to count - 1: of every axis or, for Reachable, of the properties that count.
    // Exactly one combination matches any choice of values.
    VariantValues combination(std::size_t index) const;
};
// The number of combinations of all axes; it may be more than a plan can have.
PATINA_API double combinations_of(const std::vector<VariantAxis>& axes);

// The compiled program of one or more combinations, made from the first of them.
struct VariantProgram {
    std::string hash;  // of all passes: 32 hexadecimal digits, which do not depend on the graph's names
    Result result;     // with hashes; the reflection has the variants' default values
};

// All combinations of a plan, compiled.
struct VariantSet {
    bool ok = false;                        // there are no errors
    std::vector<Diagnostic> diagnostics;    // each diagnostic once
    std::vector<VariantProgram> programs;   // with `finished`, which received each program: the hashes alone
    std::vector<std::size_t> program_of;    // index into `programs`, for each index of VariantPlan::combination
    std::vector<std::string> dependencies;  // files that were read, the graph first
    std::vector<std::string> missing;       // files that were searched for and do not exist, sorted
};

}  // namespace patina

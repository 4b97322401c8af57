// The lighting terms of the reference values by the names and inputs that they have there, worked out by nodes and
// lighting models: `patina eval --term`. Which node and port stands for which term is data,
// compiler/cli/eval/terms.json:
//
//   "D_GGX": { "node": "DistributionGGX", "in": { "ndoth": "NoH", "alpha": "sqrt(a2)" } }
//
// "in" gives ports expressions over the term's inputs, all of which must be given but the "optional" ones, whose ports
// keep their defaults; "words" are inputs that need not be numbers. "out" is an
// expression over the node's outputs and the term's inputs, or several: a list is one vector, an object has names.
// With "channel" the node works on colours, and the term on one number unless it is given a colour. Instead of a node
// there may be a "model" with a "workflow", or nothing, and "out" says it all.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "patina/patina.h"

namespace patina::cli {

struct TermResult {
    bool ok = false;
    std::string error;                    // of the words; empty if `diagnostics` say it
    std::vector<Diagnostic> diagnostics;  // of the library
    std::vector<EvalOutput> outputs;
    std::vector<std::size_t> widths;  // how many numbers each expression of "out" gave, in order
};

// Inputs as words: "0.5", "0,0,1", "[[1,0],[0,1]]" (brackets and white space do not matter), "gamma", "true".
using TermInputs = std::vector<std::pair<std::string, std::string>>;
TermResult evaluate_term(const Compiler& compiler, const std::string& term, const TermInputs& inputs, bool single);

std::vector<std::string> term_names();

}  // namespace patina::cli

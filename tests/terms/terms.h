// The lighting terms of the reference values (tests/data/brdf-values.json), with the names and inputs that they have
// there, computed by nodes and lighting models. terms.json in this folder says which node and port computes which term,
// so a new term is a row there.
//
//   "D_GGX": { "node": "DistributionGGX", "in": { "ndoth": "NoH", "alpha": "sqrt(a2)" } }
//
// "in": an expression over the term's inputs for each port. Every input must be given, except the "optional" ones; a
// port whose inputs are missing keeps its default. "words": inputs that need not be numbers. "out": an expression over
// the node's outputs and the term's inputs, or several; a list is one vector, an object has names. "channel": the node
// works on colours, and the term on one number unless its input is a colour. Instead of "node" there may be "model" and
// "workflow", or neither: then "out" is the whole term.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "patina/patina.h"

namespace patina::reference {

struct TermResult {
    bool ok = false;
    std::string error;                    // what is wrong with the inputs; empty if `diagnostics` say it
    std::vector<Diagnostic> diagnostics;  // of the library
    std::vector<EvalOutput> outputs;
    std::vector<std::size_t> widths;  // how many numbers each expression of "out" gave, in order
};

// Inputs as text: "0.5", "0,0,1", "[[1,0],[0,1]]" (brackets and white space do not matter), "gamma", "true".
using TermInputs = std::vector<std::pair<std::string, std::string>>;
TermResult evaluate_term(const Compiler& compiler, const std::string& term, const TermInputs& inputs, bool single);

std::vector<std::string> term_names();

}  // namespace patina::reference

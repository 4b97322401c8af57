// The `test:` lines of nodes on the GPU: as many as one shader can run, one a pixel, with their arguments in a texture.
#pragma once

#include <string>
#include <vector>

#include "witness/bench.h"

namespace patina::witness {

// Tests of one node that one shader can run: they differ in numbers only.
struct Batch {
    std::string expression;  // the call, reading its arguments from the nodes a0, a1, ...
    std::vector<NodeTest> tests;
};
std::vector<Batch> batches_of(const std::vector<NodeTest>& tests);

// The argument as the graph writes it: out of a texel, or, of what a shader must know beforehand, as a literal.
std::string argument_text(const NodeTest::Argument& argument, std::size_t index);
// The components of the call's value spread over colour and alpha. `node`: what the node `value` is; empty: the call.
std::string graph_of(const Batch& batch, std::size_t components, bool is_bool, const std::string& node = {});
Image arguments_of(const Batch& batch);

void expect_passed(const NodeTest& test, const char* witness);
// Draws the batch through both languages, expects what its tests expect, and returns how many pixels were looked at.
std::size_t expect_passed_when_drawn(Bench& bench, const Material& material, const Batch& batch);

}  // namespace patina::witness

// Lowered functions + a pass -> two whole stages. Semantics become parameters, and each entry function works out their
// values by their recipes: from vertex attributes, interpolated, or in the pixel. The vertex stage computes exactly
// what the fragment stage still reads.
//
//   Linked linked = link(std::move(lowered));
//   ir::Module fragment = link_fragment(linked, pass, options);
//   ir::Module vertex = link_vertex(linked, pass, fragment, options);
#pragma once

#include "compiler/lower/lower.h"

namespace patina::assemble {

struct Linked {
    graph::Lowered lowered;               // its module has no functions any more: each stage copies those that it calls
    std::vector<ir::Function> functions;  // every `semantic` is a parameter now, handed down from the entry
    std::vector<std::vector<ir::SemanticId>> needs;  // by function: its last parameters
    std::vector<ir::OriginId> readers;               // by semantic: a place in a graph that reads it; may be none
};
Linked link(graph::Lowered lowered);

// A pass of a material as its two stages.
struct LinkedPass {
    const graph::LoweredPass* pass = nullptr;
    const graph::Material* material = nullptr;  // another one for each pass that a material adds
    const graph::Lowered* lowered = nullptr;
    ir::Module vertex{}, fragment{};
};

ir::Module link_fragment(const Linked& linked, const graph::LoweredPass& pass, ir::BuildOptions options);
// `fragment`: the finished fragment stage; its inputs that are no builtins are what the vertex stage hands over, and
// are given their locations here.
ir::Module link_vertex(const Linked& linked, const graph::LoweredPass& pass, ir::Module& fragment,
                       ir::BuildOptions options);
// Where the finished vertex stage hands over a constant, the fragment stage gets that constant instead. True if it got
// any: then it is to be tidied again, and the vertex stage to be linked again.
bool take_constants(ir::Module& fragment, const ir::Module& vertex);

}  // namespace patina::assemble

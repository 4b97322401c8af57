// The room `link` turns lowered functions and a pass into two whole stages. It settles names, hashes and interpolators,
// and runs the IR passes. It makes no new operations of the graph, checks no types, and does not know how a language
// spells a stage.
//
// Semantics become parameters. Each entry function computes their values by their recipes: from vertex attributes, by
// interpolation, or in the pixel. The vertex stage computes exactly what the fragment stage still reads.
//
//   Linked linked = link(std::move(lowered));
//   ir::Module fragment = link_fragment(linked, pass, options);
//   ir::Module vertex = link_vertex(linked, pass, fragment, options);
#pragma once

#include "compiler/lower/lower.h"

namespace patina::link {

struct Linked {
    lower::Lowered lowered;  // its module has no functions any more: each stage has copies of those that it calls
    std::vector<ir::Function> functions;  // every `semantic` is a parameter now, which the entry function passes down
    std::vector<std::vector<ir::SemanticId>> needs;  // by function: the semantics of its last parameters
    std::vector<ir::OriginId> readers;               // by semantic: a place in a graph that reads it; may be none
};
Linked link(lower::Lowered lowered);

// A pass of a material as its two stages.
struct LinkedPass {
    const lower::LoweredPass* pass = nullptr;
    const resolve::Material* material = nullptr;  // differs for each extra pass
    const lower::Lowered* lowered = nullptr;
    ir::Module vertex{}, fragment{};
    bool reads_elsewhere = false;  // it reads a target of the picture at other pixels than its own
    std::uint32_t left_out = 0;    // of its targets, the last ones: no pass of the material reads them (target_reads.h)
};

ir::Module link_fragment(const Linked& linked, const lower::LoweredPass& pass, ir::BuildOptions options,
                         std::uint32_t left_out = 0);
// `fragment`: the finished fragment stage, with its inputs numbered. The vertex stage computes them, except builtins.
ir::Module link_vertex(const Linked& linked, const lower::LoweredPass& pass, const ir::Module& fragment,
                       ir::BuildOptions options);
// If the finished vertex stage outputs a constant, the fragment stage gets that constant instead. True if there was
// one: then the fragment stage must be tidied again, and the vertex stage linked again.
bool take_constants(ir::Module& fragment, const ir::Module& vertex);

}  // namespace patina::link

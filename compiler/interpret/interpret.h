// Executes IR on four lanes (a 2x2 quad). What an op does is a row of a table; no function here is named for a node.
// The public face is patina/interpret.h; this is what it, doc tests and `eval` are built on.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "compiler/ir/ir.h"
#include "patina/interpret.h"

namespace patina::interpret {

// What globals hold. Uniforms are doubles by component; matrices row by row; arrays element by element.
struct Resources {
    std::vector<std::vector<double>> uniforms;                 // by Module::globals index
    std::vector<std::shared_ptr<const TextureData>> textures;  // by Module::globals index
};

// A composite value of one lane, flattened: components, rows, members and elements end to end. Opaque members take one
// slot that holds the global's index.
using Flat = std::vector<double>;

struct QuadResult {
    std::array<Flat, 4> lanes;
    std::array<bool, 4> discarded{};
};

// Runs `function` with one flattened argument list per lane. In Float precision every operation on a float is rounded
// to 32 bits; half operations are rounded to 16 bits in both.
QuadResult run(const ir::Module& module, ir::FunctionId function, const std::array<std::vector<Flat>, 4>& arguments,
               const Resources& resources, Precision precision);

// Slots that a value of this type takes in a Flat.
std::size_t flat_size(const ir::Module& module, ir::Type type);

}  // namespace patina::interpret

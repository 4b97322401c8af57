// The room `interpret` executes IR on four lanes (a 2x2 quad of pixels), to check what GPUs compute. It has arithmetic
// of its own and shares no code with the compiler's folding. It knows no node by name: the meaning of an op is a row of
// a table. Its public header is patina/interpret.h. The public class, the doc tests and `eval` call the functions
// below.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "compiler/ir/ir.h"
#include "patina/interpret.h"

namespace patina::interpret {

// The values of globals. A uniform is a list of doubles: its components, a matrix row by row, an array element by
// element.
struct Resources {
    std::vector<std::vector<double>> uniforms;                 // by Module::globals index
    std::vector<std::shared_ptr<const TextureData>> textures;  // by Module::globals index
};

// A value of one lane as a list: the components of its rows, members and elements end to end. An opaque member is one
// number, the index of its global.
using Flat = std::vector<double>;

struct QuadResult {
    std::array<Flat, 4> lanes;
    std::array<bool, 4> discarded{};
    bool is_whole = true;  // false: it would have taken more steps than are left
};

// Runs `function` with one list of arguments for each lane. In Float precision, the result of every float operation is
// rounded to 32 bits; half operations are rounded to 16 bits in both precisions. The steps that it takes are subtracted
// from `steps_left`; null: any number.
QuadResult run(const ir::Module& module, ir::FunctionId function, const std::array<std::vector<Flat>, 4>& arguments,
               const Resources& resources, Precision precision, std::uint64_t* steps_left = nullptr);

// How many numbers a value of this type has in a Flat.
std::size_t flat_size(const ir::Module& module, ir::Type type);

}  // namespace patina::interpret

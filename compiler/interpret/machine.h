// A function of the IR, made ready to run. Every value has a fixed place in one memory, and a block is a list of steps
// that read and write places. Functions do not recurse, so each has one frame, and nothing is allocated while the
// machine runs. To take a part of a value is no step: the part has a place inside of the whole.
//
//   Machine machine = make_machine(module, entry, Precision::Float);
//   machine.argument(0, 0) = 0.5;   // component 0, lane 0
//   execute(machine);
//   machine.result(0, 0);
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "compiler/ir/ir.h"
#include "patina/interpret.h"

namespace patina::interpret {

inline constexpr unsigned kLanes = 4;
// One bit for each lane.
using Mask = unsigned;
inline constexpr Mask kAllLanes = (1u << kLanes) - 1;

// The number of a component in the memory; its four lanes lie side by side.
using Slot = std::uint32_t;
inline constexpr Slot kNowhere = 0xffffffffu;

struct Step;
struct Machine;
// Computes all four lanes; the result of a lane that is switched off is never read.
using Kernel = void (*)(const Step&, Machine&);

struct Shape {
    std::uint8_t rows = 1;
    std::uint8_t cols = 1;
};

struct Step {
    enum class Kind : std::uint8_t { Compute, Copy, Branch, Loop, Call, Discard, Watch };
    Kind kind = Kind::Compute;
    bool rounds_to_half = false;
    std::array<Shape, 2> shapes{};  // of the first two operands
    Kernel kernel = nullptr;
    Slot to = kNowhere;
    std::uint32_t count = 0;  // components of the result
    std::array<Slot, 5> from{};
    std::uint32_t data = 0;  // Branch, Loop, Call, Watch: the index of the code to run; an op: its kernel defines it
};

struct Move {
    Slot to = kNowhere;
    Slot from = kNowhere;
    std::uint32_t count = 0;
};

struct Branch {
    Slot condition = kNowhere;
    std::array<std::uint32_t, 2> blocks{};  // if true, if false
    std::array<std::vector<Move>, 2> yields{};
};

struct Loop {
    Slot begin = kNowhere;
    Slot end = kNowhere;
    Slot index = kNowhere;
    Slot goes_on = kNowhere;  // of a loop that may end early: a carried bool
    std::uint32_t block = 0;
    bool is_over_lights = false;
    std::vector<Move> initial{};
    std::vector<Move> next{};
    // If a carried value becomes another carried value, all of them are first moved to a second place.
    std::vector<Move> staged{};
};

struct CallSite {
    std::uint32_t block = 0;
    std::vector<Move> arguments{};
    Move result{};
};

// A probe of a function, and where its value is when the function returns.
struct Watched {
    std::uint32_t function = 0;
    std::uint32_t probe = 0;  // into Function::probes
    Slot slot = kNowhere;
    std::uint32_t count = 0;  // components
};
// The value that was there in one lane.
struct Sighting {
    std::uint32_t watched = 0;
    int light = -1;  // the number of the light, inside a loop over lights
    std::vector<double> values{};
};
struct Watcher {
    unsigned lane = 0;
    std::vector<Sighting> sightings{};
};

struct Machine {
    Precision precision = Precision::Float;
    std::vector<std::vector<Step>> blocks{};
    std::vector<Branch> branches{};
    std::vector<Loop> loops{};
    std::vector<CallSite> calls{};
    std::vector<Watched> watched{};
    std::uint32_t entry = 0;  // a block
    Slot first_argument = 0;
    std::vector<ir::Type> argument_types{};  // scalar or opaque, one per component, end to end
    Move output;                             // from, count
    std::vector<Slot> globals{};             // by Module::globals; kNowhere if nothing reads it

    std::vector<double> memory{};
    std::vector<std::shared_ptr<const TextureData>> textures{};  // by Module::globals; null: not bound
    bool is_quad = true;  // the lanes are neighbouring pixels; false: they are unrelated, like vertices
    Mask discarded = 0;
    std::uint64_t steps_left = ~std::uint64_t{0};
    Watcher* watcher = nullptr;  // null: there is none
    int light = -1;

    double* at(Slot slot) { return memory.data() + std::size_t{slot} * kLanes; }
    const double* at(Slot slot) const { return memory.data() + std::size_t{slot} * kLanes; }
    // In Float precision the number is rounded to what the parameter's type can hold.
    void set_argument(std::size_t component, unsigned lane, double value);
    double result(std::size_t component, unsigned lane) const {
        return at(output.from + static_cast<Slot>(component))[lane];
    }
};

Machine make_machine(const ir::Module& module, ir::FunctionId entry, Precision precision);

// Components of a uniform, as in Resources::uniforms; missing ones are 0.
void set_uniform(Machine& machine, const ir::Module& module, ir::GlobalId global, std::span<const double> components);
// A texture without texels counts as not bound.
void set_texture(Machine& machine, ir::GlobalId global, std::shared_ptr<const TextureData> texture);

void execute(Machine& machine);

// Thrown by it when `steps_left` are used up.
struct OutOfSteps {};

// The scalar (or opaque) type of each slot of a value of this type, end to end.
void append_slot_types(const ir::Module& module, ir::Type type, std::vector<ir::Type>& into);

}  // namespace patina::interpret

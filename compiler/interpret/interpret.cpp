// Runs a machine: blocks, branches and loops with a mask of the lanes that take part.
#include "compiler/interpret/interpret.h"

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/interpret/machine.h"
#include "compiler/interpret/rounding.h"

namespace patina::interpret {
namespace {

// A step of the machine is short: so many of them take as long as one that is counted (Cancellation).
constexpr std::size_t kStepsOfOne = 16;

void run_block(Machine& machine, std::uint32_t block, Mask active);

void move(Machine& machine, const Move& m, Mask lanes) {
    const double* from = machine.at(m.from);
    double* to = machine.at(m.to);
    const std::size_t count = std::size_t{m.count} * kLanes;
    if (lanes == kAllLanes) {
        std::copy_n(from, count, to);
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (lanes >> (i % kLanes) & 1) to[i] = from[i];
    }
}

void move(Machine& machine, const std::vector<Move>& moves, Mask lanes) {
    for (const Move& m : moves) move(machine, m, lanes);
}

template <class Predicate>
Mask lanes_where(Predicate predicate) {
    Mask mask = 0;
    for (unsigned lane = 0; lane < kLanes; ++lane) mask |= predicate(lane) ? 1u << lane : 0u;
    return mask;
}

void run_branch(Machine& machine, const Branch& branch, Mask active) {
    const double* condition = machine.at(branch.condition);
    const Mask if_true = lanes_where([&](unsigned lane) { return condition[lane] != 0; });
    const std::array<Mask, 2> sides = {active & if_true, active & ~if_true};
    for (std::size_t side : {0u, 1u}) {
        if (sides[side] == 0) continue;
        run_block(machine, branch.blocks[side], sides[side]);
        // All lanes are moved, because that is cheaper than to move some; the other side does not need the old values.
        move(machine, branch.yields[side], sides[1 - side] == 0 ? kAllLanes : sides[side]);
    }
}

int light_of(const Machine& machine, const double* index) {
    return static_cast<int>(index[machine.watcher ? machine.watcher->lane : 0]);
}

void watch(Machine& machine, std::uint32_t which, Mask active) {
    Watcher* watcher = machine.watcher;
    if (!watcher || (active >> watcher->lane & 1) == 0) return;
    const Watched& watched = machine.watched[which];
    Sighting& seen = watcher->sightings.emplace_back(Sighting{.watched = which, .light = machine.light});
    for (Slot i = 0; i < watched.count; ++i) seen.values.push_back(machine.at(watched.slot + i)[watcher->lane]);
}

// Each lane has bounds of its own. The block runs until all lanes are done; a lane that is done keeps its values.
void run_loop(Machine& machine, const Loop& loop, Mask active) {
    move(machine, loop.initial, kAllLanes);
    std::copy_n(machine.at(loop.begin), kLanes, machine.at(loop.index));
    while (true) {
        double* index = machine.at(loop.index);
        const double* end = machine.at(loop.end);
        Mask running = active & lanes_where([&](unsigned lane) { return index[lane] < end[lane]; });
        if (loop.goes_on != kNowhere) {
            const double* goes_on = machine.at(loop.goes_on);
            running &= lanes_where([&](unsigned lane) { return goes_on[lane] != 0; });
        }
        if (loop.is_over_lights) machine.light = running == 0 ? -1 : light_of(machine, index);
        if (running == 0) return;
        run_block(machine, loop.block, running);
        move(machine, loop.next, running);
        move(machine, loop.staged, running);
        for (unsigned lane = 0; lane < kLanes; ++lane) index[lane] += 1;
    }
}

void run_step(Machine& machine, const Step& step, Mask active) {
    switch (step.kind) {
        case Step::Kind::Compute:
            step.kernel(step, machine);
            if (step.rounds_to_half) {
                double* values = machine.at(step.to);
                std::transform(values, values + std::size_t{step.count} * kLanes, values, to_half);
            }
            return;
        case Step::Kind::Copy: std::copy_n(machine.at(step.from[0]), step.count * kLanes, machine.at(step.to)); return;
        case Step::Kind::Branch: run_branch(machine, machine.branches[step.data], active); return;
        case Step::Kind::Loop: run_loop(machine, machine.loops[step.data], active); return;
        case Step::Kind::Call: {
            const CallSite& site = machine.calls[step.data];
            move(machine, site.arguments, kAllLanes);
            run_block(machine, site.block, active);
            if (site.result.count > 0) move(machine, site.result, kAllLanes);
            return;
        }
        case Step::Kind::Discard: {
            // A discarded lane goes on as a helper, because its neighbours need it for their derivatives.
            const double* condition = machine.at(step.from[0]);
            machine.discarded |= active & lanes_where([&](unsigned lane) { return condition[lane] != 0; });
            return;
        }
        case Step::Kind::Watch: watch(machine, step.data, active); return;
    }
}

void run_block(Machine& machine, std::uint32_t block, Mask active) {
    const std::vector<Step>& steps = machine.blocks[block];
    Cancellation::step(1 + steps.size() / kStepsOfOne);
    if (machine.steps_left <= steps.size()) throw OutOfSteps{};
    machine.steps_left -= 1 + steps.size();
    for (const Step& step : steps) run_step(machine, step, active);
}

}  // namespace

void execute(Machine& machine) {
    machine.discarded = 0;
    run_block(machine, machine.entry, kAllLanes);
}

QuadResult run(const ir::Module& module, ir::FunctionId function, const std::array<std::vector<Flat>, 4>& arguments,
               const Resources& resources, Precision precision, std::uint64_t* steps_left) {
    Machine machine = make_machine(module, function, precision);
    for (std::uint32_t i = 0; i < module.globals.size(); ++i) {
        if (i < resources.uniforms.size()) set_uniform(machine, module, ir::GlobalId{i}, resources.uniforms[i]);
        if (i < resources.textures.size()) set_texture(machine, ir::GlobalId{i}, resources.textures[i]);
    }
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        std::size_t component = 0;
        for (const Flat& argument : arguments[lane]) {
            for (double value : argument) {
                if (component < machine.argument_types.size()) machine.set_argument(component++, lane, value);
            }
        }
    }
    QuadResult result;
    if (steps_left) machine.steps_left = *steps_left;
    try {
        execute(machine);
    } catch (const OutOfSteps&) {
        result.is_whole = false;
        return result;
    }
    if (steps_left) *steps_left = machine.steps_left;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        for (std::uint32_t i = 0; i < machine.output.count; ++i) result.lanes[lane].push_back(machine.result(i, lane));
        result.discarded[lane] = (machine.discarded >> lane & 1) != 0;
    }
    return result;
}

}  // namespace patina::interpret

// Assigns memory to the values of a function and of the functions that it calls, and turns instructions into steps.
#include <algorithm>

#include "compiler/interpret/interpret.h"
#include "compiler/interpret/kernels.h"
#include "compiler/interpret/machine.h"
#include "compiler/interpret/rounding.h"

namespace patina::interpret {
namespace {

using ir::Inst;
using ir::Op;
using ir::Type;
using ir::Value;

struct FunctionPlace {
    bool is_called = false;
    Slot params = kNowhere;
    Slot result = kNowhere;         // the place of the returned value
    std::uint32_t first_block = 0;  // of the function's blocks among the machine's
};

// What all lanes of a slot hold before the first run.
struct Preset {
    Slot slot;
    double value;
};

// A For whose block is being planned.
struct OpenLoop {
    Slot index;
    Slot carried;
    std::span<const Value> initial;
};

class Planner {
public:
    Planner(const ir::Module& module, Precision precision) : module_(module) {
        machine_.precision = precision;
        machine_.globals.assign(module.globals.size(), kNowhere);
        machine_.textures.resize(module.globals.size());
        functions_.resize(module.functions.size());
        constants_.assign(module.constants.size(), kNowhere);
    }

    Machine plan(ir::FunctionId entry);

private:
    Slot reserve(std::size_t count);
    std::size_t size(Type type) const { return flat_size(module_, type); }
    Slot total_size(std::span<const Value> values) const;

    void find_called(ir::FunctionId entry);
    void plan_function(std::uint32_t index);
    void plan_block(ir::BlockId block);
    void plan_inst(Value value);

    Slot& slot(Value value) { return slots_[value.index]; }
    const Inst& inst(Value value) const { return (*function_)[value]; }
    std::uint32_t block_index(std::uint32_t block) const { return place_->first_block + block; }
    void add(Step step) { machine_.blocks[block_index(block_.index)].push_back(step); }
    Slot operand(Value value, std::size_t which) { return slot(function_->args(value)[which]); }
    Type operand_type(Value value, std::size_t which) const { return inst(function_->args(value)[which]).type; }
    void copy(Slot to, Slot from, std::size_t count);
    void compute(Value value, Kernel kernel);

    // Ops that are not just one kernel.
    struct OpPlan {
        Op op;
        void (Planner::*plan)(Value);
    };
    static const OpPlan kOpPlans[];
    void constant(Value value);
    void param(Value value);
    void global(Value value);
    void semantic(Value value);
    void construct(Value value);
    void extract(Value value);
    void insert(Value value);
    void swizzle(Value value);
    void convert(Value value);
    void call(Value value);
    void branch(Value value);
    void loop(Value value);
    void loop_index(Value value);
    void loop_carried(Value value);
    void result(Value value);
    void yield(Value value);
    void give_back(Value value);
    void watch();
    void discard_if(Value value);

    Slot part(Type composite, Slot first, std::uint32_t index) const;
    std::span<const Value> yielded(ir::BlockId block) const;
    std::vector<Move> moves(std::span<const Value> values, Slot to) const;

    const ir::Module& module_;
    Machine machine_;
    std::vector<FunctionPlace> functions_;
    std::vector<Slot> constants_;  // by Module::constants
    std::vector<Preset> presets_;
    std::size_t next_ = 0;  // slot

    // The function and block that are being planned.
    const ir::Function* function_ = nullptr;
    FunctionPlace* place_ = nullptr;
    std::vector<Slot> slots_;  // by value
    ir::BlockId block_{0};
    std::vector<OpenLoop> open_loops_;
};

Slot Planner::reserve(std::size_t count) {
    const std::size_t first = next_;
    next_ += count;
    return static_cast<Slot>(first);
}

Machine Planner::plan(ir::FunctionId entry) {
    find_called(entry);
    for (std::uint32_t i = 0; i <= entry.index; ++i) {
        if (functions_[i].is_called) plan_function(i);
    }
    const FunctionPlace& place = functions_[entry.index];
    machine_.entry = place.first_block;
    machine_.first_argument = place.params;
    for (const ir::Param& param : module_[entry].params) {
        append_slot_types(module_, param.type, machine_.argument_types);
    }
    if (place.result != kNowhere) {
        machine_.output = {.from = place.result, .count = static_cast<std::uint32_t>(size(module_[entry].result))};
    }
    machine_.memory.assign(next_ * kLanes, 0.0);
    for (const Preset& preset : presets_) std::fill_n(machine_.at(preset.slot), kLanes, preset.value);
    return std::move(machine_);
}

Slot Planner::total_size(std::span<const Value> values) const {
    std::size_t sum = 0;
    for (Value value : values) sum += size(inst(value).type);
    return static_cast<Slot>(sum);
}

// A callee comes before its callers, so one walk backwards finds all.
void Planner::find_called(ir::FunctionId entry) {
    functions_[entry.index].is_called = true;
    for (std::uint32_t i = entry.index + 1; i-- > 0;) {
        if (!functions_[i].is_called) continue;
        for (const Inst& inst : module_.functions[i].insts) {
            if (inst.op == Op::Call) functions_[inst.data].is_called = true;
        }
    }
}

void Planner::plan_function(std::uint32_t index) {
    function_ = &module_.functions[index];
    place_ = &functions_[index];
    std::size_t params = 0;
    for (const ir::Param& param : function_->params) params += size(param.type);
    place_->params = reserve(params);
    place_->first_block = static_cast<std::uint32_t>(machine_.blocks.size());
    machine_.blocks.resize(machine_.blocks.size() + function_->blocks.size());
    slots_.assign(function_->insts.size(), kNowhere);
    plan_block(ir::BlockId{0});
}

void Planner::plan_block(ir::BlockId block) {
    const ir::BlockId outer = block_;
    block_ = block;
    for (Value value : function_->blocks[block.index].insts) plan_inst(value);
    block_ = outer;
}

// --- instructions. One makes no step if its value already has a place.

const Planner::OpPlan Planner::kOpPlans[] = {
    {Op::Constant, &Planner::constant},
    {Op::Param, &Planner::param},
    {Op::Global, &Planner::global},
    {Op::Semantic, &Planner::semantic},
    {Op::Construct, &Planner::construct},
    {Op::Extract, &Planner::extract},
    {Op::Insert, &Planner::insert},
    {Op::Swizzle, &Planner::swizzle},
    {Op::Convert, &Planner::convert},
    {Op::Bitcast, &Planner::convert},
    {Op::Call, &Planner::call},
    {Op::If, &Planner::branch},
    {Op::For, &Planner::loop},
    {Op::LoopIndex, &Planner::loop_index},
    {Op::LoopCarried, &Planner::loop_carried},
    {Op::Result, &Planner::result},
    {Op::Yield, &Planner::yield},
    {Op::Return, &Planner::give_back},
    {Op::DiscardIf, &Planner::discard_if},
};

void Planner::plan_inst(Value value) {
    const Op op = inst(value).op;
    const auto row =
        std::find_if(std::begin(kOpPlans), std::end(kOpPlans), [&](const OpPlan& r) { return r.op == op; });
    if (row != std::end(kOpPlans)) return (this->*row->plan)(value);
    const Type first = operand_type(value, 0);
    Kernel kernel = arithmetic_kernel(op, first.scalar, machine_.precision);
    if (!kernel) kernel = vector_kernel(op, first.scalar, machine_.precision);
    if (!kernel) kernel = sampling_kernel(op, first.kind);
    compute(value, kernel);
}

void Planner::compute(Value value, Kernel kernel) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const auto count = static_cast<std::uint32_t>(size(i.type));
    Step step{.kind = Step::Kind::Compute,
              .rounds_to_half = i.type.is_numeric() && i.type.scalar == ir::Scalar::Half,
              .kernel = kernel,
              .to = reserve(count),
              .count = count,
              .data = ir::part_count(module_, operand_type(value, 0))};
    for (std::size_t a = 0; a < args.size() && a < step.from.size(); ++a) {
        step.from[a] = slot(args[a]);
        if (a < step.shapes.size()) step.shapes[a] = {inst(args[a]).type.rows, inst(args[a]).type.cols};
    }
    slot(value) = step.to;
    add(step);
}

void Planner::copy(Slot to, Slot from, std::size_t count) {
    if (count == 0) return;
    add({.kind = Step::Kind::Copy, .to = to, .count = static_cast<std::uint32_t>(count), .from = {from}});
}

// Convert and Bitcast.
void Planner::convert(Value value) {
    const Inst& i = inst(value);
    const ir::Scalar from = operand_type(value, 0).scalar, to = i.type.scalar;
    if (from == to) {
        slot(value) = operand(value, 0);
    } else if (i.op == Op::Convert) {
        compute(value, conversion_kernel(from, to, machine_.precision));
    } else {
        compute(value, bitcast_kernel(from, to));
    }
}

// --- leaves

void Planner::constant(Value value) {
    const Inst& i = inst(value);
    Slot& place = constants_[i.data];
    if (place == kNowhere) {
        const ir::Constant& constant = module_.constants[i.data];
        const std::span<const double> numbers = module_.numbers_of(constant);
        place = reserve(numbers.size());
        for (std::size_t c = 0; c < numbers.size(); ++c) {
            presets_.push_back(
                {static_cast<Slot>(place + c), fit(constant.type.scalar, machine_.precision, numbers[c])});
        }
    }
    slot(value) = place;
}

void Planner::global(Value value) {
    const std::uint32_t index = inst(value).data;
    Slot& place = machine_.globals[index];
    const Type type = module_.globals[index].type;
    if (place == kNowhere) {
        place = reserve(size(type));
        if (type.is_opaque()) presets_.push_back({place, static_cast<double>(index)});
        const ir::Global& global = module_.globals[index];
        if (global.is_keyword()) presets_.push_back({place, module_.keywords[global.keyword].value});
    }
    slot(value) = place;
}

void Planner::param(Value value) {
    Slot first = place_->params;
    for (std::uint32_t p = 0; p < inst(value).data; ++p) first += static_cast<Slot>(size(function_->params[p].type));
    slot(value) = first;
}

// A linked stage has no semantics; in a function that is not linked they are zero.
void Planner::semantic(Value value) {
    slot(value) = reserve(size(inst(value).type));
}

// --- composites

Slot Planner::part(Type composite, Slot first, std::uint32_t index) const {
    if (composite.kind == ir::Kind::Struct) {
        for (std::uint32_t m = 0; m < index; ++m) {
            first += static_cast<Slot>(size(module_.structs[composite.ref].members[m].type));
        }
        return first;
    }
    return first + static_cast<Slot>(index * size(ir::part_type(module_, composite, index)));
}

void Planner::extract(Value value) {
    slot(value) = part(operand_type(value, 0), operand(value, 0), inst(value).data);
}

void Planner::construct(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const std::size_t count = size(i.type);
    // If the parts already lie end to end, their place is the place of the whole.
    std::size_t laid = 0;
    bool is_whole = !args.empty();
    for (Value arg : args) {
        is_whole = is_whole && slot(arg) == slot(args[0]) + laid;
        laid += size(inst(arg).type);
    }
    if (is_whole && laid == count) {
        slot(value) = slot(args[0]);
        return;
    }
    const Slot to = reserve(count);
    const bool is_splat = args.size() == 1 && i.type.is_vector();
    for (std::size_t c = 0; is_splat && c < count; ++c) copy(to + static_cast<Slot>(c), slot(args[0]), 1);
    Slot next = to;
    for (std::size_t a = 0; !is_splat && a < args.size(); ++a) {
        const std::size_t part_size = size(inst(args[a]).type);
        copy(next, slot(args[a]), part_size);
        next += static_cast<Slot>(part_size);
    }
    slot(value) = to;
}

void Planner::insert(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const Slot to = reserve(size(i.type));
    copy(to, slot(args[0]), size(i.type));
    copy(part(i.type, to, i.data), slot(args[1]), size(inst(args[1]).type));
    slot(value) = to;
}

void Planner::swizzle(Value value) {
    const Inst& i = inst(value);
    const Slot from = operand(value, 0);
    const auto component = [&](unsigned c) { return i.data >> (2 * c) & 3u; };
    bool is_run = true;
    for (unsigned c = 1; c < i.type.width(); ++c) is_run = is_run && component(c) == component(0) + c;
    if (is_run) {
        slot(value) = from + component(0);
        return;
    }
    slot(value) = reserve(i.type.width());
    for (unsigned c = 0; c < i.type.width(); ++c) copy(slot(value) + c, from + component(c), 1);
}

// --- control

// Lays values end to end, from `to` on.
std::vector<Move> Planner::moves(std::span<const Value> values, Slot to) const {
    std::vector<Move> all;
    for (Value value : values) {
        const auto count = static_cast<std::uint32_t>(size(inst(value).type));
        if (count > 0) all.push_back({.to = to, .from = slots_[value.index], .count = count});
        to += count;
    }
    return all;
}

void Planner::call(Value value) {
    const Inst& i = inst(value);
    const FunctionPlace& callee = functions_[i.data];
    CallSite site{.block = callee.first_block, .arguments = moves(function_->args(i), callee.params)};
    slot(value) = reserve(size(i.type));
    if (callee.result != kNowhere) {
        site.result = {.to = slot(value), .from = callee.result, .count = static_cast<std::uint32_t>(size(i.type))};
    }
    const auto index = static_cast<std::uint32_t>(machine_.calls.size());
    machine_.calls.push_back(std::move(site));
    add({.kind = Step::Kind::Call, .data = index});
}

std::span<const Value> Planner::yielded(ir::BlockId block) const {
    const std::vector<Value>& insts = function_->blocks[block.index].insts;
    if (insts.empty() || inst(insts.back()).op != Op::Yield) return {};
    return function_->args(insts.back());
}

void Planner::branch(Value value) {
    const Inst& i = inst(value);
    const std::array<ir::BlockId, 2> blocks = {ir::BlockId{i.data}, ir::BlockId{i.data + 1}};
    Branch made{.condition = operand(value, 0)};
    slot(value) = reserve(total_size(yielded(blocks[0])));
    for (std::size_t side : {0u, 1u}) {
        made.blocks[side] = block_index(blocks[side].index);
        plan_block(blocks[side]);
        made.yields[side] = moves(yielded(blocks[side]), slot(value));
    }
    const auto index = static_cast<std::uint32_t>(machine_.branches.size());
    machine_.branches.push_back(std::move(made));
    add({.kind = Step::Kind::Branch, .data = index});
}

void Planner::loop(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    Loop made{.begin = slot(args[0]),
              .end = slot(args[1]),
              .index = reserve(1),
              .block = block_index(i.data),
              .is_over_lights = i.is_light_loop};
    const std::span<const Value> initial = args.subspan(2);
    const std::uint32_t count = total_size(initial);
    const Slot carried = reserve(count);
    slot(value) = carried;
    made.initial = moves(initial, carried);
    if (i.is_while) made.goes_on = carried + count - 1;
    open_loops_.push_back({.index = made.index, .carried = carried, .initial = initial});
    plan_block(ir::BlockId{i.data});
    open_loops_.pop_back();

    made.next = moves(yielded(ir::BlockId{i.data}), carried);
    // A value that the loop does not change stays where it is.
    std::erase_if(made.next, [](const Move& move) { return move.from == move.to; });
    const bool is_crossed = std::any_of(made.next.begin(), made.next.end(), [&](const Move& move) {
        return move.from >= carried && move.from < carried + count;
    });
    if (is_crossed) {
        made.staged = made.next;
        for (std::size_t m = 0; m < made.next.size(); ++m) {
            const Slot between = reserve(made.next[m].count);
            made.next[m].to = between;
            made.staged[m].from = between;
        }
    }
    const auto index = static_cast<std::uint32_t>(machine_.loops.size());
    machine_.loops.push_back(std::move(made));
    add({.kind = Step::Kind::Loop, .data = index});
}

void Planner::loop_index(Value value) {
    slot(value) = open_loops_.back().index;
}

void Planner::loop_carried(Value value) {
    const OpenLoop& loop = open_loops_.back();
    slot(value) = loop.carried + total_size(loop.initial.first(inst(value).data));
}

void Planner::result(Value value) {
    const Inst& structure = inst(function_->args(value)[0]);
    const std::span<const Value> results = yielded(ir::BlockId{structure.data});
    slot(value) = operand(value, 0) + total_size(results.first(inst(value).data));
}

// The If or For moves the operands.
void Planner::yield(Value) {}

// A probe can be read when the function returns: all values of the frame are still there.
void Planner::watch() {
    const auto function = static_cast<std::uint32_t>(function_ - module_.functions.data());
    for (std::uint32_t p = 0; p < function_->probes.size(); ++p) {
        const Value value = function_->probes[p].value;
        add({.kind = Step::Kind::Watch, .data = static_cast<std::uint32_t>(machine_.watched.size())});
        machine_.watched.push_back({.function = function,
                                    .probe = p,
                                    .slot = slot(value),
                                    .count = static_cast<std::uint32_t>(size(inst(value).type))});
    }
}

void Planner::give_back(Value value) {
    watch();
    if (inst(value).operand_count > 0) place_->result = operand(value, 0);
}

void Planner::discard_if(Value value) {
    add({.kind = Step::Kind::Discard, .from = {operand(value, 0)}});
}

}  // namespace

Machine make_machine(const ir::Module& module, ir::FunctionId entry, Precision precision) {
    return Planner(module, precision).plan(entry);
}

}  // namespace patina::interpret

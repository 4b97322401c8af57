// Lays a function and those that it calls out in memory, and turns their instructions into steps.
#include "compiler/interpret/machine.h"

#include "compiler/interpret/interpret.h"
#include "compiler/interpret/kernels.h"
#include "compiler/interpret/rounding.h"

#include <algorithm>

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

    void find_called(ir::FunctionId entry);
    void plan_function(std::uint32_t index);
    void plan_block(ir::BlockId block);
    void plan_inst(Value value);

    Slot& slot(Value value) { return slots_[value.index]; }
    const Inst& inst(Value value) const { return (*function_)[value]; }
    std::uint32_t block_index(std::uint32_t block) const { return place_->first_block + block; }
    void add(Step step) { machine_.blocks[block_index(block_.index)].push_back(step); }
    void add_copy(Slot to, Slot from, std::size_t count);
    void add_compute(Value value, Kernel kernel);

    void constant(Value value);
    void global(Value value);
    void construct(Value value);
    void insert(Value value);
    void swizzle(Value value);
    void call(Value value);
    void branch(Value value);
    void loop(Value value);
    Slot part(Type composite, Slot first, std::uint32_t index) const;
    std::span<const Value> yielded(ir::BlockId block) const;

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
    std::vector<std::pair<Slot, Slot>> open_loops_;  // index, first carried value
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
    machine_.output = {.from = place.result, .count = static_cast<std::uint32_t>(size(module_[entry].result))};
    machine_.memory.assign(next_ * kLanes, 0.0);
    for (const Preset& preset : presets_) std::fill_n(machine_.at(preset.slot), kLanes, preset.value);
    return std::move(machine_);
}

// A callee stands before its callers, so one walk back finds all.
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

// --- instructions. Those that only name something that has a place already make no step.

void Planner::plan_inst(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const auto kind = [&](std::size_t arg) { return inst(args[arg]).type; };
    switch (i.op) {
        case Op::Constant: return constant(value);
        case Op::Param: {
            Slot first = place_->params;
            for (std::uint32_t p = 0; p < i.data; ++p) first += static_cast<Slot>(size(function_->params[p].type));
            slot(value) = first;
            return;
        }
        case Op::Global: return global(value);
        case Op::Semantic:
            // A linked stage has none; what has not been linked reads zeros.
            slot(value) = reserve(size(i.type));
            return;

        case Op::Construct: return construct(value);
        case Op::Extract: slot(value) = part(kind(0), slot(args[0]), i.data); return;
        case Op::Insert: return insert(value);
        case Op::Swizzle: return swizzle(value);
        case Op::Convert:
            if (kind(0).scalar == i.type.scalar) {
                slot(value) = slot(args[0]);
                return;
            }
            return add_compute(value, conversion_kernel(kind(0).scalar, i.type.scalar, machine_.precision));
        case Op::Bitcast:
            if (kind(0).scalar == i.type.scalar) {
                slot(value) = slot(args[0]);
                return;
            }
            return add_compute(value, bitcast_kernel(kind(0).scalar, i.type.scalar));

        case Op::Call: return call(value);
        case Op::If: return branch(value);
        case Op::For: return loop(value);
        case Op::LoopIndex: slot(value) = open_loops_.back().first; return;
        case Op::LoopCarried: {
            // The carried values are laid end to end in the order of the LoopCarried instructions.
            const auto& insts = function_->blocks[block_.index].insts;
            Slot first = open_loops_.back().second;
            for (Value other : insts) {
                if (inst(other).op == Op::LoopCarried && inst(other).data < i.data) {
                    first += static_cast<Slot>(size(inst(other).type));
                }
            }
            slot(value) = first;
            return;
        }
        case Op::Result: {
            const Inst& structure = inst(args[0]);
            const ir::BlockId block{structure.data};
            Slot first = slot(args[0]);
            const std::span<const Value> values = yielded(block);
            for (std::uint32_t r = 0; r < i.data; ++r) first += static_cast<Slot>(size(inst(values[r]).type));
            slot(value) = first;
            return;
        }
        case Op::Yield: return;  // the If or For moves its operands
        case Op::Return:
            if (!args.empty()) place_->result = slot(args[0]);
            return;
        case Op::DiscardIf:
            add({.kind = Step::Kind::Discard, .from = {slot(args[0])}});
            return;

        case Op::Add:
        case Op::Sub:
        case Op::Mul:
        case Op::Div:
        case Op::Mod:
        case Op::Neg:
        case Op::Less:
        case Op::LessEqual:
        case Op::Greater:
        case Op::GreaterEqual:
        case Op::Equal:
        case Op::NotEqual:
        case Op::And:
        case Op::Or:
        case Op::Not:
        case Op::BitAnd:
        case Op::BitOr:
        case Op::BitXor:
        case Op::BitNot:
        case Op::ShiftLeft:
        case Op::ShiftRight:
        case Op::Abs:
        case Op::Sign:
        case Op::Floor:
        case Op::Ceil:
        case Op::Round:
        case Op::Trunc:
        case Op::Frac:
        case Op::Saturate:
        case Op::Sqrt:
        case Op::Rsqrt:
        case Op::Exp:
        case Op::Exp2:
        case Op::Log:
        case Op::Log2:
        case Op::Sin:
        case Op::Cos:
        case Op::Tan:
        case Op::Asin:
        case Op::Acos:
        case Op::Atan:
        case Op::Sinh:
        case Op::Cosh:
        case Op::Tanh:
        case Op::Radians:
        case Op::Degrees:
        case Op::Min:
        case Op::Max:
        case Op::Pow:
        case Op::Atan2:
        case Op::Step:
        case Op::Clamp:
        case Op::Lerp:
        case Op::Smoothstep:
        case Op::IsNan:
        case Op::IsInf: return add_compute(value, arithmetic_kernel(i.op, kind(0).scalar, machine_.precision));

        case Op::Select:
        case Op::Index:
        case Op::Any:
        case Op::All:
        case Op::Dot:
        case Op::Length:
        case Op::Distance:
        case Op::Normalize:
        case Op::Cross:
        case Op::Reflect:
        case Op::Refract:
        case Op::MatMul:
        case Op::Transpose:
        case Op::Determinant:
        case Op::Ddx:
        case Op::Ddy:
        case Op::Fwidth: return add_compute(value, vector_kernel(i.op, kind(0).scalar, machine_.precision));

        case Op::Sample:
        case Op::SampleBias:
        case Op::SampleLevel:
        case Op::SampleGrad:
        case Op::TexelLoad:
        case Op::TextureSize: return add_compute(value, sampling_kernel(i.op, kind(0).kind));
    }
}

void Planner::add_compute(Value value, Kernel kernel) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    Step step{.kind = Step::Kind::Compute,
              .rounds_to_half = i.type.is_numeric() && i.type.scalar == ir::Scalar::Half,
              .kernel = kernel,
              .to = reserve(size(i.type)),
              .count = static_cast<std::uint32_t>(size(i.type)),
              .data = args.empty() ? 0 : ir::part_count(module_, inst(args[0]).type)};
    for (std::size_t a = 0; a < args.size() && a < step.from.size(); ++a) {
        step.from[a] = slot(args[a]);
        if (a < step.shapes.size()) step.shapes[a] = {inst(args[a]).type.rows, inst(args[a]).type.cols};
    }
    slot(value) = step.to;
    add(step);
}

void Planner::add_copy(Slot to, Slot from, std::size_t count) {
    if (count == 0) return;
    add({.kind = Step::Kind::Copy, .to = to, .count = static_cast<std::uint32_t>(count), .from = {from}});
}

void Planner::constant(Value value) {
    const Inst& i = inst(value);
    Slot& place = constants_[i.data];
    if (place == kNowhere) {
        const ir::Constant& constant = module_.constants[i.data];
        const std::span<const double> numbers = module_.numbers_of(constant);
        place = reserve(numbers.size());
        for (std::size_t c = 0; c < numbers.size(); ++c) {
            presets_.push_back({static_cast<Slot>(place + c), fit(constant.type.scalar, machine_.precision, numbers[c])});
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
    }
    slot(value) = place;
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

void Planner::construct(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const std::size_t count = size(i.type);
    // Parts that lie end to end already are the whole.
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
    for (std::size_t c = 0; is_splat && c < count; ++c) add_copy(to + static_cast<Slot>(c), slot(args[0]), 1);
    Slot next = to;
    for (std::size_t a = 0; !is_splat && a < args.size(); ++a) {
        const std::size_t part_size = size(inst(args[a]).type);
        add_copy(next, slot(args[a]), part_size);
        next += static_cast<Slot>(part_size);
    }
    slot(value) = to;
}

void Planner::insert(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    const Slot to = reserve(size(i.type));
    add_copy(to, slot(args[0]), size(i.type));
    add_copy(part(i.type, to, i.data), slot(args[1]), size(inst(args[1]).type));
    slot(value) = to;
}

void Planner::swizzle(Value value) {
    const Inst& i = inst(value);
    const Slot from = slot(function_->args(i)[0]);
    const auto component = [&](unsigned c) { return i.data >> (2 * c) & 3u; };
    bool is_run = true;
    for (unsigned c = 1; c < i.type.width(); ++c) is_run = is_run && component(c) == component(0) + c;
    if (is_run) {
        slot(value) = from + component(0);
        return;
    }
    slot(value) = reserve(i.type.width());
    for (unsigned c = 0; c < i.type.width(); ++c) add_copy(slot(value) + c, from + component(c), 1);
}

// --- control

void Planner::call(Value value) {
    const Inst& i = inst(value);
    const FunctionPlace& callee = functions_[i.data];
    CallSite site{.block = callee.first_block};
    Slot param = callee.params;
    for (Value arg : function_->args(i)) {
        const auto count = static_cast<std::uint32_t>(size(inst(arg).type));
        site.arguments.push_back({.to = param, .from = slot(arg), .count = count});
        param += count;
    }
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
    Branch made{.condition = slot(function_->args(i)[0])};
    std::size_t count = 0;
    for (Value result : yielded(blocks[0])) count += size(inst(result).type);
    slot(value) = reserve(count);
    for (std::size_t side : {0u, 1u}) {
        made.blocks[side] = block_index(blocks[side].index);
        plan_block(blocks[side]);
        Slot to = slot(value);
        for (Value result : yielded(blocks[side])) {
            const auto result_count = static_cast<std::uint32_t>(size(inst(result).type));
            made.yields[side].push_back({.to = to, .from = slot(result), .count = result_count});
            to += result_count;
        }
    }
    const auto index = static_cast<std::uint32_t>(machine_.branches.size());
    machine_.branches.push_back(std::move(made));
    add({.kind = Step::Kind::Branch, .data = index});
}

void Planner::loop(Value value) {
    const Inst& i = inst(value);
    const std::span<const Value> args = function_->args(i);
    Loop made{.begin = slot(args[0]), .end = slot(args[1]), .index = reserve(1), .block = block_index(i.data)};
    std::size_t count = 0;
    for (Value initial : args.subspan(2)) count += size(inst(initial).type);
    const Slot carried = reserve(count);
    slot(value) = carried;
    Slot to = carried;
    for (Value initial : args.subspan(2)) {
        const auto part_size = static_cast<std::uint32_t>(size(inst(initial).type));
        made.initial.push_back({.to = to, .from = slot(initial), .count = part_size});
        to += part_size;
    }
    open_loops_.emplace_back(made.index, carried);
    plan_block(ir::BlockId{i.data});
    open_loops_.pop_back();

    to = carried;
    bool is_crossed = false;
    for (Value next : yielded(ir::BlockId{i.data})) {
        const auto part_size = static_cast<std::uint32_t>(size(inst(next).type));
        const Slot from = slot(next);
        if (from != to) made.next.push_back({.to = to, .from = from, .count = part_size});
        is_crossed = is_crossed || (from != to && from >= carried && from < carried + count);
        to += part_size;
    }
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

}  // namespace

Machine make_machine(const ir::Module& module, ir::FunctionId entry, Precision precision) {
    return Planner(module, precision).plan(entry);
}

std::size_t flat_size(const ir::Module& module, Type type) {
    switch (type.kind) {
        case ir::Kind::Void:
        case ir::Kind::Error: return 0;
        case ir::Kind::Numeric: return type.components();
        case ir::Kind::Texture2D:
        case ir::Kind::TextureCube:
        case ir::Kind::Sampler: return 1;
        case ir::Kind::Array: {
            const ir::Array& array = module.arrays[type.ref];
            return array.count * flat_size(module, array.element);
        }
        case ir::Kind::Struct: {
            std::size_t sum = 0;
            for (const ir::Member& member : module.structs[type.ref].members) sum += flat_size(module, member.type);
            return sum;
        }
    }
    return 0;
}

void append_slot_types(const ir::Module& module, Type type, std::vector<Type>& into) {
    if (type.is_numeric()) {
        into.insert(into.end(), type.components(), Type::scalar_of(type.scalar));
    } else if (type.is_opaque()) {
        into.push_back(type);
    } else {
        for (std::uint32_t i = 0; i < ir::part_count(module, type); ++i) {
            append_slot_types(module, ir::part_type(module, type, i), into);
        }
    }
}

}  // namespace patina::interpret

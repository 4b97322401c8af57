#include "compiler/ir/builder.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "compiler/base/bits.h"
#include "compiler/base/cancellation.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/fold/fold.h"

namespace patina::ir {
namespace {

constexpr std::uint32_t mix(std::uint32_t hash, std::uint32_t value) {
    const std::uint64_t product = (static_cast<std::uint64_t>(hash) ^ value) * 0x9e3779b97f4a7c15ull;
    return static_cast<std::uint32_t>(product >> 32) ^ static_cast<std::uint32_t>(product);
}

std::uint32_t hash_of(Type type) {
    const std::uint32_t shape = static_cast<std::uint32_t>(type.kind) | static_cast<std::uint32_t>(type.scalar) << 8 |
                                static_cast<std::uint32_t>(type.rows) << 16 |
                                static_cast<std::uint32_t>(type.cols) << 24;
    return mix(mix(0x5bd1e995u, shape), type.ref);
}

// Operands are hashed in order, except those of a commuting op, which are sorted by index. So a + b and b + a are
// equal.
std::uint32_t hash_of(Op op, Type type, std::span<const Value> args, std::uint32_t data) {
    std::uint32_t hash = mix(mix(hash_of(type), static_cast<std::uint32_t>(op)), data);
    if (has(op, Commutes)) {
        hash = mix(hash, std::min(args[0], args[1]).index);
        return mix(hash, std::max(args[0], args[1]).index);
    }
    for (const Value arg : args) hash = mix(hash, arg.index);
    return hash;
}

bool same_operands(Op op, std::span<const Value> a, std::span<const Value> b) {
    if (std::equal(a.begin(), a.end(), b.begin(), b.end())) return true;
    return has(op, Commutes) && a[0] == b[1] && a[1] == b[0];
}

// Compares bits: -0 and 0 are two constants.
bool same_numbers(std::span<const double> a, std::span<const double> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](double x, double y) { return bits_as<std::uint64_t>(x) == bits_as<std::uint64_t>(y); });
}

// Instead of an index, for a constant that the module does not have yet.
constexpr std::uint32_t kNewConstant = 0xffffffffu;

bool is_leaf(Op op) {
    return op == Op::Constant || op == Op::Param || op == Op::Global || op == Op::Semantic;
}

[[noreturn]] void refuse(const Module& module, const Function& function, std::string_view what) {
    const std::string text = dump(module, function);
    std::fprintf(stderr, "%s\nwhile building: %.*s\n", text.c_str(), static_cast<int>(what.size()), what.data());
    std::abort();
}

// Of emptied tables that a thread keeps for its next builders.
constexpr std::size_t kMaxSpare = 8;

}  // namespace

Builder::Builder(Module& module, Function& function, BuildOptions options)
    : module_(module), function_(function), options_(options) {
    if (function_.blocks.empty()) function_.blocks.emplace_back();
    // Enough for most functions, which would otherwise allocate seven times while they grow.
    if (function_.insts.capacity() == 0) {
        function_.insts.reserve(32);
        function_.operands.reserve(64);
        current().reserve(32);
    }
    if (!options_.fold) return;
    if (std::vector<Tables>& spare = spare_tables(); !spare.empty()) {
        tables_ = std::move(spare.back());
        spare.pop_back();
    }
    tables_.numbered.reserve(function_.insts.capacity());
}

Builder::~Builder() {
    constexpr std::size_t kMaxKept = 4096;  // the tables of a very long function are not kept
    std::vector<Tables>& spare = spare_tables();
    if (!options_.fold || spare.size() >= kMaxSpare || function_.insts.capacity() > kMaxKept) return;
    tables_.numbered.shrink(0);
    tables_.leaves.shrink(0);
    tables_.head.clear();
    spare.push_back(std::move(tables_));
}

std::vector<Builder::Tables>& Builder::spare_tables() {
    // With room for all of them, because a destructor adds them.
    thread_local std::vector<Tables> spare = [] {
        std::vector<Tables> room;
        room.reserve(kMaxSpare);
        return room;
    }();
    return spare;
}

constexpr std::uint32_t kInstsPerStep = 32;

Value Builder::append(Inst inst, std::span<const Value> args, std::vector<Value>& where) {
    const Value value{static_cast<std::uint32_t>(function_.insts.size())};
    inst.first_operand = static_cast<std::uint32_t>(function_.operands.size());
    inst.operand_count = static_cast<std::uint32_t>(args.size());
    inst.origin = origin_;
    for (const Value arg : args) function_.operands.push_back(arg);  // few: faster than insert()
    function_.insts.push_back(inst);
    where.push_back(value);
    // Not at each one: a question costs as much as an instruction.
    if (value.index % kInstsPerStep == 0) Cancellation::step(value.index == 0 ? 1 : kInstsPerStep);
    return value;
}

void Builder::check_rule([[maybe_unused]] Op op, [[maybe_unused]] Type type,
                         [[maybe_unused]] std::span<const Value> args) const {
#ifdef PATINA_VERIFY
    if (info(op).rule == TypeRule::Declared || info(op).rule == TypeRule::Void) return;
    std::vector<Type> types;
    for (const Value arg : args) {
        types.push_back(this->type(arg));
        if (types.back().is_error()) return;
    }
    if (type.is_error() || result_type(op, types) == type) return;
    std::string what = std::string(info(op).text) + " of (";
    for (std::size_t i = 0; i < types.size(); i++) what += (i == 0 ? "" : ", ") + module_.type_name(types[i]);
    refuse(module_, function_, what + ") is not a " + module_.type_name(type));
#endif
}

Value Builder::emit(Op op, Type type, std::span<const Value> args, std::uint32_t data) {
    check_rule(op, type, args);
    // The operands may be stored with another instruction and would move while this one is appended, so they are
    // copied.
    const Value* const operands = function_.operands.data();
    if (!args.empty() && args.data() >= operands && args.data() < operands + function_.operands.size()) {
        const std::vector<Value> copy(args.begin(), args.end());
        return emit_numbered(op, type, copy, data);
    }
    return emit_numbered(op, type, args, data);
}

Value Builder::emit(Op op, std::initializer_list<Value> args) {
    Type types[8];
    std::size_t count = 0;
    for (const Value arg : args) {
        if (count < std::size(types)) types[count++] = type(arg);
    }
    return emit(op, result_type(op, {types, count}), std::span<const Value>(args.begin(), args.size()));
}

Value Builder::emit_numbered(Op op, Type type, std::span<const Value> args, std::uint32_t data, bool is_settled) {
    const Inst inst{.op = op, .type = type, .data = data};
    if (!options_.fold) return append(inst, args, current());
    if (is_leaf(op)) return emit_leaf(op, type, data);
    if (has(op, Effect) || has(op, Structure)) return append(inst, args, current());
    if (!is_settled) {
        if (const Value known = simplify(*this, op, type, args, data)) return known;
    }
    const std::uint32_t hash = hash_of(op, type, args, data);
    const Value same = tables_.numbered.find(hash, [&](Value v) {
        const Inst& other = function_.insts[v.index];
        return other.op == op && other.type == type && other.data == data &&
               same_operands(op, function_.args(other), args);
    });
    if (same) return same;
    const Value value = append(inst, args, current());
    tables_.numbered.insert(hash, value);
    return value;
}

Value Builder::emit_leaf(Op op, Type type, std::uint32_t data) {
    if (op == Op::Constant) return emit_constant(type, module_.numbers_of(module_.constants[data]), data);
    const std::uint32_t hash = hash_of(op, type, {}, data);
    const Value same = tables_.leaves.find(hash, [&](Value v) {
        const Inst& other = function_.insts[v.index];
        return other.op == op && other.type == type && other.data == data;
    });
    if (same) return same;
    const Value value = append({.op = op, .type = type, .data = data}, {}, tables_.head);
    tables_.leaves.insert(hash, value);
    return value;
}

// `data` is the constant's index if the module has it already. While folding, numbers are rounded to what the type can
// hold, because folding computes with them, and equal constants become one.
Value Builder::emit_constant(Type type, std::span<const double> components, std::uint32_t data) {
    double rounded[16];
    const std::size_t count = std::min<std::size_t>(components.size(), std::size(rounded));
    for (std::size_t i = 0; i < count; i++) {
        rounded[i] = options_.fold ? round_to(type.scalar, components[i]) : components[i];
    }
    const std::span<const double> numbers(rounded, count);
    if (data != kNewConstant && !same_numbers(numbers, components)) data = kNewConstant;

    std::uint32_t hash = hash_of(type);
    for (const double number : numbers) {
        const auto bits = bits_as<std::uint64_t>(number);
        hash = mix(mix(hash, static_cast<std::uint32_t>(bits)), static_cast<std::uint32_t>(bits >> 32));
    }
    if (options_.fold) {
        const Value same = tables_.leaves.find(hash, [&](Value v) {
            const Inst& other = function_.insts[v.index];
            return other.op == Op::Constant && other.type == type && same_numbers(constant_of(v), numbers);
        });
        if (same) return same;
    }
    if (data == kNewConstant) {
        data = static_cast<std::uint32_t>(module_.constants.size());
        module_.constants.push_back({type, static_cast<std::uint32_t>(module_.numbers.size())});
        module_.numbers.insert(module_.numbers.end(), numbers.begin(), numbers.end());
    }
    const Inst inst{.op = Op::Constant, .type = type, .data = data};
    if (!options_.fold) return append(inst, {}, current());
    const Value value = append(inst, {}, tables_.head);
    tables_.leaves.insert(hash, value);
    return value;
}

Value Builder::constant(Type type, std::span<const double> components) {
    if (!type.is_numeric() || components.size() != type.components()) {
        refuse(module_, function_, "a constant's components do not fit its type");
    }
    return emit_constant(type, components, kNewConstant);
}

Value Builder::splat_constant(Type type, double value) {
    double components[16];
    std::fill(std::begin(components), std::end(components), value);
    return constant(type, std::span<const double>(components, type.components()));
}

Value Builder::param(std::uint32_t index) {
    return emit(Op::Param, function_.params[index].type, {}, index);
}

Value Builder::extract(Value composite, std::uint32_t index) {
    return emit(Op::Extract, part_type(module_, type(composite), index), {composite}, index);
}

Value Builder::zero(Type type) {
    if (type.is_numeric() && !type.is_matrix()) return splat_constant(type, 0);
    std::vector<Value> parts;
    for (std::uint32_t i = 0; i < part_count(module_, type); ++i) parts.push_back(zero(part_type(module_, type, i)));
    return construct(type, parts);
}

Value Builder::splat(Value scalar, unsigned width) {
    return width == 1 ? scalar : construct(type(scalar).with_width(width), {&scalar, 1});
}

Value Builder::swizzle(Value vector, std::span<const unsigned> components) {
    if (components.size() == 1) return type(vector).is_scalar() ? vector : extract(vector, components[0]);
    if (type(vector).is_scalar()) return splat(vector, static_cast<unsigned>(components.size()));
    std::uint32_t data = 0;
    for (std::size_t i = 0; i < components.size(); i++) data |= (components[i] & 3u) << (2 * i);
    return emit(Op::Swizzle, type(vector).with_width(static_cast<unsigned>(components.size())), {vector}, data);
}

Value Builder::convert(Value value, Scalar to) {
    const Type from = type(value);
    return from.scalar == to ? value : emit(Op::Convert, from.with_scalar(to), {value});
}

Value Builder::call(FunctionId callee, std::span<const Value> args) {
    return emit(Op::Call, module_[callee].result, args, callee.index);
}

BlockId Builder::add_block() {
    function_.blocks.emplace_back();
    return {static_cast<std::uint32_t>(function_.blocks.size() - 1)};
}

void Builder::yield(BlockId block, std::span<const Value> values) {
    append({.op = Op::Yield, .type = Type::none()}, values, function_.blocks[block.index].insts);
}

Value Builder::begin_if(Value condition) {
    const BlockId then_block = add_block();
    add_block();
    const Inst inst{.op = Op::If, .type = Type::none(), .data = then_block.index};
    const Value structure = append(inst, {&condition, 1}, current());
    open_.push_back(
        {.structure = structure, .outer = block_, .loop_index = {}, .carried = {}, .scope = tables_.numbered.size()});
    block_ = then_block;
    return structure;
}

void Builder::begin_else() {
    tables_.numbered.shrink(open_.back().scope);
    block_ = {function_[open_.back().structure].data + 1};
}

Value Builder::end_if(std::span<const Value> then_values, std::span<const Value> else_values) {
    const Open open = std::move(open_.back());
    open_.pop_back();
    const BlockId then_block{function_[open.structure].data};
    yield(then_block, then_values);
    yield({then_block.index + 1}, else_values);
    tables_.numbered.shrink(open.scope);
    block_ = open.outer;
    return open.structure;
}

Value Builder::begin_for(Value begin, Value end, std::span<const Value> initial, bool is_light_loop, bool is_while) {
    std::vector<Value> operands = {begin, end};
    operands.insert(operands.end(), initial.begin(), initial.end());
    const BlockId body = add_block();
    const Inst inst{
        .op = Op::For, .is_light_loop = is_light_loop, .is_while = is_while, .type = Type::none(), .data = body.index};
    const Value structure = append(inst, operands, current());
    Open open{
        .structure = structure, .outer = block_, .loop_index = {}, .carried = {}, .scope = tables_.numbered.size()};
    block_ = body;
    open.loop_index = append({.op = Op::LoopIndex, .type = type(begin)}, {}, current());
    for (std::uint32_t i = 0; i + 2 < operands.size(); i++) {
        const Inst carried{.op = Op::LoopCarried, .type = type(operands[i + 2]), .data = i};
        open.carried.push_back(append(carried, {}, current()));
    }
    open_.push_back(std::move(open));
    return structure;
}

const Builder::Open& Builder::innermost_loop() const {
    for (std::size_t i = open_.size(); i-- > 0;) {
        if (open_[i].loop_index) return open_[i];
    }
    refuse(module_, function_, "a loop's value is asked for outside of any loop");
}

Value Builder::loop_index() const {
    return innermost_loop().loop_index;
}

Value Builder::loop_carried(std::uint32_t index) const {
    return innermost_loop().carried[index];
}

Value Builder::end_for(std::span<const Value> next) {
    const Open open = std::move(open_.back());
    open_.pop_back();
    yield(block_, next);
    tables_.numbered.shrink(open.scope);
    block_ = open.outer;
    return open.structure;
}

Value Builder::result(Value structure, std::uint32_t index) {
    const Inst& inst = function_[structure];
    const auto yielded = [&](std::uint32_t block) {
        return function_.args(function_.blocks[block].insts.back())[index];
    };
    const Value last = yielded(inst.data);
    if (options_.fold) {
        // if (c) { yield x } else { yield x } = x: a value that both branches see was made before them.
        if (inst.op == Op::If && yielded(inst.data + 1) == last) return last;
        // A carried value that each iteration hands on unchanged is its initial one.
        if (inst.op == Op::For && function_[last].op == Op::LoopCarried && function_[last].data == index) {
            const std::vector<Value>& body = function_.blocks[inst.data].insts;
            if (body[index + 1] == last) return function_.args(inst)[index + 2];
        }
    }
    return emit(Op::Result, type(last), {structure}, index);
}

void Builder::ret(Value value) {
    append({.op = Op::Return, .type = Type::none()}, std::span<const Value>(&value, value ? 1 : 0), current());
    std::vector<Value>& body = function_.blocks[0].insts;
    body.insert(body.begin(), tables_.head.begin(), tables_.head.end());
    tables_.head.clear();
}

void Builder::name(Value value, NameId name) {
    if (!value || is_leaf(function_[value].op)) return;
    Inst& inst = function_.insts[value.index];
    if (!inst.name || module_.name_of(inst.name).empty()) inst.name = name;
}

void Builder::rename(Value value, NameId name) {
    function_.insts[value.index].name = {};
    this->name(value, name);
}

std::span<const double> Builder::constant_of(Value v) const {
    const Inst& inst = function_[v];
    if (inst.op != Op::Constant) return {};
    return module_.numbers_of(module_.constants[inst.data]);
}

bool Builder::is_constant(Value v, double every_component) const {
    const std::span<const double> numbers = constant_of(v);
    return !numbers.empty() &&
           std::all_of(numbers.begin(), numbers.end(), [&](double number) { return number == every_component; });
}

}  // namespace patina::ir

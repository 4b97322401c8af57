#include "compiler/ir/composites.h"

#include <algorithm>
#include <array>
#include <utility>

namespace patina::ir {
namespace {

// How far a chain of inserts is followed, so that the time to build a function stays linear.
constexpr int kMaxChain = 32;
// Up to how many parts an insert becomes a new construct, for the same reason.
constexpr std::uint32_t kMaxParts = 16;

unsigned component(std::uint32_t swizzle, unsigned i) {
    return swizzle >> (2 * i) & 3u;
}

// One component of a vector, or a scalar.
struct Component {
    Value value;
    unsigned index = 0;
};

// Component `index` of a vector that a construct lays out.
Component part_at(const Builder& b, std::span<const Value> parts, unsigned index) {
    if (parts.size() == 1 && b.type(parts[0]).is_scalar()) return {parts[0], 0};
    for (const Value part : parts) {
        const unsigned width = b.type(part).width();
        if (index < width) return {part, index};
        index -= width;
    }
    return {};
}

// Where component `index` of the value comes from, one step back.
Component source_of(const Builder& b, Value value, unsigned index) {
    const Inst& inst = b[value];
    if (inst.op == Op::Extract && b.type(b.args(value)[0]).is_vector()) return {b.args(value)[0], inst.data};
    if (inst.op == Op::Swizzle) return {b.args(value)[0], component(inst.data, index)};
    return {value, index};
}

Value take(Builder& b, Component c) {
    return b.type(c.value).is_scalar() ? c.value : b.extract(c.value, c.index);
}

// extract(construct(p, q, ...), k) = part k        extract(insert(a, v, k), k) = v, or of a if it is another part
// extract(swizzle(v, yzx), k) = extract(v, yzx[k])
Value extract(Builder& b, Value whole, std::uint32_t index) {
    const Type type = b.type(whole);
    if (type.is_scalar()) return whole;
    Value from = whole;
    for (int step = 0; b[from].op == Op::Insert; step++) {
        if (b[from].data == index) return b.args(from)[1];
        if (step == kMaxChain) return {};
        from = b.args(from)[0];
    }
    if (b[from].op == Op::Construct) {
        const auto parts = b.args(from);
        if (!type.is_vector()) return parts[index];
        return take(b, part_at(b, parts, index));
    }
    if (b[from].op == Op::Swizzle) return take(b, source_of(b, from, index));
    return from == whole ? Value() : b.extract(from, index);
}

// insert(construct(p, q, ...), v, k) = construct(p, v, ...)        insert(insert(a, v, k), w, k) = insert(a, w, k)
// insert(a, extract(a, k), k) = a
Value insert(Builder& b, Type type, std::span<const Value> args, std::uint32_t index) {
    const auto [whole, part] = std::pair(args[0], args[1]);
    if (b[part].op == Op::Extract && b[part].data == index && b.args(part)[0] == whole) return whole;
    if (b[whole].op == Op::Insert && b[whole].data == index)
        return b.emit(Op::Insert, type, {b.args(whole)[0], part}, index);
    if (b[whole].op == Op::Construct) {
        const auto parts = b.args(whole);
        if (parts.size() != part_count(b.module(), type) || parts.size() > kMaxParts) return {};
        std::vector<Value> changed(parts.begin(), parts.end());
        changed[index] = part;
        return b.construct(type, changed);
    }
    return {};
}

Value swizzle_of(Builder& b, Value vector, std::span<const unsigned> components) {
    bool is_identity = components.size() == b.type(vector).width();
    for (unsigned i = 0; i < components.size(); i++) is_identity = is_identity && components[i] == i;
    return is_identity ? vector : b.swizzle(vector, components);
}

// If the components are parts of one vector: its swizzle.
Value gather(Builder& b, std::span<const Component> components) {
    std::array<unsigned, 4> indices{};
    for (std::size_t i = 0; i < components.size(); i++) {
        if (components[i].value != components[0].value) return {};
        indices[i] = components[i].index;
    }
    return swizzle_of(b, components[0].value, {indices.data(), components.size()});
}

// swizzle(v, xyz) = v        swizzle(swizzle(v, yzx), xy) = swizzle(v, yz)        swizzle(construct(s), xx) =
// construct(s) swizzle(construct(s, t, v), yx) = construct(t, s)        swizzle(construct(s, v), yz) = swizzle(v, xy)
Value swizzle(Builder& b, Type type, Value vector, std::uint32_t data) {
    const unsigned width = type.width();
    const Op op = b[vector].op;
    std::array<Component, 4> sources;
    bool is_identity = width == b.type(vector).width();
    bool are_scalars = true;
    for (unsigned i = 0; i < width; i++) {
        const unsigned index = component(data, i);
        is_identity = is_identity && index == i;
        sources[i] = op == Op::Construct ? part_at(b, b.args(vector), index) : source_of(b, vector, index);
        are_scalars = are_scalars && b.type(sources[i].value).is_scalar();
    }
    if (is_identity) return vector;
    if (op == Op::Swizzle) return gather(b, {sources.data(), width});
    if (op != Op::Construct) return {};
    if (!are_scalars) return b.type(sources[0].value).is_vector() ? gather(b, {sources.data(), width}) : Value();
    std::array<Value, 4> scalars;
    for (unsigned i = 0; i < width; i++) scalars[i] = sources[i].value;
    return b.construct(type, {scalars.data(), width});
}

// construct(extract(v, 0), extract(v, 1), ...) = v, or a swizzle of v        construct(s, s, s) = construct(s)
Value construct_vector(Builder& b, Type type, std::span<const Value> parts) {
    if (parts.size() == 1) return b.type(parts[0]) == type ? parts[0] : Value();
    std::array<Component, 4> sources;
    unsigned count = 0;
    bool is_splat = true;
    for (const Value part : parts) {
        is_splat = is_splat && part == parts[0] && b.type(part).is_scalar();
        for (unsigned i = 0; i < b.type(part).width() && count < 4; i++) sources[count++] = source_of(b, part, i);
    }
    if (is_splat) return b.construct(type, parts.first(1));
    const bool is_one_vector = b.type(sources[0].value).is_vector();
    return is_one_vector ? gather(b, {sources.data(), count}) : Value();
}

// construct(extract(x, 0), extract(x, 1), ...) = x, for structs, arrays and matrices
Value construct_whole(Builder& b, Type type, std::span<const Value> parts) {
    if (parts.empty() || b[parts[0]].op != Op::Extract) return {};
    const Value whole = b.args(parts[0])[0];
    if (b.type(whole) != type) return {};
    for (std::uint32_t i = 0; i < parts.size(); i++) {
        const Inst& part = b[parts[i]];
        if (part.op != Op::Extract || part.data != i || b.args(parts[i])[0] != whole) return {};
    }
    return whole;
}

// True if every value of one scalar kind is the same after a conversion to the other kind and back.
bool is_lossless(Scalar from, Scalar through) {
    if (from == through || from == Scalar::Bool) return true;
    if (from == Scalar::Half) return through == Scalar::Float;
    const bool are_whole = (from == Scalar::Int || from == Scalar::Uint);
    return are_whole && (through == Scalar::Int || through == Scalar::Uint);
}

// convert(x to its own type) = x        convert(convert(x to wider) back) = x
Value convert(const Builder& b, Type type, Value value) {
    if (b.type(value) == type) return value;
    if (b[value].op != Op::Convert) return {};
    const Value original = b.args(value)[0];
    const bool is_back = b.type(original) == type && is_lossless(type.scalar, b.type(value).scalar);
    return is_back ? original : Value();
}

Value bitcast(Builder& b, Type type, Value value) {
    if (b.type(value) == type) return value;
    if (b[value].op != Op::Bitcast) return {};
    const Value original = b.args(value)[0];
    return b.type(original) == type ? original : b.emit(Op::Bitcast, type, {original});
}

bool repeats_number(std::span<const double> numbers) {
    return !numbers.empty() && std::all_of(numbers.begin(), numbers.end(), [&](double n) { return n == numbers[0]; });
}

// index(a, 2) = extract(a, 2)
Value index(Builder& b, Value whole, Value at) {
    const auto number = b.constant_of(at);
    const std::uint32_t count = part_count(b.module(), b.type(whole));
    if (number.empty() || count == 0) return {};
    return b.extract(whole, static_cast<std::uint32_t>(std::clamp(number[0], 0.0, count - 1.0)));
}

}  // namespace

Value simplify_composite(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data) {
    if (op == Op::Extract) return extract(b, args[0], data);
    if (op == Op::Insert) return insert(b, type, args, data);
    if (op == Op::Swizzle) return swizzle(b, type, args[0], data);
    if (op == Op::Construct) {
        return type.is_vector() ? construct_vector(b, type, args) : construct_whole(b, type, args);
    }
    if (op == Op::Convert) return convert(b, type, args[0]);
    if (op == Op::Bitcast) return bitcast(b, type, args[0]);
    if (op == Op::Index) return index(b, args[0], args[1]);
    return {};
}

Value simplify_splat(Builder& b, Op op, Type type, std::span<const Value> args) {
    constexpr std::size_t kMost = 3;
    if (!type.is_vector() || args.empty() || args.size() > kMost) return {};
    const Op first = b[args[0]].op;
    if (first != Op::Construct && first != Op::Constant) return {};
    const bool is_componentwise = info(op).rule == TypeRule::Same && !has(op, Derivative) && op != Op::Normalize &&
                                  op != Op::Cross && op != Op::Reflect;
    if (!is_componentwise) return {};
    std::array<Value, kMost> scalars;
    for (std::size_t i = 0; i < args.size(); i++) {
        const bool is_construct = b[args[i]].op == Op::Construct && b[args[i]].operand_count == 1;
        if (is_construct) scalars[i] = b.args(args[i])[0];
        if (!is_construct && !repeats_number(b.constant_of(args[i]))) return {};
    }
    for (std::size_t i = 0; i < args.size(); i++) {
        if (!scalars[i]) scalars[i] = b.constant(type.with_width(1), {b.constant_of(args[i])[0]});
    }
    return b.splat(b.emit(op, type.with_width(1), std::span<const Value>(scalars.data(), args.size())), type.width());
}

}  // namespace patina::ir

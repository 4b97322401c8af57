// simplify(): the value that replaces a new instruction op(args). Constants fold (fold.cpp), composites are taken apart
// (composites.cpp), and the algebra is the table below.
//
// What may change: the sign of a zero, and nothing else. A GPU need not preserve NaN, but users debug with it and no
// target promises to lose it. So x - x stays unchanged for floats: it is NaN where x is NaN or infinite. Rounded
// identities are the exception; each has a comment with its reason.
#include <algorithm>
#include <array>

#include "compiler/ir/builder.h"
#include "compiler/ir/composites.h"
#include "compiler/ir/fold/choices.h"
#include "compiler/ir/fold/known.h"
#include "compiler/ir/fold/pattern.h"
#include "compiler/ir/fold/products.h"

namespace patina::ir {
namespace {

using namespace pattern;

constexpr auto kRounded = Identity::Holds::Rounded;
constexpr auto kRegrouped = Identity::Holds::Regrouped;
// NaN becomes the upper limit on one side and the lower one on the other. Languages do not say which of them it
// becomes.
constexpr auto kOtherLimit = Identity::Holds::Rounded;

constexpr Identity kIdentities[] = {
    {x + 0, x},
    {x + -y, x - y},
    {(x + k) + l, x + (k + l), kRegrouped},
    {(x - k) + l, x + (l - k), kRegrouped},
    {(k - x) + l, (k + l) - x, kRegrouped},

    {x - 0, x},
    {0 - x, -x},
    {x - -y, x + y},
    {i - i, 0},
    {(x + k) - l, x + (k - l), kRegrouped},
    {(x - k) - l, x - (k + l), kRegrouped},
    {(k - x) - l, (k - l) - x, kRegrouped},
    {k - (x + l), (k - l) - x, kRegrouped},
    {k - (x - l), (k + l) - x, kRegrouped},
    {k - (l - x), x + (k - l), kRegrouped},

    {x * 1, x},
    {x * -1, -x},
    {-x * -y, x* y},
    // Most zeros are those of a material: a metal scatters no light, from any light. HLSL compilers and drivers do the
    // same, though x may be infinite or NaN.
    {x * 0, 0, kRounded},

    {x / 1, x},
    {x / -1, -x},

    {-(-x), x},
    {-(x - y), y - x},

    {!!c, c},
    {!(x == y), x != y},
    {!(x != y), x == y},
    // !(x < y) is not x >= y: both are false for NaN. For whole numbers it is.
    {!(i < j), i >= j},
    {!(i <= j), i > j},
    {!(i > j), i <= j},
    {!(i >= j), i < j},

    {c && true, c},
    {c && false, false},
    {c && c, c},
    {c && !c, false},

    {c || false, c},
    {c || true, true},
    {c || c, c},
    {c || !c, true},

    {i & 0, 0},
    {i & -1, i},
    {i & i, i},

    {i | 0, i},
    {i | i, i},

    {i ^ 0, i},
    {i ^ i, 0},

    {~~i, i},

    {i << 0, i},

    {i >> 0, i},

    {x < x, false},

    {x > x, false},

    {i <= i, true},

    {i >= i, true},

    {i == i, true},
    {c == c, true},
    {c == true, c},
    {c == false, !c},

    {i != i, false},
    {c != c, false},
    {c != false, c},
    {c != true, !c},

    {select(true, x, y), x},
    {select(false, x, y), y},
    {select(c, x, x), x},
    {select(!c, x, y), select(c, y, x)},
    {select(c, true, false), c},
    {select(c, false, true), !c},
    {select(c, select(c, x, y), z), select(c, x, z)},
    {select(c, x, select(c, y, z)), select(c, x, z)},

    {abs(abs(x)), abs(x)},
    {abs(-x), abs(x)},
    {abs(saturate(x)), saturate(x)},

    {sign(sign(x)), sign(x)},

    {floor(floor(x)), floor(x)},

    {ceil(ceil(x)), ceil(x)},

    {round(round(x)), round(x)},

    {trunc(trunc(x)), trunc(x)},

    {saturate(saturate(x)), saturate(x)},
    {saturate(max(x, 0)), saturate(x)},
    {saturate(clamp(x, 0, 1)), saturate(x)},
    {saturate(max(x, k)), clamp(x, saturate(k), 1)},
    {saturate(min(x, k)), clamp(x, 0, saturate(k)), kOtherLimit},
    {saturate(clamp(x, k, l)), clamp(x, saturate(k), saturate(l))},

    // A limit of a limited value limits the limits instead.
    {min(x, x), x},
    {min(max(x, 0), 1), saturate(x)},
    {min(saturate(x), 1), saturate(x)},
    {min(min(x, k), l), min(x, min(k, l))},
    {min(max(x, k), l), clamp(x, min(k, l), l)},
    {min(saturate(x), k), clamp(x, min(k, 0), min(k, 1))},
    {min(clamp(x, k, l), m), clamp(x, min(k, m), min(l, m))},

    {max(x, x), x},
    {max(saturate(x), 0), saturate(x)},
    {max(max(x, k), l), max(x, max(k, l))},
    {max(min(x, k), l), clamp(x, l, max(k, l)), kOtherLimit},
    {max(saturate(x), k), clamp(x, max(k, 0), max(k, 1))},
    {max(clamp(x, k, l), m), clamp(x, max(k, m), max(l, m))},

    {clamp(x, 0, 1), saturate(x)},
    {clamp(x, k, k), k},
    {clamp(clamp(x, y, z), y, z), clamp(x, y, z)},
    {clamp(clamp(x, k, l), m, n), clamp(x, clamp(k, m, n), clamp(l, m, n))},
    {clamp(saturate(x), k, l), clamp(x, clamp(0, k, l), clamp(1, k, l))},
    {clamp(max(x, k), l, m), clamp(x, clamp(k, l, m), m)},
    {clamp(min(x, k), l, m), clamp(x, min(l, m), clamp(k, l, m)), kOtherLimit},

    // Languages differ in how lerp rounds (a + (b - a) t, a (1 - t) + b t); its ends are meant to be a and b.
    {lerp(x, y, 0), x, kRounded},
    {lerp(x, y, 1), y, kRounded},
    {lerp(x, x, y), x, kRounded},

    // A GPU computes exp2(y log2(x)), which loses some digits that x has.
    {pow(x, 1), x, kRounded},
    {pow(x, 0), 1},  // of 0, too: that is what the IR means by it

    {any(c), c},  // of a scalar; a vector's type does not fit

    {all(c), c},

    {dot(x, y), x* y},  // of scalars

    // The length of a unit vector is 1, except for rounding.
    {normalize(normalize(x)), normalize(x), kRounded},

    {transpose(transpose(x)), x},
};

constexpr std::size_t root(const Identity& identity) {
    return static_cast<std::size_t>(identity.left.nodes[0].op);
}

// The first identity of each op, and the one after its last.
constexpr auto kRanges = [] {
    std::array<std::array<std::uint16_t, 2>, kOpCount> ranges{};
    for (std::size_t k = 0; k < std::size(kIdentities); k++) {
        auto& [begin, end] = ranges[root(kIdentities[k])];
        if (end == 0) begin = static_cast<std::uint16_t>(k);
        end = static_cast<std::uint16_t>(k + 1);
    }
    return ranges;
}();

constexpr bool is_grouped_by_op() {
    for (std::size_t k = 0; k < std::size(kIdentities); k++) {
        const auto [begin, end] = kRanges[root(kIdentities[k])];
        for (std::size_t other = begin; other < end; other++) {
            if (root(kIdentities[other]) != root(kIdentities[k])) return false;
        }
    }
    return true;
}
static_assert(is_grouped_by_op());

// --- matching

using Node = Pattern::Node;
using Bindings = std::array<Value, kVariables>;

// Facts that are checked before an identity is matched, because they rule out most identities: the ops of the operands,
// and whether two operands are the same value.
struct Glance {
    std::array<std::uint64_t, 2> ops{};
    bool has_twins = false;

    constexpr void add(Op op) {
        const auto bit = static_cast<unsigned>(op);
        ops[bit / 64] |= std::uint64_t{1} << bit % 64;
    }
    constexpr bool holds(const Glance& wanted) const {
        return (ops[0] & wanted.ops[0]) == wanted.ops[0] && (ops[1] & wanted.ops[1]) == wanted.ops[1] &&
               (has_twins || !wanted.has_twins);
    }
};
static_assert(kOpCount <= 128);

constexpr const Node* behind(const Node* node, int operands) {
    for (int k = 0; k < operands; k++) {
        const int inner = node->kind == Pattern::Kind::Operation ? static_cast<int>(node->operands) : 0;
        node = behind(node + 1, inner);
    }
    return node;
}

constexpr Glance glance_of(const Pattern& left) {
    Glance wanted;
    const Node* operand = left.nodes.data() + 1;
    unsigned variables = 0;
    for (int k = 0; k < left.nodes[0].operands; k++) {
        if (operand->kind == Pattern::Kind::Operation) {
            wanted.add(operand->op);
        } else if (operand->kind == Pattern::Kind::Number || operand->kind == Pattern::Kind::Constant) {
            wanted.add(Op::Constant);
        } else {
            wanted.has_twins = wanted.has_twins || (variables >> operand->number & 1u) != 0;
            variables |= 1u << operand->number;
        }
        operand = behind(operand, 1);
    }
    return wanted;
}

constexpr auto kGlances = [] {
    std::array<Glance, std::size(kIdentities)> glances{};
    for (std::size_t k = 0; k < glances.size(); k++) glances[k] = glance_of(kIdentities[k].left);
    return glances;
}();

Glance glance_at(const Builder& b, std::span<const Value> args) {
    Glance seen;
    for (std::size_t k = 0; k < args.size(); k++) {
        seen.add(b[args[k]].op);
        for (std::size_t other = 0; other < k; other++) seen.has_twins = seen.has_twins || args[other] == args[k];
    }
    return seen;
}

bool match_operands(const Builder& b, const Node* node, Op op, std::span<const Value> args, Bindings& bound);

bool match(const Builder& b, const Node* node, Value value, Bindings& bound) {
    if (node->kind == Pattern::Kind::Number) return b.is_constant(value, node->number);
    if (node->kind == Pattern::Kind::Operation) {
        const Op op = b[value].op;
        return op == node->op && match_operands(b, node + 1, op, b.args(value), bound);
    }
    if (node->kind == Pattern::Kind::Integer && !b.type(value).is_integer()) return false;
    if (node->kind == Pattern::Kind::Bool && !b.type(value).is_bool()) return false;
    if (node->kind == Pattern::Kind::Constant && b[value].op != Op::Constant) return false;
    Value& variable = bound[static_cast<std::size_t>(node->number)];
    if (variable) return variable == value;
    variable = value;
    return true;
}

bool match_operands(const Builder& b, const Node* node, Op op, std::span<const Value> args, Bindings& bound) {
    const Bindings before = bound;
    const auto in_order = [&](std::span<const Value> values) {
        const Node* operand = node;
        for (const Value value : values) {
            if (!match(b, operand, value, bound)) return false;
            operand = behind(operand, 1);
        }
        return true;
    };
    if (in_order(args)) return true;
    bound = before;
    if (!has(op, Commutes)) return false;
    const std::array<Value, 2> swapped = {args[1], args[0]};
    return in_order(swapped);
}

// --- rewriting

Type type_of(const Builder& b, const Node*& node, const Bindings& bound) {
    const Node& head = *node++;
    if (head.kind != Pattern::Kind::Operation) {
        return head.kind == Pattern::Kind::Number ? Type::error()
                                                  : b.type(bound[static_cast<std::size_t>(head.number)]);
    }
    std::array<Type, 3> types;
    const std::size_t count = head.operands;
    for (std::size_t k = 0; k < count; k++) types[k] = type_of(b, node, bound);
    // A number has the type of the operands next to it.
    const auto end = types.begin() + static_cast<std::ptrdiff_t>(count);
    const auto beside = std::find_if(types.begin(), end, [](Type type) { return !type.is_error(); });
    for (std::size_t k = 0; beside != end && k < count; k++) {
        if (types[k].is_error()) types[k] = *beside;
    }
    return result_type(head.op, {types.data(), count});
}

// Numbers on the right side have the type of the whole.
Value build(Builder& b, Type type, const Node*& node, const Bindings& bound) {
    const Node& head = *node++;
    if (head.kind == Pattern::Kind::Number) return b.splat_constant(type, head.number);
    if (head.kind != Pattern::Kind::Operation) return bound[static_cast<std::size_t>(head.number)];
    std::array<Value, 3> args;
    std::array<Type, 3> types;
    const std::size_t count = head.operands;
    for (std::size_t k = 0; k < count; k++) {
        args[k] = build(b, type, node, bound);
        types[k] = b.type(args[k]);
    }
    return b.emit(head.op, result_type(head.op, {types.data(), count}), std::span<const Value>(args.data(), count));
}

// True for a usual summand; false for a number so large that adding it rounds the value.
bool is_usual(const Builder& b, Value constant) {
    constexpr double kMost = 1024;
    const std::span<const double> numbers = b.constant_of(constant);
    return std::all_of(numbers.begin(), numbers.end(), [&](double n) { return n >= -kMost && n <= kMost; });
}
bool may_regroup(const Builder& b, std::span<const Value> args) {
    return std::all_of(args.begin(), args.end(), [&](Value arg) {
        if (b[arg].op == Op::Constant) return is_usual(b, arg);
        const auto inner = b.args(arg);
        return !b[arg].name && std::all_of(inner.begin(), inner.end(), [&](Value v) { return is_usual(b, v); });
    });
}

Value rewrite(Builder& b, Op op, Type type, std::span<const Value> args) {
    const auto [begin, end] = kRanges[static_cast<std::size_t>(op)];
    if (begin == end) return {};
    const Glance seen = glance_at(b, args);
    for (std::size_t k = begin; k < end; k++) {
        if (!seen.holds(kGlances[k])) continue;
        const Identity& identity = kIdentities[k];
        Bindings bound;
        if (!match_operands(b, identity.left.nodes.data() + 1, op, args, bound)) continue;
        if (identity.holds == Identity::Holds::Regrouped && !may_regroup(b, args)) continue;
        // select(c, true, false) = c only where the select is as wide as its condition, and so on.
        const Node* node = identity.right.nodes.data();
        if (node->kind != Pattern::Kind::Number && type_of(b, node, bound) != type) continue;
        node = identity.right.nodes.data();
        return build(b, type, node, bound);
    }
    return {};
}

Value fold(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data) {
    constexpr std::size_t kMost = 16;
    if (args.empty() || args.size() > kMost || !type.is_numeric()) return {};
    const auto is_constant = [&](Value v) { return b[v].op == Op::Constant; };
    if (!std::all_of(args.begin(), args.end(), is_constant)) return {};
    std::array<Type, kMost> types;
    std::array<std::span<const double>, kMost> numbers;
    for (std::size_t k = 0; k < args.size(); k++) {
        numbers[k] = b.constant_of(args[k]);
        types[k] = b.type(args[k]);
    }
    std::vector<double> folded;
    const bool is_known =
        fold_constant(op, type, {types.data(), args.size()}, {numbers.data(), args.size()}, data, folded);
    return is_known ? b.constant(type, folded) : Value();
}

}  // namespace

std::span<const Identity> all_identities() {
    return kIdentities;
}

Value simplify(Builder& b, Op op, Type type, std::span<const Value> args, std::uint32_t data) {
    if (const Value folded = fold(b, op, type, args, data)) return folded;
    if (const Value whole = simplify_composite(b, op, type, args, data)) return whole;
    if (const Value splat = simplify_splat(b, op, type, args)) return splat;
    if (const Value equal = rewrite(b, op, type, args)) return equal;
    // The op is tested here, outside of the function: a function that guards its stack sets that up before it looks at
    // its arguments.
    if (op == Op::Mul || op == Op::Div) {
        if (const Value scaled = simplify_product(b, op, type, args)) return scaled;
    }
    if (op == Op::Select) {
        if (const Value chosen = simplify_choice(b, type, args)) return chosen;
    }
    return simplify_known(b, op, type, args);
}

}  // namespace patina::ir

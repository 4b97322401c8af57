#include "compiler/ir/fold/facts.h"

#include <algorithm>
#include <cmath>

#include "compiler/ir/fold/fold.h"

namespace patina::ir {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostFloat = std::numeric_limits<float>::max(), kMostHalf = 65504;
// The search for facts goes back so many operands, so that its time stays bounded.
constexpr int kMaxDepth = 6;
// Functions that are called from more places are not looked into.
constexpr std::size_t kMaxSites = 8;

// --- calls

struct Site {
    std::uint32_t caller;
    Value call;
};

bool calls(const Function& function, std::uint32_t callee) {
    return std::any_of(function.insts.begin(), function.insts.end(),
                       [&](const Inst& inst) { return inst.op == Op::Call && inst.data == callee; });
}

// True for a function of a stage that is not called any more, and which prune() will drop.
bool is_dead(const Module& module, std::uint32_t f) {
    if (!module.stage.entry || module.stage.entry.index == f || module.functions[f].linkage != Linkage::Internal)
        return false;
    return std::none_of(module.functions.begin() + f, module.functions.end(),
                        [&](const Function& caller) { return calls(caller, f); });
}

// Everything that calls the function. Callers stand behind it. Nothing if another text may call it, too.
std::vector<Site> sites_of(const FactsOf& facts) {
    std::vector<Site> sites;
    const Module& module = facts.module;
    const auto self = static_cast<std::uint32_t>(&facts.function - module.functions.data());
    const bool is_entry = module.stage.entry && module.stage.entry.index == self;
    if (!facts.across_calls || is_entry || facts.function.linkage != Linkage::Internal) return sites;
    for (std::uint32_t f = self + 1; f < module.functions.size(); f++) {
        const std::vector<Inst>& insts = module.functions[f].insts;
        if (!calls(module.functions[f], self) || is_dead(module, f)) continue;
        for (std::uint32_t i = 0; i < insts.size(); i++) {
            if (insts[i].op != Op::Call || insts[i].data != self) continue;
            if (sites.size() == kMaxSites) return {};
            sites.push_back({f, {i}});
        }
    }
    return sites;
}

// True if `holds(facts, value)` for the argument of every call.
template <class Holds>
bool at_all_calls(const FactsOf& facts, std::uint32_t param, const Holds& holds) {
    const std::vector<Site> sites = sites_of(facts);
    return !sites.empty() && std::all_of(sites.begin(), sites.end(), [&](const Site& site) {
        const Function& caller = facts.module.functions[site.caller];
        return holds(FactsOf{facts.module, caller, true}, caller.args(site.call)[param]);
    });
}

// The value that a function returns; none if another text defines it.
Value returned_by(const Function& function) {
    if (is_elsewhere(function) || function.blocks.empty() || function.blocks[0].insts.empty()) return {};
    const Inst& end = function[function.blocks[0].insts.back()];
    return end.op == Op::Return && end.operand_count == 1 ? function.args(end)[0] : Value();
}

// The member of a struct that is put together in the function; none if it comes from elsewhere.
Value member_of(const Function& function, Value whole, std::uint32_t member) {
    while (function[whole].op == Op::Insert) {
        if (function[whole].data == member) return function.args(whole)[1];
        whole = function.args(whole)[0];
    }
    const bool is_made = function[whole].op == Op::Construct && function[whole].type.kind == Kind::Struct;
    return is_made ? function.args(whole)[member] : Value();
}

std::span<const Value> yielded_by(const Function& function, std::uint32_t block) {
    return function.args(function.blocks[block].insts.back());
}

// --- ranges

constexpr Range kUnknown{};

Range number(double low, double high) {
    return {low, high, false};
}

Range either(const Range& a, const Range& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), a.may_be_nan || b.may_be_nan};
}

// All values of a scalar kind.
Range all_of_type(Type type) {
    switch (type.scalar) {
        case Scalar::Bool: return number(0, 1);
        case Scalar::Int: return number(-0x1p31, 0x1p31 - 1);
        case Scalar::Uint: return number(0, 0x1p32 - 1);
        case Scalar::Half:
        case Scalar::Float: return kUnknown;
    }
    return kUnknown;
}

// What min and max give for NaN is the other operand.
Range least(const Range& a, const Range& b) {
    Range made{std::min(a.low, b.low), std::min(a.high, b.high), a.may_be_nan && b.may_be_nan};
    if (a.may_be_nan) made.high = std::max(made.high, b.high);
    if (b.may_be_nan) made.high = std::max(made.high, a.high);
    return made;
}
Range negated(const Range& a) {
    return {-a.high, -a.low, a.may_be_nan};
}
Range greatest(const Range& a, const Range& b) {
    return negated(least(negated(a), negated(b)));
}

// Bounds that were computed exactly, of an operation that rounds its result. Integers wrap.
Range rounded(Type type, Range made) {
    if (type.is_integer()) {
        const Range all = all_of_type(type);
        return made.low >= all.low && made.high <= all.high ? made : all;
    }
    const double most = type.scalar == Scalar::Half ? kMostHalf : kMostFloat;
    const Range rounded = number(round_to(type.scalar, made.low), round_to(type.scalar, made.high));
    return made.is_finite() && rounded.low >= -most && rounded.high <= most ? rounded : kUnknown;
}

Range product(const Range& a, const Range& b) {
    const double ends[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return number(*std::min_element(ends, ends + 4), *std::max_element(ends, ends + 4));
}

class Ranges {
public:
    explicit Ranges(const FactsOf& facts, int depth) : facts_(facts), depth_(depth) {}

    Range of(Value value) const {
        const Inst& inst = function()[value];
        if (inst.op == Op::Global) return of_global(inst);
        if (!inst.type.is_numeric()) return kUnknown;
        if (inst.op == Op::Constant) return of_constant(inst);
        if (depth_ >= kMaxDepth) return all_of_type(inst.type);
        Range found = of_inst(value, inst);
        const Range all = all_of_type(inst.type);
        if (all.is_finite()) found = {std::max(found.low, all.low), std::min(found.high, all.high), false};
        return found;
    }

private:
    const Function& function() const { return facts_.function; }

    // An engine gives finite numbers (Group). An array of them is asked about for its elements.
    Range of_global(const Inst& inst) const {
        const bool is_of_engine = facts_.module.globals[inst.data].group != Group::Material;
        const Range all = all_of_type(inst.type);
        return is_of_engine && !all.is_finite() ? number(-kMostFloat, kMostFloat) : all;
    }

    Range of_constant(const Inst& inst) const {
        const auto numbers = facts_.module.numbers_of(facts_.module.constants[inst.data]);
        Range made = number(kInfinity, -kInfinity);
        for (const double each : numbers) {
            if (std::isnan(each)) return kUnknown;
            made = either(made, number(each, each));
        }
        return made;
    }

    Range of_inst(Value value, const Inst& inst) const {
        const auto args = function().args(inst);
        const Ranges deeper(facts_, depth_ + 1);
        const auto arg = [&](std::size_t i) { return deeper.of(args[i]); };
        const Op op = inst.op;
        if (op == Op::Param) return of_param(inst.data, inst.type);
        if (op == Op::LoopIndex) return of_loop(value, inst.type);
        if (op == Op::Construct) {
            Range all = number(kInfinity, -kInfinity);
            for (const Value part : args) all = either(all, deeper.of(part));
            return all;
        }
        if (op == Op::Extract || op == Op::Swizzle || op == Op::Index) return arg(0);
        if (op == Op::Convert) return of_conversion(inst.type, args[0], arg(0));
        if (op == Op::Select) return either(chosen_above(args, arg(1), deeper), arg(2));
        if (op == Op::Result) return of_result(inst, deeper);
        if (op == Op::Neg) return rounded_or(inst.type, negated(arg(0)));
        if (op == Op::Abs) return of_abs(inst.type, arg(0));
        if (op == Op::Saturate) return least(greatest(arg(0), number(0, 0)), number(1, 1));
        if (op == Op::Min) return least(arg(0), arg(1));
        if (op == Op::Max) return greatest(arg(0), arg(1));
        if (op == Op::Clamp) return least(greatest(arg(0), arg(1)), arg(2));
        if (op == Op::Step) return number(0, 1);
        if (op == Op::Lerp) return of_blend(arg(0), arg(1), arg(2));
        if (op == Op::Add) return of_sum(inst.type, arg(0), arg(1));
        if (op == Op::Sub) return of_sum(inst.type, arg(0), negated(arg(1)));
        if (op == Op::Mul) return of_product(inst.type, args, arg(0), arg(1));
        if (op == Op::BitAnd) return of_bits(arg(0), arg(1));
        if (op == Op::Mod) return of_remainder(inst.type, arg(0), arg(1));
        if (op == Op::Sign) return {-1, 1, true};
        if (op == Op::Pow) return of_power(arg(0), arg(1));
        const bool is_square = op == Op::Dot && args[0] == args[1];
        const bool is_positive =
            op == Op::Sqrt || op == Op::Length || op == Op::Distance || op == Op::Exp || op == Op::Exp2;
        return is_square || is_positive ? Range{0, kInfinity, true} : kUnknown;
    }

    // x, in `x > limit ? x : y`.
    Range chosen_above(std::span<const Value> args, Range x, const Ranges& deeper) const {
        const Inst& condition = function()[args[0]];
        if (condition.op != Op::Greater || function().args(condition)[0] != args[1]) return x;
        const double limit = deeper.of(function().args(condition)[1]).low;
        return number(std::max(x.low, std::nextafter(limit, kInfinity)), x.high);
    }
    // Languages round in different ways, so the ends are not exact.
    static Range of_blend(const Range& a, const Range& b, const Range& share) {
        if (!a.is_finite() || !b.is_finite() || share.may_be_nan || share.low < 0 || share.high > 1) return kUnknown;
        const Range made = either(a, b);
        const double error = 1e-5 * std::max(std::fabs(made.low), std::fabs(made.high));
        return made.high + error < kMostHalf && made.low - error > -kMostHalf
                   ? number(made.low - error, made.high + error)
                   : kUnknown;
    }

    Range of_param(std::uint32_t param, Type type) const {
        Range all = number(kInfinity, -kInfinity);
        const bool is_called = at_all_calls(facts_, param, [&](const FactsOf& caller, Value argument) {
            all = either(all, Ranges(caller, depth_ + 1).of(argument));
            return true;
        });
        return is_called ? all : all_of_type(type);
    }

    Range of_loop(Value index, Type type) const {
        for (const Inst& loop : function().insts) {
            if (loop.op != Op::For || function().blocks[loop.data].insts.front() != index) continue;
            const Ranges deeper(facts_, depth_ + 1);
            const auto args = function().args(loop);
            // The loop runs at least once where its index is read.
            return number(deeper.of(args[0]).low, deeper.of(args[1]).high - 1);
        }
        return all_of_type(type);
    }

    Range of_result(const Inst& inst, const Ranges& deeper) const {
        const Inst& structure = function()[function().args(inst)[0]];
        if (structure.op != Op::If) return all_of_type(inst.type);
        return either(deeper.of(yielded_by(function(), structure.data)[inst.data]),
                      deeper.of(yielded_by(function(), structure.data + 1)[inst.data]));
    }

    Range of_conversion(Type to, Value from, const Range& range) const {
        const bool is_exact = function()[from].type.is_integer() || function()[from].type.is_bool();
        if (to.is_floating()) return range.is_finite() ? rounded(to, range) : kUnknown;
        const Range all = all_of_type(to);
        return is_exact && range.low >= all.low && range.high <= all.high ? range : all;
    }

    static Range rounded_or(Type type, const Range& made) { return type.is_integer() ? rounded(type, made) : made; }
    static Range of_abs(Type type, const Range& a) {
        if (a.low >= 0) return a;
        const Range made{a.high <= 0 ? -a.high : 0.0, std::max(-a.low, a.high), a.may_be_nan};
        return rounded_or(type, made);
    }
    static Range of_sum(Type type, const Range& a, const Range& b) {
        if (!a.is_finite() || !b.is_finite()) return all_of_type(type);
        return rounded(type, number(a.low + b.low, a.high + b.high));
    }
    static Range of_product(Type type, std::span<const Value> args, const Range& a, const Range& b) {
        const bool is_square = !type.is_matrix() && args[0] == args[1];
        if (is_square && a.is_finite()) {
            const Range size = of_abs(type, a);
            return rounded(type, number(size.low * size.low, size.high * size.high));
        }
        if (a.is_finite() && b.is_finite()) return rounded(type, product(a, b));
        return is_square && type.is_floating() ? Range{0, kInfinity, true} : all_of_type(type);
    }
    // A GPU computes exp2(exponent log2(base)). This may round to more than 1 where the exact power is not more.
    // Languages make the power 1 where the exponent is 0 (languages/legalize.cpp).
    static Range of_power(const Range& base, const Range& exponent) {
        const bool may_be_nan = !base.is_finite() || !exponent.is_finite() || base.low < 0 || exponent.low < 0;
        return {0, kInfinity, may_be_nan};
    }
    static Range of_bits(const Range& a, const Range& b) {
        if (a.low >= 0 && b.low >= 0) return number(0, std::min(a.high, b.high));
        if (a.low >= 0) return number(0, a.high);
        return b.low >= 0 ? number(0, b.high) : kUnknown;
    }
    static Range of_remainder(Type type, const Range& a, const Range& b) {
        const bool is_known = type.is_integer() && a.low >= 0 && b.low > 0;
        return is_known ? number(0, std::min(a.high, b.high - 1)) : all_of_type(type);
    }

    const FactsOf& facts_;
    int depth_;
};

// --- unit vectors

bool is_unit_constant(const Module& module, const Inst& inst) {
    double squared = 0;
    for (const double each : module.numbers_of(module.constants[inst.data])) squared += each * each;
    return std::fabs(squared - 1) < 1e-6;
}

// True if the swizzle only changes the order of the components.
bool is_permutation(const Inst& inst, unsigned width) {
    unsigned seen = 0;
    for (unsigned i = 0; i < width; i++) seen |= 1u << (inst.data >> (2 * i) & 3u);
    return inst.type.width() == width && seen == (1u << width) - 1;
}

bool is_unit(const FactsOf& facts, Value value, int depth) {
    const Function& function = facts.function;
    const Inst& inst = function[value];
    const auto args = function.args(inst);
    if (!inst.type.is_vector() || !inst.type.is_floating() || depth >= kMaxDepth) return false;
    const auto is_unit_arg = [&](std::size_t i) { return is_unit(facts, args[i], depth + 1); };
    const auto is_unit_in = [&](const Function& callee, Value returned) {
        return returned && is_unit({facts.module, callee, true}, returned, depth + 1);
    };
    const Op op = inst.op;
    if (op == Op::Constant) return is_unit_constant(facts.module, inst);
    if (op == Op::Normalize) return true;
    if (op == Op::Neg) return is_unit_arg(0);
    if (op == Op::Select) return is_unit_arg(1) && is_unit_arg(2);
    if (op == Op::Reflect) return is_unit_arg(0) && is_unit_arg(1);
    if (op == Op::Swizzle) return is_permutation(inst, function[args[0]].type.width()) && is_unit_arg(0);
    if (op == Op::Semantic) return facts.module.semantics[inst.data].is_unit;
    if (op == Op::Param) {
        return function.params[inst.data].is_unit ||
               at_all_calls(facts, inst.data, [&](const FactsOf& caller, Value argument) {
                   return is_unit(caller, argument, depth + 1);
               });
    }
    if (op == Op::Result) {
        const Inst& structure = function[args[0]];
        return structure.op == Op::If && is_unit(facts, yielded_by(function, structure.data)[inst.data], depth + 1) &&
               is_unit(facts, yielded_by(function, structure.data + 1)[inst.data], depth + 1);
    }
    if (!facts.across_calls) return false;
    if (op == Op::Call) {
        const Function& callee = facts.module.functions[inst.data];
        return is_unit_in(callee, returned_by(callee));
    }
    if (op != Op::Extract || function[args[0]].op != Op::Call) return false;
    const Function& callee = facts.module.functions[function[args[0]].data];
    const Value returned = returned_by(callee);
    return returned && is_unit_in(callee, member_of(callee, returned, inst.data));
}

}  // namespace

bool Range::is_finite() const {
    return !may_be_nan && low > -kInfinity && high < kInfinity;
}

Range range_of(const FactsOf& facts, Value value) {
    return Ranges(facts, 0).of(value);
}

bool is_unit(const FactsOf& facts, Value value) {
    return is_unit(facts, value, 0);
}

bool returns_unit(const Module& module, const Function& function) {
    const Value returned = returned_by(function);
    return returned && is_unit({module, function}, returned);
}

}  // namespace patina::ir

#include <algorithm>

#include "compiler/ir/passes/keyword_sides.h"

namespace patina::ir {
namespace {

// Where a value is needed: where the condition is true, or where it is false.
struct Guard {
    Value condition{};
    bool holds = true;
    friend bool operator==(const Guard&, const Guard&) = default;
};

// All combinations of the values of the keywords that a function reads, and which of them make a condition true.
class Worlds {
public:
    Worlds(const Module& module, const Function& function) : module_(module), from_(function) {
        for (const Inst& inst : function.insts) {
            if (inst.op != Op::Global || !module.globals[inst.data].is_keyword()) continue;
            const std::uint32_t keyword = module.globals[inst.data].keyword;
            if (std::count(keywords_.begin(), keywords_.end(), keyword) > 0) continue;
            keywords_.push_back(keyword);
            steps_.push_back(count_);
            const std::size_t values = module.keywords[keyword].values.size();
            count_ = std::min(kMost + 1, count_ * (values == 0 ? 2 : values));
        }
    }

    bool are_few() const { return count_ <= kMost; }
    std::vector<bool> where(const Guard& guard) const {
        std::vector<bool> made(count_);
        for (std::size_t world = 0; world < count_; ++world)
            made[world] = (value_in(guard.condition, world) != 0) == guard.holds;
        return made;
    }

private:
    double value_in(Value v, std::size_t world) const {
        const Inst& inst = from_[v];
        const auto args = from_.args(inst);
        if (inst.op == Op::Constant) return module_.numbers_of(module_.constants[inst.data])[0];
        if (inst.op == Op::Global) {
            const std::uint32_t keyword = module_.globals[inst.data].keyword;
            const auto at =
                static_cast<std::size_t>(std::find(keywords_.begin(), keywords_.end(), keyword) - keywords_.begin());
            const std::size_t values = module_.keywords[keyword].values.size();
            return static_cast<double>(world / steps_[at] % (values == 0 ? 2 : values));
        }
        const double left = value_in(args[0], world);
        if (inst.op == Op::Not) return left == 0;
        const double right = value_in(args[1], world);
        if (inst.op == Op::And) return left != 0 && right != 0;
        if (inst.op == Op::Or) return left != 0 || right != 0;
        return (left == right) == (inst.op == Op::Equal);
    }

    static constexpr std::size_t kMost = 1024;
    const Module& module_;
    const Function& from_;
    std::vector<std::uint32_t> keywords_;
    std::vector<std::size_t> steps_;
    std::size_t count_ = 1;
};

class Guards {
public:
    Guards(const Module& module, const Function& from, const Sides& sides)
        : from_(from), sides_(sides), worlds_(module, from), heavy_(from.insts.size()) {
        for (const Block& block : from.blocks) {
            for (const Value v : block.insts) heavy_[v.index] = is_heavy(v);
        }
    }

    bool rewrite(Copy& copy, Value v) {
        if (!worlds_.are_few() || !heavy_[v.index] || !may_be_chosen(v)) return false;
        const std::vector<Guard> guards = guards_of(v);
        if (guards.empty()) return false;
        copy_plain(copy, v);
        const Value made = copy.map[v.index];
        Value needed;
        for (const Guard& guard : guards) {
            Value one = repeated(copy, guard.condition);
            if (!guard.holds) one = copy.to.emit(Op::Not, {one});
            needed = needed ? copy.to.emit(Op::Or, {needed, one}) : one;
        }
        const Type type = copy.to.type(made);
        copy.map[v.index] = copy.to.emit(Op::Select, type, {needed, made, copy.to.zero(type)});
        copy.to.name(copy.map[v.index], from_[v].name);
        return true;
    }

private:
    bool is_part(const Inst& inst) const {
        return (inst.op == Op::Extract && from_[from_.args(inst)[0]].type.kind != Kind::Struct) ||
               inst.op == Op::Swizzle || (inst.op == Op::Construct && inst.operand_count == 1);
    }
    bool may_be_chosen(Value v) const {
        const Inst& inst = from_[v];
        return inst.type.is_numeric() && !inst.type.is_matrix() && !is_part(inst) && !sides_.of(v).choice;
    }
    // True if the value costs enough for a condition around it, or is computed from such values that nothing else
    // reads.
    bool is_heavy(Value v) const {
        const Inst& inst = from_[v];
        const auto args = from_.args(inst);
        const bool is_loop = inst.op == Op::Result && from_[args[0]].op == Op::For;
        if (inst.op == Op::Call || info(inst.op).rule == TypeRule::Texel || is_loop) return true;
        if (has(inst.op, Structure) || has(inst.op, Effect) || inst.op == Op::Result || sides_.is_choice(v))
            return false;
        return std::any_of(args.begin(), args.end(),
                           [&](Value arg) { return heavy_[arg.index] && sides_.is_only_for(arg, v); });
    }

    // The narrowest condition around the uses of a value, or several conditions, that is true wherever a use needs the
    // value.
    std::vector<Guard> guards_of(Value v) const {
        std::vector<Guard> known;
        std::vector<bool> needed;
        for (const std::vector<Side>& around : sides_.around_uses(v, true)) {
            if (around.empty()) return {};
            std::vector<bool> here;
            for (const Side& side : around) {
                const Guard guard{from_.args(side.choice)[0], side.index == 1};
                here = here.empty() ? worlds_.where(guard) : both(here, worlds_.where(guard));
                if (std::count(known.begin(), known.end(), guard) == 0) known.push_back(guard);
            }
            needed = needed.empty() ? here : either(needed, here);
        }
        std::vector<Guard> best;
        auto fewest = static_cast<std::ptrdiff_t>(needed.size());  // all: no condition is needed
        const auto consider = [&](const std::vector<Guard>& guards) {
            std::vector<bool> where = worlds_.where(guards[0]);
            for (std::size_t i = 1; i < guards.size(); ++i) where = either(where, worlds_.where(guards[i]));
            const std::ptrdiff_t count = std::count(where.begin(), where.end(), true);
            if (count >= fewest || either(where, needed) != where) return;
            fewest = count;
            best = guards;
        };
        for (const Guard& a : known) consider({a});
        for (std::size_t i = 0; i < known.size() && i < kMostKnown; ++i) {
            for (std::size_t k = 0; k < i; ++k) consider({known[k], known[i]});
        }
        for (std::size_t i = 0; i < known.size() && i < kMostKnown; ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                for (std::size_t m = 0; m < k; ++m) consider({known[m], known[k], known[i]});
            }
        }
        return best;
    }
    static std::vector<bool> both(std::vector<bool> a, const std::vector<bool>& b) {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
        return a;
    }
    static std::vector<bool> either(std::vector<bool> a, const std::vector<bool>& b) {
        for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] || b[i];
        return a;
    }

    // Emits a condition of keywords again, because the existing one may come after the position where it is needed.
    Value repeated(Copy& copy, Value condition) const {
        const Inst& inst = from_[condition];
        std::vector<Value> operands;
        for (const Value arg : from_.args(inst)) operands.push_back(repeated(copy, arg));
        if (inst.op == Op::Constant) {
            const auto numbers = copy.to.module().numbers_of(copy.to.module().constants[inst.data]);
            return copy.to.constant(inst.type, std::vector<double>(numbers.begin(), numbers.end()));
        }
        return copy.to.emit(inst.op, inst.type, operands, inst.data);
    }

    static constexpr std::size_t kMostKnown = 8;
    const Function& from_;
    const Sides& sides_;
    Worlds worlds_;
    std::vector<bool> heavy_;
};

}  // namespace

Function guarded(Module& module, const Function& from, const Sides& sides) {
    Guards guards(module, from, sides);
    return rewritten(module, from, [&](Copy& c, Value v) { return guards.rewrite(c, v); });
}

}  // namespace patina::ir

#include "compiler/ir/linear/affine.h"

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <utility>

#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// The most activations: each call has one, and functions that call others twice double their number at each level.
constexpr std::size_t kBudget = 1u << 18;
constexpr int kMaxDepth = 32;
constexpr std::uint32_t kSeedBits = 6;

bool is_one_of(Op op, std::initializer_list<Op> ops) {
    return std::find(ops.begin(), ops.end(), op) != ops.end();
}

// Components of the result are components of the operands.
bool is_moving(Op op) {
    return is_one_of(op, {Op::Construct, Op::Extract, Op::Insert, Op::Swizzle, Op::Transpose});
}

// Component i of the result is made of the components i of the operands.
bool is_by_component(Op op) {
    return is_one_of(op, {Op::Neg, Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Lerp, Op::Radians, Op::Degrees});
}

class Analyst {
public:
    Analyst(const Module& module, const Seed& seed) : module_(module), seed_(seed) {
        if (seed.callee) reaches_ = reaching(module, seed.callee);
    }

    Affine run(FunctionId function) {
        const Function& f = module_[function];
        std::vector<Dependence> arguments(f.params.size());
        if (!seed_.callee) arguments[seed_.param] = of_param(f.params[seed_.param].type);
        Affine made{.root = activate(function, std::move(arguments), {}, 0), .blames = {}};
        made.blames = std::move(blames_);
        return made;
    }

private:
    struct Frame {
        const Function& function;
        FunctionId id;
        std::vector<Dependence> arguments;
        OriginId origin;  // of the call
        int depth;
        Activation& made;
    };

    std::unique_ptr<Activation> activate(FunctionId id, std::vector<Dependence> arguments, OriginId origin, int depth) {
        auto made = std::make_unique<Activation>();
        const Function& function = module_[id];
        made->values.resize(function.insts.size());
        Frame frame{function, id, std::move(arguments), origin, depth, *made};
        block(frame, 0);
        return made;
    }

    // --- the seed

    static std::uint8_t bit(std::uint32_t component) { return static_cast<std::uint8_t>(1u << component % kSeedBits); }

    Dependence whole(Type type) const {
        Dependence made{};
        for (std::uint32_t i = 0; i < component_count(module_, type); i++) made.on.push_back(bit(i));
        return made;
    }

    Dependence of_param(Type type) const {
        if (type.kind != Kind::Struct) return whole(type);
        Dependence made{};
        made.on.resize(component_count(module_, type), Dependence::kOffset);
        const Dependence member = whole(part_type(module_, type, seed_.member));
        std::copy(member.on.begin(), member.on.end(), made.on.begin() + first_component(module_, type, seed_.member));
        return made;
    }

    // --- the walk

    void block(Frame& frame, std::uint32_t index) {
        for (const Value value : frame.function.blocks[index].insts) {
            const Inst& inst = frame.function[value];
            budget_ -= budget_ > 0 ? 1 : 0;
            if (inst.op == Op::If) {
                block(frame, inst.data);
                block(frame, inst.data + 1);
            } else if (inst.op == Op::For) {
                loop(frame, inst);
            } else if (inst.op == Op::Return) {
                if (inst.operand_count > 0) frame.made.result = of(frame, frame.function.args(inst)[0]);
            } else if (inst.op != Op::LoopCarried && inst.op != Op::Yield) {
                Dependence made = dependence(frame, value);
                note_mixing(frame, inst, made);
                if ((made.all_of() & Dependence::kBroken) == 0) made.broken_by = kNoBlame;
                if (is_all_offset(made)) made = {};
                frame.made.values[value.index] = std::move(made);
            }
        }
    }

    // The values that a loop carries depend on the end of its body, so the body is repeated until nothing is added.
    // Dependences only grow, so this ends.
    void loop(Frame& frame, const Inst& inst) {
        const auto args = frame.function.args(inst);
        const std::vector<Value>& body = frame.function.blocks[inst.data].insts;
        for (std::uint32_t k = 0; k + 2 < args.size(); k++) {
            Dependence& carried = frame.made.values[body[k + 1].index];
            carried = of(frame, args[k + 2]);
            const std::uint32_t count = component_count(module_, frame.function[args[k + 2]].type);
            if (of(frame, args[0]).any() || of(frame, args[1]).any())
                carried = broken(frame, inst, count, {args[0], args[1]}, Blame::What::Condition);
        }
        for (bool has_grown = true; has_grown;) {
            block(frame, inst.data);
            has_grown = false;
            const auto next = yielded(frame.function, inst.data);
            for (std::uint32_t k = 0; k < next.size(); k++) {
                has_grown |= add(frame.made.values[body[k + 1].index], of(frame, next[k]));
            }
        }
        if (!inst.is_while) return;
        // A loop that may end early is linear in nothing that it computes with.
        for (std::uint32_t k = 0; k + 2 < args.size(); k++) {
            Dependence& carried = frame.made.values[body[k + 1].index];
            if (!carried.any()) continue;
            const std::uint32_t count = component_count(module_, frame.function[args[k + 2]].type);
            carried = broken(frame, inst, count, {body[k + 1]}, Blame::What::Condition);
        }
    }

    const Dependence& of(const Frame& frame, Value value) const { return frame.made.values[value.index]; }

    static std::uint8_t at(const Dependence& dependence, std::size_t component) {
        return dependence.on.empty() ? Dependence::kOffset : dependence.on[component];
    }
    static bool is_dependent(std::uint8_t component) { return (component & ~Dependence::kOffset) != 0; }
    static bool is_all_offset(const Dependence& dependence) {
        return std::all_of(dependence.on.begin(), dependence.on.end(),
                           [](std::uint8_t on) { return on == Dependence::kOffset; });
    }

    // What either of two values depends on; true if that is more than before.
    static bool add(Dependence& to, const Dependence& from) {
        bool has_grown = false;
        if (to.on.empty()) to.on.resize(from.on.size(), Dependence::kOffset);
        for (std::size_t i = 0; i < to.on.size(); i++) {
            has_grown |= (at(from, i) & ~to.on[i]) != 0;
            to.on[i] |= at(from, i);
        }
        if (to.broken_by == kNoBlame) to.broken_by = from.broken_by;
        if (to.mixed_by == kNoBlame) to.mixed_by = from.mixed_by;
        return has_grown;
    }

    // --- blame

    std::uint32_t blame(const Frame& frame, const Inst& inst, Blame::What what) {
        blames_.push_back({what, inst.op, frame.id, inst.origin ? inst.origin : frame.origin});
        return static_cast<std::uint32_t>(blames_.size() - 1);
    }

    void inherit(const Frame& frame, std::span<const Value> args, Dependence& made) const {
        for (const Value arg : args) {
            if (made.broken_by == kNoBlame) made.broken_by = of(frame, arg).broken_by;
            if (made.mixed_by == kNoBlame) made.mixed_by = of(frame, arg).mixed_by;
        }
    }

    // Marks a component that was not broken before it came here.
    void break_component(const Frame& frame, const Inst& inst, Dependence& made, std::size_t component,
                         Blame::What what) {
        if (made.broken_by == kNoBlame) made.broken_by = blame(frame, inst, what);
        made.on[component] |= Dependence::kBroken;
    }

    // Every component depends on all that these operands depend on, and is not affine in it.
    Dependence broken(const Frame& frame, const Inst& inst, std::size_t count, std::span<const Value> args,
                      Blame::What what) {
        Dependence made{};
        std::uint8_t all = 0;
        for (const Value arg : args) all |= of(frame, arg).all_of();
        inherit(frame, args, made);
        made.on.assign(count, all | Dependence::kOffset);
        for (std::size_t i = 0; i < made.on.size(); i++) break_component(frame, inst, made, i, what);
        return made;
    }
    Dependence broken(const Frame& frame, const Inst& inst, std::size_t count, std::initializer_list<Value> args,
                      Blame::What what) {
        return broken(frame, inst, count, std::span<const Value>(args.begin(), args.size()), what);
    }

    void note_mixing(const Frame& frame, const Inst& inst, Dependence& made) {
        if (made.mixed_by != kNoBlame || !inst.type.is_numeric() || inst.type.is_matrix()) return;
        for (std::size_t i = 0; i < made.on.size(); i++) {
            const std::uint8_t on = made.on[i] & ~(Dependence::kBroken | Dependence::kOffset);
            const bool is_mixed = inst.type.is_scalar() ? std::popcount(on) > 1 : (on & ~bit(i)) != 0;
            if (is_mixed) made.mixed_by = blame(frame, inst, Blame::What::Mixes);
            if (is_mixed) return;
        }
    }

    // --- the rules

    Dependence dependence(Frame& frame, Value value) {
        const Inst& inst = frame.function[value];
        const auto args = frame.function.args(inst);
        if (inst.op == Op::Param) return frame.arguments[inst.data];
        if (inst.op == Op::Result) return result(frame, inst);
        if (inst.op == Op::Call) return call(frame, value);
        if (inst.op == Op::Constant) return constant(inst);
        const std::uint32_t count = component_count(module_, inst.type);
        if (std::none_of(args.begin(), args.end(), [&](Value v) { return of(frame, v).any(); }))
            return is_moving(inst.op) && has_zeros(frame, args) ? moved(frame, inst, count) : Dependence{};
        if (is_by_component(inst.op) || (inst.op == Op::Convert && is_linear(inst, frame)))
            return by_component(frame, inst, count);
        if (inst.op == Op::Select) return select(frame, inst, count);
        if (is_one_of(inst.op, {Op::Dot, Op::Cross, Op::MatMul})) return product(frame, inst, count);
        if (inst.op == Op::Reflect || inst.op == Op::Index) return linear_in_first(frame, inst, count);
        if (is_moving(inst.op)) return moved(frame, inst, count);
        return broken(frame, inst, count, args, Blame::What::NotLinear);
    }

    bool has_zeros(const Frame& frame, std::span<const Value> args) const {
        return std::any_of(args.begin(), args.end(), [&](Value v) { return !of(frame, v).on.empty(); });
    }

    bool is_linear(const Inst& convert, const Frame& frame) const {
        return convert.type.is_floating() && frame.function[frame.function.args(convert)[0]].type.is_floating();
    }

    Dependence constant(const Inst& inst) const {
        Dependence made{};
        for (const double number : module_.numbers_of(module_.constants[inst.data]))
            made.on.push_back(number == 0 ? std::uint8_t{0} : Dependence::kOffset);
        return made;
    }

    // What has a part that does not depend on x, of one component of the operands. x times anything has none.
    static std::uint8_t offset(Op op, std::array<std::uint8_t, 3> on) {
        const std::uint8_t either = on[0] | on[1];
        if (!is_dependent(either | on[2])) return Dependence::kOffset;
        if (op == Op::Mul) return (is_dependent(on[0]) ? on[0] : on[1]) & Dependence::kOffset;
        const bool is_of_first = op == Op::Div || (op == Op::Lerp && !is_dependent(either));
        return (is_of_first ? on[0] : either) & Dependence::kOffset;
    }

    Dependence by_component(const Frame& frame, const Inst& inst, std::uint32_t count) {
        const auto args = frame.function.args(inst);
        Dependence made{};
        inherit(frame, args, made);
        made.on.resize(count);
        for (std::uint32_t i = 0; i < count; i++) {
            std::array<std::uint8_t, 3> on{};
            for (std::size_t k = 0; k < args.size(); k++) on[k] = at(of(frame, args[k]), i);
            made.on[i] = ((on[0] | on[1] | on[2]) & ~Dependence::kOffset) | offset(inst.op, on);
            const bool of_first = is_dependent(on[0]), of_second = is_dependent(on[1]), of_third = is_dependent(on[2]);
            const bool is_product =
                (inst.op == Op::Mul && of_first && of_second) || (of_third && (of_first || of_second));
            const bool is_quotient = inst.op == Op::Div && of_second;
            if (is_product) break_component(frame, inst, made, i, Blame::What::Product);
            if (is_quotient) break_component(frame, inst, made, i, Blame::What::NotLinear);
        }
        return made;
    }

    Dependence select(const Frame& frame, const Inst& inst, std::uint32_t count) {
        const auto args = frame.function.args(inst);
        const bool is_by_vector = frame.function[args[0]].type.is_vector();
        Dependence made{};
        inherit(frame, args, made);
        made.on.resize(count);
        for (std::uint32_t i = 0; i < count; i++) {
            const std::uint8_t condition = at(of(frame, args[0]), is_by_vector ? i : 0) & ~Dependence::kOffset;
            made.on[i] = condition | at(of(frame, args[1]), i) | at(of(frame, args[2]), i);
            if (condition != 0) break_component(frame, inst, made, i, Blame::What::Condition);
        }
        return made;
    }

    // All components of the operand go into all of the result.
    Dependence spread(const Frame& frame, const Inst& inst, std::uint32_t count) const {
        const auto args = frame.function.args(inst);
        Dependence made{};
        inherit(frame, args, made);
        std::uint8_t all = 0;
        for (const Value arg : args) all |= of(frame, arg).any() ? of(frame, arg).all_of() : 0;
        made.on.assign(count, all);
        return made;
    }

    Dependence product(const Frame& frame, const Inst& inst, std::uint32_t count) {
        const auto args = frame.function.args(inst);
        if (of(frame, args[0]).any() && of(frame, args[1]).any())
            return broken(frame, inst, count, args, Blame::What::Product);
        return spread(frame, inst, count);
    }

    Dependence linear_in_first(const Frame& frame, const Inst& inst, std::uint32_t count) {
        const auto args = frame.function.args(inst);
        if (of(frame, args[1]).any()) return broken(frame, inst, count, args, Blame::What::NotLinear);
        if (inst.op == Op::Reflect) return spread(frame, inst, count);
        // Any of the parts, each in its own order.
        Dependence made{};
        inherit(frame, args, made);
        made.on.resize(count);
        const std::vector<std::uint8_t>& parts = of(frame, args[0]).on;
        for (std::size_t i = 0; i < parts.size(); i++) made.on[i % count] |= parts[i];
        return made;
    }

    Dependence moved(const Frame& frame, const Inst& inst, std::uint32_t count) const {
        const auto args = frame.function.args(inst);
        Dependence made{};
        inherit(frame, args, made);
        const Dependence& first = of(frame, args[0]);
        const Type from = frame.function[args[0]].type;
        const auto copy = [&](const Dependence& source, std::uint32_t source_at, std::uint32_t number) {
            for (std::uint32_t i = 0; i < number; i++) made.on.push_back(at(source, source_at + i));
        };
        if (inst.op == Op::Extract) {
            copy(first, first_component(module_, from, inst.data), count);
        } else if (inst.op == Op::Swizzle) {
            for (std::uint32_t i = 0; i < count; i++) copy(first, from.is_scalar() ? 0 : inst.data >> (2 * i) & 3u, 1);
        } else if (inst.op == Op::Transpose) {
            for (std::uint32_t i = 0; i < count; i++) copy(first, i % from.rows * from.cols + i / from.rows, 1);
        } else if (inst.op == Op::Insert) {
            const std::uint32_t at_part = first_component(module_, from, inst.data);
            const std::uint32_t size = component_count(module_, frame.function[args[1]].type);
            copy(first, 0, at_part);
            copy(of(frame, args[1]), 0, size);
            copy(first, at_part + size, count - at_part - size);
        } else {
            const bool is_splat = args.size() == 1 && component_count(module_, from) < count;
            for (std::uint32_t i = 0; is_splat && i < count; i++) copy(first, 0, 1);
            for (std::size_t k = 0; !is_splat && k < args.size(); k++)
                copy(of(frame, args[k]), 0, component_count(module_, frame.function[args[k]].type));
        }
        return made;
    }

    Dependence result(const Frame& frame, const Inst& inst) {
        const Value owner = frame.function.args(inst)[0];
        const Inst& structure = frame.function[owner];
        if (structure.op == Op::For) return of(frame, frame.function.blocks[structure.data].insts[inst.data + 1]);
        const Value condition = frame.function.args(structure)[0];
        const Value if_true = yielded(frame.function, structure.data)[inst.data];
        const Value if_false = yielded(frame.function, structure.data + 1)[inst.data];
        if (of(frame, condition).any()) {
            const std::uint32_t count = component_count(module_, inst.type);
            return broken(frame, structure, count, {condition, if_true, if_false}, Blame::What::Condition);
        }
        Dependence made = of(frame, if_true);
        add(made, of(frame, if_false));
        return made;
    }

    Dependence call(Frame& frame, Value value) {
        const Inst& inst = frame.function[value];
        const auto args = frame.function.args(inst);
        const bool has_arguments = std::any_of(args.begin(), args.end(), [&](Value v) { return of(frame, v).any(); });
        const std::uint32_t count = component_count(module_, inst.type);
        if (seed_.callee && inst.data == seed_.callee.index) {
            return has_arguments ? broken(frame, inst, count, args, Blame::What::SeedArguments) : whole(inst.type);
        }
        const bool reaches = !reaches_.empty() && reaches_[inst.data] != 0;
        if (!has_arguments && !reaches) return {};
        if (budget_ < module_.functions[inst.data].insts.size() || frame.depth >= kMaxDepth) {
            Dependence made = broken(frame, inst, count, args, Blame::What::TooLong);
            for (std::uint8_t& on : made.on) on |= bit(0) | Dependence::kOffset;
            return made;
        }
        std::vector<Dependence> arguments;
        for (const Value arg : args) arguments.push_back(of(frame, arg));
        std::unique_ptr<Activation>& made = frame.made.calls[value.index];
        made = activate({inst.data}, std::move(arguments), inst.origin ? inst.origin : frame.origin, frame.depth + 1);
        const Dependence result = made->result;
        if (!result.any()) frame.made.calls.erase(value.index);
        return result;
    }

    const Module& module_;
    const Seed seed_;
    std::vector<std::uint8_t> reaches_;
    std::vector<Blame> blames_;
    std::size_t budget_ = kBudget;
};

}  // namespace

bool Dependence::any() const {
    return std::any_of(on.begin(), on.end(), [](std::uint8_t component) { return (component & ~kOffset) != 0; });
}

bool Dependence::is_homogeneous() const {
    return any() && (all_of() & (kBroken | kOffset)) == 0;
}

std::uint8_t Dependence::all_of() const {
    std::uint8_t all = 0;
    for (const std::uint8_t component : on) all |= component;
    return all;
}

Affine affine_in(const Module& module, FunctionId function, const Seed& seed) {
    return Analyst(module, seed).run(function);
}

std::vector<std::uint8_t> reaching(const Module& module, FunctionId callee) {
    std::vector<std::uint8_t> reaches(module.functions.size());
    for (std::uint32_t f = 0; f < module.functions.size(); f++) {
        const std::vector<Inst>& insts = module.functions[f].insts;
        const bool calls = std::any_of(insts.begin(), insts.end(), [&](const Inst& inst) {
            return inst.op == Op::Call && reaches[inst.data] != 0;
        });
        reaches[f] = f == callee.index || calls ? 1 : 0;
    }
    return reaches;
}

std::uint32_t component_count(const Module& module, Type type) {
    if (type.is_numeric()) return type.components();
    if (type.kind == Kind::Array)
        return module.arrays[type.ref].count * component_count(module, module.arrays[type.ref].element);
    return type.kind == Kind::Struct ? first_component(module, type, part_count(module, type)) : 1;
}

std::uint32_t first_component(const Module& module, Type composite, std::uint32_t part) {
    if (composite.is_numeric()) return part * composite.cols;
    if (composite.kind == Kind::Array) return part * component_count(module, part_type(module, composite, 0));
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < part; i++) first += component_count(module, part_type(module, composite, i));
    return first;
}

bool is_linear(Op op) {
    return is_one_of(op, {Op::Construct, Op::Extract, Op::Insert, Op::Swizzle, Op::Convert, Op::Transpose, Op::Neg,
                          Op::Add, Op::Sub, Op::Radians, Op::Degrees});
}

}  // namespace patina::ir

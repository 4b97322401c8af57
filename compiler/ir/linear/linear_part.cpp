#include "compiler/ir/linear/linear_part.h"

#include <algorithm>
#include <functional>

#include "compiler/ir/linear/affine.h"
#include "compiler/ir/liveness.h"

namespace patina::ir {
namespace {

// Zero of the value's type. Members of a struct that are not numbers stay those of the value.
Value zero(Builder& b, Value like) {
    const Type type = b.type(like);
    if (type.is_numeric()) return b.splat_constant(type, 0);
    if (type.is_opaque()) return like;
    std::vector<Value> parts;
    for (std::uint32_t i = 0; i < part_count(b.module(), type); i++) parts.push_back(zero(b, b.extract(like, i)));
    return b.construct(type, parts);
}

// A body that is being copied. In a body that replaces a call, the parameters are the arguments of the call.
struct Frame {
    const Activation& facts;
    std::vector<Value> arguments{};          // of a call
    std::vector<Value> argument_tangents{};  // null: does not depend on x
    std::vector<Value> tangents{};           // by old value; null: does not depend on x, or is not affine
    std::vector<std::uint32_t> kept{};       // by old value, of If and For: how many values precede the tangents
    Value result{};                          // of a call
    Value result_tangent{};
};

// Emits each value and its tangent. Values that no tangent is multiplied by are dropped later.
class Emission {
public:
    Emission(Module& module, const Seed& seed, BuildOptions options)
        : module_(module), seed_(seed), options_(options) {}

    Function run(const Function& from, const Activation& facts) {
        Function made = shell(from);
        made.probes.clear();
        Builder builder(module_, made, options_);
        Frame frame{.facts = facts};
        copy(frame, from, builder, {}, 0);
        builder.ret(frame.result_tangent ? frame.result_tangent : zero(builder, frame.result));
        return made;
    }

private:
    void copy(Frame& frame, const Function& from, Builder& to, OriginId origin, int depth) {
        frame.tangents.resize(from.insts.size());
        frame.kept.resize(from.insts.size());
        Copy copy{.from = from, .to = to, .origin = origin, .rewrite = [&](Copy& c, Value v) {
                      return rewrite(frame, c, v, depth);
                  }};
        copy_body(copy);
    }

    static bool depends(const Frame& frame, Value value) { return frame.facts.values[value.index].any(); }

    bool rewrite(Frame& frame, Copy& copy, Value value, int depth) {
        const Inst& inst = copy.from[value];
        copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
        if (inst.op == Op::Param) return param(frame, copy, value, depth);
        if (inst.op == Op::If) return branch(frame, copy, value);
        if (inst.op == Op::For) return loop(frame, copy, value);
        if (inst.op == Op::Result) return result(frame, copy, value);
        if (inst.op == Op::Call) return call(frame, copy, value, depth);
        if (inst.op == Op::Return) {
            frame.result = copy.map[copy.from.args(inst)[0].index];
            frame.result_tangent = frame.tangents[copy.from.args(inst)[0].index];
            return true;
        }
        if (!depends(frame, value) || inst.op == Op::LoopCarried) return false;
        copy_plain(copy, value);
        copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
        const Value tangent = tangent_of(frame, copy, value);
        if (tangent && tangent != copy.map[value.index]) copy.to.name(tangent, inst.name);
        frame.tangents[value.index] = tangent;
        return true;
    }

    // --- what tangents are made of

    static Value tangent(const Frame& frame, Copy& copy, Value old) {
        const Value known = frame.tangents[old.index];
        return known ? known : zero(copy.to, copy.map[old.index]);
    }

    // Null for an op whose result is not affine.
    static Value tangent_of(const Frame& frame, Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const auto args = copy.from.args(inst);
        const auto tangent_at = [&](std::size_t k) { return frame.tangents[args[k].index]; };
        const auto value_at = [&](std::size_t k) { return copy.map[args[k].index]; };
        const auto emit = [&](std::initializer_list<Value> operands) {
            return copy.to.emit(inst.op, inst.type, operands, inst.data);
        };
        if (is_linear(inst.op)) {
            std::vector<Value> operands;
            for (const Value arg : args) operands.push_back(tangent(frame, copy, arg));
            return copy.to.emit(inst.op, inst.type, operands, inst.data);
        }
        if (inst.op == Op::Mul || inst.op == Op::Dot || inst.op == Op::Cross || inst.op == Op::MatMul) {
            const Value left = tangent_at(0) ? emit({tangent_at(0), value_at(1)}) : Value();
            const Value right = tangent_at(1) ? emit({value_at(0), tangent_at(1)}) : Value();
            return left && right ? copy.to.emit(Op::Add, inst.type, {left, right}) : left ? left : right;
        }
        if (inst.op == Op::Div || inst.op == Op::Reflect || inst.op == Op::Index)
            return tangent_at(0) ? emit({tangent_at(0), value_at(1)}) : Value();
        if (inst.op == Op::Select)
            return emit({value_at(0), tangent(frame, copy, args[1]), tangent(frame, copy, args[2])});
        if (inst.op != Op::Lerp) return {};
        const Value mixed = emit({tangent(frame, copy, args[0]), tangent(frame, copy, args[1]), value_at(2)});
        if (!tangent_at(2)) return mixed;
        const Value range = copy.to.emit(Op::Sub, inst.type, {value_at(1), value_at(0)});
        return copy.to.emit(Op::Add, inst.type, {mixed, copy.to.emit(Op::Mul, inst.type, {range, tangent_at(2)})});
    }

    bool param(Frame& frame, Copy& copy, Value value, int depth) {
        const std::uint32_t index = copy.from[value].data;
        if (depth > 0) {
            copy.map[value.index] = frame.arguments[index];
            frame.tangents[value.index] = frame.argument_tangents[index];
            return true;
        }
        copy_plain(copy, value);
        if (!depends(frame, value)) return true;
        const Value whole = copy.map[value.index];
        const bool is_struct = copy.from[value].type.kind == Kind::Struct;
        frame.tangents[value.index] =
            is_struct ? copy.to.emit(Op::Insert, copy.from[value].type,
                                     {zero(copy.to, whole), copy.to.extract(whole, seed_.member)}, seed_.member)
                      : whole;
        return true;
    }

    bool call(Frame& outer, Copy& copy, Value value, int depth) {
        if (!depends(outer, value)) return false;
        const auto opened = outer.facts.calls.find(value.index);
        if (opened == outer.facts.calls.end()) {
            copy_plain(copy, value);
            if (seed_.callee && copy.from[value].data == seed_.callee.index)
                outer.tangents[value.index] = copy.map[value.index];
            return true;
        }
        const Inst& inst = copy.from[value];
        Frame inner{.facts = *opened->second};
        for (const Value arg : copy.from.args(inst)) {
            inner.arguments.push_back(copy.map[arg.index]);
            inner.argument_tangents.push_back(outer.tangents[arg.index]);
        }
        this->copy(inner, module_.functions[inst.data], copy.to, inst.origin ? inst.origin : copy.origin, depth + 1);
        copy.to.name(inner.result_tangent, inst.name);
        copy.map[value.index] = inner.result;
        outer.tangents[value.index] = inner.result_tangent;
        return true;
    }

    // --- structure: what a branch or a loop yields is followed by the tangents that it yields

    bool branch(Frame& frame, Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const auto then_values = yielded(copy.from, inst.data), else_values = yielded(copy.from, inst.data + 1);
        std::vector<std::uint32_t> dependent;
        for (std::uint32_t k = 0; k < then_values.size(); k++) {
            if (depends(frame, then_values[k]) || depends(frame, else_values[k])) dependent.push_back(k);
        }
        if (dependent.empty()) return false;
        frame.kept[value.index] = static_cast<std::uint32_t>(then_values.size());
        const Value made = copy.to.begin_if(copy.map[copy.from.args(inst)[0].index]);
        copy_block(copy, inst.data);
        const std::vector<Value> if_true = with_tangents(frame, copy, then_values, dependent);
        copy.to.begin_else();
        copy_block(copy, inst.data + 1);
        const std::vector<Value> if_false = with_tangents(frame, copy, else_values, dependent);
        copy.to.end_if(if_true, if_false);
        copy.map[value.index] = made;
        return true;
    }

    bool loop(Frame& frame, Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const auto args = copy.from.args(inst);
        const std::vector<Value>& body = copy.from.blocks[inst.data].insts;
        const auto carried = static_cast<std::uint32_t>(args.size() - 2);
        std::vector<std::uint32_t> dependent;
        for (std::uint32_t k = 0; k < carried; k++) {
            if (depends(frame, body[k + 1])) dependent.push_back(k);
        }
        if (dependent.empty()) return false;
        frame.kept[value.index] = carried;
        const Value made =
            copy.to.begin_for(copy.map[args[0].index], copy.map[args[1].index],
                              with_tangents(frame, copy, args.subspan(2), dependent), inst.is_light_loop);
        copy.map[body[0].index] = copy.to.loop_index();
        for (std::uint32_t k = 0; k < carried; k++) {
            copy.map[body[k + 1].index] = copy.to.loop_carried(k);
            copy.changed[body[k + 1].index] = 1;
        }
        for (std::uint32_t k = 0; k < dependent.size(); k++)
            frame.tangents[body[dependent[k] + 1].index] = copy.to.loop_carried(carried + k);
        copy_block(copy, inst.data);
        copy.to.end_for(with_tangents(frame, copy, yielded(copy.from, inst.data), dependent));
        copy.map[value.index] = made;
        return true;
    }

    static std::vector<Value> with_tangents(const Frame& frame, Copy& copy, std::span<const Value> old,
                                            std::span<const std::uint32_t> dependent) {
        std::vector<Value> values;
        for (const Value value : old) values.push_back(copy.map[value.index]);
        for (const std::uint32_t k : dependent) values.push_back(tangent(frame, copy, old[k]));
        return values;
    }

    // Which of the tangents that the structure yields belongs to its value number `index`.
    static std::uint32_t number_of(const Frame& frame, const Function& from, const Inst& structure,
                                   std::uint32_t index) {
        std::uint32_t number = 0;
        for (std::uint32_t k = 0; k < index; k++) {
            const bool is_dependent = structure.op == Op::For
                                          ? depends(frame, from.blocks[structure.data].insts[k + 1])
                                          : depends(frame, yielded(from, structure.data)[k]) ||
                                                depends(frame, yielded(from, structure.data + 1)[k]);
            number += is_dependent ? 1 : 0;
        }
        return number;
    }

    bool result(Frame& frame, Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const Value owner = copy.from.args(inst)[0];
        if (frame.kept[owner.index] == 0) return false;  // copied plainly
        const Value structure = copy.map[owner.index];
        copy.map[value.index] = copy.to.result(structure, inst.data);
        copy.to.name(copy.map[value.index], inst.name);
        if (!depends(frame, value)) return true;
        const std::uint32_t number = number_of(frame, copy.from, copy.from[owner], inst.data);
        frame.tangents[value.index] = copy.to.result(structure, frame.kept[owner.index] + number);
        copy.to.name(frame.tangents[value.index], inst.name);
        return true;
    }

    Module& module_;
    const Seed seed_;
    const BuildOptions options_;
};

Function swept(Module& module, const Function& from, BuildOptions options) {
    const Liveness live = live_in(from);
    Function made = shell(from);
    Builder builder(module, made, options);
    Copy copy{.from = from, .to = builder, .live = &live};
    copy_body(copy);
    return made;
}

std::string reason_of(const Module& module, const Blame& blame, FunctionId function) {
    const std::string op = "'" + std::string(info(blame.op).text) + "'";
    const auto what = [&]() -> std::string {
        switch (blame.what) {
            case Blame::What::NotLinear: return op + " is not linear";
            case Blame::What::Product: return op + " is given two values that depend on it";
            case Blame::What::Condition: return op + " has a condition that depends on it";
            case Blame::What::SeedArguments: return "its arguments depend on it";
            case Blame::What::TooLong: return "it calls too many functions to check";
            case Blame::What::Mixes: return op + " mixes its components";
        }
        return {};
    };
    return blame.function == function ? what() : what() + ", in " + module[blame.function].name;
}

bool is_componentwise(const Dependence& result) {
    for (std::size_t i = 0; i < result.on.size(); i++) {
        if ((result.on[i] & ~(1u << i | Dependence::kOffset)) != 0) return false;
    }
    return true;
}

// The function with zero in the place of x. A value that is homogeneous in x becomes zero, so that the other factors of
// a product are not computed.
class Without {
public:
    Without(Module& module, const Seed& seed, BuildOptions options) : module_(module), seed_(seed), options_(options) {
        if (seed.callee) reaches_ = reaching(module, seed.callee);
    }

    Function run(FunctionId function, const Activation& facts) {
        Function made = shell(module_[function]);
        made.probes.clear();
        Builder builder(module_, made, options_);
        Copy copy{.from = module_[function], .to = builder, .rewrite = [&](Copy& c, Value v) {
                      return homogeneous(c, v, &facts) ||
                             (c.from[v].op == Op::Param ? param(c, v) : call(c, v, &facts));
                  }};
        copy_body(copy);
        return made;
    }

private:
    // `facts`: null if nothing is known of the function.
    static bool homogeneous(Copy& copy, Value value, const Activation* facts) {
        if (!facts || copy.from[value].op == Op::LoopCarried || !facts->values[value.index].is_homogeneous())
            return false;
        copy_plain(copy, value);
        copy.map[value.index] = zero(copy.to, copy.map[value.index]);
        copy.changed[value.index] = 1;
        return true;
    }

    bool param(Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        if (seed_.callee || inst.data != seed_.param) return false;
        copy_plain(copy, value);
        const Value whole = copy.map[value.index];
        copy.map[value.index] = copy.to.emit(
            Op::Insert, inst.type, {whole, zero(copy.to, copy.to.extract(whole, seed_.member))}, seed_.member);
        copy.changed[value.index] = 1;
        return true;
    }

    // A call is inlined if the function calls the seed's callee, or if it is affine in an argument that depends on x.
    bool call(Copy& outer, Value value, const Activation* facts) {
        const Inst& inst = outer.from[value];
        if (inst.op != Op::Call) return false;
        const Activation* inside = nullptr;
        if (facts && facts->calls.contains(value.index)) inside = facts->calls.at(value.index).get();
        const bool is_affine = inside && (inside->result.all_of() & Dependence::kBroken) == 0;
        const bool reaches = seed_.callee && reaches_[inst.data] != 0;
        if (!reaches && !is_affine) return false;
        if (seed_.callee && inst.data == seed_.callee.index) {
            copy_plain(outer, value);
            outer.map[value.index] = zero(outer.to, outer.map[value.index]);
            outer.changed[value.index] = 1;
            return true;
        }
        Value result;
        Copy inner{.from = module_.functions[inst.data],
                   .to = outer.to,
                   .origin = inst.origin ? inst.origin : outer.origin,
                   .rewrite = [&](Copy& c, Value v) {
                       const Inst& at = c.from[v];
                       if (at.op == Op::Param) c.map[v.index] = outer.map[outer.from.args(inst)[at.data].index];
                       if (at.op == Op::Return) result = c.map[c.from.args(at)[0].index];
                       return at.op == Op::Param || at.op == Op::Return || homogeneous(c, v, inside) ||
                              call(c, v, inside);
                   }};
        copy_body(inner);
        outer.to.name(result, inst.name);
        outer.map[value.index] = result;
        return true;
    }

    Module& module_;
    const Seed seed_;
    const BuildOptions options_;
    std::vector<std::uint8_t> reaches_;
};

}  // namespace

LinearPart linear_part(Module& module, FunctionId function, const Seed& seed, const LinearOptions& options) {
    const Affine affine = affine_in(module, function, seed);
    const Dependence& result = affine.root->result;
    LinearPart made{.function = {}, .depends = result.any(), .reason = {}, .origin = {}};
    const bool is_broken = (result.all_of() & Dependence::kBroken) != 0;
    if (is_broken || (options.componentwise && !is_componentwise(result))) {
        const std::uint32_t by = is_broken ? result.broken_by : result.mixed_by;
        // No instruction has mixed a single component that is not the first.
        made.reason = by == kNoBlame ? "its components are reordered" : reason_of(module, affine.blames[by], function);
        if (by != kNoBlame) made.origin = affine.blames[by].origin;
        return made;
    }
    const Function whole = Emission(module, seed, options.build).run(module[function], *affine.root);
    made.function = swept(module, whole, options.build);
    return made;
}

Function without(Module& module, FunctionId function, const Seed& seed, BuildOptions build) {
    const Affine affine = affine_in(module, function, seed);
    return swept(module, Without(module, seed, build).run(function, *affine.root), build);
}

}  // namespace patina::ir

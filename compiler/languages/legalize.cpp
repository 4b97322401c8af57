#include "compiler/languages/legalize.h"

#include <algorithm>
#include <optional>

#include "compiler/ir/fold/facts.h"
#include "compiler/ir/passes/passes.h"

namespace patina::languages {

using namespace ir;

namespace {

const Type& type_of_operand(const Function& function, Value v, std::uint32_t index) {
    return function[function.args(v)[index]].type;
}

// --- x mod y has the sign of x; GLSL's mod and glslang's % have the sign of y, even for ints

bool is_signed_mod(const Module&, const Function& function, Value v) {
    return function[v].type.scalar != Scalar::Uint && !function[v].type.is_matrix();
}
Value expand_mod(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Value x = operand(copy, v, 0), y = operand(copy, v, 1);
    const Type type = copy.from[v].type;
    Value quotient = b.emit(Op::Div, type, {x, y});
    if (type.is_floating()) quotient = b.emit(Op::Trunc, type, {quotient});
    return b.emit(Op::Sub, type, {x, b.emit(Op::Mul, type, {y, quotient})});
}

// --- x to the power of 0 is 1, of x = 0 too; GLSL leaves that undefined, and HLSL computes exp2(0 log2(0)), NaN

// True if `power` only counts where its base is above 0: all that reads it is `base > 0 ? power : y`.
bool is_chosen_above_zero(const FactsOf& facts, Value power, Value base) {
    const Function& function = facts.function;
    const auto is_above_zero = [&](Value condition) {
        const auto sides = function.args(condition);
        return function[condition].op == Op::Greater && sides[0] == base && range_of(facts, sides[1]).low >= 0;
    };
    return std::all_of(function.insts.begin(), function.insts.end(), [&](const Inst& inst) {
        const auto args = function.args(inst);
        const auto reads = std::count(args.begin(), args.end(), power);
        return reads == 0 || (reads == 1 && inst.op == Op::Select && args[1] == power && is_above_zero(args[0]));
    });
}

bool may_be_zero_to_zero(const Module& module, const Function& function, Value v) {
    if (function[v].type.is_matrix()) return false;
    const FactsOf facts{module, function, true};
    const Value base = function.args(v)[0], exponent = function.args(v)[1];
    if (range_of(facts, exponent).low > 0 || range_of(facts, base).low > 0) return false;
    if (is_chosen_above_zero(facts, v, base)) return false;
    const Inst& chosen = function[base];
    if (chosen.op != Op::Select || function[function.args(chosen)[0]].op != Op::Equal) return true;
    return function.args(function.args(chosen)[0])[0] != exponent;  // else the base is one_where_exponent_is_zero()
}
Value one_where_exponent_is_zero(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Type type = copy.from[v].type;
    const Value base = operand(copy, v, 0), exponent = operand(copy, v, 1);
    const Value is_zero = b.emit(Op::Equal, type.with_scalar(Scalar::Bool), {exponent, b.splat_constant(type, 0)});
    return b.emit(Op::Pow, type, {b.emit(Op::Select, type, {is_zero, b.splat_constant(type, 1), base}), exponent});
}

// --- component-wise operations on matrices: in GLSL, * multiplies matrices, and functions take none

bool is_matrix_op(const Module&, const Function& function, Value v) {
    const Inst& inst = function[v];
    const bool is_operator = inst.op == Op::Add || inst.op == Op::Sub || inst.op == Op::Div || inst.op == Op::Neg;
    return inst.type.is_matrix() && !is_operator;
}
Value split_rows(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Inst& inst = copy.from[v];
    const Type row_type = inst.type.with_width(inst.type.cols);
    std::vector<Value> rows;
    for (std::uint32_t i = 0; i < inst.type.rows; ++i) {
        std::vector<Value> parts;
        for (std::uint32_t n = 0; n < inst.operand_count; ++n) parts.push_back(b.extract(operand(copy, v, n), i));
        rows.push_back(b.emit(inst.op, row_type, parts));
    }
    return b.construct(inst.type, rows);
}

// --- an index out of range is clamped; the languages leave it undefined

bool may_leave_range(const Module& module, const Function& function, Value v) {
    const Range range = range_of({module, function, true}, function.args(v)[1]);
    return range.low < 0 || range.high > part_count(module, type_of_operand(function, v, 0)) - 1.0;
}
Value clamp_index(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Value composite = operand(copy, v, 0), index = operand(copy, v, 1);
    const Type type = b.type(index);
    const Value last = b.constant(type, {part_count(b.module(), b.type(composite)) - 1.0});
    const bool is_signed = type.scalar == Scalar::Int;
    const Value clamped = is_signed ? b.emit(Op::Clamp, type, {index, b.constant(type, {0}), last})
                                    : b.emit(Op::Min, type, {index, last});
    return b.emit(Op::Index, copy.from[v].type, {composite, clamped});
}

// --- SPIR-V differentiates only 32-bit floats

bool is_half_derivative(const Module&, const Function& function, Value v) {
    return function[v].type.scalar == Scalar::Half;
}
Value differentiate_as_float(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Type type = copy.from[v].type.with_scalar(Scalar::Float);
    return b.convert(b.emit(copy.from[v].op, type, {b.convert(operand(copy, v, 0), Scalar::Float)}), Scalar::Half);
}

// --- the vertex stage has no neighbouring pixels, so a sample reads level 0 there

bool samples_in_vertex_stage(const Module& module, const Function&, Value) {
    return module.stage.entry && module.stage.kind == StageKind::Vertex;
}
Value sample_at_level(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Value level = copy.from[v].op == Op::SampleBias ? operand(copy, v, 3) : b.constant(kFloat, {0});
    return b.emit(Op::SampleLevel, kFloat4, {operand(copy, v, 0), operand(copy, v, 1), operand(copy, v, 2), level});
}

// --- functions of vectors that the IR allows on scalars

bool is_scalar_geometry(const Module&, const Function& function, Value v) {
    return type_of_operand(function, v, 0).is_scalar();
}
Value scalar_geometry(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Op op = copy.from[v].op;
    const Value x = operand(copy, v, 0);
    if (op == Op::Any || op == Op::All) return x;
    const Type type = b.type(x);
    if (op == Op::Length) return b.emit(Op::Abs, type, {x});
    const Value y = operand(copy, v, 1);
    if (op == Op::Dot) return b.emit(Op::Mul, type, {x, y});
    if (op == Op::Distance) return b.emit(Op::Abs, type, {b.emit(Op::Sub, type, {x, y})});
    // reflect(x, y) = x - 2 (y . x) y
    const Value twice = b.emit(Op::Mul, type, {b.constant(type, {2}), b.emit(Op::Mul, type, {y, x})});
    return b.emit(Op::Sub, type, {x, b.emit(Op::Mul, type, {twice, y})});
}

// --- a choice between vectors by a specialization constant: glslang makes a constant of it, as SPIR-V allows, and Mesa
// 22.3 takes the wrong vector, even if the condition repeats one value three times. A choice between scalars is right.

bool is_of_pipeline(const Module& module, const Function& function, Value v, int depth = 0) {
    const Inst& inst = function[v];
    if (inst.op == Op::Constant) return true;
    if (inst.op == Op::Global) return module.globals[inst.data].is_keyword();
    const auto args = function.args(v);
    return depth < 16 && !args.empty() && info(inst.op).traits != Structure && inst.op != Op::Call &&
           std::all_of(args.begin(), args.end(),
                       [&](Value arg) { return is_of_pipeline(module, function, arg, depth + 1); });
}
bool chooses_vector_of_pipeline(const Module& module, const Function& function, Value v) {
    return !module.keywords.empty() && !module.tests_keywords && function[v].type.is_vector() &&
           is_of_pipeline(module, function, v);
}
Value component(Builder& b, Value vector, std::uint32_t index) {
    const std::span<const double> numbers = b.constant_of(vector);
    const Type type = b.type(vector).with_width(1);
    return numbers.empty() ? b.extract(vector, index) : b.constant(type, {numbers[index]});
}
bool repeats(std::span<const double> numbers) {
    return !numbers.empty() && std::all_of(numbers.begin(), numbers.end(), [&](double n) { return n == numbers[0]; });
}
Value choose_components(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Type type = copy.from[v].type;
    const Value condition = operand(copy, v, 0), yes = operand(copy, v, 1), no = operand(copy, v, 2);
    if (b.type(condition).is_scalar() && repeats(b.constant_of(yes)) && repeats(b.constant_of(no))) {
        const Value chosen =
            b.emit(Op::Select, type.with_width(1), {condition, component(b, yes, 0), component(b, no, 0)});
        return b.splat(chosen, type.width());
    }
    std::vector<Value> parts;
    for (std::uint32_t i = 0; i < type.width(); ++i) {
        const Value chosen = b.type(condition).is_scalar() ? condition : component(b, condition, i);
        parts.push_back(b.emit(Op::Select, type.with_width(1), {chosen, component(b, yes, i), component(b, no, i)}));
    }
    return b.construct(type, parts);
}

constexpr Rule kShared[] = {
    {{Op::Mod}, is_signed_mod, expand_mod},
    {{Op::Pow}, may_be_zero_to_zero, one_where_exponent_is_zero},
    {OpSet(TypeRule::Same), is_matrix_op, split_rows},
    {{Op::Index}, may_leave_range, clamp_index},
    {{Op::Ddx, Op::Ddy, Op::Fwidth}, is_half_derivative, differentiate_as_float},
    {{Op::Sample, Op::SampleBias}, samples_in_vertex_stage, sample_at_level},
    {{Op::Dot, Op::Length, Op::Distance, Op::Reflect, Op::Any, Op::All}, is_scalar_geometry, scalar_geometry},
    {{Op::Select}, chooses_vector_of_pipeline, choose_components},
};

const Rule* rule_for(std::span<const Rule> rules, const Module& module, const Function& function, Value v) {
    const Op op = function[v].op;
    const auto applies = [&](const Rule& rule) { return rule.ops.has(op) && rule.applies(module, function, v); };
    const auto found = std::find_if(rules.begin(), rules.end(), applies);
    return found == rules.end() ? nullptr : &*found;
}

bool is_legal_in(const Module& module, const Function& function, std::span<const Rule> rules) {
    for (std::uint32_t i = 0; i < function.insts.size(); ++i) {
        if (function.insts[i].op == Op::DiscardIf || rule_for(rules, module, function, {i}) != nullptr) return false;
    }
    return true;
}

// True if anything was rewritten.
bool legalize_once(Module& module, Function& function, std::span<const Rule> rules) {
    std::vector<const Rule*> applying(function.insts.size());
    for (std::uint32_t i = 0; i < applying.size(); ++i) applying[i] = rule_for(rules, module, function, {i});
    if (std::all_of(applying.begin(), applying.end(), [](const Rule* rule) { return rule == nullptr; })) return false;

    Function made = take_shell(function);
    Builder builder(module, made, {.fold = false});  // folding would undo some rewrites
    Copy copy{.from = function, .to = builder};
    copy.rewrite = [&](Copy& c, Value v) {
        if (applying[v.index] == nullptr) return false;
        c.to.set_origin(c.from[v].origin);
        const Value value = applying[v.index]->rewrite(c, v);
        c.to.name(value, c.from[v].name);
        c.map[v.index] = value;
        return true;
    };
    copy_body(copy);
    function = std::move(made);
    return true;
}

}  // namespace

std::optional<Module> legalize(const Module& module, std::span<const Rule> rules) {
    std::vector<Rule> all(std::begin(kShared), std::end(kShared));
    all.insert(all.end(), rules.begin(), rules.end());
    const bool is_legal = std::all_of(module.functions.begin(), module.functions.end(),
                                      [&](const Function& function) { return is_legal_in(module, function, all); });
    if (is_legal) return {};

    // In both languages a discard ends the pixel at once, but its neighbours still need its values for their
    // derivatives.
    Module legal = legalize_discard(module);
    for (Function& function : legal.functions) {
        // The result of a rule may need another one, of a smaller type: a matrix's saturate becomes that of its rows.
        while (legalize_once(legal, function, all)) continue;
    }
    return legal;
}

}  // namespace patina::languages

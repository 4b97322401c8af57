// The loops of HLSL. A loop whose rounds can be counted becomes a For over them. Any other loop becomes a For with at
// most kOpenRounds rounds. It carries a bool, and ends when the bool is false.
#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/emit/constant_value.h"
#include "compiler/emit/conversion.h"
#include "compiler/emit/statements/statements.h"

namespace patina::emit {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

constexpr double kOpenRounds = 1024;  // of one whose end only the shader knows

// "int i = first; i < limit; i += step"
struct Counter {
    const Local* local = nullptr;
    std::string_view comparison{};
    const Expr* limit = nullptr;
    double first = 0, step = 0;
};

std::string_view turned(std::string_view comparison) {
    return comparison == "<"    ? ">"
           : comparison == ">"  ? "<"
           : comparison == "<=" ? ">="
           : comparison == ">=" ? "<="
                                : comparison;
}

bool is_assigned(std::string_view name, const std::vector<std::string_view>& assigned) {
    return std::find(assigned.begin(), assigned.end(), name) != assigned.end();
}

// True if no round changes what the expression gives.
bool stays(const Expr& expr, const std::vector<std::string_view>& assigned) {
    if (expr.kind == Expr::Kind::Name && is_assigned(expr.text, assigned)) return false;
    if (expr.kind == Expr::Kind::Assign || expr.kind == Expr::Kind::AssignLater) return false;
    return std::all_of(expr.args.begin(), expr.args.end(), [&](const Expr* arg) { return stays(*arg, assigned); });
}

// i++, i += 2, i = i + 2: the constant that is added.
std::optional<double> step_of(Emitter& emitter, const Stmt& step, std::string_view name, const Scope& scope) {
    const auto is_counter = [&](const Expr& expr) { return expr.kind == Expr::Kind::Name && expr.text == name; };
    if (step.kind != Stmt::Kind::Assign || !is_counter(*step.target)) return {};
    const bool is_sum = step.op == "=" && step.value->kind == Expr::Kind::Binary && is_counter(*step.value->args[0]);
    const std::string_view op = is_sum ? step.value->text : step.op.substr(0, step.op.size() - 1);
    const std::optional<double> by = constant_value(emitter.known, is_sum ? *step.value->args[1] : *step.value, scope);
    if (!by || *by == 0 || (op != "+" && op != "-")) return {};
    return op == "+" ? *by : -*by;
}

std::optional<Counter> counter_of(Emitter& emitter, const Stmt& loop, const Scope& scope,
                                  const std::vector<std::string_view>& assigned_in_body) {
    if (!loop.counter || loop.tests_later || !loop.value || loop.step.size() != 1) return {};
    Counter made;
    for (const Local& local : scope.locals) {
        if (local.name == loop.counter->name) made.local = &local;
    }
    if (!made.local || !made.local->constant || is_assigned(made.local->name, assigned_in_body)) return {};
    const Type type = made.local->value.type;
    if (!type.is_scalar() || type.is_bool()) return {};
    const Expr& test = *loop.value;
    constexpr std::string_view kComparisons[] = {"<", "<=", ">", ">=", "!="};
    if (test.kind != Expr::Kind::Binary ||
        std::find(std::begin(kComparisons), std::end(kComparisons), test.text) == std::end(kComparisons))
        return {};
    const auto is_counter = [&](const Expr& expr) {
        return expr.kind == Expr::Kind::Name && expr.text == made.local->name;
    };
    const bool is_left = is_counter(*test.args[0]);
    if (!is_left && !is_counter(*test.args[1])) return {};
    made.comparison = is_left ? test.text : turned(test.text);
    made.limit = test.args[is_left ? 1 : 0];
    made.first = *made.local->constant;
    // The guard of a step that a jump skips has the step inside.
    const Stmt* step = loop.step[0];
    if (loop.limit && step->kind == Stmt::Kind::If && step->body.size() == 1) step = step->body[0];
    const std::optional<double> by = step_of(emitter, *step, made.local->name, scope);
    if (!by) return {};
    made.step = *by;
    if (type.is_integer() && made.step != std::floor(made.step)) return {};
    return made;
}

bool holds(std::string_view comparison, double a, double b) {
    return comparison == "<"    ? a < b
           : comparison == "<=" ? a <= b
           : comparison == ">"  ? a > b
           : comparison == ">=" ? a >= b
                                : a != b;
}

// The rounds of a counter with a constant limit, as 32-bit numbers count; more than kMaxIterations: at least so many.
double rounds_of(const Counter& counter, double limit) {
    const Type type = counter.local->value.type;
    double rounds = 0;
    for (double at = counter.first; rounds <= kMaxIterations && holds(counter.comparison, at, limit); ++rounds) {
        at += counter.step;
        if (type.is_floating()) at = static_cast<float>(at);
        if (type.scalar == ir::Scalar::Uint && at < 0) at += 4294967296.0;
    }
    return rounds;
}

// The variables that a loop carries, and how they are before and after it.
class Carried {
public:
    // `last`: the variable that comes last; may be empty.
    Carried(const Stmt& loop, Scope& scope, std::string_view without, std::string_view last) : scope_(scope) {
        std::vector<std::string_view> assigned;
        collect_assigned({&loop}, scope, assigned);
        for (std::size_t i = 0; i < scope.locals.size(); ++i) {
            const Local& local = scope.locals[i];
            if (!local.value.ok() || local.name == without || !is_assigned(local.name, assigned)) continue;
            locals_.push_back(i);
        }
        std::stable_partition(locals_.begin(), locals_.end(),
                              [&](std::size_t i) { return scope.locals[i].name != last; });
    }
    std::vector<Value> values() const {
        std::vector<Value> made;
        for (const std::size_t i : locals_) made.push_back(scope_.locals[i].value.value);
        return made;
    }
    // They have the values that `value` gives, which nobody knows before the shader runs.
    template <class Give>
    void set(Emitter& emitter, const Give& value) {
        for (std::uint32_t k = 0; k < locals_.size(); ++k) {
            Local& local = scope_.locals[locals_[k]];
            local.value.value = value(k);
            local.constant.reset();
            scope_.builder->name(local.value.value, emitter.module.intern(local.name));
        }
    }

private:
    Scope& scope_;
    std::vector<std::size_t> locals_{};
};

// The conditions of a further round as one bool; null after an error.
Value goes_on(Emitter& emitter, const Stmt& loop, bool is_first, bool is_counted, Scope& scope) {
    Value made;
    for (const Expr* each : {is_first ? nullptr : loop.limit, is_counted ? nullptr : loop.value}) {
        if (!each) continue;
        const Typed value = expression_as(emitter, *each, ir::kBool, scope, "the condition");
        if (!value.ok()) return {};
        made = made ? scope.builder->emit(Op::And, ir::kBool, {made, value.value}) : value.value;
    }
    return made ? made : scope.builder->constant(ir::kBool, {1});
}

void emit_body(Emitter& emitter, const Stmt& loop, bool with_step, Scope& scope) {
    const std::string_view outer_flow = std::exchange(scope.flow, "for");
    Value returned;
    block(emitter, loop.body, scope, returned);
    if (with_step) block(emitter, loop.step, scope, returned);
    scope.flow = outer_flow;
}

// The counter in round `round`, as a constant of the body.
void push_counter(Emitter& emitter, const Counter& counter, Value round, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Type type = counter.local->value.type;
    Local made{.name = counter.local->name, .value = {.value = {}, .type = type}, .is_const = true, .constant = {}};
    Value at = round;
    if (counter.step != 1) at = b.emit(Op::Mul, ir::kInt, {at, b.constant(ir::kInt, {counter.step})});
    if (counter.first != 0) at = b.emit(Op::Add, ir::kInt, {at, b.constant(ir::kInt, {counter.first})});
    made.value.value = b.convert(at, type.scalar);
    if (const std::span<const double> known = b.constant_of(made.value.value); !known.empty()) made.constant = known[0];
    b.name(made.value.value, emitter.module.intern(made.name));
    scope.locals.push_back(std::move(made));
}

// The rounds one after the other.
void write_out(Emitter& emitter, const Stmt& loop, const Counter& counter, double rounds, Scope& scope) {
    const std::size_t outer = scope.locals.size(), before = emitter.growth ? emitter.growth->made : 0;
    for (double i = 0; i < rounds; ++i) {
        grow(emitter, loop.name_span);
        if (i == 1 && emitter.growth) {
            const auto round = static_cast<double>(emitter.growth->made - before);
            expect_growth(emitter, round * rounds, loop.name_span,
                          "[unroll] writes out all rounds of the loop: without it, the loop stays one");
        }
        push_counter(emitter, counter, scope.builder->constant(ir::kInt, {i}), scope);
        emit_body(emitter, loop, false, scope);
        scope.locals.resize(outer);
    }
}

}  // namespace

void loop_statement(Emitter& emitter, const Stmt& stmt, Scope& scope) {
    ir::Builder& b = *scope.builder;
    std::vector<std::string_view> assigned;
    collect_assigned(stmt.body, scope, assigned);
    std::optional<Counter> counter = counter_of(emitter, stmt, scope, assigned);
    std::optional<double> limit = counter ? constant_value(emitter.known, *counter->limit, scope) : std::nullopt;
    Value end;
    double rounds = kOpenRounds;
    if (limit) {
        rounds = rounds_of(*counter, *limit);
        if (rounds > kMaxIterations) {
            emitter.diagnostics.report(Code::TooMany, stmt.name_span, rounds, "iterations of a loop", kMaxIterations);
            return;
        }
        end = b.constant(ir::kInt, {rounds});
    } else if (counter) {
        // "i < count" with an int that stays: the shader asks for it once.
        const Type type = counter->local->value.type;
        const bool is_plain =
            counter->step == 1 && type == ir::kInt && counter->comparison == "<" && stays(*counter->limit, assigned);
        const Typed count =
            is_plain ? primary(emitter, expression(emitter, *counter->limit, scope), scope, counter->limit->span)
                     : Typed{};
        if (is_plain && !count.ok()) return;
        if (is_plain && count.type.is_scalar() && (count.type == ir::kInt)) {
            const Value from = counter->first == 0
                                   ? count.value
                                   : b.emit(Op::Sub, ir::kInt, {count.value, b.constant(ir::kInt, {counter->first})});
            end = b.emit(Op::Min, ir::kInt, {from, b.constant(ir::kInt, {kOpenRounds})});
        } else {
            counter.reset();
        }
    }
    // A counter that is rounded from step to step is carried like any variable.
    const bool is_whole = counter && counter->first == std::floor(counter->first) &&
                          counter->step == std::floor(counter->step) && std::abs(counter->first) < 1e6 &&
                          std::abs(counter->step) < 1e6;
    const bool is_counted = static_cast<bool>(end);
    const bool has_index = is_counted && is_whole;
    count_rounds(emitter, rounds, scope, stmt.name_span);
    if (has_index && stmt.is_unrolled && limit && !stmt.limit) return write_out(emitter, stmt, *counter, rounds, scope);
    if (!end) end = b.constant(ir::kInt, {kOpenRounds});

    const bool is_while = !is_counted || stmt.limit;
    const std::size_t outer = scope.locals.size();
    // The counter's own local is not changed if the index of the For stands for it.
    // One bool alone may decide; then it is what the For carries last.
    const bool is_flag = is_counted && stmt.limit && stmt.limit->kind == Expr::Kind::Name;
    Carried carried(stmt, scope, has_index ? stmt.counter->name : std::string_view(),
                    is_flag ? stmt.limit->text : std::string_view());
    std::vector<Value> initial = carried.values();
    if (is_while && !is_flag) {
        Value first = stmt.tests_later ? b.constant(ir::kBool, {1}) : goes_on(emitter, stmt, true, is_counted, scope);
        if (!first) return;
        initial = carried.values();  // the condition may assign
        initial.push_back(first);
    }
    Counter counted = has_index ? *counter : Counter{};
    const Local own = has_index ? *counter->local : Local{};
    counted.local = &own;
    b.begin_for(b.constant(ir::kInt, {0}), end, initial, false, is_while);
    scope.rounds_around *= std::max(rounds, 1.0);
    carried.set(emitter, [&](std::uint32_t k) { return b.loop_carried(k); });
    if (has_index) push_counter(emitter, counted, b.loop_index(), scope);
    emit_body(emitter, stmt, !has_index, scope);
    scope.rounds_around /= std::max(rounds, 1.0);
    Value again;
    if (is_while && !is_flag) again = goes_on(emitter, stmt, false, is_counted, scope);
    scope.locals.resize(outer);
    std::vector<Value> next = carried.values();
    if (is_while && !is_flag) {
        if (!again) again = b.constant(ir::kBool, {0});  // reported
        b.name(again, emitter.module.intern("running"));
        next.push_back(again);
    }
    const Value loop = b.end_for(next);
    carried.set(emitter, [&](std::uint32_t k) { return b.result(loop, k); });
}

}  // namespace patina::emit

// If and for: branches yield what was assigned in them, loops carry it, and the rounds of all loops are counted.
#include <algorithm>
#include <array>
#include <utility>

#include "compiler/base/text.h"
#include "compiler/emit/constant_value.h"
#include "compiler/emit/statements/statements.h"

namespace patina::emit {

using ir::Value;

namespace {

constexpr double kMaxRounds = 1u << 22;  // of all loops and calls of a function, nested ones multiplied
// The statements after a branch that returns are nested in its else.
constexpr std::size_t kMaxBranches = 200;

bool contains_return(const Statements& list) {
    return std::any_of(list.begin(), list.end(), [](const Stmt* s) {
        return s->kind == Stmt::Kind::Return || contains_return(s->body) || contains_return(s->alternative);
    });
}

void add_root(const Expr& target, std::vector<std::string_view>& names) {
    const Expr* root = &target;
    while (root->kind == Expr::Kind::Member || root->kind == Expr::Kind::Index) root = root->args[0];
    if (root->kind == Expr::Kind::Name) names.push_back(root->text);
}

// HLSL: assignments in an expression, and arguments that a function may assign to.
void collect_assigned(const Expr* expr, const Scope& scope, std::vector<std::string_view>& names) {
    if (!expr || !scope.hlsl) return;
    if (expr->kind == Expr::Kind::Assign || expr->kind == Expr::Kind::AssignLater) add_root(*expr->args[0], names);
    if (expr->kind == Expr::Kind::Call && scope.declarations->function(expr->text)) {
        for (const Expr* arg : expr->args) add_root(*arg, names);
    }
    for (const Expr* arg : expr->args) collect_assigned(arg, scope, names);
}

}  // namespace

void collect_assigned(const Statements& list, const Scope& scope, std::vector<std::string_view>& names) {
    for (const Stmt* s : list) {
        if (s->kind == Stmt::Kind::Assign) add_root(*s->target, names);
        for (const Expr* expr : {s->target, s->value, s->limit}) collect_assigned(expr, scope, names);
        collect_assigned(s->body, scope, names);
        collect_assigned(s->alternative, scope, names);
        collect_assigned(s->step, scope, names);
    }
}

namespace {

std::vector<Value> values_of(const std::vector<Local>& locals, std::size_t count) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(locals[i].value.value);
    return values;
}

void restore(std::vector<Local>& locals, std::span<const Value> values) {
    locals.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) locals[i].value.value = values[i];
}

// How often the loop runs at most. The first index must be a constant, and the limit a constant or min(anything, a
// constant), so that no shader runs for ever.
std::optional<double> rounds_of(Emitter& emitter, const Stmt& loop, const Scope& scope) {
    const Expr& limit = *loop.limit;
    std::optional<double> cap = constant_value(emitter.known, limit, scope);
    if (!cap && limit.kind == Expr::Kind::Call && limit.text == "min" && limit.args.size() == 2) {
        cap = constant_value(emitter.known, *limit.args[0], scope);
        if (!cap) cap = constant_value(emitter.known, *limit.args[1], scope);
    }
    if (!cap) {
        emitter.diagnostics.report(Code::UnboundedLoop, limit.span, "limit")
            .note("write min(count, 64), with a cap that fits");
        return {};
    }
    const std::optional<double> first = constant_value(emitter.known, *loop.value, scope);
    if (!first) {
        emitter.diagnostics.report(Code::UnboundedLoop, loop.value->span, "first index")
            .note("begin at 0, and add the rest in the body");
        return {};
    }
    if (*cap - *first <= kMaxIterations) return std::max(*cap - *first, 0.0);
    emitter.diagnostics.report(Code::TooMany, limit.span, *cap - *first, "iterations of a loop", kMaxIterations);
    return {};
}

}  // namespace

bool if_statement(Emitter& emitter, const Stmt& stmt, const Statements& list, std::size_t next, Scope& scope,
                  Value& returned) {
    // If the condition is known, only the branch that runs is emitted, and the other one is not checked.
    if (const std::optional<double> known = constant_value(emitter.known, *stmt.value, scope)) {
        const std::size_t outer = scope.locals.size();
        if (block(emitter, *known != 0 ? stmt.body : stmt.alternative, scope, returned)) return true;
        scope.locals.resize(outer);
        return false;
    }
    const Typed condition = expression_as(emitter, *stmt.value, ir::kBool, scope, "the condition");
    if (!condition.ok()) return false;
    const bool returns = contains_return(stmt.body) || contains_return(stmt.alternative);
    // `if (c) return a; rest` is `if (c) return a; else { rest }`.
    const bool rest_is_else = returns && stmt.alternative.empty();

    ir::Builder& b = *scope.builder;
    if (b.depth() >= kMaxBranches) {
        emitter.diagnostics.report(Code::TooDeep, stmt.name_span, kMaxBranches)
            .note("code after a branch that returns is nested one level deeper: assign, and return once");
        returned = {};
        return true;
    }
    const std::size_t outer = scope.locals.size();
    const std::vector<Value> before = values_of(scope.locals, outer);
    const std::string_view outer_flow = scope.flow;
    b.begin_if(condition.value);
    scope.flow = outer_flow == "for" ? outer_flow : "if";
    Value then_returned, else_returned;
    const bool then_returns = block(emitter, stmt.body, scope, then_returned);
    const std::vector<Value> then_values = values_of(scope.locals, outer);
    restore(scope.locals, before);
    b.begin_else();
    const bool else_returns = rest_is_else ? statements(emitter, list, next, scope, else_returned)
                                           : block(emitter, stmt.alternative, scope, else_returned);
    const std::vector<Value> else_values = values_of(scope.locals, outer);
    restore(scope.locals, before);
    scope.flow = outer_flow;

    if (returns) {
        if (!then_returns || !else_returns) {
            if (outer_flow != "for")
                emitter.diagnostics.report(Code::PartialReturn, stmt.span).note(std::string(kReturnOnce));
            b.end_if({}, {});
            return true;
        }
        if (!then_returned || !else_returned) {  // an error inside, already reported
            b.end_if({}, {});
            return true;
        }
        returned = b.result(b.end_if(std::array{then_returned}, std::array{else_returned}), 0);
        return true;
    }
    std::vector<Value> then_yield, else_yield;
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < outer; ++i) {
        if (then_values[i] == before[i] && else_values[i] == before[i]) continue;
        changed.push_back(i);
        then_yield.push_back(then_values[i]);
        else_yield.push_back(else_values[i]);
    }
    const Value merged = b.end_if(then_yield, else_yield);
    for (std::uint32_t k = 0; k < changed.size(); ++k) {
        Local& local = scope.locals[changed[k]];
        local.value.value = b.result(merged, k);
        b.name(local.value.value, emitter.module.intern(local.name));
    }
    return false;
}

// Rounds of nested loops multiply, also in called functions. So do calls, if functions call each other: each one calls
// the next one twice. All of them must end in a reasonable time.
void count_rounds(Emitter& emitter, double rounds, Scope& scope, Span span) {
    const bool was_fine = scope.rounds <= kMaxRounds;
    scope.rounds += scope.rounds_around * rounds;
    if (was_fine && scope.rounds > kMaxRounds) {
        emitter.diagnostics.report(Code::TooMany, span, scope.rounds, "iterations of nested loops and calls",
                                   kMaxRounds);
    }
}

namespace {

// The rounds of a loop one after the other, with the index as a constant.
void write_out(Emitter& emitter, const Stmt& loop, double first, double end, Scope& scope) {
    const std::string_view outer_flow = std::exchange(scope.flow, "for");
    const std::size_t outer = scope.locals.size(), before = emitter.growth ? emitter.growth->made : 0;
    for (double i = first; i < end; ++i) {
        grow(emitter, loop.name_span);
        if (i == first + 1 && emitter.growth) {
            // The other rounds are about as long as the first one.
            const auto round = static_cast<double>(emitter.growth->made - before);
            expect_growth(emitter, round * (end - i), loop.name_span,
                          "[unroll] writes out all rounds of the loop: without it, the loop stays one");
        }
        const Value index = scope.builder->constant(ir::kInt, {i});
        scope.locals.push_back(
            {.name = loop.name, .value = {.value = index, .type = ir::kInt}, .is_const = true, .constant = i});
        Value returned;
        statements(emitter, loop.body, 0, scope, returned);
        scope.locals.resize(outer);
    }
    scope.flow = outer_flow;
}

}  // namespace

void for_statement(Emitter& emitter, const Stmt& stmt, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Typed begin = expression_as(emitter, *stmt.value, ir::kInt, scope, "the first index");
    const Typed end = expression_as(emitter, *stmt.limit, ir::kInt, scope, "the limit");
    if (!begin.ok() || !end.ok()) return;
    const std::optional<double> rounds = rounds_of(emitter, stmt, scope);
    if (!rounds) return;
    count_rounds(emitter, *rounds, scope, stmt.name_span);
    // Without folding, the limit is seldom a constant: the interpreter runs the loop itself.
    if (stmt.is_unrolled && !b.constant_of(begin.value).empty() && !b.constant_of(end.value).empty())
        return write_out(emitter, stmt, b.constant_of(begin.value)[0], b.constant_of(end.value)[0], scope);
    b.name(end.value, emitter.module.intern("count"));
    const std::size_t outer = scope.locals.size();
    std::vector<std::string_view> assigned;
    collect_assigned(stmt.body, scope, assigned);
    std::vector<std::size_t> carried;
    std::vector<Value> initial;
    for (std::size_t i = 0; i < outer; ++i) {
        const Local& local = scope.locals[i];
        if (!local.value.ok() || std::find(assigned.begin(), assigned.end(), local.name) == assigned.end()) continue;
        carried.push_back(i);
        initial.push_back(local.value.value);
    }
    b.begin_for(begin.value, end.value, initial, stmt.is_light_loop);
    const std::string_view outer_flow = scope.flow;
    scope.flow = "for";
    scope.rounds_around *= std::max(*rounds, 1.0);
    for (std::uint32_t k = 0; k < carried.size(); ++k) {
        scope.locals[carried[k]].value.value = b.loop_carried(k);
        b.name(b.loop_carried(k), emitter.module.intern(scope.locals[carried[k]].name));
    }
    scope.locals.push_back(
        {.name = stmt.name, .value = {.value = b.loop_index(), .type = ir::kInt}, .is_const = true, .constant = {}});
    Value returned;
    statements(emitter, stmt.body, 0, scope, returned);
    scope.locals.resize(outer);
    scope.flow = outer_flow;
    scope.rounds_around /= std::max(*rounds, 1.0);
    std::vector<Value> next;
    for (std::size_t i : carried) next.push_back(scope.locals[i].value.value);
    const Value loop = b.end_for(next);
    for (std::uint32_t k = 0; k < carried.size(); ++k) {
        scope.locals[carried[k]].value.value = b.result(loop, k);
        b.name(b.result(loop, k), emitter.module.intern(scope.locals[carried[k]].name));
    }
}

}  // namespace patina::emit

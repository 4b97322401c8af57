// Statements -> structured SSA: a variable is just the value it holds now; an If or For yields what was assigned in it.
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/text.h"
#include "compiler/nodelang/emit.h"

namespace patina::nodelang {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

constexpr double kMaxIterations = 4096;  // of one loop
constexpr double kMaxRounds = 1u << 22;  // of all loops of a function, nested ones multiplied
// What follows a branch that returns is nested in its else.
constexpr std::size_t kMaxBranches = 200;

constexpr std::string_view kReturnOnce = "assign to a variable here, and return it at the end of the function";

bool contains_return(const Statements& list) {
    return std::any_of(list.begin(), list.end(), [](const Stmt* s) {
        return s->kind == Stmt::Kind::Return || contains_return(s->body) || contains_return(s->alternative);
    });
}

// Names that the statements assign to, wherever they are declared.
void collect_assigned(const Statements& list, std::vector<std::string_view>& names) {
    for (const Stmt* s : list) {
        if (s->kind == Stmt::Kind::Assign) {
            const Expr* root = s->target;
            while (root->kind == Expr::Kind::Member || root->kind == Expr::Kind::Index) root = root->args[0];
            if (root->kind == Expr::Kind::Name) names.push_back(root->text);
        }
        collect_assigned(s->body, names);
        collect_assigned(s->alternative, names);
    }
}

std::vector<Value> values_of(const std::vector<Local>& locals, std::size_t count) {
    std::vector<Value> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(locals[i].value.value);
    return values;
}

void restore(std::vector<Local>& locals, std::span<const Value> values) {
    locals.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) locals[i].value.value = values[i];
}

}  // namespace

bool Emitter::statements(const Statements& list, std::size_t first, Scope& scope, Value& returned) {
    for (std::size_t i = first; i < list.size(); ++i) {
        const Stmt& stmt = *list[i];
        switch (stmt.kind) {
            case Stmt::Kind::Declare: declare(stmt, scope); break;
            case Stmt::Kind::Assign: assign(stmt, scope); break;
            case Stmt::Kind::If:
                if (if_statement(stmt, list, i + 1, scope, returned)) return true;
                break;
            case Stmt::Kind::For: for_statement(stmt, scope); break;
            case Stmt::Kind::Return:
                if (scope.flow == "for") {
                    diagnostics_.report(Code::PartialReturn, stmt.span).note(std::string(kReturnOnce));
                    return true;
                }
                returned = return_value(&stmt, scope);
                return true;
            case Stmt::Kind::Discard: {
                const Typed condition = expression_as(*stmt.value, ir::kBool, scope, "the condition");
                if (!condition.ok()) break;
                if (scope.builder->depth() > 0 || !scope.flow.empty()) {
                    diagnostics_.report(Code::DerivativeInFlow, stmt.span, "discardIf", scope.flow);
                    break;
                }
                scope.builder->emit(Op::DiscardIf, Type::none(), {condition.value});
                break;
            }
            case Stmt::Kind::Block: {
                const std::size_t outer = scope.locals.size();
                const bool returns = statements(stmt.body, 0, scope, returned);
                if (returns) return true;
                scope.locals.resize(outer);
                break;
            }
        }
    }
    return false;
}

Value Emitter::return_value(const Stmt* stmt, Scope& scope) {
    const FunctionDecl& function = *scope.function;
    const bool has_primary = function.result.name != "void";
    std::vector<Value> parts;
    if (has_primary && stmt) {
        if (!stmt->value) {
            diagnostics_.report(Code::MissingReturn, stmt->span, function.name);
            return {};
        }
        const Typed value = expression_as(*stmt->value, type(function.result, scope), scope, "the returned value");
        if (!value.ok()) return {};
        if (value.type == scope.result &&
            !std::any_of(function.params.begin(), function.params.end(), [](const ParamDecl& p) { return p.is_out; })) {
            return value.value;
        }
        parts.push_back(value.value);
    }
    for (const ParamDecl& param : function.params) {
        if (!param.is_out) continue;
        const auto local = std::find_if(scope.locals.begin(), scope.locals.end(),
                                        [&](const Local& l) { return l.name == param.name; });
        parts.push_back(local->value.value);
    }
    return scope.builder->construct(scope.result, parts);
}

void Emitter::declare(const Stmt& stmt, Scope& scope) {
    const Type wanted = type(stmt.type, scope);
    Local local{.name = stmt.name, .value = {}, .is_const = stmt.is_const, .constant = {}};
    const bool clash =
        std::any_of(scope.locals.begin(), scope.locals.end(), [&](const Local& l) { return l.name == stmt.name; });
    if (clash) diagnostics_.report(Code::Redefinition, stmt.name_span, stmt.name);
    if (!wanted.is_error()) {
        if (!stmt.value) {
            local.value = {.value = scope.builder->zero(wanted), .type = wanted};
        } else if (wanted.kind == ir::Kind::Array && stmt.value->kind == Expr::Kind::List) {
            const ir::Array array = module_.arrays[wanted.ref];
            std::vector<Value> elements;
            if (stmt.value->args.size() != array.count) {
                diagnostics_.report(Code::TypeMismatch, stmt.value->span, fmt::format("'{}'", stmt.name),
                                    fmt::format("a list of {}", stmt.value->args.size()),
                                    fmt::format("a list of {}", array.count));
            } else {
                for (const Expr* element : stmt.value->args) {
                    const Typed value = expression_as(*element, array.element, scope, "an element");
                    if (value.ok()) elements.push_back(value.value);
                }
                if (elements.size() == array.count) {
                    local.value = {.value = scope.builder->construct(wanted, elements), .type = wanted};
                }
            }
        } else {
            local.value = expression_as(*stmt.value, wanted, scope, fmt::format("'{}'", stmt.name));
            if (stmt.is_const) local.constant = constant_value(*stmt.value, scope);
        }
        if (local.value.ok() && stmt.value) {
            scope.builder->name(local.value.value, module_.intern(stmt.name));
        }
    }
    scope.locals.push_back(std::move(local));
}

void Emitter::assign(const Stmt& stmt, Scope& scope) {
    Typed value;
    if (stmt.op == "=") {
        value = primary(expression(*stmt.value, scope), scope, stmt.value->span);
    } else {
        // a += b is a = a + b
        Expr sum{.kind = Expr::Kind::Binary,
                 .span = stmt.span,
                 .name_span = stmt.span,
                 .text = stmt.op.substr(0, 1),
                 .args = {stmt.target, stmt.value}};
        value = binary(sum, scope);
    }
    if (value.ok()) store(*stmt.target, value, scope);
}

// Puts a value where the target says, rebuilding the aggregates on the way to the variable.
bool Emitter::store(const Expr& target, Typed value, Scope& scope) {
    ir::Builder& b = *scope.builder;
    if (target.kind == Expr::Kind::Name) {
        for (auto local = scope.locals.rbegin(); local != scope.locals.rend(); ++local) {
            if (local->name != target.text) continue;
            if (local->is_const) break;
            if (!local->value.ok()) return false;
            value =
                convert(value, local->value.type, scope, target.span, fmt::format("the value for '{}'", target.text));
            if (!value.ok()) return false;
            b.name(value.value, module_.intern(target.text));
            local->value.value = value.value;
            return true;
        }
        const bool is_constant = std::any_of(scope.locals.begin(), scope.locals.end(),
                                             [&](const Local& local) { return local.name == target.text; }) ||
                                 scope.declarations->variable(target.text);
        if (is_constant) {
            diagnostics_.report(Code::NotAssignable, target.span, fmt::format("'{}'", target.text))
                .note("it is a constant");
        } else {
            (void)name(target, scope);  // there is no such variable: says so
        }
        return false;
    }
    if (target.kind != Expr::Kind::Member && target.kind != Expr::Kind::Index) {
        diagnostics_.report(Code::NotAssignable, target.span, "what is computed");
        return false;
    }
    const Typed object = expression(*target.args[0], scope);
    if (!object.ok()) return false;
    const auto insert = [&](std::uint32_t part) {
        const Typed fitted = convert(value, ir::part_type(module_, object.type, part), scope, target.span, "the value");
        if (!fitted.ok()) return false;
        if (object.type.kind == ir::Kind::Struct) b.name(fitted.value, module_.intern(target.text));
        const Value whole = b.emit(Op::Insert, object.type, {object.value, fitted.value}, part);
        return store(*target.args[0], {.value = whole, .type = object.type}, scope);
    };
    if (target.kind == Expr::Kind::Index) {
        const std::optional<double> at = constant_value(*target.args[1], scope);
        if (!at || *at < 0 || *at >= ir::part_count(module_, object.type)) {
            diagnostics_.report(Code::NotConstant, target.args[1]->span, "the index of an assignment");
            return false;
        }
        return insert(static_cast<std::uint32_t>(*at));
    }
    if (object.type.kind == ir::Kind::Struct) {
        const auto& members = module_.structs[object.type.ref].members;
        const auto found =
            std::find_if(members.begin(), members.end(), [&](const ir::Member& m) { return m.name == target.text; });
        if (found != members.end()) return insert(static_cast<std::uint32_t>(found - members.begin()));
    }
    if (object.type.is_vector()) {
        const std::string_view letters = target.text;
        std::vector<std::uint32_t> parts;
        for (char letter : letters) {
            std::size_t at = std::string_view("xyzw").find(letter);
            if (at == std::string_view::npos) at = std::string_view("rgba").find(letter);
            if (at >= object.type.width()) break;
            if (std::find(parts.begin(), parts.end(), at) != parts.end()) break;
            parts.push_back(static_cast<std::uint32_t>(at));
        }
        if (parts.size() == letters.size()) {
            if (parts.size() == 1) return insert(parts[0]);
            const Type part_type = object.type.with_width(static_cast<unsigned>(parts.size()));
            value = convert(value, part_type, scope, target.span, "the value");
            if (!value.ok()) return false;
            Value whole = object.value;
            for (std::uint32_t i = 0; i < parts.size(); ++i) {
                whole = b.emit(Op::Insert, object.type, {whole, b.extract(value.value, i)}, parts[i]);
            }
            return store(*target.args[0], {.value = whole, .type = object.type}, scope);
        }
    }
    diagnostics_.report(Code::UnknownSwizzle, target.name_span, target.text, module_.type_name(object.type));
    return false;
}

bool Emitter::if_statement(const Stmt& stmt, const Statements& list, std::size_t next, Scope& scope, Value& returned) {
    // A branch that is known now costs nothing: the other one is not even checked for derivatives.
    if (const std::optional<double> known = constant_value(*stmt.value, scope)) {
        const std::size_t outer = scope.locals.size();
        if (statements(*known != 0 ? stmt.body : stmt.alternative, 0, scope, returned)) return true;
        scope.locals.resize(outer);
        return false;
    }
    const Typed condition = expression_as(*stmt.value, ir::kBool, scope, "the condition");
    if (!condition.ok()) return false;
    const bool returns = contains_return(stmt.body) || contains_return(stmt.alternative);
    // `if (c) return a; rest` is `if (c) return a; else { rest }`.
    const bool rest_is_else = returns && stmt.alternative.empty();

    ir::Builder& b = *scope.builder;
    if (b.depth() >= kMaxBranches) {
        diagnostics_.report(Code::TooDeep, stmt.name_span, kMaxBranches)
            .note("what follows a branch that returns lies one level deeper: assign, and return once");
        returned = {};
        return true;
    }
    const std::size_t outer = scope.locals.size();
    const std::vector<Value> before = values_of(scope.locals, outer);
    const std::string_view outer_flow = scope.flow;
    b.begin_if(condition.value);
    scope.flow = outer_flow == "for" ? outer_flow : "if";
    Value then_returned, else_returned;
    const bool then_returns = statements(stmt.body, 0, scope, then_returned);
    const std::vector<Value> then_values = values_of(scope.locals, outer);
    restore(scope.locals, before);
    b.begin_else();
    const bool else_returns = rest_is_else ? statements(list, next, scope, else_returned)
                                           : statements(stmt.alternative, 0, scope, else_returned);
    const std::vector<Value> else_values = values_of(scope.locals, outer);
    restore(scope.locals, before);
    scope.flow = outer_flow;

    if (returns) {
        if (!then_returns || !else_returns) {
            if (outer_flow != "for") diagnostics_.report(Code::PartialReturn, stmt.span).note(std::string(kReturnOnce));
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
        b.name(local.value.value, module_.intern(local.name));
    }
    return false;
}

// The index begins at a constant, and the limit is a constant, or min(anything, a constant): a shader cannot run for
// ever.
std::optional<double> Emitter::rounds_of(const Stmt& loop, const Scope& scope) {
    const Expr& limit = *loop.limit;
    std::optional<double> cap = constant_value(limit, scope);
    if (!cap && limit.kind == Expr::Kind::Call && limit.text == "min" && limit.args.size() == 2) {
        cap = constant_value(*limit.args[0], scope);
        if (!cap) cap = constant_value(*limit.args[1], scope);
    }
    if (!cap) {
        diagnostics_.report(Code::UnboundedLoop, limit.span, "limit")
            .note("write min(count, 64), with a cap that fits");
        return {};
    }
    const std::optional<double> first = constant_value(*loop.value, scope);
    if (!first) {
        diagnostics_.report(Code::UnboundedLoop, loop.value->span, "first index")
            .note("begin at 0, and add the rest in the body");
        return {};
    }
    if (*cap - *first <= kMaxIterations) return std::max(*cap - *first, 0.0);
    diagnostics_.report(Code::TooMany, limit.span, *cap - *first, "rounds of a loop", kMaxIterations);
    return {};
}

// Loops in loops multiply, in called functions too: together they must end in a reasonable time.
void Emitter::count_rounds(double rounds, Scope& scope, Span span) {
    const bool was_fine = scope.rounds <= kMaxRounds;
    scope.rounds += scope.rounds_around * rounds;
    if (was_fine && scope.rounds > kMaxRounds) {
        diagnostics_.report(Code::TooMany, span, scope.rounds, "rounds of nested loops", kMaxRounds);
    }
}

void Emitter::for_statement(const Stmt& stmt, Scope& scope) {
    ir::Builder& b = *scope.builder;
    const Typed begin = expression_as(*stmt.value, ir::kInt, scope, "the first index");
    const Typed end = expression_as(*stmt.limit, ir::kInt, scope, "the limit");
    if (!begin.ok() || !end.ok()) return;
    const std::optional<double> rounds = rounds_of(stmt, scope);
    if (!rounds) return;
    count_rounds(*rounds, scope, stmt.name_span);
    b.name(end.value, module_.intern("count"));
    const std::size_t outer = scope.locals.size();
    std::vector<std::string_view> assigned;
    collect_assigned(stmt.body, assigned);
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
        b.name(b.loop_carried(k), module_.intern(scope.locals[carried[k]].name));
    }
    scope.locals.push_back(
        {.name = stmt.name, .value = {.value = b.loop_index(), .type = ir::kInt}, .is_const = true, .constant = {}});
    Value returned;
    statements(stmt.body, 0, scope, returned);
    scope.locals.resize(outer);
    scope.flow = outer_flow;
    scope.rounds_around /= std::max(*rounds, 1.0);
    std::vector<Value> next;
    for (std::size_t i : carried) next.push_back(scope.locals[i].value.value);
    const Value loop = b.end_for(next);
    for (std::uint32_t k = 0; k < carried.size(); ++k) {
        scope.locals[carried[k]].value.value = b.result(loop, k);
        b.name(b.result(loop, k), module_.intern(scope.locals[carried[k]].name));
    }
}

}  // namespace patina::nodelang

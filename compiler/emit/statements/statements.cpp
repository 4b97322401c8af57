#include "compiler/emit/statements/statements.h"

#include <algorithm>
#include <utility>

#include "compiler/emit/types.h"

namespace patina::emit {

using ir::Op;
using ir::Type;
using ir::Value;

namespace {

// An expression as a statement: a call for its outputs.
void evaluate(Emitter& emitter, const Expr& expr, Scope& scope) {
    (void)expression(emitter, expr, scope);
}

}  // namespace

bool block(Emitter& emitter, const Statements& list, Scope& scope, Value& returned) {
    const std::size_t outer = scope.locals.size();
    const std::size_t outer_block = std::exchange(scope.block, outer);
    const bool returns = statements(emitter, list, 0, scope, returned);
    scope.block = outer_block;
    if (!returns) scope.locals.resize(outer);
    return returns;
}

bool statements(Emitter& emitter, const Statements& list, std::size_t first, Scope& scope, Value& returned) {
    for (std::size_t i = first; i < list.size(); ++i) {
        const Stmt& stmt = *list[i];
        switch (stmt.kind) {
            case Stmt::Kind::Declare: declare(emitter, stmt, scope); break;
            case Stmt::Kind::Assign: assign(emitter, stmt, scope); break;
            case Stmt::Kind::If:
                if (if_statement(emitter, stmt, list, i + 1, scope, returned)) return true;
                break;
            case Stmt::Kind::For: for_statement(emitter, stmt, scope); break;
            case Stmt::Kind::Loop: loop_statement(emitter, stmt, scope); break;
            case Stmt::Kind::Evaluate: evaluate(emitter, *stmt.value, scope); break;
            case Stmt::Kind::Break:
            case Stmt::Kind::Continue:
                emitter.diagnostics.report(Code::Syntax, stmt.span, "a statement",
                                           stmt.kind == Stmt::Kind::Break ? "'break' outside of a loop or 'switch'"
                                                                          : "'continue' outside of a loop");
                break;
            case Stmt::Kind::Return:
                if (scope.flow == "for") {
                    emitter.diagnostics.report(Code::PartialReturn, stmt.span).note(std::string(kReturnOnce));
                    return true;
                }
                returned = return_value(emitter, &stmt, scope);
                return true;
            case Stmt::Kind::Discard: {
                const Typed condition = expression_as(emitter, *stmt.value, ir::kBool, scope, "the condition");
                if (!condition.ok()) break;
                if (scope.builder->depth() > 0 || !scope.flow.empty()) {
                    emitter.diagnostics.report(Code::DerivativeInFlow, stmt.span, "discardIf", scope.flow,
                                               "call it outside of branches and loops");
                    break;
                }
                scope.builder->emit(Op::DiscardIf, Type::none(), {condition.value});
                break;
            }
            case Stmt::Kind::Block: {
                if (block(emitter, stmt.body, scope, returned)) return true;
                break;
            }
        }
    }
    return false;
}

Value return_value(Emitter& emitter, const Stmt* stmt, Scope& scope) {
    const FunctionDecl& function = *scope.function;
    const bool has_primary = function.result.name != "void";
    std::vector<Value> parts;
    if (has_primary && stmt) {
        if (!stmt->value) {
            emitter.diagnostics.report(Code::MissingReturn, stmt->span, function.name);
            return {};
        }
        const Typed value =
            expression_as(emitter, *stmt->value, type(emitter, function.result, scope), scope, "the returned value");
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

}  // namespace patina::emit

// What the parser makes of a text, as text: "(+ 1 (* 2 3))", "{ a = 1; }".
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "compiler/nodelang/lex.h"
#include "compiler/nodelang/parse.h"

namespace patina::nodelang {

// (op a b): what the tree is, without places.
inline std::string show(const Expr* expr) {
    if (!expr) return "null";
    std::string parts;
    for (const Expr* arg : expr->args) parts += " " + show(arg);
    const std::string text(expr->text);
    switch (expr->kind) {
        case Expr::Kind::Number:
        case Expr::Kind::Bool:
        case Expr::Kind::Name: return text;
        case Expr::Kind::Property: return "$" + text;
        case Expr::Kind::Semantic: return "@" + text;
        case Expr::Kind::File: return "\"" + text + "\"";
        case Expr::Kind::List: return "{" + parts + " }";
        case Expr::Kind::Color: return "color";
        case Expr::Kind::Member: return "(." + text + parts + ")";
        case Expr::Kind::Index: return "([]" + parts + ")";
        case Expr::Kind::Object:
        case Expr::Kind::Call: return "(" + text + "()" + parts + ")";
        case Expr::Kind::Method: return "(." + text + "()" + parts + ")";
        case Expr::Kind::Unary:
        case Expr::Kind::Binary:
        case Expr::Kind::Ternary:
        case Expr::Kind::Assign:
        case Expr::Kind::Sequence: return "(" + text + parts + ")";
        case Expr::Kind::AssignLater: return "(later " + text + parts + ")";
    }
    return {};
}

inline std::string show(const Statements& list);
inline std::string show(const Stmt& s) {
    const std::string name(s.name);
    switch (s.kind) {
        case Stmt::Kind::Declare: {
            std::string text = (s.is_const ? "const " : "") + std::string(s.type.name) + " " + name;
            if (s.type.array_size) text += "[" + show(s.type.array_size) + "]";
            return s.value ? text + " = " + show(s.value) + ";" : text + ";";
        }
        case Stmt::Kind::Assign: return show(s.target) + " " + std::string(s.op) + " " + show(s.value) + ";";
        case Stmt::Kind::If: return "if " + show(s.value) + show(s.body) + " else" + show(s.alternative);
        case Stmt::Kind::For:
            return (s.is_light_loop ? "[light] for " : "for ") + name + " " + show(s.value) + " " + show(s.limit) +
                   show(s.body);
        case Stmt::Kind::Return: return s.value ? "return " + show(s.value) + ";" : "return;";
        case Stmt::Kind::Discard: return "discard " + show(s.value) + ";";
        case Stmt::Kind::Block: return show(s.body);
        case Stmt::Kind::Evaluate: return show(s.value) + ";";
        case Stmt::Kind::Loop:
            return std::string(s.tests_later ? "do " : "while ") + show(s.value) +
                   (s.limit ? " and " + show(s.limit) : "") + show(s.body) + (s.step.empty() ? "" : show(s.step));
        case Stmt::Kind::Break: return "break;";
        case Stmt::Kind::Continue: return "continue;";
    }
    return {};
}
inline std::string show(const Statements& list) {
    std::string text = "{";
    for (const Stmt* s : list) text += " " + show(*s);
    return text + " }";
}

struct Parsed {
    SourceMap sources;
    Ast ast;
    Diagnostics diagnostics;
    std::uint32_t base = 0;
    const Expr* expr = nullptr;

    // The text under each error, and what was wrong with it.
    std::vector<std::string> errors() const {
        std::vector<std::string> all;
        for (const DiagnosticRecord& r : diagnostics.records()) {
            all.push_back("[" + std::string(sources.text(r.span)) + "] " + r.message);
        }
        return all;
    }
    std::string_view text(Span span) const { return sources.text(span); }
    std::string place(Span span) const {
        const Position p = sources.resolve(span.begin);
        return fmt::format("{}:{}", p.line, p.column);
    }
};

enum class As { File, Expression, Link };

inline std::unique_ptr<Parsed> parse(As as, std::string source) {
    auto parsed = std::make_unique<Parsed>();
    parsed->base = parsed->sources.add("test", std::move(source));
    const Text text{.text = parsed->sources.file_text(parsed->base), .base = parsed->base};
    switch (as) {
        case As::File: parse_file(text, parsed->ast, parsed->diagnostics); break;
        case As::Expression: parsed->expr = parse_expression(text, parsed->ast, parsed->diagnostics); break;
        case As::Link: parsed->expr = parse_link(text, parsed->ast, parsed->diagnostics); break;
    }
    return parsed;
}

inline std::string expression(std::string source) {
    const auto parsed = parse(As::Expression, std::move(source));
    EXPECT_EQ(parsed->errors(), std::vector<std::string>{});
    return show(parsed->expr);
}

inline std::string body(std::string statements) {
    const auto parsed = parse(As::File, "void f() {" + statements + "}");
    EXPECT_EQ(parsed->errors(), std::vector<std::string>{});
    return parsed->ast.functions.empty() ? "nothing" : show(parsed->ast.functions[0].body);
}

using Errors = std::vector<std::string>;

}  // namespace patina::nodelang

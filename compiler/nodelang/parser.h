// The recursive-descent parser behind parse.h. Private to parse*.cpp: expressions, statements and declarations are one
// grammar in three files. If a function cannot read the expected token, it reports that once and returns a null Node, a
// null Stmt or false. A caller that can go on (a list of statements, a file) then skips to a safe place.
//
//   Parser parser(text, Lexer::Dialect::File, ast, diagnostics);
//   parser.file();
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <unordered_set>

#include "compiler/base/made_once.h"
#include "compiler/base/precedence.h"
#include "compiler/nodelang/hlsl/preprocessor.h"
#include "compiler/nodelang/lex.h"

namespace patina::nodelang {

// A chain of operators and members without brackets makes a tree as deep as the chain is long, and later steps recurse.
inline constexpr int kMaxExpressionHeight = 1000;
inline constexpr std::size_t kMaxTextBytes = 1u << 20;

// An expression, its height as a tree, and where its text begins. Brackets around an expression are not part of its own
// span, but they are part of the span of the expression around it.
struct Node {
    const Expr* expr = nullptr;
    int height = 0;
    std::size_t begin = 0;  // offset into the text, brackets included

    explicit operator bool() const { return expr != nullptr; }
};

// What a body that has been skipped holds.
struct ReadBody {
    Ast ast{};
    Statements statements{};
    Diagnostics diagnostics{};
};
// A body that has been skipped. Most are never asked for.
struct UnreadBody {
    Text text{};
    MadeOnce<ReadBody> read{};
};

// = += -= ...
bool is_assignment(const Token& token);

class Parser {
public:
    Parser(Text text, Lexer::Dialect dialect, Ast& ast, Diagnostics& diagnostics, Bodies bodies = Bodies::Now);

    void file();
    // The text is a function's body with its braces.
    void function_body(Statements& into) { block(into); }
    const Expr* whole_expression();
    const Expr* link();

private:
    // Counts one level of brackets, blocks or prefix operators while it lives.
    class Nested {
    public:
        explicit Nested(Parser& parser) : parser_(parser) { ++parser_.nesting_; }
        ~Nested() { --parser_.nesting_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;
        // False, and reported, beyond kMaxNesting.
        bool allowed() const;

    private:
        Parser& parser_;
    };

    // --- tokens (parse.cpp)
    const Token& now() const { return now_; }
    const Token& after() const { return after_; }
    bool is_hlsl() const { return dialect_ == Lexer::Dialect::Hlsl; }
    Token next_token() { return preprocessor_ ? preprocessor_->next() : lexer_.next(); }
    Token take();  // the current token; the next one becomes current
    bool take_if(std::string_view punctuation);
    bool take_word(std::string_view word);
    Span span(const Token& token) const { return lexer_.span(token.begin, token.end); }
    Span span_from(std::size_t begin) const { return lexer_.span(begin, last_end_); }
    std::string describe(const Token& token) const;
    // "expected {what}, not {the current token}". The result may be given notes.
    DiagnosticRecord& expected(std::string_view what);
    bool expect(std::string_view punctuation, std::string_view what);
    bool expect_close(std::string_view punctuation, const Token& open, std::string_view or_else = {});
    bool name(std::string_view what, Token& into);
    bool end_of_statement();
    std::size_t offset_of(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - text_.text.data());
    }
    void skip_statement(int depth);
    void skip_declaration();

    // --- expressions (parse_expression.cpp)
    Node expression();
    Node binary(Precedence lowest);
    Node unary();
    Node postfix();
    Node member_of(const Node& object);
    Node method_of(const Node& object);
    Node index_of(const Node& object);
    Node primary();
    Node bracketed();
    Node call(const Token& callee);
    bool is_statement(const Token& word);
    Node initializer();
    Node list();
    bool arguments(const Token& open, std::vector<Node>& into);
    Node leaf(Expr::Kind kind, const Token& token);
    Node make(Expr expr, std::size_t begin, std::span<const Node> operands);
    Node make(Expr expr, std::size_t begin, std::initializer_list<Node> operands) {
        return make(std::move(expr), begin, std::span<const Node>(operands.begin(), operands.size()));
    }

    // --- statements (parse_statement.cpp)
    bool block(Statements& into);
    void statements(Statements& into);
    bool statement(Statements& into);
    bool declaration_statement(Statements& into);
    const Stmt* assignment();
    const Stmt* if_statement();
    const Stmt* for_statement();
    bool for_header(Stmt& loop);
    bool for_step(std::string_view index);
    void skip_header();
    const Stmt* return_statement();
    const Stmt* discard_statement();
    bool body(Statements& into);
    const Stmt* finish(Stmt stmt, std::size_t begin);

    // --- what only HLSL has (parse_hlsl.cpp)
    bool hlsl_statement(Statements& into);
    bool hints(Stmt& loop);
    bool condition(Node& into);
    bool for_loop(Stmt& loop, Statements& first);
    const Stmt* switch_statement();
    bool cases(const Node& selector, Statements& into);
    bool expressions(Statements& into);
    Node assigned(const Node& target);
    Node stepped(const Node& target, const Token& op, bool is_before);
    Node cast(const Token& open);
    bool begins_declaration() const;
    void qualifiers(bool& is_const);
    void lacks(Span at, std::string_view what);
    bool hlsl_parameter(ParamDecl& into);
    void skip_semantic();

    // --- declarations (parse_declaration.cpp)
    bool declaration();
    bool attributes(std::vector<Attribute>& into);
    void check_attributes(std::span<const Attribute> marks, std::string_view what);
    bool attribute(Attribute& into);
    bool type_name(TypeName& into, std::string_view what);
    bool array_size(TypeName& into);
    std::string_view trailing_doc_and(std::string_view separator, bool& found);
    void declare_once(std::unordered_set<std::string_view>& names, const Token& name);
    bool structure(std::vector<Attribute> marks, std::string_view doc);
    bool enumeration(std::string_view doc);
    bool variable(VariableDecl& decl);
    bool function(FunctionDecl decl, std::size_t begin);
    bool parameters(FunctionDecl& function);
    bool foreign_code(FunctionDecl& function);
    void leave_unread(FunctionDecl& function);
    void go_to(std::size_t offset);
    bool parameter(ParamDecl& into);
    bool typed_parameter(ParamDecl& into);

    Text text_;
    Lexer::Dialect dialect_;
    Ast& ast_;
    Diagnostics& diagnostics_;
    std::size_t errors_before_;  // number of errors before this text was read
    Bodies bodies_;
    Lexer lexer_;
    std::optional<Preprocessor> preprocessor_{};  // of HLSL
    Token now_;
    Token after_;               // the token after now_
    std::size_t last_end_ = 0;  // where the last taken token ended
    int nesting_ = 0;
    int braces_ = 0;             // how many { are open
    DiagnosticRecord silent_{};  // takes the notes about a Bad token, which has been reported
};

}  // namespace patina::nodelang

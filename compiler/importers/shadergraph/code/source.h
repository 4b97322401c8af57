// The code of a custom function, read by the node language's own reader of HLSL. The preprocessor's result becomes a
// text again, with the lines of the author; of this text is the syntax tree, so that a part of the tree is a part of
// the text.
//
//   const Source source("#ifdef A\nOut = 1;\n#else\nOut = B * 2.0h;\n#endif", "void Glow(float B, out float Out)", {});
//   source.text(source.function("Glow")->span);   // "void Glow(float B, out float Out) {\n\n\nOut = B * 2.0;\n}"
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "compiler/nodelang/parse.h"

namespace patina::importers::shadergraph {

// Other mistakes of the parser are parts of HLSL that the node language lacks.
bool is_no_hlsl(Code code);

class Source {
public:
    // `head`: of the only function, whose body the code is; empty: the code is a file. `samplers`: parameters that are
    // samplers, in addition to those that the code itself declares.
    Source(std::string code, std::string_view head, std::set<std::string, std::less<>> samplers);
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // Why there is no tree: "line 2 of its code: expected ..."
    const std::string& error() const { return error_; }
    // The first mistake of the parser, or nothing. A file may have mistakes in functions that nobody needs.
    const std::string& mistake() const { return mistake_; }

    const nodelang::Ast& ast() const { return ast_; }
    // Null: the file has no such function.
    const nodelang::FunctionDecl* function(std::string_view name) const;
    // The code has it, and not the words of the engine before it.
    bool is_own(Span span) const { return span.begin >= begin_ + kBase; }
    std::string_view text(Span span) const;
    // Between the braces of a function.
    std::string_view body(const nodelang::FunctionDecl& function) const;
    // The line of the code, from 1, in which a part of text() begins.
    int line_of(std::string_view part) const;
    // "line 2 of its code: MESSAGE, in 'Out = A * ;'"
    std::string at_line(int line, std::string_view message) const;
    // ", in 'Out = A * ;'", as its author wrote it; empty: there is no such line.
    std::string quoted(int number) const;
    // The variable of the file is a constant, or is one unless something assigns to it.
    bool is_constant(const nodelang::VariableDecl& variable) const;

private:
    static constexpr std::uint32_t kBase = 1;  // of spans: no span begins at 0

    void preprocess(std::set<std::string, std::less<>> samplers);
    void parse(std::string_view head);

    std::string code_;
    std::string text_{};
    std::size_t begin_ = 0;  // of the code in `text_`
    int lines_before_ = 0;   // of the engine's words
    nodelang::Ast ast_{};
    std::string error_{}, mistake_{};
};

}  // namespace patina::importers::shadergraph

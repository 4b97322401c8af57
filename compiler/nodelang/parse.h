// The room `nodelang` reads the text of the node language: lexer, parser, syntax trees (ast.h) and an index of
// declarations (library.h). It reports wrong syntax and knows no types and no IR: what a tree means is emit's business.
//
// The parser makes a syntax tree of a text. After an error it continues behind the next ; or }, so that one run finds
// several errors.
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/nodelang/ast.h"

namespace patina::nodelang {

// A text, and where its bytes are in the source map: byte i is at base + i. If the text was a JSON string with escapes,
// decoded byte i is at map[i] instead, and the last entry of `map` is the end. The text must outlive the Ast.
struct Text {
    std::string_view text;
    std::uint32_t base = 0;
    const std::vector<std::uint32_t>* map = nullptr;

    std::uint32_t at(std::size_t i) const { return map ? (*map)[i] : base + static_cast<std::uint32_t>(i); }
};

// Deeper nesting of expressions or blocks is refused (the parser and the emitter recurse).
inline constexpr int kMaxNesting = 200;

// When the bodies of a file's functions are parsed. A user's file is parsed completely, to find its errors. Of the
// library, a compilation needs a few functions out of hundreds, and parses these on demand.
enum class Bodies { Now, WhenAsked };
// If the first line behind comments is kHlslMark, the file is read by the rules of HLSL (docs/node-language.md). Then
// it has a preprocessor, more statements, and conversions that an author need not write. Then all bodies are parsed
// now.
inline constexpr std::string_view kHlslMark = "#pragma hlsl";
void parse_file(Text text, Ast& ast, Diagnostics& diagnostics, Bodies bodies = Bodies::Now);

// The statements of a function. Any thread may call this. The errors of a body that is parsed only now go to
// body_errors().
const Statements& body_of(const FunctionDecl& function);
// The errors in the body of a function of Bodies::WhenAsked, which is parsed now if it was not parsed before. Null for
// other functions.
const Diagnostics* body_errors(const FunctionDecl& function);

// An expression of a graph: may read $properties and @semantics.
const Expr* parse_expression(Text text, Ast& ast, Diagnostics& diagnostics);
// A link of a graph: `id`, `id.port`, `id.port.swizzle`, `$property...`, `@semantic...` and nothing else.
const Expr* parse_link(Text text, Ast& ast, Diagnostics& diagnostics);

}  // namespace patina::nodelang

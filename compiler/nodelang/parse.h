// Text of the node language -> syntax tree. Reports what it cannot read and goes on behind the next ; or }, so that one
// run finds several errors. Knows no types and no library.
//
//   parse_file({text, base}, ast, diagnostics);                       // a .node.hlsl file
//   const Expr* e = parse_expression({"1 - mask", base}, ast, diagnostics);   // null after an error
#pragma once

#include "compiler/base/diagnostics.h"
#include "compiler/nodelang/ast.h"

namespace patina::nodelang {

// A text and where its bytes are in the source map. For a JSON string with escapes, `map[i]` is the global offset of
// decoded byte i (one more entry than bytes: the end); else byte i is at base + i. The text must outlive the Ast.
struct Text {
    std::string_view text;
    std::uint32_t base = 0;
    const std::vector<std::uint32_t>* map = nullptr;

    std::uint32_t at(std::size_t i) const { return map ? (*map)[i] : base + static_cast<std::uint32_t>(i); }
};

// Deeper nesting of expressions or blocks is refused (the parser and the emitter recurse).
inline constexpr int kMaxNesting = 200;

// When the bodies of a file's functions are read: a text that may hold mistakes is read whole; of the library, a
// compilation needs a few functions out of hundreds.
enum class Bodies { Now, WhenAsked };
void parse_file(Text text, Ast& ast, Diagnostics& diagnostics, Bodies bodies = Bodies::Now);

// The statements of a function; any thread may ask. Mistakes in a body that is read only now go to body_errors().
const Statements& body_of(const FunctionDecl& function);
// What was wrong with a body that was read when asked for: it is asked for now.
const Diagnostics* body_errors(const FunctionDecl& function);

// An expression of a graph: may read $properties and @semantics.
const Expr* parse_expression(Text text, Ast& ast, Diagnostics& diagnostics);
// A link of a graph: `id`, `id.port`, `id.port.swizzle`, `$property...`, `@semantic...` and nothing else.
const Expr* parse_link(Text text, Ast& ast, Diagnostics& diagnostics);

}  // namespace patina::nodelang

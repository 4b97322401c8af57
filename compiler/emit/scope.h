// The result of an emitted expression (Typed), and the names that are visible to the code that is emitted (Scope). A
// Scope is made by the caller that begins a function or a graph; emission adds and removes the local variables.
//
//   Scope scope{.builder = &builder, .declarations = &library, .environment = &graph};
//   Typed mask = expression(emitter, *expr, scope);
//   if (mask.ok()) use(mask.value);
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/builder.h"
#include "compiler/nodelang/library.h"

namespace patina::emit {

// The syntax that this room reads.
using nodelang::Declarations;
using nodelang::EnumDecl;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::MemberDecl;
using nodelang::NumberKind;
using nodelang::ParamDecl;
using nodelang::Statements;
using nodelang::Stmt;
using nodelang::StructDecl;
using nodelang::TypeName;
using nodelang::VariableDecl;

// The outputs of a call or of a node that has more than one. Its value is a struct, and each output is a member of it.
struct Outputs {
    std::vector<std::string> names;  // in the order of the members
    bool has_primary = true;         // the name of the call alone means member 0
};

// A value while it is being emitted.
struct Typed {
    ir::Value value;
    ir::Type type = ir::Type::error();
    bool literal = false;   // a literal, or arithmetic of literals: it takes the type of number that its context needs
    bool is_whole = false;  // in HLSL: a float that is an int there, of sign()
    const Outputs* outputs = nullptr;
    const std::vector<std::string_view>* enumerators = nullptr;  // of an enum's value: the words that == accepts

    bool ok() const { return !type.is_error(); }
};

struct Scope;

// What a name means beyond the language itself: a graph's nodes, properties and semantics.
class Environment {
public:
    virtual ~Environment() = default;
    // If there is no such thing, each of these reports it and returns a Typed that is not ok().
    virtual Typed name(const Expr& expr, Scope& scope) = 0;
    // As name(), where a sampler is wanted.
    virtual Typed sampler(const Expr& expr, Scope& scope) { return name(expr, scope); }
    virtual Typed property(const Expr& expr, Scope& scope) = 0;
    virtual Typed semantic(std::string_view name, Span span, Scope& scope) = 0;
    virtual Typed file(const Expr& expr, Scope& scope) = 0;
    // True if the environment itself has the name (a node's id), which then hides a constant of the library.
    virtual bool hides(std::string_view) const { return false; }
    // In the vertex stage: adds to a message which node or output reads the value there.
    virtual void tell_reader(DiagnosticRecord&) const {}
};

// A port without a value, while its default is emitted: the location of the call, and the port and its function.
struct OpenPort {
    Span call;
    std::string_view function, port;
};

// A variable or parameter of the function that is being emitted.
struct Local {
    std::string_view name;
    Typed value;
    bool is_const = false;
    std::optional<double> constant;  // the value, if it is known; in HLSL also of a variable, until it is assigned
};

// Where an expression or statement is being emitted.
struct Scope {
    ir::Builder* builder = nullptr;
    const Declarations* declarations = nullptr;
    Environment* environment = nullptr;  // null in function bodies
    std::vector<Local> locals{};
    unsigned generic_width = 0;  // of floatN; 0 outside generic functions
    bool half = false;           // `float` means half
    bool hlsl = false;           // HLSL's rules hold: numbers convert to each other, vectors are cut
    std::size_t block = 0;       // the first of the locals that the innermost block declares
    // The function that is being emitted, for its returns.
    const FunctionDecl* function = nullptr;
    ir::Type result{};
    bool* needs_quad = nullptr;  // set if something reads neighbouring pixels
    // The same for slots, which may be called in a loop, in the body of an [inline] function; else null.
    bool* slot_needs_quad = nullptr;
    std::string_view flow{};  // "if" or "for" inside of one
    const OpenPort* open_port = nullptr;
    bool in_vertex_stage = false;
    double rounds_around = 1;  // how often the enclosing loops run what is emitted now
    double rounds = 0;         // of all loops so far, those in called functions included
};

}  // namespace patina::emit

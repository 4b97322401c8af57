// The syntax tree of the node language, for a .node.hlsl or .pass.hlsl file and for every value in a graph:
// "albedo.rgb", "= 1 - mask", "#f2a38a" and [1, 0, 0] all become an Expr. Nothing here has a type yet; types appear
// when an expression is emitted into the IR (emit/emit.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/source.h"
#include "compiler/base/stable_list.h"

namespace patina::nodelang {

enum class NumberKind : std::uint8_t { Int, Uint, Float, Half };

struct Expr {
    enum class Kind : std::uint8_t {
        Number,    // number, number_kind
        Bool,      // number is 0 or 1
        List,      // args: the elements of a JSON array, or of { } in an initialiser
        Color,     // args: three or four Numbers, already linear; text: as written
        Name,      // text: a local, a node id, a constant, an enumerator
        Property,  // text: name without $
        Semantic,  // text: name without @
        Member,    // args[0].text: a struct member, swizzle, output port
        Index,     // args[0][args[1]]
        Call,      // text(args): a function, intrinsic or type constructor
        Method,    // args[0].text(args[1..])
        Unary,     // text: - ! ~ +
        Binary,    // text: + - * / % < <= > >= == != && || & | ^ << >>
        Ternary,   // args[0] ? args[1] : args[2]
        File,      // text: "./rust.png"
        Object,    // text: a struct of the library; args: the values of its members. A gradient of a graph
        // Of HLSL alone:
        Assign,       // args[0] text args[1]; its value is what was assigned. text: = += ...
        AssignLater,  // the same, but its value is that of before: x++
        Sequence,     // (args[0], args[1]): its value is that of the second
    };
    Kind kind = Kind::Number;
    NumberKind number_kind = NumberKind::Int;
    Span span{};       // the whole expression
    Span name_span{};  // the word `text` alone (member, callee, operator)
    std::string_view text{};
    double number = 0;
    std::vector<const Expr*> args{};
};

struct TypeName {
    std::string_view name{};  // "float3", "floatN", "Surface", "BlendMode"
    Span span{};
    const Expr* array_size = nullptr;  // float k[4]
};

struct Stmt;
using Statements = std::vector<const Stmt*>;

struct Stmt {
    enum class Kind : std::uint8_t {
        Declare,  // type name = value;       value may be null
        Assign,   // target op= value;        op: "=", "+=", ...
        If,       // if (value) body else alternative
        For,      // for (int name = value; name < limit; name++) body
        Return,   // value may be null
        Discard,  // discardIf(value);
        Block,    // body
        // Of HLSL alone. The jumps are gone when a function has been parsed (jumps.h).
        Evaluate,  // value, for what it assigns
        Loop,      // while (value) { body; step }. No value: for ever
        Break,
        Continue,
    };
    Kind kind = Kind::Block;
    Span span{};
    TypeName type{};
    std::string_view name{};
    Span name_span{};
    std::string_view op{};
    bool is_const = false;
    bool is_light_loop = false;  // [light] for
    bool is_unrolled = false;    // [unroll] for: the rounds are written out if their number is known
    bool tests_later = false;    // Loop: the first round runs in any case
    bool takes_break = false;    // Block: of a switch, which a break leaves
    const Expr* target = nullptr;
    const Expr* value = nullptr;
    const Expr* limit = nullptr;    // Loop: what must hold, too, for a further round; may be null
    const Stmt* counter = nullptr;  // Loop: the only declaration at its head
    Statements body{};
    Statements alternative{};
    Statements step{};
};

// [name(arguments)]; arguments are expressions, or strings (kind File with the text).
struct Attribute {
    std::string_view name{};
    Span span{};
    std::vector<const Expr*> args{};
};

struct ParamDecl {
    TypeName type{};
    std::string_view name{};
    Span span{};
    bool is_const = false;
    bool is_out = false;
    bool is_inout = false;          // is_out, and an input too
    const Expr* initial = nullptr;  // a constant expression, a semantic (Name), or an earlier parameter's .sampler
    std::vector<Attribute> attributes{};
    std::string_view doc{};  // text of the trailing `///<` or of the @-lines of the function's comment

    bool is_input() const { return !is_out || is_inout; }
};

struct UnreadBody;

// What the attributes of a function mean for the emitter. The parser reads them once.
struct FunctionMarks {
    bool is_stage = false;        // [pass]: a stage of a pass, which nothing calls
    bool is_slot = false;         // [slot]: a pass calls it, and lowering fills it
    bool is_inlined = false;      // [inline]: it is spelled out where it is called
    bool is_member = false;       // [member]: its first parameter is the value before the dot
    bool is_in_float = false;     // [inFloat]: it computes in float, also for half arguments
    bool is_of_object = false;    // [perObject]: it depends on the object that is drawn
    bool is_of_hlsl = false;      // [hlsl]: only functions that are read by HLSL's rules may call it
    bool is_foreign = false;      // [foreign]: an included file defines it, or text that is not the node language
    std::string_view spelling{};  // of a call of a foreign function; empty: its name and the arguments
};

struct FunctionDecl {
    std::string_view name{};
    Span name_span{};
    Span span{};
    TypeName result{};
    std::vector<ParamDecl> params{};
    std::vector<Attribute> attributes{};
    FunctionMarks marks{};
    bool is_hlsl = false;         // read by HLSL's rules: see parse.h
    std::string_view doc{};       // the /// lines, with the slashes
    std::uint32_t doc_begin = 0;  // global offset of doc's first byte
    bool has_body = false;
    std::string_view code{};                     // of a [foreign] function: its body as text, which nobody reads
    Statements body{};                           // ask body_of() (parse.h): it may not have been read yet
    std::shared_ptr<const UnreadBody> unread{};  // the text of a body that is parsed at the first request

    const Attribute* attribute(std::string_view attribute_name) const {
        for (const Attribute& a : attributes) {
            if (a.name == attribute_name) return &a;
        }
        return nullptr;
    }
};

struct MemberDecl {
    TypeName type{};
    std::string_view name{};
    Span span{};
    std::vector<Attribute> attributes{};
    std::string_view doc{};

    const Attribute* attribute(std::string_view attribute_name) const {
        for (const Attribute& a : attributes) {
            if (a.name == attribute_name) return &a;
        }
        return nullptr;
    }
};
struct StructDecl {
    std::string_view name{};
    Span span{};
    std::vector<MemberDecl> members{};
    std::vector<Attribute> attributes{};
    std::string_view doc{};
};
struct EnumDecl {
    std::string_view name{};
    Span span{};
    std::vector<std::string_view> values{};
    std::vector<std::string_view> docs{};
    std::string_view doc{};
};
// `const float PI = 3.14;` at file level, or a [extern]/[attribute]/[builtin] variable.
struct VariableDecl {
    TypeName type{};
    std::string_view name{};
    Span span{};
    bool is_const = false;
    bool is_hlsl = false;
    const Expr* value = nullptr;
    std::vector<Attribute> attributes{};
    std::string_view doc{};

    const Attribute* attribute(std::string_view attribute_name) const {
        for (const Attribute& a : attributes) {
            if (a.name == attribute_name) return &a;
        }
        return nullptr;
    }
};

// Owns what the parser made of one or more texts. Addresses are stable.
struct Ast {
    StableList<Expr> exprs;
    StableList<Stmt> stmts;
    StableList<FunctionDecl> functions;
    StableList<StructDecl> structs;
    StableList<EnumDecl> enums;
    StableList<VariableDecl> variables;
    StableList<std::string> texts;  // decoded JSON strings that views point into
};

}  // namespace patina::nodelang

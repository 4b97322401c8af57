// The room `emit` turns syntax trees of the node language into IR, and checks their types on the way. It parses nothing
// (nodelang does), and it knows no graph, material or pass (lower does). Names that are not the language's own are
// answered by an Environment; slots, externs and statics by a Known. So function bodies and expressions of graphs are
// emitted by the same code.
//
//   Emitter emitter{.module = module, .diagnostics = diagnostics};
//   Scope scope{.builder = &builder, .declarations = &library, .environment = &graph};
//   Typed mask = expression(emitter, *expr, scope);
//
// Other rooms call only the functions below, and use scope.h, known.h and instances.h with them. The other headers are
// private to the room. expression.cpp emits an expression. It calls, by the kind of the expression, operations.h
// (operators, members, intrinsics), textures.h (methods) or calls.h. A call gathers its values (arguments.h). If a
// function is called for the first time, functions.h emits it with its statements (statements.h), which contain
// expressions again. All of them use conversion.h, types.h and constant_value.h.
#pragma once

#include <array>
#include <deque>
#include <tuple>

#include "compiler/base/cancellation.h"
#include "compiler/emit/instances.h"
#include "compiler/emit/known.h"

namespace patina::emit {

// How a texture is read, if not as its file has it. It is part of the texture's type. Code that reads texels applies
// it, and each function that takes textures is emitted once for each view of them.
struct TextureView {
    std::array<char, 4> channels{'r', 'g', 'b', 'a'};  // of the four components: r, g, b, a, 0 or 1
    bool green_is_down = false;                        // the component that is green after that is 1 - green
    friend bool operator==(const TextureView&, const TextureView&) = default;
    friend bool operator<(const TextureView& a, const TextureView& b) {
        return std::tie(a.channels, a.green_is_down) < std::tie(b.channels, b.green_is_down);
    }
};

// The struct types that have been made.
struct Structures {
    std::map<const StructDecl*, ir::Type> made{};
    // The values of textures: {texture, sampler}, and of Texture2D {texture, sampler, texelSize, tiling}.
    std::map<std::pair<ir::Kind, TextureView>, ir::Type> textures{};
};

// What the emission into one module needs and keeps.
struct Emitter {
    ir::Module& module;
    Diagnostics& diagnostics;
    ir::BuildOptions options{};
    Known known{};                  // filled by the caller
    Instances instances{};          // the functions that have been made
    Structures structures{};        // the structs that have been made
    std::deque<Outputs> outputs{};  // what Typed::outputs points to
    Growth* growth = nullptr;       // null: there is no limit
    // Of HLSL: the function that a call means, by the call, the width of floatN and the precision.
    std::map<std::tuple<const Expr*, unsigned, bool>, const FunctionDecl*> overloads{};
    std::vector<const FunctionDecl*> active{};  // whose bodies are being emitted, the innermost last: finds recursion
};

// --- expressions. A mistake is reported at its place, and the result is then not ok().
Typed expression(Emitter& emitter, const Expr& expr, Scope& scope);
// Converted to `type` by the implicit conversions. `what` opens the message: "the input 'uv'".
Typed expression_as(Emitter& emitter, const Expr& expr, ir::Type type, Scope& scope, std::string_view what);
Typed convert(Emitter& emitter, Typed value, ir::Type type, Scope& scope, Span span, std::string_view what);
// The primary output of a call or node; anything else is returned as it is.
Typed primary(Emitter& emitter, Typed value, Scope& scope, Span span);
// Calls a function of the language with one expression for each parameter (null: the parameter's default).
Typed call(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
           std::span<const Expr* const> arguments, Scope& scope, Span span, bool half);
// What an [extern] variable holds; a texture comes with its sampler. Not ok() if Known does not list it.
Typed extern_value(Emitter& emitter, const VariableDecl& variable, Scope& scope);
// A texture of its parts. Only a Texture2D has the last two.
struct TextureParts {
    ir::Value texture, sampler;
    ir::Value tiling{};      // float4: scale and offset; null: 1 and 0
    ir::Value texel_size{};  // float4: (1/width, 1/height, width, height); null: the shader asks the texture
    TextureView view{};
};
Typed make_texture(Emitter& emitter, const TextureParts& parts, Scope& scope);
// As expression_as(), but a texture keeps its view: for parameters and variables that may have the type of their value.
Typed view_as(Emitter& emitter, const Expr& expr, ir::Type type, Scope& scope, std::string_view what);
bool is_texture(const Emitter& emitter, ir::Type type);
// True for two texture types that differ at most in their views.
bool is_view_of(const Emitter& emitter, ir::Type type, ir::Type texture);

// Counts what is made for an expression of the language. If that is too much, reports it at `where`, and ends the work.
void check_growth(Emitter& emitter, Span where);
inline constexpr std::size_t kMadePerCheck = 64;
inline void grow(Emitter& emitter, Span where) {
    Growth* const growth = emitter.growth;
    if (growth && (++growth->made % kMadePerCheck == 0 || growth->made > growth->most)) check_growth(emitter, where);
}
// The same for so many more of them that are about to be made. The advice says how there would be fewer.
void expect_growth(Emitter& emitter, double more, Span where, std::string_view advice);

// --- types
// The type that a word of the language means here. Reports a word that means none.
ir::Type type(Emitter& emitter, const TypeName& name, const Scope& scope);
// Keeps a list of outputs for as long as the Emitter lives.
const Outputs* keep(Emitter& emitter, Outputs outputs);

// --- functions. Each returns a null id after an error.
// A function of which every parameter is a semantic: a recipe, or what a pass calls first. It is always inlined.
// `needs_quad` is set if it reads neighbouring pixels.
ir::FunctionId semantic_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                                 Environment& environment, bool in_vertex_stage, bool* needs_quad = nullptr);
// A function that replaces another one. Parameters without a default are those of the replaced function, and the others
// are semantics.
ir::FunctionId given_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home,
                              Environment& environment, bool half);
// A function with plain parameters only: no floatN and no constants. It is always inlined.
ir::FunctionId plain_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home);
// Emits a function in each of its forms (each width of floatN, each value of a drop-down) to find its errors.
void check_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home);

}  // namespace patina::emit

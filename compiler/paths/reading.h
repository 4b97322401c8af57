// Functions that the files of this room share while they read a file's attributes. Private to compiler/paths.
#pragma once

#include "compiler/paths/declarations.h"

namespace patina::paths {

// Checks every declaration of the file: structs, enums and variables (check_declarations.cpp), functions
// (check_functions.cpp), and slots that are derived from other slots (check_slots.cpp).
void check_declarations(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                        const PathDeclarations& paths, Diagnostics& diagnostics);
void check_functions(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                     const PathDeclarations& paths, Diagnostics& diagnostics);
void check_slots(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                 const PathDeclarations& paths, Diagnostics& diagnostics);
// Checks that the file's passes agree with each other (check_passes.cpp).
void check_passes(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const PathDeclarations& paths,
                  Diagnostics& diagnostics);
// The name of the path that a file is: "art/mine.pass.hlsl" -> "mine".
std::string stem(std::string_view path);
// True for a place in a .pass.hlsl.
bool is_of_pass(const SourceMap& sources, Span span);

// Reads the attributes of a pass's fragment function, and the targets that it returns (pass_state.cpp).
void read_pass_state(const nodelang::FunctionDecl& fragment, const nodelang::Declarations& declarations, PassDecl& pass,
                     Diagnostics& diagnostics);
// The lines that a function adds to the engine's file: its [text] attributes.
std::vector<ir::StageText> texts_of(std::span<const nodelang::Attribute> attributes, Diagnostics& diagnostics);
// True for an attribute that derives a slot from another: [part], [without], [pack], [unpack].
bool is_derivation(std::string_view attribute);
std::vector<std::string_view> attribute_words(const nodelang::Attribute& attribute, std::size_t first = 0);

// The words of [static].
struct StaticWord {
    std::string_view text;
    StaticDecl::About about;
};
std::span<const StaticWord> static_words();
// The words of [builtin], and the type of each.
struct BuiltinWord {
    std::string_view text, type;
    ir::Builtin builtin;
};
std::span<const BuiltinWord> builtin_words();
// The words of [wraps], and the type that each takes and returns.
struct WrapWord {
    std::string_view text, type;
    WrapDecl::What what;
};
std::span<const WrapWord> wrap_words();

}  // namespace patina::paths

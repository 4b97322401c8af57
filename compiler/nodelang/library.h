// Finds declarations by name: in the built-in library (nodes/**), or in a user's .node.hlsl file, which has the library
// as its parent. It owns only the maps; the declarations are in an Ast. Names that are declared twice are reported.
//
//   Declarations library;  index_declarations(ast, library, diagnostics);
//   const FunctionDecl* ggx = library.function("DistributionGGX");
#pragma once

#include <unordered_map>

#include "compiler/base/diagnostics.h"
#include "compiler/nodelang/unread.h"

namespace patina::nodelang {

struct Declarations {
    const Declarations* parent = nullptr;
    std::unordered_map<std::string_view, const FunctionDecl*> functions;
    std::unordered_map<std::string_view, const StructDecl*> structs;
    std::unordered_map<std::string_view, const EnumDecl*> enums;
    std::unordered_map<std::string_view, const VariableDecl*> variables;
    std::unordered_map<std::string_view, const Unread*> unread;  // further ones, of any kind
    // Of HLSL: the functions of a name after the first one.
    std::unordered_map<std::string_view, std::vector<const FunctionDecl*>> overloads{};

    const FunctionDecl* function(std::string_view name) const;
    const StructDecl* structure(std::string_view name) const;
    const EnumDecl* enumeration(std::string_view name) const;
    const VariableDecl* variable(std::string_view name) const;
    // The scope that declares the function, and in which the names in its body are searched.
    const Declarations& home_of(std::string_view function_name) const;
    // Names of all library nodes and helpers that can be called, sorted.
    std::vector<std::string_view> function_names() const;
};

// Adds every declaration of `ast` to `into`, in addition to those that are unread. A constant that leads back to itself
// is reported, and loses its value.
void index_declarations(Ast& ast, Declarations& into, Diagnostics& diagnostics);

// The text of attribute argument `index` (a string or a bare word), or empty.
std::string_view attribute_text(const Attribute& attribute, std::size_t index = 0);

// The first sentence of a declaration's comment, without the slashes and on one line.
std::string first_sentence(std::string_view doc);

}  // namespace patina::nodelang

// What a function reads: the words of its syntax tree.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "compiler/nodelang/ast.h"

namespace patina::importers::shadergraph {

struct Word {
    enum class Kind { Name, Call, Type };
    Kind kind = Kind::Name;
    std::string_view text{};
    std::size_t arguments = 0;  // of a call
};

struct Reads {
    std::vector<Word> words{};              // in the order of the text
    std::set<std::string_view> declared{};  // its parameters and variables
    std::set<std::string_view> assigned{};  // variables that something is assigned to, or that a function takes

    void add(const nodelang::FunctionDecl& function);
    void add(const nodelang::TypeName& type);
    void add(const nodelang::Expr* expr);
    void add(const nodelang::Statements& list);
};

// The function or type is a part of HLSL itself.
bool is_of_hlsl(std::string_view word);

}  // namespace patina::importers::shadergraph

// What the checks of a file's declarations share: where they look names up, and how they report. Private to
// compiler/paths.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "compiler/paths/reading.h"

namespace patina::paths {

// The base of the checks: it has the declarations of the file, and reports errors.
class DeclarationCheck {
public:
    DeclarationCheck(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                     const PathDeclarations& paths, Diagnostics& diagnostics)
        : ast_(ast), declarations_(declarations), sources_(sources), paths_(paths), diagnostics_(diagnostics) {}

protected:
    using Words = std::span<const std::string_view>;

    static bool is_in(Words words, std::string_view word) {
        return std::find(words.begin(), words.end(), word) != words.end();
    }
    static bool is_same(const nodelang::TypeName& a, const nodelang::TypeName& b) {
        return a.name == b.name && !a.array_size == !b.array_size;
    }
    // True for functions with the same parameters and result.
    static bool is_like(const nodelang::FunctionDecl& a, const nodelang::FunctionDecl& b);

    void bad(Span span, std::string_view attribute, std::string_view why) {
        diagnostics_.report(Code::BadAttribute, span, attribute, why);
    }
    // Reports an argument that is not in `words`.
    void one_of(const nodelang::Expr& given, Words words, std::string_view what);
    // Reports a pass that does not exist: false.
    bool pass(const nodelang::Expr& given);
    // The slot of that name; null when there is none, which is reported.
    const nodelang::FunctionDecl* slot(const nodelang::Expr& given);
    const nodelang::FunctionDecl* find_slot(std::string_view name) const {
        const SlotDecl* found = paths_.slot(name);
        return found ? found->function : nullptr;
    }

    // The library declares `name` already, outside of pass files, where it keeps its meaning for graphs and for the
    // library's functions. So a file cannot declare something else of that name.
    template <class Decl>
    bool is_taken(const Decl* older) const {
        return older && !is_of_pass(sources_, older->span);
    }
    DiagnosticRecord& twice(Span span, std::string_view name, Span older) {
        return diagnostics_.report(Code::Redefinition, span, name)
            .note(older, "the library's declaration is here: give this one another name");
    }

    // True for a declaration in an engine's passes. The engine reads the text that they state (engines/engine.h).
    bool is_of_engine(Span span) const {
        return std::string_view(sources_.resolve(span.begin).file).starts_with("nodes/engines/");
    }
    // The text of [foreign] has a meaning only for an included file, and the engine provides the rest.
    void foreign(const nodelang::Attribute& attribute, Span span);

    // Reports declarations that lead back to themselves. `active` are those on the way to `next`.
    bool is_circle(std::span<const nodelang::FunctionDecl* const> active, const nodelang::FunctionDecl& next,
                   Span span);

    const nodelang::Ast& ast_;
    const nodelang::Declarations& declarations_;
    const SourceMap& sources_;
    const PathDeclarations& paths_;
    Diagnostics& diagnostics_;
};

// The types that std140 can lay out.
bool is_uniform_type(std::string_view name);

}  // namespace patina::paths

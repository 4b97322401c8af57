// The room `languages` prints stages: a linked and tidied stage -> text in one language, with a map from its lines to
// the graph. A language is a row in languages.cpp: its name, legalize() and print(). Its print() passes a Language
// (language.h: the spelling table and the hooks) to the shared printer. This room sees only the IR: it knows no graph
// and no engine. It changes no values except to rewrite operations that a language lacks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/ir/ir.h"

namespace patina::languages {

struct PrintedLine {
    int line = 0;  // from 1
    ir::OriginId origin;
};
// A declaration of the text.
struct Piece {
    enum class Kind { Uniform, Struct, Function, Entry };
    Kind kind = Kind::Function;
    std::string name{};
    std::size_t begin = 0, end = 0;  // in the text: whole lines
    int line = 0;                    // its first one
};
struct Printed {
    std::string text;
    std::vector<PrintedLine> lines;  // ascending; a line without an entry belongs to the one before it
    std::vector<Piece> pieces{};     // in order
    std::vector<int> light_loops{};  // lines at which a loop over lights begins
};

// The values of functions that become variables (plan.h). They do not depend on the language, so languages that print
// the same module share them.
class Plans;

// For a text that is pasted into shaders. It has no version, and the material's descriptor set has a name in it,
// "Rust_set". If the shader defines that name first, its number is used.
struct Pasting {
    std::string prefix;  // "Rust_"
    std::uint32_t set = 0;

    std::string set_name() const { return prefix + "set"; }
};

// Names that the surrounding text declares, and prefixes that belong to it. A printed name with such a prefix gets
// "own" in front.
struct TakenNames {
    std::unordered_set<std::string> names;
    std::unordered_set<std::string> macros;  // the names among them that members must avoid, too
    std::vector<std::string> prefixes;
};

struct PrintOptions {
    std::string header;                        // lines for a comment at the top, without comment marks
    Plans* plans = nullptr;                    // those of this module; null: made for this printing
    std::optional<Pasting> pasting = {};       // none: a whole shader
    const TakenNames* taken = nullptr;         // null: there is no surrounding text
    std::vector<std::string> also_taken = {};  // more names of the surrounding text
    std::size_t width = 120;                   // columns; longer lines are broken
};

struct LanguageInfo {
    std::string_view name;       // "glsl"
    std::string_view extension;  // "glsl"
    // Rewrites what the language cannot express; nothing if it can express the whole stage.
    std::optional<ir::Module> (*legalize)(const ir::Module& module);
    Printed (*print)(const ir::Module& module, const PrintOptions& options);
    bool has_preprocessor = true;  // texts that are pasted into others need it
    bool takes_foreign = false;    // the text of [foreign] functions is in this language (ir::ForeignCode)
};

std::span<const LanguageInfo> all_languages();
const LanguageInfo* find_language(std::string_view name);

// True if some language reserves the word: keywords, reserved words, intrinsics.
bool is_reserved_word(std::string_view word);
// The word itself, or the name that replaces a reserved word or a word with __ or gl_ in it.
std::string safe_identifier(std::string_view word);

}  // namespace patina::languages

// A linked, tidied and legalized stage -> text in one target language, with a map from its lines back to the graph.
// Sees the IR and nothing else. A target is a row of targets.cpp: a spelling table, a few functions and its legalize.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/ir.h"

namespace patina::targets {

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
};

// By function: which values become variables (plan.h). The same for all languages, so that a stage that several of them
// can say as it is has them made once.
struct Plan;
std::vector<Plan> make_plans(const ir::Module& module);

// Of a text that is pasted into shaders: it has no version of its own, and the descriptor set of the material stands in
// it by a name, "Rust_set", that the shader may define before.
struct Pasting {
    std::string prefix;  // "Rust_"
    std::uint32_t set = 0;

    std::string set_name() const { return prefix + "set"; }
};

struct PrintOptions {
    std::string header;                        // lines for a comment at the top, without comment marks
    const std::vector<Plan>* plans = nullptr;  // of this module; null: made for this printing
    std::optional<Pasting> pasting = {};       // none: a whole shader
    std::vector<std::string> taken = {};       // names that the text around it has
    std::size_t width = 120;                   // columns that lines are broken at
};

struct LanguageInfo {
    std::string_view name;       // "glsl"
    std::string_view extension;  // "glsl"
    // The stage with what the language cannot say rewritten; none if it can say all of it as it is.
    std::optional<ir::Module> (*legalize)(const ir::Module& module);
    Printed (*print)(const ir::Module& module, const PrintOptions& options);
};

std::span<const LanguageInfo> all_languages();
const LanguageInfo* find_language(std::string_view name);

// True if the word cannot be an identifier in every target language: keywords, reserved words, intrinsics.
bool is_reserved_word(std::string_view word);
// The word itself, or the name that a target gets instead of a reserved word or one with __ or gl_ in it.
std::string safe_identifier(std::string_view word);

}  // namespace patina::targets

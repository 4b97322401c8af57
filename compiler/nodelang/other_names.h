// Names of other languages and programs (GLSL, C#, MaterialX, Unity), for users who search for the name they know.
// Nothing compiles because of them: they are advice.
//
//   record.note(advice("mix", known, declarations));       // "'mix' is written 'lerp' here"
//   record.note(word_advice("_Time"));                     // "'_Time' is written '@time' here: in seconds, as _Time.y"
//   record.note(node_advice("Mix", known, declarations));  // "'Mix' is the node 'Lerp' here"
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "compiler/nodelang/library.h"

namespace patina::nodelang {

// A name of another language, Patina's name for it, and a remark. If `own` is empty, Patina has no such name, and the
// remark says what to write. "atan/2" is the function with two arguments.
struct OtherName {
    std::string_view other, own, remark{};
};
// All names, except those that node files declare for their nodes.
std::span<const OtherName> other_names();

// What to write for a function, a type or a value of another language; empty if the word is unknown. "atan/2" is the
// function with two arguments.
std::string word_advice(std::string_view word);

// The node that has `word` in its attribute [also("mix")]; null if there is none. Capitals, spaces and _ do not count.
const FunctionDecl* known_as(const Declarations& declarations, std::string_view word);

// Advice for an unknown input: the input that has `word` in its attribute [also("frequency")], or the nearest.
std::string port_advice(std::string_view word, std::span<const std::string_view> known, const FunctionDecl* function);

// What is written here for an unknown function, or for an unknown node; else the nearest of `known`, or nothing.
std::string node_advice(std::string_view word, std::span<const std::string_view> known,
                        const Declarations& declarations);
std::string advice(std::string_view word, std::span<const std::string_view> known, const Declarations& declarations);

}  // namespace patina::nodelang

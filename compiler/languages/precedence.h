// Printed text with its precedence, which decides where it needs parentheses.
#pragma once

#include <string>
#include <utility>

#include "compiler/base/precedence.h"

namespace patina::languages {

struct Text {
    std::string text;
    Precedence precedence = Precedence::Primary;
};

// The text, in parentheses if its place requires a higher precedence than it has.
inline std::string at_least(Precedence needed, Text t) {
    return t.precedence < needed ? "(" + t.text + ")" : std::move(t.text);
}

}  // namespace patina::languages

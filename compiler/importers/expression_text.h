// Expressions and names of imported graphs as text: brackets where operators need them, numbers as short as they can
// be, identifiers from names that may be any text.
//
//   at_least("a + b", kProduct) + " * 2";   // "(a + b) * 2"
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace patina::importers::terms {

enum Precedence { kChoice, kOr, kAnd, kEqual, kCompare, kSum, kProduct, kUnary, kPrimary };
Precedence precedence_of(std::string_view expression);
// In brackets, if it binds less strongly than that.
std::string at_least(std::string_view expression, Precedence precedence);
// In brackets, if an operator before or after it binds more strongly.
std::string bracketed(const std::string& text, std::string_view before, std::string_view after);
std::string digits(double number);  // "0.5"
// The expression without what nobody writes: "x - (-1)" is "x + 1", "(1 - 0.5)" is "0.5", "(uv) / 2" is "uv / 2",
// "-1 * x" is "-x".
std::string folded(std::string expression);
// The arguments of a call at the outer level: "a, f(b, c)" -> "a", "f(b, c)".
std::vector<std::string> arguments_of(std::string_view list);

// --- names

std::string camel_case(std::string_view name);   // "Tiling And Offset", "tiling_and_offset" -> "tilingAndOffset"
std::string pascal_case(std::string_view name);  // "tiling_and_offset" -> "TilingAndOffset"; may be empty
std::string identifier(std::string_view name);   // "_Main Tex" -> "_Main_Tex"; may be empty

// Each name once: "mask", "mask2", "mask3".
class Names {
public:
    std::string unique(std::string_view wanted, std::string_view otherwise);
    void take(std::string_view name) { taken_.insert(std::string(name)); }

private:
    std::set<std::string, std::less<>> taken_;
    std::map<std::string, int> next_;  // by the name without a number: the number that may be free
};

}  // namespace patina::importers::terms

#include "compiler/importers/expression_text.h"

#include <algorithm>
#include <optional>
#include <set>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers::terms {
namespace {

// Words of the node language, which no name may be.
constexpr std::string_view kReserved[] = {"true",  "false", "if",  "else",  "for",    "return",
                                          "const", "in",    "out", "inout", "struct", "enum",
                                          "void",  "uint",  "int", "bool",  "half",   "float"};

// The value of "1 - 0.5".
std::optional<double> value_of_pair(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == text.npos || space + 3 >= text.size() || text[space + 2] != ' ') return {};
    const auto left = read_number(text.substr(0, space)), right = read_number(text.substr(space + 3));
    if (!left || !right) return {};
    switch (text[space + 1]) {
        case '+': return *left + *right;
        case '-': return *left - *right;
        case '*': return *left * *right;
        case '/': return *right == 0 ? std::nullopt : std::optional(*left / *right);
        default: return {};
    }
}

// Makes the group in these brackets shorter, if that is possible.
bool folds_group(std::string& text, std::size_t open, std::size_t close) {
    const std::string inner = text.substr(open + 1, close - open - 1);
    const char before = open > 0 ? text[open - 1] : ' ';
    const bool is_call = is_word_letter(before);
    if (const auto value = value_of_pair(inner)) {
        const std::string made = digits(*value);
        text.replace(open + 1, inner.size(), made);
        return true;
    }
    if (is_call) return false;
    const bool is_number = read_number(inner).has_value();
    if (is_number && inner.starts_with('-')) {
        const char sign = open > 1 && before == ' ' ? text[open - 2] : ' ';
        const bool is_binary = open > 3 && text[open - 3] == ' ' && (sign == '-' || sign == '+');
        if (!is_binary) return false;
        text.replace(open, close + 1 - open, inner.substr(1));
        text[open - 2] = sign == '-' ? '+' : '-';
        return true;
    }
    const bool is_name = !inner.empty() && !is_digit(inner[0]) && std::ranges::all_of(inner, [](char c) {
        return is_word_letter(c) || c == '$' || c == '@' || c == '.';
    });
    if (!is_number && !is_name) return false;
    const char after = close + 1 < text.size() ? text[close + 1] : ' ';
    if (is_number && (after == '.' || after == '[')) return false;
    text.replace(open, close + 1 - open, inner);
    return true;
}

}  // namespace

std::string digits(double number) {
    return shortest(static_cast<float>(number));
}

Precedence precedence_of(std::string_view text) {
    Precedence lowest = kPrimary;
    int depth = 0;
    bool is_operand = false;  // something stands to the left
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i], next = i + 1 < text.size() ? text[i + 1] : '\0';
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
        if (c == ' ') continue;
        Precedence found = kPrimary;
        if (depth == 0) {
            const bool is_exponent = i > 1 && (text[i - 1] == 'e' || text[i - 1] == 'E') && is_digit(next) &&
                                     (is_digit(text[i - 2]) || text[i - 2] == '.');
            if (c == '?') found = kChoice;
            if (c == '|' && next == '|') found = kOr;
            if (c == '&' && next == '&') found = kAnd;
            if ((c == '=' || c == '!') && next == '=') found = kEqual;
            if (c == '<' || c == '>') found = kCompare;
            if ((c == '+' || c == '-') && !is_exponent) found = is_operand ? kSum : kUnary;
            if (c == '*' || c == '/' || c == '%') found = kProduct;
            if (c == '!' && next != '=') found = kUnary;
            if ((found == kEqual || found == kOr || found == kAnd || found == kCompare) && (next == '=' || next == c))
                ++i;
        }
        if (found != kPrimary) {
            if (!(found == kUnary && lowest != kPrimary)) lowest = std::min(lowest, found);
            is_operand = false;
        } else {
            is_operand = true;
        }
    }
    return lowest;
}

std::string at_least(std::string_view expression, Precedence precedence) {
    if (precedence_of(expression) >= precedence) return std::string(expression);
    return "(" + std::string(expression) + ")";
}

std::string bracketed(const std::string& text, std::string_view before, std::string_view after) {
    while (before.ends_with(' ')) before.remove_suffix(1);
    while (after.starts_with(' ')) after.remove_prefix(1);
    const auto strength = [](char c) {
        if (c == '+' || c == '-') return kSum;
        if (c == '*' || c == '/' || c == '%') return kProduct;
        if (c == '!') return kUnary;
        if (c == '=' || c == '<' || c == '>') return kCompare;
        if (c == '&') return kAnd;
        if (c == '|') return kOr;
        if (c == '.' || c == '[') return kPrimary;
        return kChoice;
    };
    const char left = before.empty() ? ' ' : before.back(), right = after.empty() ? ' ' : after.front();
    int needed = std::max<int>(strength(right), strength(left));
    if (std::string_view("-/%*=<>").find(left) != std::string_view::npos) ++needed;
    if (left == '?' || right == '?' || (left == ':' && precedence_of(text) == kChoice))
        needed = std::max<int>(needed, kOr);
    if (needed > kChoice && text.starts_with("-") && strength(left) > kChoice) return "(" + text + ")";
    return at_least(text, static_cast<Precedence>(std::min<int>(needed, kPrimary)));
}

std::string folded(std::string text) {
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::size_t open = text.find('('); open != text.npos; open = text.find('(', open + 1)) {
            const std::size_t close = text.find_first_of("()", open + 1);
            if (close != text.npos && text[close] == ')') is_changed |= folds_group(text, open, close);
        }
    }
    if (text.starts_with("-1 * ") && text.size() > 5 && (is_letter(text[5]) || text[5] == '$' || text[5] == '@'))
        text.replace(0, 5, "-");
    return text;
}

std::vector<std::string> arguments_of(std::string_view list) {
    std::vector<std::string> made;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        if (i < list.size() && (list[i] == '(' || list[i] == '{' || list[i] == '[')) ++depth;
        if (i < list.size() && (list[i] == ')' || list[i] == '}' || list[i] == ']')) --depth;
        if (i < list.size() && (list[i] != ',' || depth > 0)) continue;
        const std::string_view part = trimmed(list.substr(begin, i - begin));
        if (!part.empty()) made.emplace_back(part);
        begin = i + 1;
    }
    return made;
}

std::string camel_case(std::string_view name) {
    std::string made;
    bool starts_word = false;
    for (const char c : name) {
        if (!is_letter(c) && !is_digit(c)) {
            starts_word = !made.empty();
            continue;
        }
        made += starts_word ? to_upper(c) : c;
        starts_word = false;
    }
    // The first word in small letters: "UV" -> "uv", "HSVShift" -> "hsvShift", "MainTex" -> "mainTex".
    std::size_t capitals = 0;
    while (capitals < made.size() && is_upper(made[capitals])) ++capitals;
    if (capitals > 1 && capitals < made.size() && is_letter(made[capitals])) --capitals;
    for (std::size_t i = 0; i < std::max<std::size_t>(capitals, 1) && i < made.size(); ++i) made[i] = to_lower(made[i]);
    if (!made.empty() && is_digit(made[0])) made = "n" + made;
    return made;
}

std::string pascal_case(std::string_view name) {
    std::string made;
    bool starts_word = true;
    for (const char c : name) {
        if (is_letter(c) || is_digit(c)) made += starts_word ? to_upper(c) : c;
        starts_word = !is_letter(c) && !is_digit(c);
    }
    return made;
}

std::string identifier(std::string_view name) {
    std::string made;
    for (const char c : name) made += is_word_letter(c) ? c : '_';
    if (made.find_first_not_of('_') == made.npos) return {};
    if (is_digit(made[0])) made = "_" + made;
    return made;
}

std::string Names::unique(std::string_view wanted, std::string_view otherwise) {
    constexpr std::size_t kLongest = 100;  // also a name of a file
    std::string base((wanted.empty() ? otherwise : wanted).substr(0, kLongest));
    if (std::ranges::find(kReserved, base) != std::end(kReserved)) base += "Value";
    std::string made = base;
    for (int& i = next_.emplace(base, 2).first->second; taken_.contains(made); ++i)
        made = base + (is_digit(base.back()) ? "_" : "") + std::to_string(i);
    taken_.insert(made);
    return made;
}

}  // namespace patina::importers::terms

#include "compiler/importers/shadergraph/code/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace patina::importers::shadergraph {
namespace {

constexpr std::size_t kLongest = 1000;  // the reader calls itself
constexpr int kDeepest = 16;            // macros in macros

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

// Operators by how strongly they bind, the weakest first. Longer ones come before those that they begin with.
struct Operator {
    std::string_view text;
    int strength;
    bool compares;
};
constexpr Operator kOperators[] = {{"||", 1, false}, {"&&", 2, false}, {"==", 3, true}, {"!=", 3, true},
                                   {"<=", 4, true},  {">=", 4, true},  {"<", 4, true},  {">", 4, true},
                                   {"+", 5, false},  {"-", 5, false},  {"*", 6, false}};

struct Number {
    long long value = 0;
    std::string unknown{};  // the word of the engine that it is
};

class Reader {
public:
    Reader(std::string_view text, const Macros& macros, int depth) : text_(text), macros_(macros), depth_(depth) {}

    Number all(std::string& error) {
        Number made = binary(1);
        skip();
        if (at_ < text_.size() && error_.empty())
            error_ = fmt::format("it cannot be read at '{}'", text_.substr(at_, 20));
        error = error_;
        return made;
    }

private:
    void skip() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    const Operator* next_operator() {
        skip();
        const auto found = std::ranges::find_if(
            kOperators, [&](const Operator& each) { return text_.substr(at_).starts_with(each.text); });
        return found == std::end(kOperators) ? nullptr : &*found;
    }

    Number binary(int strength) {
        Number left = unary();
        for (;;) {
            const Operator* op = next_operator();
            if (!op || op->strength < strength || !error_.empty()) return left;
            at_ += op->text.size();
            const Number right = binary(op->strength + 1);
            for (const Number& each : {left, right})
                if (!each.unknown.empty() && (op->compares || op->strength > 4) && error_.empty())
                    error_ = fmt::format("it compares '{}', whose value only the engine knows", each.unknown);
            left = {.value = result(op->text, left.value, right.value)};
        }
    }
    static long long result(std::string_view op, long long a, long long b) {
        if (op == "||") return a != 0 || b != 0;
        if (op == "&&") return a != 0 && b != 0;
        if (op == "==") return a == b;
        if (op == "!=") return a != b;
        if (op == "<=") return a <= b;
        if (op == ">=") return a >= b;
        if (op == "<") return a < b;
        if (op == ">") return a > b;
        // As unsigned numbers, which wrap around.
        const auto x = static_cast<unsigned long long>(a), y = static_cast<unsigned long long>(b);
        return static_cast<long long>(op == "+" ? x + y : op == "-" ? x - y : x * y);
    }

    Number unary() {
        skip();
        const char c = at_ < text_.size() ? text_[at_] : ' ';
        if (c == '!' || c == '-') {
            ++at_;
            const Number of = unary();
            return {.value = c == '!' ? of.value == 0 : result("-", 0, of.value)};
        }
        if (c == '(') {
            ++at_;
            const Number made = binary(1);
            skip();
            if (at_ < text_.size() && text_[at_] == ')')
                ++at_;
            else if (error_.empty())
                error_ = "a ')' is missing in it";
            return made;
        }
        std::size_t end = at_;
        while (end < text_.size() && is_word(text_[end])) ++end;
        const std::string_view word = text_.substr(at_, end - at_);
        at_ = end;
        if (word.empty()) {
            if (error_.empty()) error_ = fmt::format("it cannot be read at '{}'", text_.substr(at_, 20));
            return {};
        }
        if (word[0] >= '0' && word[0] <= '9') {
            const bool is_hex = word.starts_with("0x") || word.starts_with("0X");
            Number made;
            std::from_chars(word.data() + (is_hex ? 2 : 0), word.data() + word.size(), made.value, is_hex ? 16 : 10);
            return made;
        }
        if (word == "defined") return is_defined();
        const auto macro = macros_.find(word);
        if (macro == macros_.end()) {
            skip();
            if (at_ < text_.size() && text_[at_] == '(' && error_.empty())
                error_ = fmt::format("it asks the macro '{}', which only the engine has", word);
            return {.value = 0, .unknown = word.starts_with("SHADERGRAPH_PREVIEW") ? "" : std::string(word)};
        }
        if (macro->second.empty()) return {};
        if (depth_ >= kDeepest) {
            error_ = fmt::format("its macro '{}' has no end", word);
            return {};
        }
        std::string wrong;
        const Number made = Reader(macro->second, macros_, depth_ + 1).all(wrong);
        if (error_.empty()) error_ = wrong;
        return made;
    }

    Number is_defined() {
        skip();
        const bool has_bracket = at_ < text_.size() && text_[at_] == '(';
        if (has_bracket) ++at_;
        skip();
        std::size_t end = at_;
        while (end < text_.size() && is_word(text_[end])) ++end;
        const bool made = macros_.contains(text_.substr(at_, end - at_));
        at_ = end;
        skip();
        if (has_bracket && at_ < text_.size() && text_[at_] == ')') ++at_;
        return {.value = made ? 1 : 0};
    }

    std::string_view text_;
    const Macros& macros_;
    const int depth_;
    std::size_t at_ = 0;
    std::string error_{};
};

}  // namespace

Decision decided(std::string_view condition, const Macros& macros) {
    if (condition.size() > kLongest) return {.error = "it is too long"};
    Decision made;
    made.holds = Reader(condition, macros, 0).all(made.error).value != 0;
    return made;
}

}  // namespace patina::importers::shadergraph

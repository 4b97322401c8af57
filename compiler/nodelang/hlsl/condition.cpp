#include "compiler/nodelang/hlsl/condition.h"

namespace patina::nodelang {
namespace {

constexpr int kDeepest = 200;

struct Number {
    std::int64_t value = 0;
    Token name{};  // a word whose value nobody here knows
};

class Reader {
public:
    Reader(std::span<const Token> tokens, const std::set<std::string_view>& zeros) : tokens_(tokens), zeros_(zeros) {}

    Decision run() {
        const Number made = binary(Precedence::LogicalOr);
        if (made_.error.empty() && next_ < tokens_.size()) fail("an operator or the end of the condition");
        made_.holds = made_.error.empty() && made.value != 0;
        return made_;
    }

private:
    Token now() const { return next_ < tokens_.size() ? tokens_[next_] : Token{}; }
    void fail(std::string_view expected) {
        if (made_.error.empty()) made_ = {.error = expected, .at = now()};
    }
    bool is_known(const Number& number) {
        if (number.name.kind == Token::Kind::End) return true;
        if (made_.error.empty())
            made_ = {.error = "a macro whose value is known here, or 'defined(...)'", .at = number.name};
        return false;
    }

    Number binary(Precedence lowest) {
        Number left = unary();
        while (made_.error.empty()) {
            const Token op = now();
            const Precedence own = precedence(op);
            if (own == Precedence::Any || own < lowest) return left;
            ++next_;
            const Number right = binary(above(own));
            if (own > Precedence::LogicalAnd && (!is_known(left) || !is_known(right))) return {};
            left = {.value = result(op.text, left.value, right.value)};
        }
        return left;
    }

    std::int64_t result(std::string_view op, std::int64_t a, std::int64_t b) {
        // As unsigned numbers, which wrap around.
        const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
        if (op == "||") return a != 0 || b != 0;
        if (op == "&&") return a != 0 && b != 0;
        if (op == "|") return static_cast<std::int64_t>(x | y);
        if (op == "^") return static_cast<std::int64_t>(x ^ y);
        if (op == "&") return static_cast<std::int64_t>(x & y);
        if (op == "==") return a == b;
        if (op == "!=") return a != b;
        if (op == "<") return a < b;
        if (op == ">") return a > b;
        if (op == "<=") return a <= b;
        if (op == ">=") return a >= b;
        if (op == "<<") return static_cast<std::int64_t>(x << (y & 63));
        if (op == ">>") return a >> (y & 63);
        if (op == "+") return static_cast<std::int64_t>(x + y);
        if (op == "-") return static_cast<std::int64_t>(x - y);
        if (op == "*") return static_cast<std::int64_t>(x * y);
        if (b == 0 || b == -1) {  // the only quotient that does not fit is that by -1
            if (b == 0) fail("a divisor that is not 0");
            return b == 0 || op == "%" ? 0 : static_cast<std::int64_t>(0 - x);
        }
        return op == "/" ? a / b : a % b;
    }

    Number unary() {
        if (++depth_ > kDeepest) fail("a condition with fewer levels");
        const Number made = made_.error.empty() ? operand() : Number{};
        --depth_;
        return made;
    }

    Number operand() {
        const Token token = now();
        if (token.is("!") || token.is("-") || token.is("~") || token.is("+")) {
            ++next_;
            const Number of = unary();
            if (token.is("!")) return {.value = of.value == 0};
            if (!is_known(of)) return {};
            const auto x = static_cast<std::uint64_t>(of.value);
            return {.value = token.is("+") ? of.value : static_cast<std::int64_t>(token.is("-") ? 0 - x : ~x)};
        }
        if (token.is("(")) {
            ++next_;
            const Number made = binary(Precedence::LogicalOr);
            if (!now().is(")")) fail("')'");
            ++next_;
            return made;
        }
        if (token.kind == Token::Kind::Number) {
            ++next_;
            return {.value = static_cast<std::int64_t>(token.number)};
        }
        if (token.kind != Token::Kind::Word) {
            fail("a value");
            return {};
        }
        ++next_;
        if (now().is("(")) {
            --next_;
            fail("a macro that is defined here");
            return {};
        }
        const bool is_zero = zeros_.contains(token.text) || token.is_word("false");
        return {.value = token.is_word("true") ? 1 : 0, .name = is_zero || token.is_word("true") ? Token{} : token};
    }

    std::span<const Token> tokens_;
    const std::set<std::string_view>& zeros_;
    std::size_t next_ = 0;
    int depth_ = 0;
    Decision made_{};
};

}  // namespace

Decision decide(std::span<const Token> condition, const std::set<std::string_view>& zeros) {
    return Reader(condition, zeros).run();
}

}  // namespace patina::nodelang

#include "compiler/importers/patterns.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers::terms {
namespace {

using nodelang::arg;
using nodelang::Expr;

constexpr std::string_view kPlace = "_place", kSelf = "_self";

struct Filled {
    Tree tree{};                    // null: `numbers` say it
    std::vector<double> numbers{};  // of a constant
    Tree literal{};                 // the same as the pattern has it: "1.0" is a float, and "1" an int
    std::size_t width = 0;          // components; 0: not known
    const Term* term = nullptr;     // if it is one and nothing more

    bool is_all(double value) const {
        return !numbers.empty() && std::ranges::all_of(numbers, [&](double each) { return each == value; });
    }
    Tree expression() const { return tree ? tree : literal ? literal : constant(numbers).expression(); }
};

Filled of_numbers(std::vector<double> numbers) {
    for (double& each : numbers) each = each == 0 ? 0 : each;  // no -0
    const std::size_t count = numbers.size();
    return {.numbers = std::move(numbers), .width = count};
}

Filled of_term(const Term& term) {
    Filled made;
    if (term.is_constant() && is_vector(term.type))
        made = of_numbers(term.numbers);
    else
        made = {.tree = term.expression(), .width = is_vector(term.type) ? width(term.type) : 0};
    made.term = &term;
    return made;
}

bool is_swizzle(std::string_view name) {
    return name.size() <= 4 && name.find_first_not_of("xyzwrgba") == name.npos;
}

bool is_arithmetic(std::string_view op) {
    return op == "+" || op == "-" || op == "*" || op == "/";
}

double result_of(std::string_view op, double left, double right) {
    if (op == "+") return left + right;
    if (op == "-") return left - right;
    return op == "*" ? left * right : left / right;
}

bool holds(std::string_view op, double left, double right) {
    if (op == "<") return left < right;
    if (op == ">") return left > right;
    if (op == "<=") return left <= right;
    if (op == ">=") return left >= right;
    return op == "==" ? left == right : left != right;
}

// a + (b - c) is written a + b - c.
Tree joined(std::string_view op, const Tree& left, const Tree& right) {
    const bool is_sum = right->kind == Expr::Kind::Binary && (right->text == "+" || right->text == "-");
    const bool is_same = right->kind == Expr::Kind::Binary && right->text == op && (op == "&&" || op == "||");
    if ((op == "+" && is_sum) || is_same)
        return nodelang::binary(right->text, joined(op, left, arg(right, 0)), arg(right, 1));
    return nodelang::binary(op, left, right);
}

class Filler {
public:
    explicit Filler(const TermOf& term_of) : term_of_(term_of) {}

    Filled fill(const Tree& pattern) {
        if (const Term* const term = term_of_(*pattern)) {
            nodes.insert(term->nodes.begin(), term->nodes.end());
            return of_term(*term);
        }
        double value = 0;
        if (nodelang::is_number(*pattern, value)) {
            Filled made = of_numbers({value});
            made.literal = pattern;
            return made;
        }
        if (pattern->kind == Expr::Kind::Member) return member(pattern);
        if (pattern->kind == Expr::Kind::Ternary) return choice(pattern);
        if (pattern->args.empty()) return {.tree = pattern};
        std::vector<Filled> args;
        for (std::size_t i = 0; i < pattern->args.size(); ++i) args.push_back(fill(arg(pattern, i)));
        if (pattern->kind == Expr::Kind::Binary) return binary(pattern->text, args[0], args[1]);
        if (pattern->kind == Expr::Kind::Unary && pattern->text == "-") return negative(args[0]);
        std::vector<Tree> trees;
        for (const Filled& each : args) trees.push_back(each.expression());
        Filled made{.tree = nodelang::with_args(pattern, std::move(trees))};
        for (const std::size_t count : {std::size_t{2}, std::size_t{3}, std::size_t{4}})
            if (pattern->kind == Expr::Kind::Call && pattern->text == word(vector_type(count))) made.width = count;
        return made;
    }

    std::set<std::size_t> nodes{};  // of the terms

private:
    Filled member(const Tree& pattern) {
        const Tree object = arg(pattern, 0);
        const Term* const term = term_of_(*object);
        // The parts of what was computed before may be outputs of a node.
        if (term && !is_self(*object) && is_swizzle(pattern->text) && is_vector(term->type)) {
            nodes.insert(term->nodes.begin(), term->nodes.end());
            return of_term(swizzles_.emplace_back(swizzled(*term, pattern->text)));
        }
        return {.tree = nodelang::with_args(pattern, {fill(object).expression()}),
                .width = is_swizzle(pattern->text) ? pattern->text.size() : 0};
    }

    Filled choice(const Tree& pattern) {
        const Tree condition = arg(pattern, 0);
        if (condition->kind == Expr::Kind::Binary && binary_precedence(condition->text) >= Precedence::Equality &&
            binary_precedence(condition->text) <= Precedence::Relational) {
            const Filled left = fill(arg(condition, 0)), right = fill(arg(condition, 1));
            if (left.numbers.size() == 1 && right.numbers.size() == 1)
                return fill(arg(pattern, holds(condition->text, left.numbers[0], right.numbers[0]) ? 1 : 2));
        }
        const Filled decides = fill(condition), if_true = fill(arg(pattern, 1)), if_false = fill(arg(pattern, 2));
        return {.tree = nodelang::choice(decides.expression(), if_true.expression(), if_false.expression()),
                .width = std::max(if_true.width, if_false.width)};
    }

    // -(a * b) is written -a * b.
    static Tree negative(const Tree& tree) {
        const bool is_product = tree->kind == Expr::Kind::Binary && (tree->text == "*" || tree->text == "/");
        if (is_product) return nodelang::binary(tree->text, negative(arg(tree, 0)), arg(tree, 1));
        double value = 0;
        return nodelang::is_number(*tree, value) ? nodelang::number(-value) : nodelang::unary("-", tree);
    }

    static Filled negative(const Filled& operand) {
        if (operand.tree) return {.tree = negative(operand.tree), .width = operand.width};
        std::vector<double> numbers = operand.numbers;
        for (double& each : numbers) each = -each;
        return of_numbers(std::move(numbers));
    }

    // `part` adds 0 or multiplies by 1, and the other operand has the components of the result.
    static bool is_neutral(const Filled& part, double value, const Filled& other) {
        return part.is_all(value) && (part.width == 1 || part.width <= other.width);
    }

    static Filled binary(std::string_view op, const Filled& left, const Filled& right) {
        const std::size_t width = left.width == 0 || right.width == 0
                                      ? std::max(left.width > 1 ? left.width : 0, right.width > 1 ? right.width : 0)
                                      : std::max(left.width, right.width);
        if (!is_arithmetic(op)) return {.tree = joined(op, left.expression(), right.expression()), .width = 0};
        const std::size_t count = std::max(left.numbers.size(), right.numbers.size());
        if (!left.tree && !right.tree && !(op == "/" && std::ranges::count(right.numbers, 0.0) > 0)) {
            std::vector<double> numbers;
            for (std::size_t i = 0; i < count; ++i)
                numbers.push_back(result_of(op, left.numbers[std::min(i, left.numbers.size() - 1)],
                                            right.numbers[std::min(i, right.numbers.size() - 1)]));
            return of_numbers(std::move(numbers));
        }
        const bool is_sum = op == "+" || op == "-";
        if (is_neutral(right, is_sum ? 0 : 1, left)) return left;
        if ((op == "+" || op == "*") && is_neutral(left, is_sum ? 0 : 1, right)) return right;
        const bool is_negative = right.numbers.size() == 1 && right.numbers[0] < 0;
        if (is_sum && is_negative)
            return {.tree = joined(op == "+" ? "-" : "+", left.expression(), nodelang::number(-right.numbers[0])),
                    .width = width};
        const bool is_operation = right.tree && nodelang::precedence_of(*right.tree) < Precedence::Postfix;
        if (op == "*" && left.numbers.size() == 1 && left.numbers[0] == -1 && !is_operation) {
            Filled made = negative(right);
            made.width = width;
            return made;
        }
        return {.tree = joined(op, left.expression(), right.expression()), .width = width};
    }

    const TermOf& term_of_;
    std::deque<Term> swizzles_{};
};

}  // namespace

Term filled(const Tree& pattern, const TermOf& term_of, Type type) {
    Filler filler(term_of);
    const Filled made = filler.fill(pattern);
    Term term = made.term ? *made.term : made.tree ? of_tree(made.tree, type) : constant(made.numbers);
    // A number that stands for a vector is converted by its reader.
    if (!made.term && !term.is_constant() && is_vector(type) && made.width == 1) term.type = Type::Float;
    term.nodes.insert(filler.nodes.begin(), filler.nodes.end());
    return term;
}

Term computed(std::string_view pattern, const std::vector<Term>& terms, Type type) {
    const auto term_of = [&](const Expr& part) -> const Term* {
        const bool is_letter = part.kind == Expr::Kind::Name && part.text.size() == 1;
        const std::size_t at = is_letter ? static_cast<std::size_t>(part.text[0] - 'a') : terms.size();
        return at < terms.size() ? &terms[at] : nullptr;
    };
    return filled(nodelang::parsed_tree(pattern), term_of, type);
}

Term product(const std::vector<Term>& factors) {
    Term made = number_term(1);
    for (const Term& each : factors) {
        const bool is_product = each.tree && each.tree->kind == Expr::Kind::Binary && each.tree->text == "*";
        if (is_product && !made.is_all(1))
            made = product({made, each.with(arg(each.tree, 0), each.type), each.with(arg(each.tree, 1), each.type)});
        else
            made = computed("a * b", {made, each}, vector_type(std::max(width(made.type), width(each.type))));
    }
    return made;
}

Pattern pattern_of(std::string_view text) {
    Pattern made;
    std::string code;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '{') {
            const std::size_t end = std::min(text.find('}', at), text.size());
            code += fmt::format("{}{}", kPlace, made.places.size());
            made.places.emplace_back(text.substr(at + 1, end - at - 1));
            at = end;
        } else if (text[at] == '$' && !(at + 1 < text.size() && is_word_letter(text[at + 1]))) {
            code += kSelf;
        } else {
            code += text[at];
        }
    }
    made.tree = nodelang::parsed_tree(code);
    if (!made.tree) made.tree = nodelang::name(code);  // which the compiler refuses
    return made;
}

std::optional<std::size_t> place_of(const Expr& part) {
    if (part.kind != Expr::Kind::Name || !part.text.starts_with(kPlace)) return {};
    return static_cast<std::size_t>(read_number(part.text.substr(kPlace.size())).value_or(0));
}

bool is_self(const Expr& part) {
    return part.kind == Expr::Kind::Name && part.text == kSelf;
}

}  // namespace patina::importers::terms

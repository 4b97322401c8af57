// Prints conditions on keywords as conditions of the preprocessor.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/languages/body.h"

namespace patina::languages {

using namespace ir;

namespace {

// A condition of the preprocessor. `joined_by`: the "&&" or "||" between its parts, which then need parentheses inside
// another condition.
struct Test {
    std::string text;
    std::string_view joined_by = {};
};

Test negated(const Test& test) {
    if (!test.joined_by.empty()) return {fmt::format("!({})", test.text)};
    return {test.text.starts_with('!') ? test.text.substr(1) : "!" + test.text};
}

Test joined(const Test& left, std::string_view by, const Test& right) {
    const auto part = [&](const Test& test) {
        return test.joined_by.empty() || test.joined_by == by ? test.text : fmt::format("({})", test.text);
    };
    return {fmt::format("{} {} {}", part(left), by, part(right)), by};
}

// Tests whether a keyword has one of the values for which `wanted` is true. If none of an enum's keywords is defined,
// it has the first value, as in a new material.
Test has_value(const Language& language, const Keyword& keyword, const std::vector<bool>& wanted) {
    const bool is_listed = !wanted[0];  // otherwise the test lists the values that it must not have
    std::optional<Test> made;
    for (std::size_t i = 1; i < wanted.size(); ++i) {
        if (wanted[i] != is_listed) continue;
        Test next{keyword.values.empty() ? language.keyword_test(keyword, {}) : language.keyword_test(keyword, i)};
        if (!is_listed) next = negated(next);
        made = made ? joined(*made, is_listed ? "||" : "&&", next) : next;
    }
    return made.value_or(Test{is_listed ? "0" : "1"});
}

// Translates a condition that reads only keywords.
class Condition {
public:
    explicit Condition(const Body& body) : body_(body), module_(body.module()) {}

    std::optional<Test> test(Value condition) const {
        std::optional<std::uint32_t> only;
        if (!find_keyword(condition, only)) return {};
        if (only) return test_of_one(condition, *only);
        const Inst& inst = body_[condition];
        const auto of = [&](std::uint32_t i) { return test(body_.arg(condition, i)); };
        if (inst.op == Op::Not) {
            const std::optional<Test> inner = of(0);
            return inner ? std::optional(negated(*inner)) : inner;
        }
        if (inst.op != Op::And && inst.op != Op::Or) return {};
        const std::optional<Test> left = of(0), right = of(1);
        if (!left || !right) return {};
        return joined(*left, inst.op == Op::And ? "&&" : "||", *right);
    }

private:
    static constexpr std::uint32_t kSeveral = 0xffffffffu;

    // Finds the one keyword that the condition reads; none if there are several. False if it reads something else.
    bool find_keyword(Value v, std::optional<std::uint32_t>& only) const {
        std::optional<std::uint32_t> found;
        if (!search(v, found) || !found) return false;
        if (*found != kSeveral) only = found;
        return true;
    }
    bool search(Value v, std::optional<std::uint32_t>& found) const {
        const Inst& inst = body_[v];
        if (inst.op == Op::Constant) return true;
        if (inst.op == Op::Global) {
            if (!module_.globals[inst.data].is_keyword()) return false;
            const std::uint32_t keyword = module_.globals[inst.data].keyword;
            found = found.value_or(keyword) == keyword ? keyword : kSeveral;
            return true;
        }
        if (inst.op != Op::Not && inst.op != Op::And && inst.op != Op::Or && inst.op != Op::Equal &&
            inst.op != Op::NotEqual)
            return false;
        for (std::uint32_t i = 0; i < inst.operand_count; ++i) {
            if (!search(body_.arg(v, i), found)) return false;
        }
        return true;
    }

    // The condition's value if its only keyword has this value.
    double value_where(Value v, double keyword) const {
        const Inst& inst = body_[v];
        if (inst.op == Op::Constant) return module_.numbers_of(module_.constants[inst.data])[0];
        if (inst.op == Op::Global) return keyword;
        const double left = value_where(body_.arg(v, 0), keyword);
        if (inst.op == Op::Not) return left == 0;
        const double right = value_where(body_.arg(v, 1), keyword);
        if (inst.op == Op::And) return left != 0 && right != 0;
        if (inst.op == Op::Or) return left != 0 || right != 0;
        return (left == right) == (inst.op == Op::Equal);
    }

    Test test_of_one(Value condition, std::uint32_t index) const {
        const Keyword& keyword = module_.keywords[index];
        std::vector<bool> wanted;
        for (std::size_t i = 0; i < std::max<std::size_t>(keyword.values.size(), keyword.values.empty() ? 2 : 1); ++i)
            wanted.push_back(value_where(condition, static_cast<double>(i)) != 0);
        return has_value(body_.writer().language, keyword, wanted);
    }

    const Body& body_;
    const Module& module_;
};

}  // namespace

// The condition in the words of the preprocessor; empty if it cannot be expressed.
std::string Body::keyword_test(Value condition) const {
    const std::optional<Test> test = Condition(*this).test(condition);
    return test ? test->text : std::string();
}

}  // namespace patina::languages

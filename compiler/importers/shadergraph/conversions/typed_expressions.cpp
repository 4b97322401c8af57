#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "compiler/importers/shadergraph/conversions/typed_reader.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::pair<std::string_view, int> kOperators[] = {
    {"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
    {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};

// Of "3", "0x1f", "3u", "1e-3"; Unknown: it is something else.
Type type_of_number(std::string_view text) {
    if (text.starts_with("0x") || text.starts_with("0X"))
        return text.find_first_of("uU") == text.npos ? Type{.kind = Kind::Int, .is_loose = true}
                                                     : Type{.kind = Kind::Uint};
    if (text.ends_with("u") || text.ends_with("U")) return {.kind = Kind::Uint};
    if (text.find_first_not_of("0123456789") == text.npos) return {.kind = Kind::Int, .is_loose = true};
    if (text.find_first_not_of("0123456789.eE+-") == text.npos && std::ranges::count(text, '.') < 2)
        return {.kind = Kind::Float};
    return {};
}

bool is_swizzle(std::string_view member) {
    return member.size() <= 4 &&
           (member.find_first_not_of("xyzw") == member.npos || member.find_first_not_of("rgba") == member.npos);
}

}  // namespace

// --- expressions

TypedReader::Value TypedReader::expression() {
    if (++depth_ > kDeepest) give_up();
    Value made = is_lost_ ? Value{} : binary(1);
    if (!is_lost_ && is("?")) made = choice(made);
    --depth_;
    return made;
}

TypedReader::Value TypedReader::choice(Value condition) {
    const std::size_t question = next_++;
    Value yes = expression();
    const std::size_t colon = next_;
    need(":");
    Value no = expression();
    Value made{.type = {}, .begin = condition.begin, .end = next_, .is_primary = false};
    if (is_lost_) return made;
    const int size = condition.type.size;
    const auto fits = [&](const Value& each) {
        return each.type.is_vector() && (each.type.size == 1 || each.type.size == size) &&
               (each.type.kind == Kind::Float || each.type.is_loose);
    };
    if (condition.type.is_vector() && condition.type.kind == Kind::Bool && size > 1) {
        if (!fits(yes) || !fits(no)) return made;
        // One function for all components; all of its operands are read anyway.
        texts_[condition.begin].before = fmt::format("choose{}(", size) + texts_[condition.begin].before;
        texts_[question].text = ",";
        texts_[colon].text = ",";
        texts_[made.end - 1].after += ")";
        made.is_primary = true;
        made.type = {.kind = Kind::Float, .size = size};
        if (yes.type.is_loose && no.type.is_loose) made.type = {.kind = Kind::Int, .size = size, .is_loose = true};
        return made;
    }
    to_bool(condition);
    if (yes.type.kind == Kind::Bool && no.type.kind == Kind::Bool && yes.type.size == no.type.size)
        made.type = yes.type;
    else
        arithmetic({&yes, &no}, made.type, false);
    return made;
}

TypedReader::Value TypedReader::binary(int strength) {
    Value left = unary();
    while (!is_lost_) {
        const auto op = std::ranges::find(kOperators, at().text, &std::pair<std::string_view, int>::first);
        if (op == std::end(kOperators) || op->second < strength) break;
        ++next_;
        Value right = binary(op->second + 1);
        if (is_lost_) break;
        const Type type = of_operator(op->first, left, right);
        left = {.type = type, .begin = left.begin, .end = right.end, .is_primary = false};
    }
    return left;
}

TypedReader::Value TypedReader::unary() {
    if (++depth_ > kDeepest) give_up();
    const std::size_t begin = next_;
    Value made;
    if (is_lost_) {
    } else if (is("-") || is("+") || is("!") || is("~")) {
        const std::string_view op = at().text;
        ++next_;
        made = unary();
        if (op == "!") to_bool(made);
        if (op == "-" && made.type.kind == Kind::Bool) convert(made, {.kind = Kind::Int, .size = made.type.size});
        made.begin = begin;
        made.is_primary = made.is_bracketed = false;
    } else if (const Type to = is("(") ? type_of(at(1).text) : Type{}; to.is_known() && at(2).text == ")") {
        next_ += 3;
        made = cast(begin, to);
    } else {
        made = postfix();
    }
    --depth_;
    return made;
}

// "(float3)x": the brackets of the type go, and the word is written only if it changes something.
TypedReader::Value TypedReader::cast(std::size_t begin, const Type& to) {
    Value made = unary();
    if (is_lost_) return made;
    const bool is_splat = to.columns == 0 && made.type.columns == 0 && to.size > 1 && made.type.size == 1;
    const bool is_unknown = made.type.kind == Kind::Unknown && to.columns == 0;
    if (is_splat || is_unknown || (made.type.is_loose && to.columns == 0)) {
        if (made.type.size > to.size) convert(made, {.kind = made.type.kind, .size = to.size, .is_loose = true});
        wrap(made, word_for(to.kind, to.size));
        made.type = to;
    } else {
        convert(made, to);
    }
    const Type& is = made.type;
    if (is.kind != to.kind || is.size != to.size || is.columns != to.columns) give_up();
    for (std::size_t i = begin; i < begin + 3; ++i) texts_[i].text.clear();
    // What was written before the value stays there.
    made.begin = begin;
    made.is_bracketed = false;
    return made;
}

std::vector<TypedReader::Value> TypedReader::arguments() {
    std::vector<Value> made;
    need("(");
    while (!is_lost_ && !is(")")) {
        made.push_back(expression());
        if (!take(",")) break;
    }
    need(")");
    return made;
}

TypedReader::Value TypedReader::call(std::string_view function, std::size_t begin) {
    std::vector<Value> values = arguments();
    Value made{.type = {}, .begin = begin, .end = next_};
    if (is_lost_) return made;
    if (const Type type = type_of(function); type.is_known()) {
        if (values.size() == 1 && type.columns == 0 && values[0].type.is_vector() && values[0].type.size > type.size)
            convert(values[0], {.kind = values[0].type.kind, .size = type.size, .is_loose = values[0].type.is_loose});
        if (values.size() == 1 && type.columns > 0) convert(values[0], type);
        made.type = type;
        return made;
    }
    if (const HlslFunction* own = own_function(function)) {
        const std::vector<Parameter> parameters = parameters_in(own->parameters);
        for (std::size_t i = 0; i < std::min(parameters.size(), values.size()); ++i)
            if (!parameters[i].is_out) convert(values[i], parameters[i].type);
        made.type = type_of(own->result);
        return made;
    }
    made.type = of_rule(rule_of(function), values);
    if (function == "rcp" && values.size() == 1) {
        texts_[begin].text = "(1.0 / ";
        texts_[made.end - 1].after += ")";
    } else if (function == "log10" && values.size() == 1) {
        texts_[begin].text = "(0.30102999566398120 * log2";
        texts_[made.end - 1].after += ")";
    } else if (function == "mad" && values.size() == 3) {
        texts_[begin].text = "(";
        texts_[made.end - 1].after += ")";
        texts_[values[1].begin - 1].text = ") * (";
        texts_[values[2].begin - 1].text = ") + (";
    }
    return made;
}

TypedReader::Value TypedReader::postfix() {
    Value made{.type = {}, .begin = next_, .end = next_};
    if (is("(")) {
        ++next_;
        const Value inner = expression();
        need(")");
        made.type = inner.type;
        made.is_bracketed = true;
    } else if (is_word() && at(1).text == "(") {
        const std::string_view function = at().text;
        ++next_;
        made = call(function, made.begin);
    } else if (is_word()) {
        const std::string_view name = at().text;
        if (const auto found = scope_.find(name); found != scope_.end()) {
            made.type = found->second.type;
            if (!found->second.read_as.empty()) texts_[next_].text = fmt::format("{}({})", found->second.read_as, name);
        } else if (name == "true" || name == "false") {
            made.type = {.kind = Kind::Bool};
        } else if (name == "PI") {
            made.type = {.kind = Kind::Float};
        } else if (name == "objectToWorld" || name == "worldToObject" || name == "worldToView") {
            made.type = {.kind = Kind::Float, .size = 4, .columns = 4};
        }
        ++next_;
    } else if (!at().text.empty() && (is_digit(at().text[0]) || (at().text[0] == '.' && at().text.size() > 1))) {
        made.type = type_of_number(at().text);
        ++next_;
    } else {
        give_up();
    }
    while (!is_lost_) {
        if (take(".")) {
            const std::string_view member = at().text;
            if (!is_word()) return give_up(), made;
            ++next_;
            if (is("(")) {
                arguments();
                const bool is_texel =
                    made.type.kind == Kind::Texture && (member.starts_with("Sample") || member == "Load");
                made.type = is_texel ? Type{.kind = Kind::Float, .size = 4} : Type{};
            } else if (made.type.is_vector() && is_swizzle(member)) {
                made.type.size = static_cast<int>(member.size());
            } else {
                made.type = {};
            }
        } else if (take("[")) {
            expression();
            need("]");
            if (made.type.is_array)
                made.type.is_array = false;
            else if (made.type.columns > 0)
                made.type = {.kind = made.type.kind, .size = made.type.columns};
            else if (made.type.is_vector())
                made.type.size = 1;
        } else {
            break;
        }
        made.is_bracketed = false;
    }
    made.end = next_;
    if (is("++") || is("--") || is("(") || is("::")) give_up();
    return made;
}

}  // namespace patina::importers::shadergraph

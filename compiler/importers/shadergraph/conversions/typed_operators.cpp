// Which conversions operators and functions of HLSL make.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/shadergraph/conversions/typed_reader.h"

namespace patina::importers::shadergraph {

// --- what is written

void TypedReader::wrap(Value& value, const std::string& function) {
    const bool has_brackets =
        value.is_bracketed && texts_[value.begin].before.empty() && texts_[value.end - 1].after.empty();
    texts_[value.begin].before = function + (has_brackets ? "" : "(") + texts_[value.begin].before;
    if (!has_brackets) texts_[value.end - 1].after += ")";
    value.is_primary = true;
    value.is_bracketed = false;
}

void TypedReader::convert(Value& value, const Type& to) {
    Type& from = value.type;
    if (!from.is_known() || !to.is_known()) return;
    if (from.columns > 0 || to.columns > 0) {
        const bool is_cut = from.columns > 0 && to.columns > 0 && from.size >= to.size && from.columns >= to.columns &&
                            (from.size > to.size || from.columns > to.columns);
        if (!is_cut || value.end != value.begin + 1) return;
        const std::string name(texts_[value.begin].text);
        std::string rows;
        for (int i = 0; i < to.size; ++i)
            rows += fmt::format("{}{}[{}]{}", i > 0 ? ", " : "", name, i,
                                to.columns < from.columns
                                    ? "." + std::string("xyzw").substr(0, static_cast<std::size_t>(to.columns))
                                    : "");
        texts_[value.begin].text = fmt::format("float{}x{}({})", to.size, to.columns, rows);
        from = {.kind = Kind::Float, .size = to.size, .columns = to.columns};
        return;
    }
    if (to.size < from.size) {
        if (!value.is_primary) wrap(value, "");
        texts_[value.end - 1].after += "." + std::string("xyzw").substr(0, static_cast<std::size_t>(to.size));
        from.size = to.size;
        value.is_bracketed = false;
    }
    // "2" or "-2", which is an integer where one is needed
    const bool is_number =
        value.end <= value.begin + 2 && is_digit(tokens_[value.end - 1].text[0]) &&
        (value.end == value.begin + 1 || (tokens_[value.begin].text == "-" && texts_[value.begin].before.empty()));
    const bool is_whole = to.kind == Kind::Int || to.kind == Kind::Uint;
    if (from.is_loose && (to.kind == Kind::Float || (is_whole && is_number))) {
        if (!to.is_loose) from.kind = to.kind, from.is_loose = false;
        return;
    }
    if (from.kind == to.kind && !from.is_loose) return;
    if (from.kind == to.kind && to.is_loose) return;
    wrap(value, word_for(to.kind, from.size));
    from = {.kind = to.kind, .size = from.size};
}

void TypedReader::to_bool(Value& value) {
    if (value.type.is_vector() && value.type.kind != Kind::Bool)
        convert(value, {.kind = Kind::Bool, .size = value.type.size});
}

// --- types

// All get the same kind and, but for numbers alone, the same size.
void TypedReader::arithmetic(std::vector<Value*> values, Type& result, bool is_float) {
    result = {};
    Kind kind = is_float ? Kind::Float : Kind::Int;
    int size = 1;
    bool is_loose = !is_float;
    for (const Value* each : values) {
        if (!each->type.is_vector()) return;
        kind = std::max(kind, each->type.kind);
        is_loose &= each->type.is_loose;
        if (each->type.size > 1) size = size == 1 ? each->type.size : std::min(size, each->type.size);
    }
    for (Value* each : values)
        convert(*each, {.kind = kind, .size = each->type.size == 1 ? 1 : size, .is_loose = is_loose});
    result = {.kind = kind, .size = size, .is_loose = is_loose};
}

Type TypedReader::of_operator(std::string_view op, Value& a, Value& b) {
    const bool is_test = op == "==" || op == "!=" || op.starts_with("<") || op.starts_with(">");
    Type made;
    if (op == "&&" || op == "||") {
        to_bool(a);
        to_bool(b);
        if (a.type.is_vector() && b.type.is_vector())
            made = {.kind = Kind::Bool, .size = std::max(a.type.size, b.type.size)};
    } else if (op == "<<" || op == ">>" || op == "&" || op == "|" || op == "^") {
        const Kind kind = a.type.is_loose ? b.type.kind : a.type.kind;
        const bool is_whole = kind == Kind::Int || kind == Kind::Uint;
        // What is shifted keeps its kind.
        if ((op == "<<" || op == ">>") && a.type.is_loose && kind != Kind::Int) return made;
        if (!a.type.is_vector() || !b.type.is_vector() || !is_whole || a.type.size != b.type.size) return made;
        for (Value* each : {&a, &b})
            if (each->type.is_loose) convert(*each, {.kind = kind, .size = each->type.size});
        if (a.type.kind == kind && b.type.kind == kind) made = {.kind = kind, .size = a.type.size};
    } else if (a.type.columns > 0 || b.type.columns > 0) {
        const Type matrix = a.type.columns > 0 ? a.type : b.type;
        Value& other = a.type.columns > 0 ? b : a;
        const bool fits = other.type.columns == 0
                              ? other.type.size == 1
                              : other.type.size == matrix.size && other.type.columns == matrix.columns;
        if (!is_test && fits && other.type.is_known() && matrix.is_known()) {
            if (other.type.columns == 0) convert(other, {.kind = Kind::Float});
            made = matrix;
        }
    } else if ((op == "==" || op == "!=") && a.type.kind == Kind::Bool && b.type.kind == Kind::Bool) {
        made = {.kind = Kind::Bool, .size = std::max(a.type.size, b.type.size)};
    } else {
        // A quotient of integers is cut.
        const bool divides = op == "/" || op == "%";
        if (divides && a.type.is_loose && b.type.is_loose)
            for (Value* each : {&a, &b}) {
                wrap(*each, word_for(Kind::Int, each->type.size));
                each->type.is_loose = false;
            }
        arithmetic({&a, &b}, made, false);
        if (is_test && made.is_known()) made = {.kind = Kind::Bool, .size = made.size};
    }
    return made;
}

Type TypedReader::of_rule(Rule rule, std::vector<Value>& values) {
    std::vector<Value*> all;
    for (Value& each : values) all.push_back(&each);
    Type made;
    if (values.empty()) return made;
    const Type first = values[0].type;
    switch (rule) {
        case Rule::None: break;
        case Rule::Float: arithmetic(all, made, true); break;
        case Rule::Numbers: arithmetic(all, made, false); break;
        case Rule::Scalar:
            // "dot" of integers is an integer.
            if (std::ranges::any_of(values, [](const Value& each) { return each.type.kind == Kind::Float; }))
                arithmetic(all, made, true);
            if (made.is_known()) made.size = 1;
            break;
        case Rule::First:
            for (Value& each : values) convert(each, {.kind = Kind::Float, .size = each.type.size});
            if (first.is_vector()) made = {.kind = Kind::Float, .size = first.size};
            break;
        case Rule::Sign:
            if (first.is_vector() && first.kind == Kind::Float)
                made = {.kind = Kind::Int, .size = first.size, .is_loose = true};
            break;
        case Rule::Test:
            if (first.is_vector() && first.kind == Kind::Float) made = {.kind = Kind::Bool, .size = first.size};
            break;
        case Rule::AnyOrAll:
            to_bool(values[0]);
            made = {.kind = Kind::Bool};
            break;
        case Rule::Product:
            // A vector may be too long, and is cut.
            for (std::size_t i = 0; i < 2 && values.size() == 2; ++i) {
                const Type& matrix = values[1 - i].type;
                const int size = i == 0 ? matrix.size : matrix.columns;
                if (matrix.columns > 0 && values[i].type.is_vector() && values[i].type.size > size)
                    convert(values[i], {.kind = values[i].type.kind, .size = size});
            }
            made = values.size() == 2 ? product(values[0].type, values[1].type) : Type{};
            break;
        case Rule::AsFloat:
        case Rule::AsInt:
        case Rule::AsUint:
            if (first.is_vector() && !first.is_loose)
                made = {.kind = rule == Rule::AsFloat ? Kind::Float
                                : rule == Rule::AsInt ? Kind::Int
                                                      : Kind::Uint,
                        .size = first.size};
            break;
    }
    return made;
}

}  // namespace patina::importers::shadergraph

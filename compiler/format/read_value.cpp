#include <climits>
#include <cmath>

#include "compiler/base/file_names.h"
#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/format/color.h"
#include "compiler/format/read_fields.h"
#include "compiler/format/read_graph.h"
#include "compiler/format/words.h"
#include "compiler/nodelang/parse.h"

namespace patina::format {
namespace {

using nodelang::Expr;
using nodelang::NumberKind;

const Expr* add(Reading& reading, Expr expr) {
    return &reading.ast.exprs.emplace_back(std::move(expr));
}

std::string_view keep(Reading& reading, std::string text) {
    return reading.ast.texts.emplace_back(std::move(text));
}

Expr number_expr(Span span, double value, NumberKind kind) {
    Expr expr;
    expr.kind = Expr::Kind::Number;
    expr.number_kind = kind;
    expr.span = span;
    expr.number = value;
    return expr;
}

const Expr* read_number(Reading& reading, const json::Json& json, std::string_view what) {
    const std::optional<double> value = read_float(reading, json, what);
    if (!value) return nullptr;
    const bool is_written_whole = reading.sources.text(json.span).find_first_of(".eE") == std::string_view::npos;
    const bool is_int = is_written_whole && *value >= INT_MIN && *value <= INT_MAX;
    return add(reading, number_expr(json.span, *value, is_int ? NumberKind::Int : NumberKind::Float));
}

// A list of `width` numbers at a time.
const Expr* rows_expr(Reading& reading, Span span, std::span<const double> numbers, std::size_t width) {
    Expr rows;
    rows.kind = Expr::Kind::List;
    rows.span = span;
    for (std::size_t i = 0; i < numbers.size(); i += width) {
        Expr row;
        row.kind = Expr::Kind::List;
        row.span = span;
        for (const double number : numbers.subspan(i, width))
            row.args.push_back(add(reading, number_expr(span, number, NumberKind::Float)));
        rows.args.push_back(add(reading, std::move(row)));
    }
    return add(reading, std::move(rows));
}

// As a property of a texture has it. A value has a name.
bool is_sampler(const json::Json& json) {
    return json.kind == json::Json::Kind::Object &&
           (json.find("wrap") || json.find("filter") || json.find("anisotropy"));
}

// A matrix; or a gradient or a curve: a struct of the node library with one member, an array of float4.
const Expr* read_array(Reading& reading, const json::Json& json) {
    const std::optional<PropertyType> type = array_type(json);
    if (is_sampler(json)) {
        report_type(reading, json, "a sampler that is a value", "one of the names " + enumerate(kSamplerNames));
        return nullptr;
    }
    if (!type) {
        report_type(reading, json, "a value", "a number, true or false, an array, a string, a gradient or a curve");
        return nullptr;
    }
    const std::optional<std::vector<double>> numbers = read_array_value(reading, json, *type);
    if (!numbers) return nullptr;
    if (json.kind == json::Json::Kind::Array) return rows_expr(reading, json.span, *numbers, json.elements.size());
    Expr object;
    object.kind = Expr::Kind::Object;
    object.span = json.span;
    object.text = *type == PropertyType::Gradient ? "Gradient" : "Curve";
    object.args = {rows_expr(reading, json.span, *numbers, 4)};
    return add(reading, std::move(object));
}

const Expr* read_list(Reading& reading, const json::Json& json) {
    if (has_rows(json) && array_type(json)) return read_array(reading, json);
    if (json.elements.size() < 2 || json.elements.size() > 4) {
        report_type(reading, json, "a vector", "an array of 2 to 4 numbers");
        return nullptr;
    }
    Expr list;
    list.kind = Expr::Kind::List;
    list.span = json.span;
    for (const json::Json& element : json.elements) {
        if (const Expr* number = read_number(reading, element, "a component of a vector")) list.args.push_back(number);
    }
    return list.args.size() == json.elements.size() ? add(reading, std::move(list)) : nullptr;
}

const Expr* read_color(Reading& reading, const json::Json& json) {
    const std::optional<LinearColor> color = parse_color(json.string);
    if (!color) {
        reading.diagnostics.report(Code::BadColor, inside(json.span), json::shown(json.string));
        return nullptr;
    }
    Expr expr;
    expr.kind = Expr::Kind::Color;
    expr.span = json.span;
    expr.name_span = inside(json.span);
    expr.text = keep(reading, json.string);
    for (std::size_t i = 0; i < (color->has_alpha ? 4u : 3u); ++i) {
        expr.args.push_back(add(reading, number_expr(json.span, color->value[i], NumberKind::Float)));
    }
    return add(reading, std::move(expr));
}

const Expr* read_file(Reading& reading, const json::Json& json) {
    Expr expr;
    expr.kind = Expr::Kind::File;
    expr.span = json.span;
    expr.name_span = inside(json.span);
    expr.text = keep(reading, json.string);
    return add(reading, std::move(expr));
}

// A decoded string and where its bytes come from, for the parsers of the node language.
class SourceText {
public:
    SourceText(Reading& reading, const json::Json& json, std::size_t skip)
        : text_(keep(reading, json.string.substr(skip))),
          base_(json.span.begin + 1 + static_cast<std::uint32_t>(skip)),
          offsets_(json::string_offsets(json, reading.sources)) {
        if (!offsets_.empty()) offsets_.erase(offsets_.begin(), offsets_.begin() + static_cast<std::ptrdiff_t>(skip));
    }
    nodelang::Text text() const { return {text_, base_, offsets_.empty() ? nullptr : &offsets_}; }

private:
    std::string_view text_;
    std::uint32_t base_;
    std::vector<std::uint32_t> offsets_;
};

bool may_stand_in_link(char c) {
    return is_word_letter(c) || c == '.';
}

// Reports why a string is not a link. The usual error is to forget the "=" or the "./", so the message says that.
void report_no_link(Reading& reading, const nodelang::Text& text, std::size_t bad) {
    std::size_t end = bad + 1;
    while (end < text.text.size() && (static_cast<unsigned char>(text.text[end]) & 0xC0u) == 0x80u) ++end;
    const Span span{text.at(bad), text.at(end)};
    const std::string_view character = text.text.substr(bad, end - bad);
    const bool is_control = character.size() == 1 && static_cast<unsigned char>(character[0]) < 0x20;
    const bool is_file = character == "/" || character == "\\";
    reading.diagnostics
        .report(Code::BadCharacter, span, is_control ? "a control character" : fmt::format("'{}'", character))
        .note(is_file ? "a file name starts with './', an expression with '='"
                      : "a link is node.port.swizzle; an expression starts with '='");
}

const Expr* read_link(Reading& reading, const json::Json& json) {
    const SourceText source(reading, json, 0);
    const nodelang::Text text = source.text();
    const char first = text.text.front();
    if ((first >= '0' && first <= '9') || first == '-' || first == '+') {
        reading.diagnostics
            .report(Code::Syntax, inside(json.span), "a link", fmt::format("'{}'", json::shown(text.text)))
            .note("write a number without quotes; start an expression with '='");
        return nullptr;
    }
    const std::size_t start = first == '$' || first == '@' ? 1 : 0;
    for (std::size_t i = start; i < text.text.size(); ++i) {
        if (may_stand_in_link(text.text[i])) continue;
        report_no_link(reading, text, i);
        return nullptr;
    }
    return nodelang::parse_link(text, reading.ast, reading.diagnostics);
}

const Expr* read_string_value(Reading& reading, const json::Json& json) {
    const std::string& text = json.string;
    if (text.empty()) {
        reading.diagnostics.report(Code::Syntax, json.span, "a value", "an empty string");
        return nullptr;
    }
    if (text.starts_with('=')) return read_expression(reading, json, 1);
    if (text.starts_with('#')) return read_color(reading, json);
    if (is_file_name(text)) return read_file(reading, json);
    return read_link(reading, json);
}

}  // namespace

const Expr* read_expression(Reading& reading, const json::Json& json, std::size_t skip) {
    const SourceText source(reading, json, skip);
    return nodelang::parse_expression(source.text(), reading.ast, reading.diagnostics);
}

const Expr* read_value(const json::Json& json, const SourceMap& sources, nodelang::Ast& ast, Diagnostics& diagnostics) {
    Reading reading{sources, ast, diagnostics};
    switch (json.kind) {
        case json::Json::Kind::Bool: {
            Expr expr = number_expr(json.span, json.boolean ? 1 : 0, NumberKind::Int);
            expr.kind = Expr::Kind::Bool;
            return add(reading, std::move(expr));
        }
        case json::Json::Kind::Number: return read_number(reading, json, "a value");
        case json::Json::Kind::Array: return read_list(reading, json);
        case json::Json::Kind::String: return read_string_value(reading, json);
        case json::Json::Kind::Object: return read_array(reading, json);
        case json::Json::Kind::Null:
            report_type(reading, json, "a value", "a number, true or false, an array or a string");
            return nullptr;
    }
    return nullptr;
}

}  // namespace patina::format

// Loops of HLSL as those of the node language, which count integers up to a constant.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "compiler/importers/shadergraph/conversions/typed_reader.h"

namespace patina::importers::shadergraph {

// The names between the semicolons of "for (int i = 0; i < count; i++)".
void TypedReader::find_limits() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].text != "for") continue;
        int semicolons = 0;
        for (; i < tokens_.size() && semicolons < 2; ++i) {
            if (tokens_[i].text == ";") ++semicolons;
            if (semicolons == 1) limits_.insert(tokens_[i].text);
        }
    }
}

void TypedReader::for_loop() {
    const Scope outside = scope_;
    need("(");
    const std::string_view type = at().text, name = at(1).text;
    const bool is_counter = type == "int" || type == "uint" || type == "float";
    if (!is_counter || at(2).text != "=") return give_up();
    texts_[next_].text = "int";
    next_ += 3;
    const std::size_t begin = next_;
    Value first = expression();
    const std::string_view start = tokens_[begin].text;
    const bool is_whole = start.substr(0, start.find(".0")).find_first_not_of("0123456789") == start.npos;
    if (type != "int" && (!is_whole || !whole_limit(begin, next_, false))) return give_up();
    convert(first, {.kind = Kind::Int});
    need(";");
    if (at().text != name) return give_up();
    next_ += 1;
    const bool is_included = is("<=");
    if (!is("<") && !is_included) return give_up();
    texts_[next_++].text = "<";
    const std::size_t limit = next_;
    Value last = expression();
    if (is_lost_) return;
    if (!whole_limit(limit, next_, is_included)) {
        if (type != "int" || last.type.kind != Kind::Int || last.type.size > 1) return give_up();
        if (is_included) {
            if (!last.is_primary) wrap(last, "");
            texts_[next_ - 1].after += " + 1";
        }
    }
    need(";");
    scope_[name] = {.type = {.kind = type == "int"    ? Kind::Int
                                     : type == "uint" ? Kind::Uint
                                                      : Kind::Float},
                    .read_as = type == "int" ? "" : type};
    while (!is_lost_ && !at().text.empty() && !is(")")) ++next_;  // the compiler reads the step
    need(")");
    ++blocks_;
    statement(false);
    --blocks_;
    scope_ = outside;
}

// A number becomes the integer that ends a loop in the same round; false: it is no number.
bool TypedReader::whole_limit(std::size_t begin, std::size_t end, bool is_included) {
    if (end != begin + 1) return false;
    double number = 0;
    const std::string_view text = tokens_[begin].text;
    const auto [rest, wrong] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_all = rest == text.data() + text.size() || std::string_view(rest, 1) == "u";
    if (wrong != std::errc() || !is_all || text.starts_with("0x") || number > 1e6) return false;
    texts_[begin].text = fmt::format("{}", static_cast<int>(is_included ? std::floor(number) + 1 : std::ceil(number)));
    return true;
}

}  // namespace patina::importers::shadergraph

#include "compiler/json/json_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "compiler/base/broken_text.h"
#include "compiler/json/json_text.h"

namespace patina {

void JsonWriter::begin(char bracket) {
    separate();
    text_ += bracket;
    brackets_ += bracket;
    is_first_ = true;
}

void JsonWriter::end() {
    const bool is_object = brackets_.back() == '{';
    brackets_.pop_back();
    if (!is_first_ && (is_object || layout_ != Layout::ShortLists)) new_line();
    text_ += is_object ? '}' : ']';
    is_first_ = false;
}

void JsonWriter::write_key(std::string_view key) {
    write_text(key);
    text_ += layout_ == Layout::OneLine ? ":" : ": ";
    is_after_key_ = true;
}

void JsonWriter::raw(std::string_view json) {
    separate();
    text_ += json;
}

void JsonWriter::write_text(std::string_view text) {
    separate();
    json::append_quoted(text_, as_utf8(text));
}

void JsonWriter::write_number(double value) {
    if (std::isfinite(value))
        raw(fmt::format("{}", value));
    else
        write_text(std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity");
}

std::string JsonWriter::take() {
    return std::move(text_);
}

void JsonWriter::separate() {
    if (std::exchange(is_after_key_, false) || brackets_.empty()) return;
    const bool shares_line = brackets_.back() == '[' && layout_ == Layout::ShortLists;
    if (!is_first_) text_ += shares_line ? ", " : ",";
    is_first_ = false;
    if (!shares_line) new_line();
}

void JsonWriter::new_line() {
    if (layout_ == Layout::OneLine) return;
    text_ += '\n';
    text_.append(2 * brackets_.size(), ' ');
}

std::string json_text(std::string_view text) {
    JsonWriter json;
    json.write(text);
    return json.take();
}

}  // namespace patina

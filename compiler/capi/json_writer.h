// Writes JSON on one line, for the documents that C programs get.
//
//   JsonWriter json;
//   json.begin('{');
//   json.text("name", node.name);       // left out if it is empty
//   json.list("tests", node.tests);
//   json.end('}');
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/base/broken_text.h"
#include "compiler/json/json_text.h"
#include "patina/words.h"

namespace patina::capi {

class JsonWriter {
public:
    void begin(char bracket) {
        separate();
        text_ += bracket;
        is_first_ = true;
    }
    void begin(std::string_view key, char bracket) {
        write_key(key);
        text_ += bracket;
        is_first_ = true;
    }
    void end(char bracket) {
        text_ += bracket;
        is_first_ = false;
    }

    // Keys with values.
    void text(std::string_view key, std::string_view value) {
        if (!value.empty()) write_key(key), json::append_quoted(text_, as_utf8(value));
    }
    void word(std::string_view key, HasWords auto value) { text(key, to_string(value)); }
    void flag(std::string_view key, bool value) { write_key(key), text_ += value ? "true" : "false"; }
    void number(std::string_view key, double value) { write_key(key), append(value); }
    template <std::size_t Count>
    void numbers(std::string_view key, const std::array<double, Count>& values) {
        begin(key, '[');
        for (const double value : values) separate(), append(value);
        end(']');
    }
    void list(std::string_view key, const std::vector<std::string>& values) {
        if (values.empty()) return;
        begin(key, '[');
        for (const std::string& value : values) separate(), json::append_quoted(text_, as_utf8(value));
        end(']');
    }

    std::string take() { return std::move(text_); }

private:
    void separate() {
        if (!is_first_) text_ += ", ";
        is_first_ = false;
    }
    void write_key(std::string_view key) {
        separate();
        json::append_quoted(text_, key);
        text_ += ": ";
    }
    // JSON has no other numbers.
    void append(double value) { text_ += std::isfinite(value) ? fmt::format("{}", value) : "0"; }

    std::string text_{};
    bool is_first_ = true;
};

}  // namespace patina::capi

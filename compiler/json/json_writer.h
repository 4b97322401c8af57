// Writes JSON: on one line, for programs, or as pages, for people.
//
//   JsonWriter json;
//   json.begin('{');
//   json.write("name", node.name);
//   json.if_any("tests", node.tests);   // left out if it is empty
//   json.end();
//   return json.take();                 // {"name":"Lerp","tests":["ends"]}
#pragma once

#include <concepts>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace patina {

class JsonWriter {
public:
    enum class Layout {
        OneLine,
        Pages,      // each element and each member on a line of its own
        ShortLists  // pages, but the elements of an array share a line
    };
    explicit JsonWriter(Layout layout = Layout::OneLine) : layout_(layout) {}

    void begin(char bracket);
    void begin(std::string_view key, char bracket) { write_key(key), begin(bracket); }
    void end();

    // Text, a boolean, a number, a word of an enum, or an array of them. Bytes that are no UTF-8 become U+FFFD. JSON
    // has no infinities: they are written as strings, which Python's float() and JavaScript's Number() read.
    template <class T>
    void write(const T& value) {
        if constexpr (std::convertible_to<const T&, std::string_view>) {
            write_text(value);
        } else if constexpr (std::same_as<T, bool>) {
            raw(value ? "true" : "false");
        } else if constexpr (std::integral<T>) {
            raw(std::to_string(value));
        } else if constexpr (std::floating_point<T>) {
            write_number(static_cast<double>(value));
        } else if constexpr (requires { value.begin(); }) {
            begin('[');
            for (const auto& each : value) write(each);
            end();
        } else {
            write_text(to_string(value));
        }
    }
    template <class T>
    void write(std::string_view key, const T& value) {
        write_key(key);
        write(value);
    }
    // Of a text or a list: unless it is empty. Of an optional value: if there is one.
    template <class T>
    void if_any(std::string_view key, const T& value) {
        if constexpr (requires { value.has_value(); }) {
            if (value) write(key, *value);
        } else if (std::begin(value) != std::end(value)) {
            write(key, value);
        }
    }
    // One number alone, several as an array.
    void write_numbers(std::string_view key, const std::vector<double>& values) {
        values.size() == 1 ? write(key, values.front()) : write(key, values);
    }
    // JSON as it is.
    void raw(std::string_view json);
    void write_key(std::string_view key);

    std::string take();

private:
    void write_text(std::string_view text);
    void write_number(double value);
    // What stands before a member or an element.
    void separate();
    void new_line();

    Layout layout_ = Layout::OneLine;
    std::string text_{};
    std::string brackets_{};  // that are open
    bool is_first_ = true;    // in its bracket
    bool is_after_key_ = false;
};

// A text alone, with its quotes.
std::string json_text(std::string_view text);

}  // namespace patina

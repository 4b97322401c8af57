// "NAME=VALUE" and "NAME", as switches and values are written on a command line.
//
//   split_name_value("_Mode=Wet")   // name "_Mode", value "Wet"
//   split_name_value("shadows")     // name "shadows", no value
#pragma once

#include <optional>
#include <string_view>

namespace patina {

// Both are parts of the text that was split.
struct NameValue {
    std::string_view name;
    std::optional<std::string_view> value{};  // may be empty: "NAME="
};

// At the first '='.
constexpr NameValue split_name_value(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos) return {.name = text};
    return {.name = text.substr(0, equals), .value = text.substr(equals + 1)};
}

}  // namespace patina

// Splits "NAME=VALUE" and "NAME", the forms of switches and values on a command line.
#pragma once

#include <optional>
#include <string_view>

namespace patina {

// Two views of the text that was split.
struct NameValue {
    std::string_view name;                    // what is before the first '='
    std::optional<std::string_view> value{};  // may be empty: "NAME="
};

// Splits at the first '='.
constexpr NameValue split_name_value(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos) return {.name = text};
    return {.name = text.substr(0, equals), .value = text.substr(equals + 1)};
}

}  // namespace patina

// Numbers as JSON, with all their digits.
//
//   JsonBuffer buffer;
//   JsonLines writer(buffer);
//   write_numbers(writer, output.values);
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "compiler/json/memory/json_memory.h"

namespace patina::cli {

// JSON has no infinities. They are written as strings, which Python's float() and JavaScript's Number() read.
inline void write_number(JsonLines& writer, double value) {
    if (std::isfinite(value)) {
        const std::string digits = fmt::format("{}", value);
        writer.RawValue(digits.data(), digits.size(), rapidjson::kNumberType);
    } else {
        writer.String(std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity");
    }
}

// One number alone, several as a list.
inline void write_numbers(JsonLines& writer, std::span<const double> values) {
    if (values.size() == 1) return write_number(writer, values.front());
    writer.StartArray();
    for (double value : values) write_number(writer, value);
    writer.EndArray();
}

}  // namespace patina::cli

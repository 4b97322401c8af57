// JSON with // comments and trailing commas, as a tree in which every value and key knows its place in the source.
// Wraps RapidJSON's iterative SAX parser; a deep or huge file is refused, never a crash. Comments are kept for `fmt`.
#pragma once

#include "compiler/base/diagnostics.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace patina::graph {

struct JsonMember;

struct Json {
    enum class Kind { Null, Bool, Number, String, Array, Object };
    Kind kind = Kind::Null;
    Span span;
    bool boolean = false;
    double number = 0;
    std::string string;               // decoded
    std::vector<Json> elements;       // array
    std::vector<JsonMember> members;  // object, in file order
    std::vector<std::string> comments;      // whole-line comments before the value (before its key, for a member)
    std::string trailing_comment;           // on the same line, after it
    std::vector<std::string> end_comments;  // before the closing bracket

    const Json* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    Span key_span;
    Json value;
};

// "an object", "a string", ...
std::string_view describe(Json::Kind kind);

// Global offset of each byte of the decoded string, and of its end; empty when there are no escapes (then byte i is at
// span.begin + 1 + i).
std::vector<std::uint32_t> string_offsets(const Json& string, const SourceMap& sources);

inline constexpr std::size_t kMaxJsonDepth = 128;
inline constexpr std::size_t kMaxJsonBytes = 64u << 20;

// The file whose text starts at `base` in the map. Null after an error, which has been reported.
std::unique_ptr<Json> parse_json(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics);

}  // namespace patina::graph

// The room `json` reads JSON into a tree in which every value and key has its location. It does not know what a file
// means. It accepts // comments and trailing commas, and keeps the comments for `fmt`. It wraps RapidJSON's iterative
// SAX parser; a file that is too deep or too large is reported.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace patina::json {

struct JsonMember;

struct JsonComments {
    // On lines of their own before the value (of a member: before its key); an empty string is a blank line.
    std::vector<std::string> before;
    std::string trailing;          // after it on the same line; of the root: all that follows, line by line
    std::vector<std::string> end;  // before the closing bracket
};

struct Json {
    enum class Kind { Null, Bool, Number, String, Array, Object };
    Kind kind = Kind::Null;
    bool boolean = false;
    Span span;
    double number = 0;
    std::string string;                      // decoded
    std::vector<Json> elements;              // array
    std::vector<JsonMember> members;         // object, in file order
    std::unique_ptr<JsonComments> comments;  // null: none

    const Json* find(std::string_view key) const;
};

struct JsonMember {
    std::string key;
    Span key_span;
    Json value;
};

// "an object", "a string", ...
std::string_view describe(Json::Kind kind);

// The user's text as a message shows it: a long text is cut.
std::string shown(std::string_view text);

// The global offset of each byte of the decoded string, and of its end. Empty if the string has no escapes: then byte i
// is at span.begin + 1 + i.
std::vector<std::uint32_t> string_offsets(const Json& string, const SourceMap& sources);

inline constexpr std::size_t kMaxJsonDepth = 128;
inline constexpr std::size_t kMaxJsonBytes = 64u << 20;
inline constexpr std::size_t kMaxJsonItems = 1'000'000;  // values and comments

// Reads the file whose text starts at `base` in the map. Reports what it cannot read, and then returns null. A
// duplicate key is reported too, but the tree is returned with the first of the two, so that one run finds several
// errors. A file of Patina whose ending says that it is something else, such as a shader, is an error at once.
enum class JsonOf { Patina, OtherProgram };
std::unique_ptr<Json> parse_json(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics,
                                 JsonOf whose = JsonOf::Patina);

}  // namespace patina::json

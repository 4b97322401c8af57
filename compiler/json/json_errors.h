// The message for JSON that the parser cannot read. The parser's error code and the location become a sentence that
// says what to change. Private to json.cpp.
//
//   { "a": 1 "b": 2 }     ->  file:1:9: broken JSON: a ',' is missing after this value
#pragma once

#include <rapidjson/error/error.h>

#include <string_view>

#include "compiler/base/diagnostics.h"

namespace patina::json {

// How far the parser came. Offsets are into the text.
struct JsonBreak {
    rapidjson::ParseErrorCode code = rapidjson::kParseErrorNone;
    std::size_t offset = 0;      // where RapidJSON stopped
    std::size_t last_begin = 0;  // the last whole token
    std::size_t last_end = 0;
    char bracket = 0;  // innermost open one, '{' or '['; 0: none
    std::size_t bracket_offset = 0;
};

void report_json_break(std::string_view text, std::uint32_t base, const JsonBreak& at, Diagnostics& diagnostics);

// The first byte at or after `from` that is not white space, a comma, a colon or part of a comment.
std::size_t skip_between_tokens(std::string_view text, std::size_t from);

}  // namespace patina::json

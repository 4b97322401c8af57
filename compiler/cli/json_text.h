// Text as JSON: with quotes, and with what JSON cannot hold escaped. For commands that print a few values; pages of the
// library are in pages/library_json.h.
#pragma once

#include <string>
#include <string_view>

namespace patina::cli {

std::string json_text(std::string_view text);

}  // namespace patina::cli

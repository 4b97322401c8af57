// What OpenImageIO says of a failure, as a part of our messages.
#pragma once

#include <string>

namespace patina::runtime {

// The first line, without the full stop.
inline std::string reason(std::string text) {
    text = text.substr(0, text.find('\n'));
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text.empty() ? "unknown reason" : text;
}

}  // namespace patina::runtime

#include "compiler/base/broken_text.h"

#include <algorithm>

#include "compiler/base/text.h"

namespace patina {

std::optional<BrokenText> broken_text(std::string_view text) {
    using namespace std::string_view_literals;
    // With its mark, or as the first character of a text: '{', '%' or '<' and a zero byte.
    const bool has_zero = text.size() > 1 && (text[0] == '\0') != (text[1] == '\0') && text.find_first_of("{%<-"sv) < 2;
    if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv) || has_zero)
        return BrokenText{.what = "it is UTF-16: save it as UTF-8"};
    constexpr std::string_view kMarker = "<<<<<<<";
    for (std::size_t at = 0; (at = text.find(kMarker, at)) != text.npos; at += kMarker.size()) {
        const std::size_t end = at + kMarker.size();
        const bool is_line = (at == 0 || text[at - 1] == '\n') &&
                             (end == text.size() || text[end] == ' ' || text[end] == '\n' || text[end] == '\r');
        if (!is_line) continue;
        const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        return BrokenText{.offset = at,
                          .line = static_cast<int>(lines) + 1,
                          .what = "a merge left a conflict here: keep one of the two sides, and no marker"};
    }
    return std::nullopt;
}

std::string as_utf8(std::string_view text) {
    std::string made;
    for (std::size_t bad = 0; !is_utf8(text, bad); text.remove_prefix(bad + 1))
        made.append(text.substr(0, bad)).append("\xEF\xBF\xBD");
    return made.append(text);
}

}  // namespace patina

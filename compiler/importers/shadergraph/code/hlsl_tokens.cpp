#include "compiler/importers/shadergraph/code/hlsl_tokens.h"

namespace patina::importers::shadergraph {

std::vector<Token> tokens_of(std::string_view text) {
    static constexpr std::string_view kLong[] = {"<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "+=",
                                                 "-=",  "*=",  "/=", "%=", "&=", "|=", "^=", "++", "--", "::"};
    std::vector<Token> made;
    int line = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            ++at;
            continue;
        }
        std::size_t end = at + 1;
        if (is_letter(c)) {
            while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
        } else if (is_digit(c) || (c == '.' && end < text.size() && is_digit(text[end]))) {
            while (end < text.size() &&
                   (is_letter(text[end]) || is_digit(text[end]) || text[end] == '.' ||
                    ((text[end] == '-' || text[end] == '+') && (text[end - 1] == 'e' || text[end - 1] == 'E'))))
                ++end;
        } else {
            for (const std::string_view each : kLong)
                if (text.substr(at).starts_with(each)) {
                    end = at + each.size();
                    break;
                }
        }
        made.push_back({text.substr(at, end - at), line});
        at = end;
    }
    made.push_back({text.substr(text.size()), line});
    return made;
}

}  // namespace patina::importers::shadergraph

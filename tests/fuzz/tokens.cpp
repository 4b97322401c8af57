#include <algorithm>
#include <cctype>

#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

using Tokens = std::vector<std::string>;

constexpr std::string_view kOperators = " ++ += -= *= /= == != <= >= && || ";

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

enum class TokenKind { Quoted, Word, Other };
TokenKind kind_of(const std::string& token) {
    if (token[0] == '"') return TokenKind::Quoted;
    const bool is_number = token[0] == '-' && token.size() > 1 && is_digit(token[1]);
    return is_number || std::isalnum(static_cast<unsigned char>(token[0])) ? TokenKind::Word : TokenKind::Other;
}

// Words, numbers, quoted words, documentation, and every other character alone; other comments are left
// out.
std::vector<std::string> tokens_of(const std::string& text) {
    std::vector<std::string> tokens;
    for (std::size_t at = 0; at < text.size();) {
        const auto is_word = [&](std::size_t i) {
            return std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' || text[i] == '.';
        };
        // A sign stands before a number, and not behind a value.
        const auto is_sign = [&](std::size_t i) {
            const bool is_behind = !tokens.empty() && (kind_of(tokens.back()) != TokenKind::Other ||
                                                       tokens.back() == ")" || tokens.back() == "]");
            return text[i] == '-' && i + 1 < text.size() && is_digit(text[i + 1]) && !is_behind;
        };
        const auto is_exponent = [&](std::size_t from, std::size_t i) {
            return (text[i] == '-' || text[i] == '+') && (text[i - 1] == 'e' || text[i - 1] == 'E') &&
                   (is_digit(text[from]) || text[from] == '-');
        };
        std::size_t end = at + 1;
        if (text.compare(at, 2, "//") == 0) {
            end = std::min(text.find('\n', at), text.size());
            if (text.compare(at, 3, "///") == 0) tokens.push_back(text.substr(at, end - at));
            at = end;
            continue;
        }
        if (std::isspace(static_cast<unsigned char>(text[at]))) {
            ++at;
            continue;
        }
        if (text[at] == '"') {
            while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, text.size());
        } else if (is_word(at) || is_sign(at)) {
            while (end < text.size() && (is_word(end) || is_exponent(at, end))) ++end;
        } else if (at + 1 < text.size() && kOperators.find(" " + text.substr(at, 2) + " ") != std::string_view::npos) {
            ++end;
        }
        tokens.push_back(text.substr(at, end - at));
        at = end;
    }
    return tokens;
}

std::string joined(const std::vector<std::string>& tokens) {
    std::string text;
    for (const std::string& token : tokens) {
        const bool is_doc = token.starts_with("///");
        if (is_doc && !token.starts_with("///<")) text += "\n";
        text += token;
        text += is_doc                                         ? "\n"
                : token == ";" || token == "{" || token == "}" ? "\n"
                : token == "[" || token == "]"                 ? ""
                                                               : " ";
    }
    return text;
}

auto at(Tokens& tokens, std::size_t index) {
    return tokens.begin() + static_cast<std::ptrdiff_t>(index);
}

// From behind one of `ends` to the next of it, somewhere; nothing if there is none.
template <class Ends>
std::pair<std::size_t, std::size_t> part_of(const Tokens& tokens, Random& random, Ends ends) {
    const auto from = [&](std::size_t i) {
        return static_cast<std::size_t>(
            std::find_if(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.end(), ends) - tokens.begin());
    };
    const std::size_t first = from(below(random, tokens.size()));
    if (first == tokens.size()) return {0, 0};
    const std::size_t last = from(first + 1);
    return last == tokens.size() ? std::pair<std::size_t, std::size_t>{0, 0} : std::pair{first + 1, last + 1};
}

Tokens copy_of(const Tokens& tokens, std::size_t begin, std::size_t end) {
    return {tokens.begin() + static_cast<std::ptrdiff_t>(begin), tokens.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Leaves out a statement, declaration or element, or says one of `other` here.
void statement(Tokens& tokens, const Tokens& other, Random& random) {
    const auto ends = [](const std::string& token) {
        return token == ";" || token == "}" || token == "{" || token == ",";
    };
    const auto [begin, end] = part_of(tokens, random, ends);
    const auto [from, to] = part_of(other, random, ends);
    const Tokens copy = copy_of(other, from, to);
    if (one_in(2, random)) {
        tokens.erase(at(tokens, begin), at(tokens, end));
    } else {
        tokens.insert(at(tokens, end), copy.begin(), copy.end());
    }
}

}  // namespace

TokenChanges::TokenChanges(std::span<const Seed> seeds, std::span<const std::string_view> words) {
    for (const Seed& seed : seeds) {
        files_.push_back(tokens_of(seed.bytes));
        pool_.insert(pool_.end(), files_.back().begin(), files_.back().end());
    }
    pool_.insert(pool_.end(), words.begin(), words.end());
}

std::string TokenChanges::make(std::size_t seed, Random& random) const {
    Tokens tokens = files_[seed];
    for (std::size_t changes = 1 + below(random, 2); changes > 0; --changes) change(tokens, random);
    return joined(tokens);
}

// Of the same kind, so that the parser is not all that is tried; often of the same file.
std::string TokenChanges::like(const Tokens& tokens, const std::string& token, Random& random) const {
    const Tokens& from = one_in(2, random) ? tokens : pool_;
    for (int tries = 0; tries < 1000; ++tries) {
        const std::string& other = from[below(random, from.size())];
        if (kind_of(other) == kind_of(token)) return other;
    }
    return token;
}

void TokenChanges::change(Tokens& tokens, Random& random) const {
    if (tokens.empty()) return;
    const std::size_t place = below(random, tokens.size());
    const std::string old = tokens[place];
    const Tokens& other = files_[below(random, files_.size())];
    switch (below(random, 12)) {
        case 0: tokens[place] = pool_[below(random, pool_.size())]; break;
        case 1: {  // a piece of any file, anywhere
            if (other.empty()) break;
            const std::size_t begin = below(random, other.size());
            const Tokens piece = copy_of(other, begin, std::min(begin + 1 + below(random, 30), other.size()));
            tokens.insert(at(tokens, place), piece.begin(), piece.end());
            break;
        }
        case 2: tokens.erase(at(tokens, place)); break;
        case 3:
        case 4: {  // one name for another, everywhere
            const std::string name = like(tokens, old, random);
            if (kind_of(old) != TokenKind::Other) std::replace(tokens.begin(), tokens.end(), old, name);
            break;
        }
        case 5: statement(tokens, Tokens(tokens), random); break;
        case 6:
            if (!other.empty()) statement(tokens, other, random);
            break;
        case 7:
        case 8: attribute(tokens, random); break;
        default:
            for (std::size_t i = place; i < tokens.size(); ++i) {
                if (kind_of(tokens[i]) == TokenKind::Other) continue;
                tokens[i] = like(tokens, tokens[i], random);
                break;
            }
    }
}

// Leaves out an attribute or a list, or puts it before another one, too.
void TokenChanges::attribute(Tokens& tokens, Random& random) const {
    const auto ends = [](const std::string& token) { return token == "]"; };
    const bool is_own = one_in(2, random);
    const Tokens other = is_own ? tokens : files_[below(random, files_.size())];
    if (other.empty()) return;
    const auto [begin, end] = part_of(other, random, ends);
    if (begin == end || other[begin] != "[") return;
    const Tokens copy = copy_of(other, begin, end);
    if (is_own && one_in(2, random)) tokens.erase(at(tokens, begin), at(tokens, end));
    if (tokens.empty()) return;
    const auto before = std::find(at(tokens, below(random, tokens.size())), tokens.end(), "[");
    tokens.insert(before, copy.begin(), copy.end());
}

}  // namespace patina::fuzz

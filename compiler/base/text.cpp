#include "compiler/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <vector>

namespace patina {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// "normalWS" and "normalWS" are one word in two spellings.
std::string spelled_alike(std::string_view word) {
    std::string plain;
    plain.reserve(word.size());
    for (char c : word) {
        if (c != '_') plain += lower(c);
    }
    return plain;
}

// Optimal string alignment distance, case-insensitive.
std::size_t distance_of_letters(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (same ? 0u : 1u)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
        std::swap(before, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

// An underscore between words is no letter that has to change.
std::size_t distance(std::string_view a, std::string_view b) {
    const std::size_t as_written = distance_of_letters(a, b);
    if (as_written == 0 || a.find('_') == a.npos) return as_written;
    return std::min(as_written, distance_of_letters(spelled_alike(a), spelled_alike(b)));
}

template <class T>
std::string shortest_of(T value) {
    std::array<char, 64> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
}

}  // namespace

bool is_identifier(std::string_view text) {
    if (text.empty() || !is_letter(text[0])) return false;
    return std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > 256) return {};
    const std::string plain = spelled_alike(word);
    const auto same = std::find_if(candidates.begin(), candidates.end(),
                                   [&](std::string_view candidate) { return spelled_alike(candidate) == plain; });
    if (same != candidates.end() && !plain.empty()) return *same;
    std::string_view best;
    // Never a word of which every letter would have to change.
    std::size_t best_distance = std::min(std::max<std::size_t>(1, word.size() / 3) + 1, word.size());
    for (std::string_view candidate : candidates) {
        if (candidate.size() > word.size() + best_distance || word.size() > candidate.size() + best_distance) continue;
        const std::size_t d = distance(word, candidate);
        if (d < best_distance) {
            best = candidate;
            best_distance = d;
        }
    }
    if (!best.empty() && word.starts_with(best)) {
        // The word goes on where the best one ends: one that goes on like it is what was meant.
        const auto common = [&](std::string_view candidate) {
            return std::mismatch(word.begin(), word.end(), candidate.begin(), candidate.end()).first - word.begin();
        };
        for (std::string_view candidate : candidates) {
            if (common(candidate) > common(best) && distance(word, candidate) <= best_distance + 1) best = candidate;
        }
    }
    if (!best.empty() || word.size() < 4) return best;
    const auto completes = [&](std::string_view candidate) { return candidate.starts_with(word); };
    const auto longer = std::find_if(candidates.begin(), candidates.end(), completes);
    return longer == candidates.end() ? best : *longer;
}

std::string shortest(double value) {
    return shortest_of(value);
}
std::string shortest(float value) {
    return shortest_of(value);
}

std::string enumerate(std::span<const std::string_view> words) {
    std::string out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
        out += words[i];
    }
    return out;
}

bool is_utf8(std::string_view text, std::size_t& bad) {
    std::size_t i = 0;
    auto continuation = [&](std::size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u;
    };
    while (i < text.size()) {
        const auto c = static_cast<unsigned char>(text[i]);
        if (c < 0x80) {
            ++i;
            continue;
        }
        const std::size_t length = (c >= 0xC2 && c < 0xE0)   ? 2
                                   : (c >= 0xE0 && c < 0xF0) ? 3
                                   : (c >= 0xF0 && c < 0xF5) ? 4
                                                             : 0;
        bool good = length > 0;
        for (std::size_t k = 1; good && k < length; ++k) good = continuation(i + k);
        if (good && length >= 3) {
            const auto second = static_cast<unsigned char>(text[i + 1]);
            if (c == 0xE0 && second < 0xA0) good = false;   // overlong
            if (c == 0xED && second >= 0xA0) good = false;  // surrogate
            if (c == 0xF0 && second < 0x90) good = false;   // overlong
            if (c == 0xF4 && second >= 0x90) good = false;  // beyond U+10FFFF
        }
        if (!good) {
            bad = i;
            return false;
        }
        i += length;
    }
    return true;
}

std::vector<std::string_view> split(std::string_view text, std::string_view at) {
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(at), text.size());
        if (end > 0) parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + at.size(), text.size()));
    }
    return parts;
}

}  // namespace patina

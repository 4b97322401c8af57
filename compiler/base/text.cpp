#include "compiler/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>
#if __has_include(<version>)
#include <version>
#endif
#ifdef __cpp_lib_to_chars
#include <charconv>
#endif

#include "compiler/base/letters.h"

namespace patina {
namespace {

// Optimal string alignment distance, case-insensitive.
std::size_t distance_of_letters(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = to_lower(a[i - 1]) == to_lower(b[j - 1]);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (same ? 0u : 1u)});
            const bool swapped =
                i > 1 && j > 1 && to_lower(a[i - 1]) == to_lower(b[j - 2]) && to_lower(a[i - 2]) == to_lower(b[j - 1]);
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

// 123.4 is 1234 x 10^-1.
struct Decimal {
    bool is_negative = false;
    std::string digits{};  // neither the first nor the last is 0, unless there is only one
    int exponent = 0;

    // Of the first digit: 2 of 123.4.
    int scientific_exponent() const { return exponent + static_cast<int>(digits.size()) - 1; }
};

// The fewest digits that read back as the same value. {fmt} finds them; where it puts the point is its own choice.
template <class T>
Decimal decimal_of(T value) {
    const std::string text = fmt::format("{}", value);
    Decimal made{.is_negative = text.front() == '-'};
    bool has_point = false;
    for (std::size_t i = made.is_negative ? 1 : 0; i < text.size(); ++i) {
        if (text[i] == 'e') {
            made.exponent += std::atoi(text.c_str() + i + 1);
            break;
        }
        if (text[i] == '.') {
            has_point = true;
            continue;
        }
        if (has_point) --made.exponent;
        if (!made.digits.empty() || text[i] != '0') made.digits += text[i];
    }
    for (; made.digits.size() > 1 && made.digits.back() == '0'; ++made.exponent) made.digits.pop_back();
    if (made.digits.empty()) made = {.is_negative = made.is_negative, .digits = "0"};
    return made;
}

std::string with_exponent(const Decimal& decimal) {
    std::string text = decimal.is_negative ? "-" : "";
    text += decimal.digits.front();
    if (decimal.digits.size() > 1) text += '.' + decimal.digits.substr(1);
    return text + fmt::format("e{:+03d}", decimal.scientific_exponent());
}

template <class T>
std::string without_exponent(const Decimal& decimal, T value) {
    // All digits of a whole number are written, not zeros behind the shortest ones.
    if (decimal.exponent >= 0) return fmt::format("{:.0f}", value);
    const std::string sign = decimal.is_negative ? "-" : "";
    const auto decimals = static_cast<std::size_t>(-decimal.exponent);
    if (decimals >= decimal.digits.size()) {
        return sign + "0." + std::string(decimals - decimal.digits.size(), '0') + decimal.digits;
    }
    std::string text = decimal.digits;
    return sign + text.insert(text.size() - decimals, 1, '.');
}

template <class T>
std::string shortest_of(T value) {
    if (!std::isfinite(value)) return fmt::format("{}", value);
    const Decimal decimal = decimal_of(value);
    const auto count = static_cast<int>(decimal.digits.size()), first = decimal.scientific_exponent();
    const int scientific = count + (count > 1 ? 1 : 0) + (std::abs(first) < 100 ? 4 : 5);
    const int fixed = decimal.exponent >= 0 ? count + decimal.exponent : first >= 0 ? count + 1 : count + 1 - first;
    return scientific < fixed ? with_exponent(decimal) : without_exponent(decimal, value);
}

}  // namespace

std::string spelled_alike(std::string_view word) {
    std::string plain;
    plain.reserve(word.size());
    for (char c : word) {
        if (c != '_' && c != ' ') plain += to_lower(c);
    }
    return plain;
}

bool is_identifier(std::string_view text) {
    if (text.empty() || is_digit(text[0])) return false;
    return std::all_of(text.begin(), text.end(), is_word_letter);
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.size() > 256) return {};
    const std::string plain = spelled_alike(word);
    const auto same = std::find_if(candidates.begin(), candidates.end(),
                                   [&](std::string_view candidate) { return spelled_alike(candidate) == plain; });
    if (same != candidates.end() && !plain.empty()) return *same;
    std::string_view best;
    // A word of which every letter would have to change is no suggestion.
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
        // The word is longer than the best candidate. One that shares more of the word's beginning is what was meant.
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

std::string shortest_decimals(float value) {
    return std::isfinite(value) ? without_exponent(decimal_of(value), value) : fmt::format("{}", value);
}

std::optional<double> read_number(std::string_view text) {
    double value = 0;
#ifdef __cpp_lib_to_chars
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (stop != text.data() + text.size() || error == std::errc::invalid_argument) return {};
    if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
#else
    // Emscripten's strtod knows no locale. It reads spaces, a plus sign and hexadecimals, which std::from_chars
    // refuses.
    if (text.empty() || text.find_first_of(" \t\n\v\f\r+xX") == 0 || text.find_first_of("xX") != text.npos) return {};
    const std::string copy(text);
    char* stop = nullptr;
    value = std::strtod(copy.c_str(), &stop);
    if (stop != copy.c_str() + copy.size()) return {};
    const bool is_zero = text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == text.npos;
    if (value == 0 && !is_zero) return std::numeric_limits<double>::infinity();
#endif
    return value;
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
        // Most text is ASCII: eight letters at once.
        std::uint64_t letters = 0;
        if (i + sizeof letters <= text.size()) {
            std::memcpy(&letters, text.data() + i, sizeof letters);
            if ((letters & 0x8080808080808080u) == 0) {
                i += sizeof letters;
                continue;
            }
        }
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

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

// A line of the text, from its begin to behind its end.
std::pair<std::size_t, std::size_t> line_at(std::string_view text, std::size_t at) {
    const std::size_t before = at == 0 ? text.npos : text.rfind('\n', at - 1), after = text.find('\n', at);
    return {before == text.npos ? 0 : before + 1, after == text.npos ? text.size() : after + 1};
}

void put_number(std::string& bytes, std::size_t at, Random& random) {
    constexpr std::uint64_t kEdges[] = {0,          1,          2,          0x7f,      0x80,    0xff,
                                        0x100,      0x7fff,     0x8000,     0xffff,    0x10000, 0x1000000,
                                        0x7fffffff, 0x80000000, 0xfffffff0, 0xffffffff};
    const std::size_t size = std::size_t(1) << below(random, 4);
    const std::uint64_t edge = kEdges[below(random, std::size(kEdges))];
    const std::uint64_t number = one_in(2, random)   ? edge
                                 : one_in(2, random) ? ~edge
                                                     : bytes.size() - below(random, 16);
    const bool is_little = one_in(2, random);
    for (std::size_t i = 0; i < size && at + i < bytes.size(); ++i)
        bytes[at + i] = static_cast<char>(number >> (8 * (is_little ? i : size - 1 - i)));
}

void change_bytes(std::string& bytes, std::string_view other, Random& random) {
    if (bytes.empty()) return;
    const std::size_t range = one_in(2, random) ? std::min<std::size_t>(bytes.size(), 160) : bytes.size();
    const std::size_t at = below(random, range), count = 1 + below(random, one_in(4, random) ? 64 : 8);
    switch (below(random, 10)) {
        case 0: bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8))); break;
        case 1: bytes[at] = static_cast<char>(random()); break;
        case 2:
        case 3:
        case 4: put_number(bytes, at, random); break;
        case 5: bytes.erase(at, count); break;
        case 6: bytes.insert(at, bytes.substr(below(random, bytes.size()), count)); break;
        case 7: bytes.resize(at); break;
        case 8: {
            const std::size_t from = other.empty() ? 0 : below(random, other.size());
            bytes.replace(at, std::min(count, bytes.size() - at), other.substr(from, count));
            break;
        }
        default: bytes.insert(at, count, static_cast<char>(random())); break;
    }
}

void change_line(std::string& text, std::string_view other, Random& random) {
    if (text.empty()) return;
    const std::size_t at = below(random, text.size()), count = 1 + below(random, 12);
    const auto [begin, end] = line_at(text, at);
    const std::size_t digit = std::min(text.find_first_of("0123456789", at), text.size() - 1);
    constexpr std::string_view kPieces[] = {"-1",        "1e30", "1e999", "99999999999", "\xff", "\xC3", "漢字",
                                            "e\xCC\x81", "\t",   "\x1b",  "\\u0000",     "\"",   "nan",  "0x1p3"};
    switch (below(random, 10)) {
        case 0: text[at] = static_cast<char>(random()); break;
        case 1: text.erase(at, count); break;
        case 2: text.insert(at, text.substr(below(random, text.size()), count)); break;
        case 3: text[digit] = static_cast<char>('0' + below(random, 10)); break;
        case 4: text.replace(digit, 1, kPieces[below(random, std::size(kPieces))]); break;
        case 5: text.erase(begin, end - begin); break;
        case 6: {
            const auto [from, to] = line_at(text, below(random, text.size()));
            text.insert(begin, text.substr(from, to - from));
            break;
        }
        case 7: {
            if (other.empty()) break;
            const auto [from, to] = line_at(other, below(random, other.size()));
            text.replace(begin, end - begin, other.substr(from, to - from));
            break;
        }
        case 8: text.insert(at, kPieces[below(random, std::size(kPieces))]); break;
        default:  // lines become long ones
            for (std::size_t i = begin; i < text.size() && i < begin + 600; ++i)
                if (text[i] == '\n') text[i] = ' ';
    }
}

}  // namespace

std::size_t below(Random& random, std::size_t limit) {
    return static_cast<std::size_t>(random()) % limit;
}

bool one_in(std::size_t count, Random& random) {
    return below(random, count) == 0;
}

std::string changed_bytes(std::string bytes, std::string_view other, Random& random) {
    for (std::size_t edits = 1 + below(random, 4); edits > 0; --edits) change_bytes(bytes, other, random);
    return bytes;
}

std::string changed_lines(std::string text, std::string_view other, Random& random) {
    for (std::size_t edits = 1 + below(random, 4); edits > 0; --edits) change_line(text, other, random);
    return text;
}

Input changed_text(std::span<const Seed> seeds, const TokenChanges& tokens, Random& random) {
    const std::size_t seed = below(random, seeds.size());
    std::string text = one_in(2, random)
                           ? tokens.make(seed, random)
                           : changed_lines(seeds[seed].bytes, seeds[below(random, seeds.size())].bytes, random);
    if (one_in(16, random)) text.resize(below(random, text.size() + 1));
    return {.bytes = std::move(text), .path = seeds[seed].path};
}

}  // namespace patina::fuzz

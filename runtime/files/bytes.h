// Numbers and parts of a file's bytes. A file is not trusted: what it says to be behind its end is not there, and is
// never read. Every reader of headers and chunks reads through this.
//
//   const Bytes bytes(file);
//   const auto length = bytes.big_endian(8, 4);              // std::nullopt: the file ends before
//   const auto chunk = length ? bytes.part(16, *length) : std::nullopt;
//
// ByteStream reads one number behind another, and is asked at the end whether all of them were there:
//
//   ByteStream from(file);
//   const auto width = from.big(4), height = from.big(4);
//   if (!from.is_good()) ...                                 // the file ends before
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace patina::runtime {

class Bytes {
public:
    explicit Bytes(std::string_view all) : all_(all) {}

    std::size_t size() const { return all_.size(); }
    // Any numbers can be asked for: their sum is not computed, because it may not fit into 64 bits.
    bool has(std::uint64_t at, std::uint64_t count) const { return at <= all_.size() && count <= all_.size() - at; }
    std::optional<std::string_view> part(std::uint64_t at, std::uint64_t count) const {
        if (!has(at, count)) return std::nullopt;
        return all_.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(count));
    }
    bool says(std::uint64_t at, std::string_view word) const { return part(at, word.size()) == word; }

    // Of 0 to 8 bytes.
    std::optional<std::uint64_t> big_endian(std::uint64_t at, std::uint64_t count) const {
        return number(at, count, false);
    }
    std::optional<std::uint64_t> little_endian(std::uint64_t at, std::uint64_t count) const {
        return number(at, count, true);
    }

private:
    std::optional<std::uint64_t> number(std::uint64_t at, std::uint64_t count, bool is_little) const {
        const std::optional<std::string_view> bytes = part(at, count);
        if (!bytes || count > 8) return std::nullopt;
        std::uint64_t made = 0;
        for (std::size_t i = 0; i < bytes->size(); ++i)
            made = made << 8 | static_cast<unsigned char>((*bytes)[is_little ? bytes->size() - 1 - i : i]);
        return made;
    }

    std::string_view all_;
};

// Behind the end, and from then on, everything that is taken is 0 or empty.
class ByteStream {
public:
    explicit ByteStream(std::string_view all) : all_(all) {}

    bool is_good() const { return is_good_; }
    std::string_view take(std::uint64_t count) {
        const std::optional<std::string_view> taken = is_good_ ? all_.part(at_, count) : std::nullopt;
        is_good_ = taken.has_value();
        if (is_good_) at_ += count;
        return taken.value_or(std::string_view());
    }
    // Up to a zero byte, which is taken, too.
    std::string_view word() {
        const std::string_view left = all_.part(at_, all_.size() - at_).value_or(std::string_view());
        const std::string_view taken = take(std::min(left.find('\0'), left.size()));
        take(1);
        return taken;
    }
    // Of 0 to 8 bytes.
    std::uint64_t big(std::uint64_t count) { return Bytes(take(count)).big_endian(0, count).value_or(0); }
    std::uint64_t little(std::uint64_t count) { return Bytes(take(count)).little_endian(0, count).value_or(0); }

private:
    Bytes all_;
    std::uint64_t at_ = 0;
    bool is_good_ = true;
};

}  // namespace patina::runtime

// Numbers and parts of a file's bytes. A file is not trusted: what it says to be behind its end is not there, and is
// never read. Every reader of headers and chunks reads through this.
//
//   const Bytes bytes(file);
//   const auto length = bytes.big_endian(8, 4);              // std::nullopt: the file ends before
//   const auto chunk = length ? bytes.part(16, *length) : std::nullopt;
#pragma once

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

}  // namespace patina::runtime

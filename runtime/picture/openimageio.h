// Additions to OpenImageIO for reading and writing pictures: its messages as a part of ours, and bytes in memory that
// it reads within their bounds. Its own reader (2.4) lets a damaged header move the place before the first byte, and
// reads there.
//
//   MemoryReader reader(bytes);
//   OIIO::Filesystem::IOProxy* proxy = &reader;
//   straight.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
#pragma once

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace patina::runtime {

// What it says of a failure: the first line, without the full stop.
inline std::string reason(std::string text) {
    text = text.substr(0, text.find('\n'));
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text.empty() ? "unknown reason" : text;
}

class MemoryReader final : public OIIO::Filesystem::IOMemReader {
public:
    explicit MemoryReader(std::string_view bytes) : IOMemReader(bytes.data(), bytes.size()), bytes_(bytes) {}

    bool seek(std::int64_t offset) override {
        if (offset < 0 || static_cast<std::uint64_t>(offset) > bytes_.size()) return false;
        m_pos = offset;
        return true;
    }
    std::size_t read(void* to, std::size_t size) override {
        const std::size_t count = pread(to, size, m_pos);
        m_pos += static_cast<std::int64_t>(count);
        return count;
    }
    std::size_t pread(void* to, std::size_t size, std::int64_t offset) override {
        if (offset < 0 || static_cast<std::uint64_t>(offset) >= bytes_.size()) return 0;
        const std::string_view from = bytes_.substr(static_cast<std::size_t>(offset), size);
        if (!from.empty()) std::memcpy(to, from.data(), from.size());
        return from.size();
    }

private:
    std::string_view bytes_;
};

}  // namespace patina::runtime

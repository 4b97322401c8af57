// The first directory of a TIFF: its entries, each with numbers (TIFF 6.0, section 2; BigTIFF).
//
//   TiffDirectory directory(bytes);
//   directory.values(273);   // where its strips begin; empty: there is none
#pragma once

#include <string_view>
#include <vector>

#include "runtime/files/bytes.h"

namespace patina::runtime {

class TiffDirectory {
public:
    explicit TiffDirectory(std::string_view bytes);

    // The values of the first entry with this tag: a second one is an error of the file.
    std::vector<std::uint64_t> values(std::uint64_t tag);
    // The bytes of such an entry, as the file has them.
    std::string_view bytes_of(std::uint64_t tag);
    bool has(std::uint64_t at, std::uint64_t count) const { return bytes_.has(at, count); }
    // False if something that was asked for lies behind the end of the file.
    bool is_good() const { return is_good_; }

private:
    struct Entry {
        std::uint64_t tag = 0, type = 0, count = 0, at = 0;  // at: where its values are
        std::uint64_t size() const;                          // of a value
    };
    std::uint64_t number(std::uint64_t at, std::uint64_t size);
    const Entry* entry(std::uint64_t tag) const;

    Bytes bytes_;
    bool is_good_ = true;
    bool is_big_endian_, is_large_;
    std::vector<Entry> entries_;
};

}  // namespace patina::runtime

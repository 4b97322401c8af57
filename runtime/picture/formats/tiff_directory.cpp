#include "runtime/picture/formats/tiff_directory.h"

#include <algorithm>

namespace patina::runtime {

std::uint64_t TiffDirectory::Entry::size() const {
    constexpr std::uint64_t kSizes[] = {1, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 1, 1, 1, 8, 8, 8};
    return type < std::size(kSizes) ? kSizes[type] : 1;
}

TiffDirectory::TiffDirectory(std::string_view bytes)
    : bytes_(bytes), is_big_endian_(bytes.starts_with('M')), is_large_(false) {
    constexpr std::uint64_t kLarge = 43;
    is_large_ = number(2, 2) == kLarge;
    const std::uint64_t word = is_large_ ? 8 : 4, at = is_large_ ? number(8, 8) : number(4, 4);
    const std::uint64_t count = number(at, is_large_ ? 8 : 2), size = is_large_ ? 20 : 12;
    for (std::uint64_t i = 0; is_good_ && i < count; ++i) {
        const std::uint64_t begin = at + (is_large_ ? 8 : 2) + i * size;
        Entry made{.tag = number(begin, 2), .type = number(begin + 2, 2), .count = number(begin + 4, word)};
        const std::uint64_t inside = begin + 4 + word;
        // Values stand in the entry itself if there is room.
        const bool is_inside = made.count <= word && made.count * made.size() <= word;
        made.at = is_inside ? inside : number(inside, word);
        if (is_good_) entries_.push_back(made);
    }
}

std::uint64_t TiffDirectory::number(std::uint64_t at, std::uint64_t size) {
    const auto made = is_big_endian_ ? bytes_.big_endian(at, size) : bytes_.little_endian(at, size);
    is_good_ = is_good_ && made;
    return is_good_ ? *made : 0;
}

const TiffDirectory::Entry* TiffDirectory::entry(std::uint64_t tag) const {
    const auto found = std::ranges::find(entries_, tag, &Entry::tag);
    return found == entries_.end() ? nullptr : &*found;
}

std::vector<std::uint64_t> TiffDirectory::values(std::uint64_t tag) {
    std::vector<std::uint64_t> made;
    const Entry* const found = entry(tag);
    if (!found) return made;
    is_good_ = is_good_ && found->count <= bytes_.size();
    for (std::uint64_t i = 0; is_good_ && i < found->count; ++i)
        made.push_back(number(found->at + i * found->size(), found->size()));
    return made;
}

std::string_view TiffDirectory::bytes_of(std::uint64_t tag) {
    const Entry* const found = entry(tag);
    if (!found) return {};
    const bool is_there = found->count <= bytes_.size() && bytes_.has(found->at, found->count * found->size());
    is_good_ = is_good_ && is_there;
    return is_good_ ? *bytes_.part(found->at, found->count * found->size()) : std::string_view();
}

}  // namespace patina::runtime

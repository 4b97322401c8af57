#include "compiler/base/source.h"

#include <algorithm>

namespace patina {

SourceMap::SourceMap(const SourceMap* base) : base_(base), next_(base ? base->next_ : 1) {}

std::uint32_t SourceMap::add(std::string path, std::string text) {
    return add_file(std::move(path), std::move(text), {});
}

std::uint32_t SourceMap::add_view(std::string path, std::string_view text) {
    return add_file(std::move(path), {}, text);
}

std::uint32_t SourceMap::add_file(std::string path, std::string own, std::string_view other) {
    const std::uint32_t begin = next_;
    const File& file = files_.emplace_back(begin, std::move(path), std::move(own), other);
    // One past the end, so that the end of a file has an offset of its own.
    next_ += static_cast<std::uint32_t>(file.text.size()) + 1;
    return begin;
}

const std::vector<std::uint32_t>& SourceMap::File::lines() const {
    return lines_.get([&] {
        auto lines = std::make_unique<std::vector<std::uint32_t>>(1, 0u);
        for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
            lines->push_back(static_cast<std::uint32_t>(at + 1));
        return lines;
    });
}

const SourceMap::File* SourceMap::find(std::uint32_t offset) const {
    if (base_ && offset < base_->next_) return base_->find(offset);
    auto after = std::upper_bound(files_.begin(), files_.end(), offset,
                                  [](std::uint32_t o, const File& file) { return o < file.begin; });
    if (after == files_.begin()) return nullptr;
    const File& file = *(after - 1);
    return offset <= file.begin + file.text.size() ? &file : nullptr;
}

Position SourceMap::resolve(std::uint32_t offset) const {
    const File* file = find(offset);
    if (!file) return {};
    const std::string_view text = file->text;
    const std::size_t at = offset - file->begin;
    const std::vector<std::uint32_t>& lines = file->lines();
    const auto next = std::upper_bound(lines.begin(), lines.end(), at);
    const std::size_t start = *(next - 1);
    std::size_t end = next == lines.end() ? text.size() : *next - 1;
    if (end > start && text[end - 1] == '\r') --end;
    return {.file = file->path,
            .line = static_cast<int>(next - lines.begin()),
            .column = 1 + static_cast<int>(at - start),
            .line_text = text.substr(start, end - start)};
}

std::string_view SourceMap::text(Span span) const {
    const File* file = find(span.begin);
    if (!file || span.end < span.begin) return {};
    return file->text.substr(span.begin - file->begin, span.end - span.begin);
}

std::string_view SourceMap::file(std::uint32_t offset) const {
    const File* file = find(offset);
    return file ? std::string_view(file->path) : std::string_view();
}

std::string_view SourceMap::text_before(std::uint32_t offset) const {
    const File* file = find(offset);
    return file ? file->text.substr(0, offset - file->begin) : std::string_view();
}

std::string_view SourceMap::file_text(std::uint32_t begin) const {
    const File* file = find(begin);
    return file ? file->text : std::string_view();
}

}  // namespace patina

#include "compiler/base/source.h"

#include <algorithm>

namespace patina {

SourceMap::SourceMap(const SourceMap* base) : base_(base), next_(base ? base->next_ : 1) {}

std::uint32_t SourceMap::add(std::string path, std::string text) {
    const std::uint32_t begin = next_;
    next_ += static_cast<std::uint32_t>(text.size()) + 1;  // one past the end, so an "at end of file" span has a home
    files_.push_back({begin, std::move(path), std::move(text)});
    return begin;
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
    const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
    std::size_t end = text.find('\n', start);
    if (end == std::string_view::npos) end = text.size();
    if (end > start && text[end - 1] == '\r') --end;
    return {.file = file->path,
            .line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
            .column = 1 + static_cast<int>(at - start),
            .line_text = text.substr(start, end - start)};
}

std::string_view SourceMap::text(Span span) const {
    const File* file = find(span.begin);
    if (!file || span.end < span.begin) return {};
    return std::string_view(file->text).substr(span.begin - file->begin, span.end - span.begin);
}

std::string_view SourceMap::file(std::uint32_t offset) const {
    const File* file = find(offset);
    return file ? std::string_view(file->path) : std::string_view();
}

std::string_view SourceMap::file_text(std::uint32_t begin) const {
    const File* file = find(begin);
    return file ? std::string_view(file->text) : std::string_view();
}

}  // namespace patina

#include "compiler/base/source.h"

#include <algorithm>

namespace patina {

SourceMap::SourceMap(const SourceMap* base) : base_(base), next_(base ? base->next_ : 1) {}

std::uint32_t SourceMap::add(std::string path, std::string text) {
    const std::uint32_t begin = next_;
    next_ += static_cast<std::uint32_t>(text.size()) +
             1;  // one past the end, so that the end of a file has an offset of its own
    File& file = files_.emplace_back(File{begin, std::move(path), std::move(text), {0}});
    constexpr std::size_t kUsualLine = 40;  // bytes
    file.lines.reserve(16 + file.text.size() / kUsualLine);
    for (std::size_t at = file.text.find('\n'); at != std::string::npos; at = file.text.find('\n', at + 1)) {
        file.lines.push_back(static_cast<std::uint32_t>(at + 1));
    }
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
    const auto next = std::upper_bound(file->lines.begin(), file->lines.end(), at);
    const std::size_t start = *(next - 1);
    std::size_t end = next == file->lines.end() ? text.size() : *next - 1;
    if (end > start && text[end - 1] == '\r') --end;
    return {.file = file->path,
            .line = static_cast<int>(next - file->lines.begin()),
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

std::string_view SourceMap::text_before(std::uint32_t offset) const {
    const File* file = find(offset);
    return file ? std::string_view(file->text).substr(0, offset - file->begin) : std::string_view();
}

std::string_view SourceMap::file_text(std::uint32_t begin) const {
    const File* file = find(begin);
    return file ? std::string_view(file->text) : std::string_view();
}

}  // namespace patina

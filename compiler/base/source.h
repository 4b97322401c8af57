// Where text came from. A location is one integer: all files share one range of offsets, one file after the other. Line
// and column are computed on demand. A SourceMap may extend another one. A compilation extends the map of the node
// library, so that one diagnostic can have spans of both.
//
//   SourceMap map;
//   std::uint32_t base = map.add("rust.graph.json", text);
//   Position p = map.resolve(base + 17);   // file, line 1.., column 1.. (in bytes)
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/base/made_once.h"

namespace patina {

// Half-open range of global offsets. {0, 0} means "nowhere": no file starts at offset 0.
struct Span {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    explicit operator bool() const { return begin != 0; }
    friend bool operator==(Span, Span) = default;
};

inline Span join(Span a, Span b) {
    if (!a) return b;
    if (!b) return a;
    return {a.begin < b.begin ? a.begin : b.begin, a.end > b.end ? a.end : b.end};
}

struct Position {
    std::string_view file;       // as given to add(); empty if the offset is nowhere
    int line = 0;                // from 1
    int column = 0;              // from 1, counted in bytes
    std::string_view line_text;  // the line without its newline
};

class SourceMap {
public:
    explicit SourceMap(const SourceMap* base = nullptr);

    // Adds a file and returns the global offset of its first byte. The text is kept.
    std::uint32_t add(std::string path, std::string text);
    // The same for a text that outlives the map, which is not copied.
    std::uint32_t add_view(std::string path, std::string_view text);

    Position resolve(std::uint32_t offset) const;
    // The text under a span; empty if the span is nowhere.
    std::string_view text(Span span) const;
    // The path of the file that holds the offset; empty if none does.
    std::string_view file(std::uint32_t offset) const;
    // The text of the file before the offset.
    std::string_view text_before(std::uint32_t offset) const;
    // The whole text of the file whose first byte is `begin`.
    std::string_view file_text(std::uint32_t begin) const;

private:
    struct File {
        File(std::uint32_t at, std::string file, std::string kept, std::string_view other)
            : begin(at), path(std::move(file)), own(std::move(kept)), text(own.empty() ? other : own) {}

        std::uint32_t begin;
        std::string path;
        std::string own;  // empty: the text is somebody else's
        std::string_view text;
        // Where each line begins, from the file's first byte: found when a place is first asked for, by any thread.
        const std::vector<std::uint32_t>& lines() const;

    private:
        MadeOnce<std::vector<std::uint32_t>> lines_;
    };
    std::uint32_t add_file(std::string path, std::string own, std::string_view other);
    const File* find(std::uint32_t offset) const;

    const SourceMap* base_;
    std::uint32_t next_;
    std::deque<File> files_;
};

}  // namespace patina

#include "compiler/nodelang/unread.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "compiler/base/cancellation.h"
#include "compiler/base/letters.h"

namespace patina::nodelang {
namespace {

// Attributes that only matter to a caller, who has the declaration.
constexpr std::string_view kOfNodes[] = {"node", "also", "is", "inFloat", "inline", "range"};

std::string_view word_at(std::string_view line, std::size_t at) {
    const auto begin = line.begin() + static_cast<std::ptrdiff_t>(std::min(at, line.size()));
    const auto end = std::find_if_not(begin, line.end(), is_word_letter);
    return line.substr(std::min(at, line.size()), static_cast<std::size_t>(end - begin));
}

std::size_t after_spaces(std::string_view line, std::size_t at) {
    return std::min(line.find_first_not_of(' ', at), line.size());
}

// Removes the attributes at the beginning of a line. False if one is not of a node.
bool skip_attributes(std::string_view& line) {
    while (line.starts_with('[')) {
        const std::string_view name = word_at(line, 1);
        if (std::find(std::begin(kOfNodes), std::end(kOfNodes), name) == std::end(kOfNodes)) return false;
        std::size_t end = 1;
        for (bool in_string = false; end < line.size() && (in_string || line[end] != ']'); ++end)
            in_string ^= line[end] == '"';
        if (end == line.size()) return false;
        line.remove_prefix(after_spaces(line, end + 1));
    }
    return true;
}

// The name in "float3 Name(", "enum Name {", "const float NAME = 1;"; empty if there is none.
std::string_view name_in(std::string_view line) {
    std::string_view word = word_at(line, 0);
    std::size_t at = after_spaces(line, word.size());
    if (word == "const") {
        word = word_at(line, at);
        at = after_spaces(line, at + word.size());
    }
    return at > 0 && line[at - 1] == ' ' ? word_at(line, at) : std::string_view();
}

// True if the declaration that begins in this line also ends in it.
bool is_whole(std::string_view line) {
    const std::size_t comment = line.find("//");
    line = line.substr(0, comment);
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    return line.ends_with('}') || line.ends_with("};") || (line.ends_with(';') && line.find('{') == line.npos);
}

struct Part {
    std::string_view name;
    std::size_t begin = 0, end = 0;
};

// Nothing if the file is not written as expected.
std::optional<std::vector<Part>> parts_of(std::string_view text) {
    std::vector<Part> parts;
    Part part;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        std::string_view line = text.substr(at, end - at);
        at = end;
        bool ends = false;
        if (line[0] == '}' && !part.name.empty()) {
            ends = true;
        } else if (line[0] == '[' || is_word_start(line[0])) {
            line = line.substr(0, line.find_last_not_of("\r\n") + 1);
            if (!part.name.empty() || !skip_attributes(line)) return {};
            if (line.empty()) continue;
            part.name = name_in(line);
            if (part.name.empty()) return {};
            ends = is_whole(line);
        } else if (line[0] == '#' || line[0] == '{') {
            return {};
        }
        if (!ends) continue;
        part.end = end;
        parts.push_back(part);
        part = {.name = {}, .begin = end};
    }
    return part.name.empty() ? std::optional(std::move(parts)) : std::nullopt;
}

}  // namespace

const Ast& Unread::ast() const {
    return ast_.get([this] {
        const Cancellation nobody;
        auto ast = std::make_unique<Ast>();
        Diagnostics diagnostics;
        parse_file(text_, *ast, diagnostics, Bodies::WhenAsked);
        return ast;
    });
}

bool split(Text file, std::deque<Unread>& into) {
    const std::optional<std::vector<Part>> parts = parts_of(file.text);
    if (!parts) return false;
    for (const Part& part : *parts) {
        into.emplace_back(
            part.name, Text{.text = file.text.substr(part.begin, part.end - part.begin), .base = file.at(part.begin)});
    }
    return true;
}

}  // namespace patina::nodelang

#include "compiler/importers/shadergraph/read/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/diagnostics.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::size_t kMostInnerBytes = 256u << 20;  // of JSON in strings, however deep

// Behind the object that begins at `begin`, or the end of the text if it is not closed.
std::size_t end_of_object(std::string_view text, std::size_t begin) {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            if (c == '"') in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{') {
            ++depth;
        } else if (c == '}' && --depth == 0) {
            return i + 1;
        }
    }
    return text.size();
}

}  // namespace

const Json* Documents::parse(std::string_view text, Piece piece, std::string& wrong) {
    const std::uint32_t begin = sources_->add(path_, std::string(text));
    piece.size = static_cast<std::uint32_t>(text.size());
    pieces_[begin] = std::move(piece);
    Diagnostics diagnostics;
    std::unique_ptr<Json> tree = graph::parse_json(*sources_, begin, diagnostics, graph::JsonOf::OtherProgram);
    if (diagnostics.has_errors()) {
        const DiagnosticRecord& first = diagnostics.records().front();
        const Place at = resolve(first.span.begin);
        wrong = fmt::format("{}:{}:{}: {}", path_, at.line, at.column, first.message);
        return nullptr;
    }
    if (!tree || tree->kind != Json::Kind::Object) {
        wrong = path_ + ": it is no JSON object";
        return nullptr;
    }
    trees_.push_back(std::move(tree));
    return trees_.back().get();
}

Place Documents::resolve(std::uint32_t offset) const {
    // A string in a string leads outwards, text by text.
    for (int level = 0; level < 8; ++level) {
        auto piece = pieces_.upper_bound(offset);
        if (piece == pieces_.begin()) return {};
        --piece;
        const Piece& found = piece->second;
        const std::uint32_t within = std::min(offset - piece->first, found.size);
        if (found.string_begin == 0) {
            const Position at = sources_->resolve(offset);
            return {.line = at.line + found.lines_before, .column = at.column};
        }
        offset = within < found.offsets.size() ? found.offsets[within] : found.string_begin + 1 + within;
    }
    return {};
}

Place Documents::place(const Json& value) const {
    return resolve(value.span.begin);
}

const Json* Documents::inner(const Json& string) {
    if (string.kind != Json::Kind::String || string.string.empty()) return nullptr;
    const auto [found, is_new] = inner_.try_emplace(&string, nullptr);
    if (!is_new) return found->second;
    inner_bytes_ += string.string.size();
    if (inner_bytes_ > kMostInnerBytes) return nullptr;
    std::string wrong;
    Piece piece{.offsets = graph::string_offsets(string, *sources_), .string_begin = string.span.begin};
    found->second = parse(string.string, std::move(piece), wrong);
    return found->second;
}

Documents read_documents(const std::string& path, std::string text) {
    Documents made;
    made.path_ = path;
    if (text.size() > graph::kMaxJsonBytes) {
        made.error = fmt::format("{}: the file has more than {} MiB", path, graph::kMaxJsonBytes >> 20);
        return made;
    }
    std::string_view rest = text;
    const std::size_t first = rest.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    int lines = 0;
    std::size_t counted = 0;
    for (std::size_t at = first; (at = rest.find_first_not_of(" \t\r\n", at)) != rest.npos;) {
        lines += static_cast<int>(std::count(rest.begin() + static_cast<std::ptrdiff_t>(counted),
                                             rest.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
        counted = at;
        const std::size_t line_begin = rest.rfind('\n', at) == rest.npos ? 0 : rest.rfind('\n', at) + 1;
        if (rest[at] != '{') {
            made.error =
                fmt::format("{}:{}:{}: an object of the graph begins with '{{'", path, lines + 1, at - line_begin + 1);
            return made;
        }
        const std::size_t end = end_of_object(rest, at);
        const Json* root = made.parse(rest.substr(at, end - at), {.lines_before = lines}, made.error);
        if (!root) return made;
        made.roots.push_back(root);
        at = end;
    }
    if (made.roots.empty()) made.error = path + ": the file is empty";
    return made;
}

const Json* member(const Json* object, std::string_view path) {
    while (object && !path.empty()) {
        const std::size_t dot = path.find('.');
        object = object->kind == Json::Kind::Object ? object->find(path.substr(0, dot)) : nullptr;
        path = dot == path.npos ? std::string_view() : path.substr(dot + 1);
    }
    return object;
}

std::string_view text_of(const Json* object, std::string_view path) {
    const Json* found = member(object, path);
    return found && found->kind == Json::Kind::String ? std::string_view(found->string) : std::string_view();
}

double number_of(const Json* object, std::string_view path, double otherwise) {
    const Json* found = member(object, path);
    if (!found) return otherwise;
    if (found->kind == Json::Kind::Bool) return found->boolean ? 1 : 0;
    // A number of a graph must fit a float of 32 bits, also after it was rounded to its shortest text.
    constexpr double kLargest = 3.4e38;
    if (found->kind != Json::Kind::Number || !std::isfinite(found->number)) return otherwise;
    return std::clamp(found->number, -kLargest, kLargest);
}

int whole_of(const Json* object, std::string_view path, int otherwise) {
    const double number = number_of(object, path, otherwise);
    return std::abs(number) < 2147483648.0 ? static_cast<int>(number) : otherwise;
}

bool flag_of(const Json* object, std::string_view path, bool otherwise) {
    return number_of(object, path, otherwise ? 1 : 0) != 0;
}

const std::vector<Json>& elements_of(const Json* object, std::string_view path) {
    static const std::vector<Json> kNone;
    const Json* found = member(object, path);
    return found && found->kind == Json::Kind::Array ? found->elements : kNone;
}

std::vector<double> vector_of(const Json* object, std::string_view path, std::size_t count) {
    const Json* found = member(object, path);
    std::vector<double> made(count, 0.0);
    if (found && found->kind == Json::Kind::Number) std::fill(made.begin(), made.end(), number_of(found, ""));
    static constexpr std::string_view kNames[] = {"x", "y", "z", "w", "r", "g", "b", "a"};
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 4); ++i)
        made[i] = number_of(found, kNames[i], number_of(found, kNames[i + 4], made[i]));
    return made;
}

}  // namespace patina::importers::shadergraph

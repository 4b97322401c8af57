#include "compiler/importers/shadergraph/read/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/diagnostics.h"
#include "compiler/importers/shadergraph/read/misreads.h"

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
    std::unique_ptr<Json> tree = json::parse_json(*sources_, begin, diagnostics, json::JsonOf::OtherProgram);
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
    Piece piece{.offsets = json::string_offsets(string, *sources_), .string_begin = string.span.begin};
    found->second = parse(string.string, std::move(piece), wrong);
    return found->second;
}

Documents read_documents(const std::string& path, std::string text) {
    Documents made;
    made.path_ = path;
    if (text.size() > json::kMaxJsonBytes) {
        made.error = fmt::format("{}: the file has more than {} MiB", path, json::kMaxJsonBytes >> 20);
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

namespace {

// The member, if there is something of that name. What lies on the way to it must be objects.
const Json* asked_for(const Json* object, std::string_view path, std::string_view wanted, std::string_view taken) {
    std::size_t end = 0;
    while (object && end < path.size()) {
        if (object->kind != Json::Kind::Object) {
            note_misread(*object, end > 0 ? path.substr(0, end - 1) : path, "an object with " + std::string(wanted),
                         taken);
            return nullptr;
        }
        const std::size_t dot = std::min(path.find('.', end), path.size());
        object = object->find(path.substr(end, dot - end));
        end = dot + (dot < path.size());
    }
    return object;
}

// `key`: as a message calls it.
double number_in(const Json* found, std::string_view key, double otherwise, std::string_view wanted = "a number") {
    if (!found) return otherwise;
    if (found->kind == Json::Kind::Bool) return found->boolean ? 1 : 0;
    // A number of a graph must fit a float of 32 bits, also after it was rounded to its shortest text.
    constexpr double kLargest = 3.4e38;
    if (found->kind != Json::Kind::Number || !std::isfinite(found->number)) {
        note_misread(*found, key, wanted, fmt::format("{}", otherwise));
        return otherwise;
    }
    if (std::abs(found->number) <= kLargest) return found->number;
    const double nearest = std::copysign(kLargest, found->number);
    note_misread(*found, key, "a number of 32 bits", fmt::format("{}", nearest));
    return nearest;
}

}  // namespace

std::string_view text_of(const Json* object, std::string_view path) {
    const Json* found = asked_for(object, path, "a text", "none");
    if (!found) return {};
    if (found->kind == Json::Kind::String) return found->string;
    if (found->kind != Json::Kind::Null) note_misread(*found, path, "a text", "none");
    return {};
}

double number_of(const Json* object, std::string_view path, double otherwise) {
    return number_in(asked_for(object, path, "a number", fmt::format("{}", otherwise)), path, otherwise);
}

int whole_of(const Json* object, std::string_view path, int otherwise) {
    const Json* found = asked_for(object, path, "a whole number", fmt::format("{}", otherwise));
    const double number = number_in(found, path, otherwise, "a whole number");
    if (std::abs(number) >= 2147483648.0) {
        note_misread(*found, path, "a whole number of 32 bits", fmt::format("{}", otherwise));
        return otherwise;
    }
    const int whole = static_cast<int>(number);
    if (whole != number) note_misread(*found, path, "a whole number", fmt::format("{}", whole));
    return whole;
}

int whole_in(const Json* object, std::string_view path, int otherwise, int low, int high) {
    const int whole = whole_of(object, path, otherwise);
    if (whole >= low && whole <= high) return whole;
    if (const Json* found = member(object, path))
        note_misread(*found, path, fmt::format("a number from {} to {}", low, high), fmt::format("{}", otherwise));
    return otherwise;
}

int id_of(const Json* object, std::string_view path) {
    const Json* found = member(object, path);
    if (!found) return 0;
    const bool is_whole = found->kind == Json::Kind::Number && std::abs(found->number) < 2147483648.0 &&
                          std::trunc(found->number) == found->number;
    if (!is_whole) note_broken(*found, path, "a whole number of 32 bits");
    return is_whole ? static_cast<int>(found->number) : 0;
}

bool flag_of(const Json* object, std::string_view path, bool otherwise) {
    const std::string_view taken = otherwise ? "true" : "false";
    const Json* found = asked_for(object, path, "true or false", taken);
    if (!found) return otherwise;
    if (found->kind == Json::Kind::Bool) return found->boolean;
    if (found->kind == Json::Kind::Number) return found->number != 0;
    note_misread(*found, path, "true or false", taken);
    return otherwise;
}

const std::vector<Json>& elements_of(const Json* object, std::string_view path) {
    static const std::vector<Json> kNone;
    const Json* found = asked_for(object, path, "a list", "an empty one");
    if (!found) return kNone;
    if (found->kind == Json::Kind::Array) return found->elements;
    if (found->kind == Json::Kind::Null) return kNone;
    note_broken(*found, path, "a list");
    note_misread(*found, path, "a list", "an empty one");
    return kNone;
}

std::vector<double> vector_of(const Json* object, std::string_view path, std::size_t count) {
    const Json* found = asked_for(object, path, "a vector", "0");
    std::vector<double> made(count, 0.0);
    if (!found) return made;
    if (found->kind == Json::Kind::Number) std::fill(made.begin(), made.end(), number_in(found, path, 0));
    if (found->kind == Json::Kind::Number) return made;
    if (found->kind != Json::Kind::Object) {
        note_misread(*found, path, "a vector", "0");
        return made;
    }
    static constexpr std::string_view kNames[] = {"x", "y", "z", "w", "r", "g", "b", "a"};
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 4); ++i) {
        const std::string_view name = found->find(kNames[i]) ? kNames[i] : kNames[i + 4];
        made[i] = number_in(found->find(name), fmt::format("{}{}{}", path, path.empty() ? "" : ".", name), 0);
    }
    return made;
}

}  // namespace patina::importers::shadergraph

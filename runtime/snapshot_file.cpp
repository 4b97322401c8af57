#include "runtime/snapshot_file.h"

#include <fmt/format.h>
#include <rapidjson/error/en.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <vector>

namespace patina::runtime {
namespace {

constexpr std::uintmax_t kLargestFile = 1 << 20;  // bytes
constexpr std::string_view kEnding = ".snapshot.json";

// One value of the file, with the keys that lead to it: "mesh", "set/_Roughness". Elements of an array are entries with
// the same path, and an empty array is one entry of its own.
struct Entry {
    enum class Kind { Text, Number, Bool, EmptyArray } kind = Kind::Text;
    std::string path;
    std::string text;     // a string's content, a number as written, true or false
    std::size_t key = 0;  // offset of the key that it stands at
    bool in_array = false;
};

// Flattens the file as the parser walks it.
struct Flattener : rapidjson::BaseReaderHandler<rapidjson::UTF8<>, Flattener> {
    struct Level {
        std::string prefix;  // of the paths within: "" or "set/"
        bool is_array = false;
    };
    const rapidjson::StringStream& stream;
    std::vector<Level> levels{};
    std::vector<Entry> entries{};
    std::string path{};
    std::size_t key = 0;
    std::set<std::string> seen{};
    std::string error{};  // stops the parser, at `key`

    explicit Flattener(const rapidjson::StringStream& from) : stream(from) {}

    bool fail(std::string why) {
        error = std::move(why);
        return false;
    }
    bool add(Entry::Kind kind, std::string value) {
        if (levels.empty()) return fail("a snapshot is an object: { \"patina\": 1, ... }");
        entries.push_back(
            {.kind = kind, .path = path, .text = std::move(value), .key = key, .in_array = levels.back().is_array});
        return true;
    }

    bool Null() { return fail("null means nothing here: leave the key out"); }
    bool Bool(bool value) { return add(Entry::Kind::Bool, value ? "true" : "false"); }
    bool RawNumber(const char* digits, rapidjson::SizeType length, bool) {
        return add(Entry::Kind::Number, std::string(digits, length));
    }
    bool String(const char* characters, rapidjson::SizeType length, bool) {
        return add(Entry::Kind::Text, std::string(characters, length));
    }
    bool Key(const char* characters, rapidjson::SizeType length, bool) {
        key = stream.Tell();  // of the opening quote: the reader parses strings in a copy of the stream
        path = levels.back().prefix + std::string(characters, length);
        return seen.insert(path).second || fail("'" + path + "' is here twice");
    }
    bool StartObject() {
        if (levels.size() >= 2 || (!levels.empty() && levels.back().is_array))
            return fail("an object cannot stand here");
        levels.push_back({.prefix = levels.empty() ? "" : path + "/"});
        return true;
    }
    bool EndObject(rapidjson::SizeType) {
        levels.pop_back();
        return true;
    }
    bool StartArray() {
        if (levels.empty() || levels.back().is_array) return fail("an array cannot stand here");
        levels.push_back({.prefix = levels.back().prefix, .is_array = true});
        return true;
    }
    bool EndArray(rapidjson::SizeType count) {
        levels.pop_back();
        return count > 0 || add(Entry::Kind::EmptyArray, "");
    }
};

std::string place(const std::string& path, std::string_view text, std::size_t offset) {
    std::string_view before = text.substr(0, offset);
    auto line = std::count(before.begin(), before.end(), '\n') + 1;
    std::size_t newline = before.rfind('\n');
    std::size_t column = newline == before.npos ? offset + 1 : offset - newline;
    return fmt::format("{}:{}:{}: ", path, line, column);
}

// --- what the keys mean

struct TextKey {
    std::string_view path;
    std::string RenderRequest::*member;
};
constexpr TextKey kTextKeys[] = {
    {"graph", &RenderRequest::graph},     {"mesh", &RenderRequest::mesh},    {"camera", &RenderRequest::camera},
    {"ambient", &RenderRequest::ambient}, {"node", &RenderRequest::preview}, {"via", &RenderRequest::via},
    {"pass", &RenderRequest::pass},
};
struct WholeKey {
    std::string_view path;
    int RenderRequest::*member;
    int highest;
};
constexpr WholeKey kWholeKeys[] = {{"size", &RenderRequest::size, 4096}, {"samples", &RenderRequest::samples, 16}};
struct ToleranceKey {
    std::string_view path;
    double Tolerance::*member;
};
constexpr ToleranceKey kToleranceKeys[] = {{"tolerance/pixel", &Tolerance::pixel},
                                           {"tolerance/share", &Tolerance::share},
                                           {"tolerance/average", &Tolerance::average}};

template <class Table>
auto* find_key(const Table& table, std::string_view path) {
    auto found = std::find_if(std::begin(table), std::end(table), [&](const auto& key) { return key.path == path; });
    return found == std::end(table) ? nullptr : found;
}

std::string unknown_key(const std::string& path) {
    std::string known = "patina";
    for (const TextKey& key : kTextKeys) known += ", " + std::string(key.path);
    for (const WholeKey& key : kWholeKeys) known += ", " + std::string(key.path);
    if (path.starts_with("tolerance/"))
        return "unknown key '" + path.substr(10) + "'; there are: pixel, share, average";
    return "unknown key '" + path + "'; there are: " + known + ", time, lights, set, tolerance";
}

bool read_number(const Entry& entry, double& value) {
    const char* end = entry.text.data() + entry.text.size();
    auto [next, error] = std::from_chars(entry.text.data(), end, value);
    return entry.kind == Entry::Kind::Number && error == std::errc{} && next == end && std::isfinite(value);
}

// A property's value, in the words of the command line; the numbers of an array are joined with commas.
std::string add_override(const Entry& entry, const std::filesystem::path& folder, RenderRequest& request) {
    if (entry.kind == Entry::Kind::EmptyArray) return "an empty array is no value";
    if (entry.in_array && entry.kind != Entry::Kind::Number) return "an array here holds numbers only";
    std::string name = entry.path.substr(std::string_view("set/").size());
    std::string value = entry.text;
    std::error_code ignored;
    if (entry.kind == Entry::Kind::Text && std::filesystem::is_regular_file(folder / value, ignored))
        value = (folder / value).string();
    std::string& target = request.overrides[name];
    target += (target.empty() ? "" : ",") + value;
    return "";
}

// Empty, or what is wrong with the entry.
std::string apply(const Entry& entry, const std::filesystem::path& folder, SnapshotFile& file) {
    RenderRequest& request = file.request;
    if (entry.path == "lights") {
        if (entry.kind == Entry::Kind::EmptyArray) request.lights = {"none"};
        if (entry.kind == Entry::Kind::Text) request.lights.push_back(entry.text);
        bool good = entry.kind == Entry::Kind::EmptyArray || entry.kind == Entry::Kind::Text;
        return good ? "" : "a light is a text, like \"point position=1,2,0 range=5\"";
    }
    if (entry.path.starts_with("set/")) return add_override(entry, folder, request);
    if (entry.in_array || entry.kind == Entry::Kind::EmptyArray) return "an array cannot stand here";
    if (entry.path == "$schema") return "";

    if (const TextKey* key = find_key(kTextKeys, entry.path)) {
        if (entry.kind == Entry::Kind::Bool) return "'" + entry.path + "' must be a text";
        request.*key->member = entry.text;
        return "";
    }
    double value = 0;
    bool is_number = read_number(entry, value);
    if (entry.path == "patina") return is_number && value == 1 ? "" : "this reads version 1: \"patina\": 1";
    if (entry.path == "time") {
        request.time = value;
        return is_number ? "" : "'time' must be a number of seconds";
    }
    if (const WholeKey* key = find_key(kWholeKeys, entry.path)) {
        if (!is_number || value != std::floor(value) || value < 1 || value > key->highest)
            return fmt::format("'{}' must be a whole number from 1 to {}", key->path, key->highest);
        request.*key->member = int(value);
        return "";
    }
    if (const ToleranceKey* key = find_key(kToleranceKeys, entry.path)) {
        if (!is_number || value < 0 || value > 1) return fmt::format("'{}' must be between 0 and 1", key->path);
        file.tolerance.*key->member = value;
        return "";
    }
    return unknown_key(entry.path);
}

Outcome<std::string> read_text(const std::string& path) {
    std::error_code error;
    std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) return Failure{path + ": cannot be read: " + error.message()};
    if (size > kLargestFile) return Failure{fmt::format("{}: has {} bytes, too many for a snapshot", path, size)};
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    if (!file.good() && !file.eof()) return Failure{path + ": cannot be read"};
    return text;
}

}  // namespace

Outcome<SnapshotFile> read_snapshot(const std::string& path) {
    Outcome<std::string> text = read_text(path);
    if (!text) return Failure{text.error};
    rapidjson::StringStream stream(text.value.c_str());
    Flattener flat(stream);
    // Iterative, so that nesting cannot overflow the stack.
    constexpr unsigned kFlags = rapidjson::kParseIterativeFlag | rapidjson::kParseCommentsFlag |
                                rapidjson::kParseTrailingCommasFlag | rapidjson::kParseNumbersAsStringsFlag |
                                rapidjson::kParseValidateEncodingFlag;
    rapidjson::Reader reader;
    rapidjson::ParseResult parsed = reader.Parse<kFlags>(stream, flat);
    if (!flat.error.empty()) return Failure{place(path, text.value, flat.key) + flat.error};
    if (!parsed)
        return Failure{place(path, text.value, parsed.Offset()) +
                       "broken JSON: " + rapidjson::GetParseError_En(parsed.Code())};

    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    SnapshotFile file{.request = {.size = 128, .samples = 2}};
    for (const Entry& entry : flat.entries)
        if (std::string error = apply(entry, folder, file); !error.empty())
            return Failure{place(path, text.value, entry.key) + error};
    if (!flat.seen.contains("patina")) return Failure{place(path, text.value, 0) + "the key \"patina\": 1 is missing"};

    std::string stem = std::filesystem::path(path).filename().string();
    if (stem.ends_with(kEnding)) stem.resize(stem.size() - kEnding.size());
    std::string& graph = file.request.graph;
    graph = (folder / (graph.empty() ? stem + ".graph.json" : graph)).string();
    return file;
}

}  // namespace patina::runtime

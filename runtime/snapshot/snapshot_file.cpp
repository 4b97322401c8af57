#include "runtime/snapshot/snapshot_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <vector>

#include "compiler/api/report.h"
#include "compiler/base/disk/disk.h"
#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "patina/complaints.h"
#include "patina/scene.h"
#include "runtime/gltf/gltf_model.h"
#include "runtime/mesh/mesh.h"
#include "runtime/scene/scene_text.h"

namespace patina::runtime {
namespace {

using json::Json;

constexpr std::uintmax_t kLargestFile = 1 << 20;  // bytes

// What is wrong, for a diagnostic. No message: nothing.
struct Problem {
    std::string message{};
    std::string_view code = code_of(Complaint::BadSnapshot);
    std::string hint{};

    explicit operator bool() const { return !message.empty(); }
};

// One value of the file, with the keys that lead to it: "mesh", "set/_Roughness". Elements of an array are entries with
// the same path, and an empty array is one entry of its own.
struct Entry {
    enum class Kind { Text, Number, Bool, EmptyArray } kind = Kind::Text;
    std::string path{};
    std::string text{};  // a string's content, a number as written, true or false
    Span key{};          // that it stands at
    bool in_array = false;
};

// The values of a file, in its order.
struct Flattener {
    const SourceMap& sources;
    std::vector<Entry> entries{};
    Problem problem{};  // of the value at `key`, which is the last one
    Span key{};

    bool fail(std::string why) {
        problem = {.message = std::move(why)};
        return false;
    }
    bool add(const std::string& path, const Json& json, bool in_array) {
        if (path.empty()) return fail("a snapshot is an object: { \"patina\": 1, ... }");
        Entry& entry = entries.emplace_back(Entry{.path = path, .key = key, .in_array = in_array});
        if (json.kind == Json::Kind::String) {
            entry.text = json.string;
        } else {
            entry.kind = json.kind == Json::Kind::Number ? Entry::Kind::Number : Entry::Kind::Bool;
            entry.text = sources.text(json.span);
        }
        return true;
    }
    // `path`: empty for the whole file.
    bool take(const std::string& path, const Json& json, bool in_array = false) {
        switch (json.kind) {
            case Json::Kind::Null: return fail("null is not allowed here: leave the key out");
            case Json::Kind::Bool:
            case Json::Kind::Number:
            case Json::Kind::String: return add(path, json, in_array);
            case Json::Kind::Array:
                if (path.empty() || in_array) return fail("an array is not allowed here");
                if (json.elements.empty())
                    entries.push_back({.kind = Entry::Kind::EmptyArray, .path = path, .key = key});
                return std::ranges::all_of(json.elements, [&](const Json& each) { return take(path, each, true); });
            case Json::Kind::Object:
                if (in_array || path.find('/') != path.npos) return fail("an object is not allowed here");
                return std::ranges::all_of(json.members, [&](const json::JsonMember& member) {
                    key = member.key_span;
                    return take(path.empty() ? member.key : path + "/" + member.key, member.value);
                });
        }
        return true;
    }
};

Diagnostic unreadable(const std::string& path, const std::string& why) {
    Diagnostic diagnostic = complaint(Complaint::CannotRead, {path, why});
    diagnostic.file = path;
    return diagnostic;
}

// --- what the keys mean

struct TextKey {
    std::string_view path;
    std::string& (*text)(RenderRequest&);
};
constexpr TextKey kTextKeys[] = {
    {"graph", [](RenderRequest& request) -> std::string& { return request.graph; }},
    {"mesh", [](RenderRequest& request) -> std::string& { return request.mesh; }},
    {"ambient", [](RenderRequest& request) -> std::string& { return request.ambient; }},
    {"background", [](RenderRequest& request) -> std::string& { return request.background; }},
    {"node", [](RenderRequest& request) -> std::string& { return request.options.preview; }},
    {"object", [](RenderRequest& request) -> std::string& { return request.object; }},
    {"material", [](RenderRequest& request) -> std::string& { return request.material; }},
    {"via", [](RenderRequest& request) -> std::string& { return request.options.via; }},
};
struct WholeKey {
    std::string_view path;
    int RenderRequest::*member;
    int lowest, highest;
};
constexpr WholeKey kWholeKeys[] = {{"size", &RenderRequest::size, 1, 8192},
                                   {"samples", &RenderRequest::samples, 1, 16},
                                   {"segments", &RenderRequest::segments, kLeastSegments, kMostSegments}};
constexpr std::string_view kCameraKeys[] = {"position", "target", "up", "fov", "orthographic", "near", "far"};

// Keys whose value is an object, and what one looks like.
struct ObjectKey {
    std::string_view path, example;
};
constexpr ObjectKey kObjectKeys[] = {{"camera", R"({ "position": [2, 1, 3], "fov": 40 })"},
                                     {"environment", R"({ "file": "sunset.hdr", "rotation": 90 })"},
                                     {"set", R"({ "_Roughness": 0.2 })"},
                                     {"sweep", R"({ "_Roughness": [0, 0.5, 1] })"},
                                     {"tolerance", R"({ "pixel": 0.01 })"}};

template <class Table>
auto* find_key(const Table& table, std::string_view path) {
    auto found = std::find_if(std::begin(table), std::end(table), [&](const auto& key) { return key.path == path; });
    return found == std::end(table) ? nullptr : found;
}

Problem unknown_key(const std::string& path) {
    std::vector<std::string> known = {"patina", "time", "lights", "lighting", "path", "text"};
    for (const TextKey& key : kTextKeys) known.emplace_back(key.path);
    for (const WholeKey& key : kWholeKeys) known.emplace_back(key.path);
    for (const ObjectKey& key : kObjectKeys) known.emplace_back(key.path);
    const std::size_t slash = path.find('/');
    const std::string key = slash == path.npos ? path : path.substr(slash + 1);
    std::string_view place = "a snapshot";
    if (path.starts_with("tolerance/")) {
        place = "a tolerance";
        known.clear();
        for (const ToleranceKey& each : tolerance_keys()) known.emplace_back(each.name);
    } else if (path.starts_with("camera/")) {
        place = "a camera";
        known.assign(std::begin(kCameraKeys), std::end(kCameraKeys));
    } else if (path.starts_with("environment/")) {
        place = "an environment";
        known = {"file", "rotation", "intensity"};
    }
    return {.message = fmt::format("unknown key '{}' in {}", key, place),
            .code = "unknown-key",
            .hint = suggestion(key, known)};
}

bool read_number(const Entry& entry, double& value) {
    const char* end = entry.text.data() + entry.text.size();
    auto [next, error] = std::from_chars(entry.text.data(), end, value);
    return entry.kind == Entry::Kind::Number && error == std::errc{} && next == end && std::isfinite(value);
}

Problem wrong_unless(bool good, std::string message) {
    return good ? Problem{} : Problem{std::move(message)};
}

// A property's value, in the words of the command line.
std::string value_of(const Entry& entry, const std::filesystem::path& folder) {
    const bool is_file = entry.kind == Entry::Kind::Text && is_on_disk((folder / entry.text).string());
    return is_file ? (folder / entry.text).string() : entry.text;
}

// The numbers of an array are joined with commas.
Problem add_override(const Entry& entry, const std::filesystem::path& folder, RenderRequest& request) {
    if (entry.kind == Entry::Kind::EmptyArray) return {"an empty array is not a value"};
    if (entry.in_array && entry.kind != Entry::Kind::Number) return {"an array here holds numbers only"};
    std::string& target = request.overrides[entry.path.substr(std::string_view("set/").size())];
    target += (target.empty() ? "" : ",") + value_of(entry, folder);
    return {};
}

Problem too_many(const SnapshotFile& file) {
    std::size_t count = std::max<std::size_t>(file.paths.size(), 1);
    for (const PropertySweep& sweep : file.sweeps) count *= sweep.values.size();
    return wrong_unless(count <= kMostVariations, fmt::format("a snapshot has at most {} pictures", kMostVariations));
}

Problem add_to_sweep(const Entry& entry, const std::filesystem::path& folder, SnapshotFile& file) {
    const std::string name = entry.path.substr(std::string_view("sweep/").size());
    if (!entry.in_array) return {"'" + name + "' of a sweep is an array of values, such as [0, 0.5, 1]"};
    if (file.sweeps.empty() || file.sweeps.back().property != name) file.sweeps.push_back({.property = name});
    std::vector<std::string>& values = file.sweeps.back().values;
    const std::string value = value_of(entry, folder);
    if (std::ranges::find(values, value) != values.end()) return {"the value '" + entry.text + "' appears twice"};
    values.push_back(value);
    return too_many(file);
}

// A path by its name, or a file.
Problem add_path(const Entry& entry, const std::filesystem::path& folder, SnapshotFile& file) {
    if (entry.kind != Entry::Kind::Text || entry.text.empty())
        return {R"('path' is the name of a rendering path, or a list of names: ["forward", "deferred"])"};
    const std::string path = entry.text.ends_with(".hlsl") ? (folder / entry.text).string() : entry.text;
    if (std::ranges::find(file.paths, path) != file.paths.end()) return {"the path '" + entry.text + "' appears twice"};
    if (entry.in_array) file.paths.push_back(path);
    if (!entry.in_array || file.paths.size() == 1) file.request.options.path = path;
    return too_many(file);
}

// The camera in the words of the command line: "position=2,1,3 fov=40".
Problem add_to_camera(const Entry& entry, RenderRequest& request) {
    const std::string name = entry.path.substr(std::string_view("camera/").size());
    if (std::ranges::find(kCameraKeys, name) == std::end(kCameraKeys)) return unknown_key(entry.path);
    if (entry.kind != Entry::Kind::Number)
        return {"'" + name + "' of a camera is a number, or a list of three: [2, 1, 3]"};
    const std::string word = name + "=";
    const bool continues = entry.in_array && request.camera.find(word) != std::string::npos;
    request.camera += continues ? "," : (request.camera.empty() ? "" : " ") + word;
    request.camera += entry.text;
    return {};
}

// A picture of the surroundings, studio or none, alone or with its settings, in the words of the command line.
Problem add_to_environment(const Entry& entry, const std::filesystem::path& folder, RenderRequest& request) {
    const bool is_alone = entry.path == "environment";
    const std::string name = is_alone ? "file" : entry.path.substr(std::string_view("environment/").size());
    if (name == "file") {
        if (entry.kind != Entry::Kind::Text || entry.text.empty() || entry.in_array)
            return {R"('environment' is a picture, such as "sunset.hdr", studio or none; or an object, such as )" +
                    std::string(find_key(kObjectKeys, "environment")->example)};
        const bool is_word = is_alone && (entry.text == "studio" || entry.text == "none");
        if (!is_word && !is_on_disk((folder / entry.text).string()))
            return {.message = "there is no file '" + (folder / entry.text).string() + "'", .code = "cannot-read"};
        request.environment = (is_word ? entry.text : (folder / entry.text).string()) + request.environment;
        return {};
    }
    if (name != "rotation" && name != "intensity") return unknown_key(entry.path);
    double value = 0;
    const double lowest = name == "rotation" ? -kMostDegrees : 0;
    const double highest = name == "rotation" ? kMostDegrees : kMostIntensity;
    if (entry.in_array || !read_number(entry, value) || value < lowest || value > highest)
        return {fmt::format("'{}' of an environment is a number from {} to {}", name, lowest, highest)};
    request.environment += " " + name + "=" + entry.text;
    return {};
}

// Keys that need each other, or exclude each other; the place is that of the entry that is one too many.
std::pair<Problem, Span> check_surroundings(const std::vector<Entry>& entries) {
    const auto find = [&](auto is_wanted) { return std::find_if(entries.begin(), entries.end(), is_wanted); };
    const auto around =
        find([](const Entry& e) { return e.path == "environment" || e.path.starts_with("environment/"); });
    const auto file = find([](const Entry& e) { return e.path == "environment" || e.path == "environment/file"; });
    const auto ambient = find([](const Entry& e) { return e.path == "ambient"; });
    if (around != entries.end() && file == entries.end())
        return {{"an environment needs 'file', the picture of the surroundings"}, around->key};
    if (around != entries.end() && ambient != entries.end())
        return {{"'environment' and 'ambient' exclude each other: leave one out"}, std::max(around, ambient)->key};
    return {};
}

// A model of the library, or a lighting graph next to the snapshot.
Problem take_lighting(const Entry& entry, const std::filesystem::path& folder, RenderRequest& request) {
    if (entry.kind != Entry::Kind::Text || entry.text.empty() || entry.in_array)
        return {"'lighting' is a lighting model, or the file of a lighting graph"};
    request.options.lighting = !entry.text.ends_with(".json")
                                   ? entry.text
                                   : std::filesystem::absolute(folder / entry.text).lexically_normal().string();
    return {};
}

Problem apply(const Entry& entry, const std::filesystem::path& folder, SnapshotFile& file) {
    RenderRequest& request = file.request;
    if (entry.path == "lights") {
        if (entry.kind == Entry::Kind::EmptyArray) request.lights = {"none"};
        if (entry.kind == Entry::Kind::Text) request.lights.push_back(entry.text);
        bool good = entry.kind == Entry::Kind::EmptyArray || entry.kind == Entry::Kind::Text;
        return wrong_unless(good, "a light is a text, like \"point position=1,2,0 range=5\"");
    }
    if (entry.path.starts_with("set/")) return add_override(entry, folder, request);
    if (entry.path.starts_with("sweep/")) return add_to_sweep(entry, folder, file);
    if (entry.path.starts_with("camera/")) return add_to_camera(entry, request);
    if (entry.path == "path") return add_path(entry, folder, file);
    if (entry.path == "lighting") return take_lighting(entry, folder, request);
    if (entry.path == "environment" || entry.path.starts_with("environment/"))
        return add_to_environment(entry, folder, request);
    if (const ObjectKey* key = find_key(kObjectKeys, entry.path))
        return {fmt::format("'{}' must be an object, such as {}", key->path, key->example)};
    if (entry.in_array || entry.kind == Entry::Kind::EmptyArray) return {"an array is not allowed here"};
    if (entry.path == "$schema") return {};
    if (entry.path == "text") {
        file.text = entry.text == "true";
        return wrong_unless(entry.kind == Entry::Kind::Bool, "'text' is true or false");
    }

    if (const TextKey* key = find_key(kTextKeys, entry.path)) {
        if (entry.kind == Entry::Kind::Bool) return {"'" + entry.path + "' must be a text"};
        key->text(request) = entry.text;
        return {};
    }
    double value = 0;
    bool is_number = read_number(entry, value);
    if (entry.path == "patina") return wrong_unless(is_number && value == 1, "this reads version 1: \"patina\": 1");
    if (entry.path == "time") {
        request.time = value;
        return wrong_unless(is_number && is_time(value), "'time' must be a number of seconds that a float can hold");
    }
    if (const WholeKey* key = find_key(kWholeKeys, entry.path)) {
        if (!is_number || value != std::floor(value) || value < key->lowest || value > key->highest)
            return {fmt::format("'{}' must be a whole number from {} to {}", key->path, key->lowest, key->highest)};
        request.*key->member = int(value);
        return {};
    }
    constexpr std::string_view kTolerance = "tolerance/";
    if (!entry.path.starts_with(kTolerance)) return unknown_key(entry.path);
    const ToleranceKey* key = find_tolerance_key(std::string_view(entry.path).substr(kTolerance.size()));
    if (!key) return unknown_key(entry.path);
    if (!is_number) return {fmt::format("'{}' must be a number", key->name)};
    file.tolerance.*key->member = value;
    return wrong_unless(check_tolerance(*key, value).empty(), check_tolerance(*key, value));
}

// Words that rendering would refuse without knowing their location.
Problem check_words(const Entry& entry) {
    constexpr std::array<std::string_view, 3> kVia = {"glsl", "hlsl", "cpu"};
    if (entry.path == "via" && std::ranges::find(kVia, entry.text) == kVia.end())
        return {.message = "'via' is glsl, hlsl or cpu, not '" + entry.text + "'", .code = "unknown-word"};
    const std::vector<std::string> meshes(mesh_names().begin(), mesh_names().end());
    if (entry.path == "mesh" && !is_model_name(entry.text) && std::ranges::find(meshes, entry.text) == meshes.end())
        return {.message = "there is no mesh '" + entry.text + "'",
                .code = "unknown-name",
                .hint = suggestion(entry.text, meshes)};
    if (entry.path == "ambient") return {parse_ambient(entry.text).error};
    if (entry.path == "background") return {parse_background(entry.text).error};
    if (entry.path == "lights" && entry.kind == Entry::Kind::Text) return {parse_light(entry.text).error};
    return {};
}

// The mistake in the camera's numbers, and the entry that has it.
std::pair<Problem, Span> check_camera(const std::vector<Entry>& entries, const std::string& words) {
    const std::string error = words.empty() ? std::string() : parse_camera(words, Camera{}).error;
    std::pair<Problem, Span> found{Problem{error}, {}};
    for (const Entry& entry : entries) {
        const bool is_first = found.second.end == 0;
        if (!entry.path.starts_with("camera/")) continue;
        const bool is_named =
            error.find(": " + entry.path.substr(std::string_view("camera/").size()) + " ") != error.npos;
        if (is_first || is_named) found.second = entry.key;
    }
    return found;
}

// NAME.graph.json, or the scene if there is no such graph.
std::string default_graph(const std::filesystem::path& folder, const std::string& stem) {
    std::error_code ignored;
    const std::string graph = stem + ".graph.json", scene = stem + ".scene.json";
    const auto is_there = [&](const std::string& name) { return std::filesystem::exists(folder / name, ignored); };
    return !is_there(graph) && is_there(scene) ? scene : graph;
}

// The text, or why there is none.
Outcome<std::string> read_text(const std::string& path) {
    // A link with this name may lead to any file, which messages would quote.
    if (!without_links(path).ends_with(".json")) return Failure{"it is a link to a file that is no snapshot"};
    DiskFile file = read_disk(path, kLargestFile);
    if (file.bytes) return std::move(*file.bytes);
    if (file.is_too_large) return Failure{fmt::format("it has {} bytes, too many for a snapshot", file.size)};
    return Failure{file.why.empty() ? "No such file or directory" : file.why};
}

}  // namespace

ReadSnapshot read_snapshot(const std::string& path) {
    Outcome<std::string> text = read_text(path);
    if (!text) return {.file = {}, .error = unreadable(path, text.error)};
    SourceMap sources;
    Diagnostics diagnostics;
    const std::uint32_t begin = sources.add_view(path, text.value);
    const std::unique_ptr<Json> json = json::parse_json(sources, begin, diagnostics);
    if (diagnostics.has_errors()) return {.file = {}, .error = to_public(diagnostics, sources).front()};
    const auto wrong = [&](const Problem& problem, Span key) {
        const FileLocation place = format::place_of(sources, key ? key : Span{begin, begin});
        ReadSnapshot read{.file = {}, .error = diagnostic_at(place, std::string(problem.code), problem.message)};
        if (!problem.hint.empty()) {
            Diagnostic& note = read.error.notes.emplace_back();
            note.severity = Severity::Note;
            note.message = problem.hint;
        }
        return read;
    };
    Flattener flat{.sources = sources};
    if (!flat.take("", *json)) return wrong(flat.problem, flat.key);

    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    SnapshotFile file{.request = default_request()};
    for (const Entry& entry : flat.entries) {
        if (Problem problem = apply(entry, folder, file)) return wrong(problem, entry.key);
        if (Problem problem = check_words(entry)) return wrong(problem, entry.key);
    }
    if (const auto [problem, place] = check_camera(flat.entries, file.request.camera); problem)
        return wrong(problem, place);
    if (const auto [problem, place] = check_surroundings(flat.entries); problem) return wrong(problem, place);
    if (!json->find("patina")) return wrong({.message = "the key \"patina\": 1 is missing", .code = "missing-key"}, {});

    std::string stem = std::filesystem::path(path).filename().string();
    if (stem.ends_with(kSnapshotEnding)) stem.resize(stem.size() - kSnapshotEnding.size());
    RenderRequest& request = file.request;
    if (request.graph.empty()) request.graph = default_graph(folder, stem);
    request.graph = (folder / request.graph).string();
    if (is_model_name(request.mesh)) request.mesh = (folder / request.mesh).string();
    ReadSnapshot read{.file = std::move(file), .error = {}};
    for (const Entry& entry : flat.entries) read.places[entry.path] = format::place_of(sources, entry.key);
    return read;
}

namespace {

// A part of a file's name that stands for `value`.
std::string file_word(std::string_view value) {
    std::string word = std::filesystem::path(value).filename().string();
    for (char& c : word)
        if (!std::isalnum(static_cast<unsigned char>(c)) &&
            std::string_view("._-+,=").find(c) == std::string_view::npos)
            c = '_';
    return word;
}

}  // namespace

RenderRequest default_request() {
    return {.size = 128, .samples = 2};
}

std::vector<Variation> variations(const SnapshotFile& file) {
    std::vector<Variation> made;
    if (file.paths.empty()) made.push_back({.request = file.request});
    for (const std::string& path : file.paths) {
        const std::string name = file_word(path);
        Variation& each =
            made.emplace_back(Variation{.name = name.substr(0, name.find('.', 1)), .request = file.request});
        each.request.options.path = path;
    }
    for (const PropertySweep& sweep : file.sweeps) {
        std::vector<Variation> more;
        for (const Variation& each : made) {
            for (const std::string& value : sweep.values) {
                Variation& next = more.emplace_back(each);
                next.name += (next.name.empty() ? "" : ".") + file_word(sweep.property) + "=" + file_word(value);
                next.request.overrides[sweep.property] = value;
            }
        }
        made = std::move(more);
    }
    return made;
}

}  // namespace patina::runtime

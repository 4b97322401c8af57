// Objects of a glTF file's JSON, read so that no property is dropped silently: whatever gets no remark from its reader
// is reported as left out by rest().
//
//   Report report(path, sources);
//   Object material(report, &json, "materials[2]");
//   Object coat = material.extension("KHR_materials_clearcoat");
//   if (const auto factor = coat.number("clearcoatFactor", 0, 1)) coat.taken("clearcoatFactor", "the input
//   'clearcoat'"); coat.rest();
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/importer.h"
#include "compiler/json/json.h"

namespace patina::importers::gltf {

using json::Json;

// What the importer found, in the order in which it was found.
class Report {
public:
    // `sources`: null if the JSON lies in a binary file, whose lines say nothing.
    Report(std::string path, const SourceMap* sources) : path_(std::move(path)), sources_(sources) {}

    void add(Remark::Kind kind, const std::string& part, std::string text, const Json* at);
    // The first one is kept.
    void wrong(const std::string& part, const std::string& what, const Json* at);

    std::vector<Remark> remarks;
    std::string error;  // "chair.gltf:12:5: materials[2].alphaMode: ..."

private:
    std::string path_;
    const SourceMap* sources_;
};

class Object {
public:
    // `json`: null if the file does not have the object; then nothing in it is stated.
    Object(Report& report, const Json* json, std::string path);

    explicit operator bool() const { return json_ != nullptr; }
    bool has(std::string_view key) const { return json_ && json_->find(key); }
    const std::string& path() const { return path_; }
    const Json* json() const { return json_; }

    // Values; nothing if they are not stated. A number outside of low to high is moved into the range, with a remark.
    // Another type is an error.
    std::optional<double> number(std::string_view key, double low, double high);
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count, double low, double high);
    std::optional<bool> flag(std::string_view key);
    std::optional<std::string> word(std::string_view key);
    // Of the list `list`, which has `count` elements.
    std::optional<std::size_t> index(std::string_view key, std::string_view list, std::size_t count);

    // Objects inside; each reports its own properties.
    Object child(std::string_view key);
    Object extension(std::string_view name);

    void taken(std::string_view key, std::string text);
    void changed(std::string_view key, std::string text);
    void left_out(std::string_view key, std::string why);
    // The same for all of its properties that have no remark yet, and for those of its objects.
    void all_taken(const std::string& text);
    // Remarks on it are elsewhere.
    void skip(std::string_view key) { said_.emplace(key); }
    // Reports what is left as left out.
    void rest();

private:
    std::string part(std::string_view key) const;
    const Json* find(std::string_view key, Json::Kind kind, std::string_view what);
    void say(Remark::Kind kind, std::string_view key, std::string text);
    double within(std::string_view key, const Json& json, double low, double high);

    Report* report_;
    const Json* json_;
    std::string path_;
    std::set<std::string, std::less<>> said_{};        // keys that have a remark
    std::set<std::string, std::less<>> extensions_{};  // names of those that were asked for
};

}  // namespace patina::importers::gltf

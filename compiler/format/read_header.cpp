#include <algorithm>

#include "compiler/format/read_fields.h"

namespace patina::format {
namespace {

// "a graph", or the one kind that is allowed.
std::string_view describe(std::span<const ObjectKind> allowed) {
    return allowed.size() == 1 ? describe(allowed.front()) : "a graph";
}

bool check_version(Reading& reading, const json::Json& json, std::string_view what) {
    const json::Json* version = json.find("patina");
    if (!version) {
        reading.diagnostics.report(Code::MissingKey, opening(json), what, "patina")
            .note("add \"patina\": 1, the version of the graph format");
        return true;  // the rest is read all the same
    }
    if (version->kind != json::Json::Kind::Number) {
        report_type(reading, *version, "'patina'", "the number 1");
        return true;
    }
    if (version->number == 1) return true;
    reading.diagnostics.report(Code::UnknownVersion, version->span, json::shown(reading.sources.text(version->span)));
    return false;
}

std::optional<ObjectKind> check_kind(Reading& reading, const json::Json& json, std::span<const ObjectKind> allowed) {
    const json::Json* word = json.find("kind");
    ObjectKind kind = ObjectKind::Material;
    if (word) {
        const std::optional<ObjectKind> known = read_word<ObjectKind>(reading, *word, "kind", "a kind of graph");
        if (!known) return std::nullopt;
        kind = *known;
    }
    if (std::find(allowed.begin(), allowed.end(), kind) != allowed.end()) return kind;
    DiagnosticRecord& record = reading.diagnostics.report(Code::WrongJsonType, word ? word->span : opening(json),
                                                          "this file", describe(allowed), describe(kind));
    if (!word) record.note(fmt::format("\"kind\": \"{}\" is missing", to_string(allowed.front())));
    if (kind == ObjectKind::Scene) {
        // Its file's name is what the commands know a scene by.
        const bool is_named = reading.sources.resolve(json.span.begin).file.ends_with(".scene.json");
        record.note(
            fmt::format("use 'patina render' to draw a scene and 'patina check' to check it with its "
                        "materials{}",
                        is_named ? "" : "; name its file NAME.scene.json"));
    }
    return std::nullopt;
}

}  // namespace

std::optional<ObjectKind> read_header(Reading& reading, const json::Json& json, std::span<const ObjectKind> allowed) {
    const std::string_view what = allowed.front() == ObjectKind::Scene ? describe(ObjectKind::Scene) : "a graph";
    if (!expect(reading, json, json::Json::Kind::Object, what) || !check_version(reading, json, what))
        return std::nullopt;
    return check_kind(reading, json, allowed);
}

}  // namespace patina::format

#include "compiler/format/read_fields.h"

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/format/read_graph.h"

namespace patina::format {
namespace {

// Nobody reads more errors than this, and a hostile file may have a million.
constexpr std::size_t kEnough = 100;

constexpr std::size_t kMostLetters = 1000;  // of a name: messages repeat it
constexpr std::size_t kMostPorts = 1024;    // of a node, a surface or the outputs of a graph

// Words of other programs that have no counterpart, and why.
constexpr std::string_view kVirtualTexture =
    "a virtual texture needs an engine that streams its tiles: use a texture2d for each of its layers";
constexpr std::pair<std::string_view, std::string_view> kRefused[] = {{"virtualtexture", kVirtualTexture},
                                                                      {"virtualtexturestack", kVirtualTexture},
                                                                      {"texturestack", kVirtualTexture},
                                                                      {"proceduralvirtualtexture", kVirtualTexture}};

// In small letters, without '_' and '-'.
std::string plain_word(std::string_view word) {
    std::string plain;
    for (const char c : word) {
        if (c != '_' && c != '-') plain += to_lower(c);
    }
    return plain;
}

}  // namespace

const json::JsonMember* find_member(const json::Json& object, std::string_view key) {
    for (const json::JsonMember& member : object.members) {
        if (member.key == key) return &member;
    }
    return nullptr;
}

void report_type(Reading& reading, const json::Json& json, std::string_view what, std::string_view wanted) {
    std::string found(describe(json.kind));
    if (json.kind == json::Json::Kind::Number) found = json::shown(reading.sources.text(json.span));
    if (json.kind == json::Json::Kind::Bool) found = json.boolean ? "true" : "false";
    if (json.kind == json::Json::Kind::Array)
        found = json.elements.empty() ? "an empty array" : fmt::format("an array of {}", json.elements.size());
    const bool is_container = json.kind == json::Json::Kind::Array || json.kind == json::Json::Kind::Object;
    reading.diagnostics.report(Code::WrongJsonType, is_container ? opening(json) : json.span, what, wanted, found);
}

bool expect(Reading& reading, const json::Json& json, json::Json::Kind kind, std::string_view what) {
    if (json.kind == kind) return true;
    report_type(reading, json, what, describe(kind));
    return false;
}

const std::string* read_string(Reading& reading, const json::Json& json, std::string_view what) {
    return expect(reading, json, json::Json::Kind::String, what) ? &json.string : nullptr;
}

std::optional<bool> read_bool(Reading& reading, const json::Json& json, std::string_view what) {
    if (!expect(reading, json, json::Json::Kind::Bool, what)) return std::nullopt;
    return json.boolean;
}

std::optional<double> read_float(Reading& reading, const json::Json& json, std::string_view what) {
    if (!expect(reading, json, json::Json::Kind::Number, what)) return std::nullopt;
    if (std::fabs(json.number) <= FLT_MAX) return json.number;
    reading.diagnostics.report(Code::BadNumber, json.span, json::shown(reading.sources.text(json.span)),
                               "32-bit float");
    return std::nullopt;
}

std::optional<int> read_int(Reading& reading, const json::Json& json, std::string_view what, int low, int high) {
    if (json.kind != json::Json::Kind::Number || json.number != std::trunc(json.number)) {
        report_type(reading, json, what, "a whole number");
        return std::nullopt;
    }
    if (json.number >= low && json.number <= high) return static_cast<int>(json.number);
    const std::string text = json::shown(reading.sources.text(json.span));
    if (low == INT_MIN && high == INT_MAX) {
        reading.diagnostics.report(Code::BadNumber, json.span, text, "32-bit int");
    } else {
        std::string_view name = what;
        if (name.starts_with('\'') && name.size() > 2) name = name.substr(1, name.size() - 2);
        reading.diagnostics.report(Code::OutOfRange, json.span, text, low, high, name);
    }
    return std::nullopt;
}

std::optional<int> read_int(Reading& reading, const json::Json& json, std::string_view what, const Form& form) {
    return read_int(reading, json, what, static_cast<int>(form.low), static_cast<int>(form.high));
}

void read_int(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key, int& target) {
    if (const json::Json* json = object.find(key))
        target =
            read_int(reading, *json, fmt::format("'{}'", key), form_of(kind, key, Form::Of::Integer)).value_or(target);
}

void read_bool(Reading& reading, const json::Json& object, std::string_view key, bool& target) {
    if (const json::Json* json = object.find(key))
        target = read_bool(reading, *json, fmt::format("'{}'", key)).value_or(target);
}

std::string read_text(Reading& reading, const json::Json& object, std::string_view key) {
    const json::Json* json = object.find(key);
    if (!json) return {};
    const std::string* text = read_string(reading, *json, fmt::format("'{}'", key));
    return text ? *text : std::string();
}

std::string read_identifier(Reading& reading, const json::Json& json, std::string_view what) {
    const std::string* text = read_string(reading, json, what);
    if (!text) return {};
    if (text->size() > kMostLetters) {
        reading.diagnostics.report(Code::TooMany, inside(json.span), text->size(), "letters of a name", kMostLetters);
        return {};
    }
    if (!is_identifier(*text)) reading.diagnostics.report(Code::BadIdentifier, inside(json.span), json::shown(*text));
    return *text;
}

void suggest(Reading& reading, DiagnosticRecord& record, std::string_view word,
             std::span<const std::string_view> words) {
    if (reading.diagnostics.error_count() > kEnough) return;
    for (const auto& [refused, reason] : kRefused) {
        if (plain_word(word) == refused) return static_cast<void>(record.note(std::string(reason)));
    }
    if (std::string advice = Diagnostics::suggestion(word, words); !advice.empty()) record.note(std::move(advice));
}

std::string_view meant_by(std::string_view word, std::span<const std::string_view> known) {
    const std::string plain = plain_word(word);
    for (const Synonym& synonym : kSynonyms) {
        if (synonym.theirs == plain && std::find(known.begin(), known.end(), synonym.ours) != known.end())
            return synonym.ours;
    }
    return word;
}

void check_keys(Reading& reading, const json::Json& object, ObjectKind kind, std::span<const std::string_view> unfit) {
    static constexpr std::array kFiles = {ObjectKind::Material, ObjectKind::Subgraph, ObjectKind::Lighting,
                                          ObjectKind::Workflow, ObjectKind::Scene};
    const bool is_file = std::find(kFiles.begin(), kFiles.end(), kind) != kFiles.end();
    for (const KeyInfo& key : keys_of(kind)) {
        if (key.required && !object.find(key.name)) {
            reading.diagnostics.report(Code::MissingKey, opening(object), describe(kind), key.name);
        }
    }
    std::size_t unknown = 0;
    for (const json::JsonMember& member : object.members) {
        if (find_key(kind, member.key)) continue;
        if (++unknown > kEnough) return;
        DiagnosticRecord& record =
            reading.diagnostics.report(Code::UnknownKey, member.key_span, json::shown(member.key), describe(kind));
        const auto owner = std::find_if(kFiles.begin(), kFiles.end(),
                                        [&](ObjectKind file) { return is_file && find_key(file, member.key); });
        if (owner != kFiles.end()) {
            record.note(fmt::format("'{}' belongs to {}", member.key, describe(*owner)));
            continue;
        }
        std::vector<std::string_view> names;
        for (const KeyInfo& key : keys_of(kind)) {
            if (std::find(unfit.begin(), unfit.end(), key.name) == unfit.end()) names.push_back(key.name);
        }
        suggest(reading, record, member.key, names);
    }
}

void refuse_key(Reading& reading, const json::Json& object, std::string_view key, std::string_view what,
                std::string_view owner) {
    const json::JsonMember* member = find_member(object, key);
    if (!member) return;
    reading.diagnostics.report(Code::UnknownKey, member->key_span, key, what)
        .note(fmt::format("'{}' belongs to {}", key, owner));
}

void check_range(Reading& reading, Span span, double value, const std::array<double, 2>& range, bool hard,
                 std::string_view name) {
    if (value >= range[0] && value <= range[1]) return;
    reading.diagnostics.report(hard ? Code::OutOfRange : Code::SoftRange, span, shortest(value), shortest(range[0]),
                               shortest(range[1]), json::shown(name));
}

void UniqueNames::add(Reading& reading, const json::Json& name, std::string_view what) {
    const auto [first, added] = first_.emplace(name.string, inside(name.span));
    if (added) return;
    reading.diagnostics.report(Code::DuplicateId, inside(name.span), what, json::shown(name.string))
        .note(first->second, "the first one is here");
}

namespace {

std::optional<std::array<double, 2>> read_range(Reading& reading, const json::Json& json) {
    if (json.kind != json::Json::Kind::Array || json.elements.size() != 2) {
        report_type(reading, json, "'range'", "an array of two numbers");
        return std::nullopt;
    }
    const std::optional<double> low = read_float(reading, json.elements[0], "the lower end of 'range'");
    const std::optional<double> high = read_float(reading, json.elements[1], "the upper end of 'range'");
    if (!low || !high) return std::nullopt;
    if (*low <= *high) return std::array{*low, *high};
    reading.diagnostics.report(Code::WrongJsonType, json.span, "'range'", "two numbers, the lower one first",
                               fmt::format("[{}, {}]", shortest(*low), shortest(*high)));
    return std::nullopt;
}

}  // namespace

void read_limits(Reading& reading, const json::Json& json, std::optional<std::array<double, 2>>& range, bool& hard) {
    if (const json::Json* limits = json.find("range")) range = read_range(reading, *limits);
    const json::JsonMember* member = find_member(json, "hard");
    if (!member) return;
    read_bool(reading, json, "hard", hard);
    if (!json.find("range")) reading.diagnostics.report(Code::MissingKey, member->key_span, "'hard'", "range");
}

// Reads the name with its location, and adds it to the names that `$` reads.
void read_name(Reading& reading, const json::Json& json, std::string_view what, std::string& name, Span& span,
               UniqueNames& names) {
    const json::Json* value = json.find("name");
    if (!value) return;
    name = read_identifier(reading, *value, "'name'");
    span = value->kind == json::Json::Kind::String ? inside(value->span) : value->span;
    if (value->kind == json::Json::Kind::String) names.add(reading, *value, what);
}

std::vector<PortValue> read_ports(Reading& reading, const json::Json& object, std::string_view what,
                                  std::string_view node) {
    std::vector<PortValue> ports;
    if (!expect(reading, object, json::Json::Kind::Object, what)) return ports;
    if (object.members.size() > kMostPorts) {
        reading.diagnostics.report(Code::TooMany, object.members[kMostPorts].key_span, object.members.size(),
                                   fmt::format("keys of {}", what), kMostPorts);
        return ports;
    }
    ports.reserve(object.members.size());
    for (const json::JsonMember& member : object.members) {
        reading.diagnostics.set_context(node, member.key);
        ports.push_back({.name = member.key,
                         .name_span = member.key_span,
                         .value_span = member.value.span,
                         .value = read_value(member.value, reading.sources, reading.ast, reading.diagnostics)});
    }
    reading.diagnostics.set_context(node, {});
    return ports;
}

}  // namespace patina::format

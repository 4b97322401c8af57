// Functions for all readers of a graph's parts: each reads one JSON value and reports its errors. Private to
// compiler/format/read_*.cpp.
//
//   read_word(reading, json, "wrap", "a wrap mode", sampler.wrap);
//   read_int(reading, json, ObjectKind::Sampler, "anisotropy", sampler.anisotropy);
#pragma once

#include <optional>
#include <span>
#include <unordered_map>

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "compiler/format/words.h"
#include "compiler/json/json.h"

namespace patina::format {

// What every reader needs.
struct Reading {
    const SourceMap& sources;
    nodelang::Ast& ast;
    Diagnostics& diagnostics;
};

// Names that must be unique. The JSON tree must outlive it.
class UniqueNames {
public:
    // Reports a name that was added before.
    void add(Reading& reading, const json::Json& name, std::string_view what);

private:
    std::unordered_map<std::string_view, Span> first_;
};

// The text between the quotes.
inline Span inside(Span quoted) {
    return {quoted.begin + 1, quoted.end - 1};
}
// The opening bracket of an object or array: the place for an error about something that is missing in it.
inline Span opening(const json::Json& json) {
    return {json.span.begin, json.span.begin + 1};
}
const json::JsonMember* find_member(const json::Json& object, std::string_view key);

// These functions report a value of another type; `what` names the value in the message: "'default'".
bool expect(Reading& reading, const json::Json& json, json::Json::Kind kind, std::string_view what);
void report_type(Reading& reading, const json::Json& json, std::string_view what, std::string_view wanted);
// Null after an error.
const std::string* read_string(Reading& reading, const json::Json& json, std::string_view what);
std::optional<bool> read_bool(Reading& reading, const json::Json& json, std::string_view what);
// A number that a 32-bit float holds.
std::optional<double> read_float(Reading& reading, const json::Json& json, std::string_view what);
// A whole number from `low` to `high`.
std::optional<int> read_int(Reading& reading, const json::Json& json, std::string_view what, int low, int high);
std::optional<int> read_int(Reading& reading, const json::Json& json, std::string_view what, const Form& form);
// These read the value of a key of an object. `target` stays as it is if the key is absent or its value is wrong. The
// limits of a number are those of the table of keys.
void read_int(Reading& reading, const json::Json& object, ObjectKind kind, std::string_view key, int& target);
void read_bool(Reading& reading, const json::Json& object, std::string_view key, bool& target);
// The text at a key; empty if the key is absent.
std::string read_text(Reading& reading, const json::Json& object, std::string_view key);
// Reports a text that is not an identifier. Empty if the value is not a string.
std::string read_identifier(Reading& reading, const json::Json& json, std::string_view what);

// Reads the "name" of a property or an input with its location, and adds it to the names that `$` reads.
void read_name(Reading& reading, const json::Json& object, std::string_view what, std::string& name, Span& span,
               UniqueNames& names);
// "range" and "hard".
void read_limits(Reading& reading, const json::Json& object, std::optional<std::array<double, 2>>& range, bool& hard);

// Reports each key that an object of this kind cannot have, and each required key that is missing. The keys in `unfit`
// are not suggested, because they have no use in this place.
void check_keys(Reading& reading, const json::Json& object, ObjectKind kind,
                std::span<const std::string_view> unfit = {});
// Reports a key of the format that `what` cannot use, because it belongs to `owner`.
void refuse_key(Reading& reading, const json::Json& object, std::string_view key, std::string_view what,
                std::string_view owner);
// Adds the note "did you mean", or the list of words.
void suggest(Reading& reading, DiagnosticRecord& record, std::string_view word,
             std::span<const std::string_view> words);
// Reports a default outside its range: as an error if the range is hard, else as a warning.
void check_range(Reading& reading, Span span, double value, const std::array<double, 2>& range, bool hard,
                 std::string_view name);

// The keys of a property that is a texture: "usage", "sampler" and so on (read_texture_keys.cpp).
void read_texture_keys(Reading& reading, const json::Json& json, Property& property);
// Reads the name of a sampler: the value of a property of the type sampler, or a sampler that textures share.
void read_named_sampler(Reading& reading, const json::Json& json, Property& property);

// The numbers of a value that is more than a vector (read_keys.cpp). A gradient or a curve has the numbers of its array
// in the node library's struct; a matrix has its numbers row by row. Nothing after an error.
std::optional<std::vector<double>> read_array_value(Reading& reading, const json::Json& json, PropertyType type);
// The type that fits the form of the value; nothing if no type fits.
std::optional<PropertyType> array_type(const json::Json& json);
bool has_rows(const json::Json& json);
// Of a property without a default: the unit matrix; from black to white, opaque; a line from (0, 0) to (1, 1).
std::vector<double> implied_array_value(PropertyType type);

// The word in `known` of which `word` is a synonym, or `word` itself.
std::string_view meant_by(std::string_view word, std::span<const std::string_view> known);

// The value of a word of `E`; nothing after an error.
template <HasWords E>
std::optional<E> read_word(Reading& reading, const json::Json& json, std::string_view key, std::string_view what) {
    const std::string* text = read_string(reading, json, fmt::format("'{}'", key));
    if (!text) return std::nullopt;
    if (const std::optional<E> known = from_word<E>(*text)) return known;
    constexpr auto kTexts = texts<E>();
    suggest(reading, reading.diagnostics.report(Code::UnknownWord, inside(json.span), json::shown(*text), what),
            meant_by(*text, kTexts), kTexts);
    return std::nullopt;
}

// The same for a key of an object, as read_int(). Returns the value; null if the key is absent.
template <HasWords E>
const json::Json* read_word(Reading& reading, const json::Json& object, std::string_view key, std::string_view what,
                            E& target) {
    const json::Json* json = object.find(key);
    if (json) target = read_word<E>(reading, *json, key, what).value_or(target);
    return json;
}

// --- the readers of the parts
// Reads the top of every file: its version and its kind, which must be one of `allowed`. Nothing if an error leaves no
// file to read.
std::optional<ObjectKind> read_header(Reading& reading, const json::Json& json, std::span<const ObjectKind> allowed);
std::vector<PortValue> read_ports(Reading& reading, const json::Json& object, std::string_view what,
                                  std::string_view node);
std::vector<Node> read_nodes(Reading& reading, const json::Json& array);
RenderState read_render(Reading& reading, const json::Json& json);
// `names` collects the names that this graph can read as $name.
std::vector<Property> read_properties(Reading& reading, const json::Json& array, UniqueNames& names);
std::vector<Input> read_inputs(Reading& reading, const json::Json& array, UniqueNames& names, bool of_workflow);
// Reads the text of an expression, without its leading '='. Null after an error.
const nodelang::Expr* read_expression(Reading& reading, const json::Json& json, std::size_t skip);

}  // namespace patina::format

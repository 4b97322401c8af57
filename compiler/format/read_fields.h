// What the readers of a graph's parts share: one look at a JSON value that also says what is wrong with it. Private to
// compiler/format/read_*.cpp.
//
//   if (const Json* json = object.find("wrap")) {
//       sampler.wrap = read_word<Wrap>(reading, *json, "wrap", "a wrap mode").value_or(Wrap::Repeat);
//   }
#pragma once

#include <optional>
#include <span>
#include <unordered_map>

#include "compiler/base/diagnostics.h"
#include "compiler/format/graph.h"
#include "compiler/format/keys.h"
#include "compiler/format/words.h"
#include "compiler/json/json.h"

namespace patina::graph {

// What every reader needs.
struct Reading {
    const SourceMap& sources;
    nodelang::Ast& ast;
    Diagnostics& diagnostics;
};

// Names that must differ from each other. The JSON tree must outlive it.
class UniqueNames {
public:
    // Reports the second thing of a name.
    void add(Reading& reading, const Json& name, std::string_view what);

private:
    std::unordered_map<std::string_view, Span> first_;
};

// The text between the quotes.
inline Span inside(Span quoted) {
    return {quoted.begin + 1, quoted.end - 1};
}
// An object's or array's opening bracket: where to say that something is missing in it.
inline Span opening(const Json& json) {
    return {json.span.begin, json.span.begin + 1};
}
const JsonMember* find_member(const Json& object, std::string_view key);

// These report when the value is of another type; `what` names it in the message: "'default'".
bool expect(Reading& reading, const Json& json, Json::Kind kind, std::string_view what);
void report_type(Reading& reading, const Json& json, std::string_view what, std::string_view wanted);
// Null after an error.
const std::string* read_string(Reading& reading, const Json& json, std::string_view what);
std::optional<bool> read_bool(Reading& reading, const Json& json, std::string_view what);
// A number that a 32-bit float holds.
std::optional<double> read_float(Reading& reading, const Json& json, std::string_view what);
// A whole number from `low` to `high`.
std::optional<int> read_int(Reading& reading, const Json& json, std::string_view what, int low, int high);
// The text at a key, empty if it is not there.
std::string read_text(Reading& reading, const Json& object, std::string_view key);
// An identifier, reported if it is not one; empty if it cannot be read at all.
std::string read_identifier(Reading& reading, const Json& json, std::string_view what);

// The "name" of a property or an input and where it is; registers it among the names that `$` reads.
void read_name(Reading& reading, const Json& object, std::string_view what, std::string& name, Span& span,
               UniqueNames& names);
// "range" and "hard".
void read_limits(Reading& reading, const Json& object, std::optional<std::array<double, 2>>& range, bool& hard);

// Complains about each key that an object of this kind does not have, and about each that it needs. Those of `unfit`
// are not offered: they have no use in this place.
void check_keys(Reading& reading, const Json& object, ObjectKind kind, std::span<const std::string_view> unfit = {});
// Complains about a key of the format that `what` has no use for: it belongs to `owner`.
void refuse_key(Reading& reading, const Json& object, std::string_view key, std::string_view what,
                std::string_view owner);
// Notes "did you mean" or the list of words.
void suggest(Reading& reading, DiagnosticRecord& record, std::string_view word,
             std::span<const std::string_view> words);
// A default that is beyond its range: an error if the range is hard, else a warning.
void check_range(Reading& reading, Span span, double value, const std::array<double, 2>& range, bool hard,
                 std::string_view name);

// The word among `known` that others call `word`, or `word` itself.
std::string_view meant_by(std::string_view word, std::span<const std::string_view> known);

// The value of a word of `E`; nothing after an error.
template <HasWords E>
std::optional<E> read_word(Reading& reading, const Json& json, std::string_view key, std::string_view what) {
    const std::string* text = read_string(reading, json, fmt::format("'{}'", key));
    if (!text) return std::nullopt;
    if (const std::optional<E> known = from_word<E>(*text)) return known;
    constexpr auto kTexts = texts<E>();
    suggest(reading, reading.diagnostics.report(Code::UnknownWord, inside(json.span), shown(*text), what),
            meant_by(*text, kTexts), kTexts);
    return std::nullopt;
}

// --- the readers of the parts
// What stands at the top of every file: its version, and its kind, which must be one of `allowed`. Nothing after an
// error that leaves no file to read.
std::optional<ObjectKind> read_header(Reading& reading, const Json& json, std::span<const ObjectKind> allowed);
std::vector<PortValue> read_ports(Reading& reading, const Json& object, std::string_view what, std::string_view node);
std::vector<Node> read_nodes(Reading& reading, const Json& array);
RenderState read_render(Reading& reading, const Json& json);
// `names` holds what may be read as $name in this graph.
std::vector<Property> read_properties(Reading& reading, const Json& array, UniqueNames& names);
std::vector<Input> read_inputs(Reading& reading, const Json& array, UniqueNames& names, bool of_workflow);
// The text of an expression, without its leading '='. Null after an error.
const nodelang::Expr* read_expression(Reading& reading, const Json& json, std::size_t skip);

}  // namespace patina::graph

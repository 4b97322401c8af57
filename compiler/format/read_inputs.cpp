#include <algorithm>

#include "compiler/format/read_fields.h"
#include "compiler/format/read_graph.h"

namespace patina::format {
namespace {

// Each use of a sub-graph searches for each of them among the values that it sets.
constexpr std::size_t kMostInputs = 256;

using nodelang::Expr;

void read_type(Reading& reading, const json::Json& json, Input& input) {
    const json::Json* type = json.find("type");
    if (!type) return;
    const std::string* text = read_string(reading, *type, "'type'");
    if (!text) return;
    input.type = *text;
    input.type_span = inside(type->span);
    if (std::find(kInputTypes.begin(), kInputTypes.end(), *text) != kInputTypes.end()) return;
    suggest(reading,
            reading.diagnostics.report(Code::UnknownWord, input.type_span, json::shown(*text), "the type of an input"),
            *text, kInputTypes);
}

// Checks literals only; computed values are checked when their types are known.
void check_default_range(Reading& reading, const Input& input) {
    if (!input.value || !input.range) return;
    const auto check = [&](const Expr& number) {
        check_range(reading, number.span, number.number, *input.range, input.hard, input.name);
    };
    if (input.value->kind == Expr::Kind::Number) check(*input.value);
    if (input.value->kind == Expr::Kind::List) {
        for (const Expr* component : input.value->args) check(*component);
    }
}

// Reads "gives" and "as", which need each other: this input is an alternative to the input in "gives".
void read_conversion(Reading& reading, const json::Json& json, Input& input) {
    const json::JsonMember* gives = find_member(json, "gives");
    const json::JsonMember* as = find_member(json, "as");
    if (gives && !as) reading.diagnostics.report(Code::MissingKey, gives->key_span, "'gives'", "as");
    if (as && !gives) reading.diagnostics.report(Code::MissingKey, as->key_span, "'as'", "gives");
    if (!gives || !as) return;
    input.gives = read_identifier(reading, gives->value, "'gives'");
    const std::string* text = read_string(reading, as->value, "'as'");
    if (!text) return;
    reading.diagnostics.set_context({}, input.name);
    if (text->starts_with('=')) {
        input.as = read_expression(reading, as->value, 1);
    } else {
        reading.diagnostics.report(Code::Syntax, inside(as->value.span), "an expression that starts with '='",
                                   fmt::format("'{}'", json::shown(*text)));
    }
    reading.diagnostics.set_context({}, {});
}

constexpr std::array<std::string_view, 2> kConversion = {"gives", "as"};

void refuse_conversion(Reading& reading, const json::Json& json) {
    for (const std::string_view key : kConversion) {
        if (const json::JsonMember* member = find_member(json, key)) {
            reading.diagnostics.report(Code::UnknownKey, member->key_span, key, describe(ObjectKind::Input))
                .note(fmt::format("'{}' belongs to the inputs of a workflow", key));
        }
    }
}

Input read_input(Reading& reading, const json::Json& json, UniqueNames& names, bool of_workflow) {
    Input input;
    check_keys(reading, json, ObjectKind::Input, std::span(kConversion).first(of_workflow ? 0 : kConversion.size()));
    read_name(reading, json, "input", input.name, input.name_span, names);
    read_type(reading, json, input);
    read_limits(reading, json, input.range, input.hard);
    if (const json::Json* value = json.find("default")) {
        input.default_span = value->span;
        reading.diagnostics.set_context({}, input.name);
        input.value = read_value(*value, reading.sources, reading.ast, reading.diagnostics);
        reading.diagnostics.set_context({}, {});
        check_default_range(reading, input);
    }
    input.help = read_text(reading, json, "help");
    if (of_workflow) {
        read_conversion(reading, json, input);
    } else {
        refuse_conversion(reading, json);
    }
    return input;
}

}  // namespace

std::vector<Input> read_inputs(Reading& reading, const json::Json& array, UniqueNames& names, bool of_workflow) {
    std::vector<Input> inputs;
    if (!expect(reading, array, json::Json::Kind::Array, "a list of inputs")) return inputs;
    if (array.elements.size() > kMostInputs) {
        reading.diagnostics.report(Code::TooMany, array.elements[kMostInputs].span, array.elements.size(), "inputs",
                                   kMostInputs);
        return inputs;
    }
    for (const json::Json& element : array.elements) {
        if (!expect(reading, element, json::Json::Kind::Object, "an input")) continue;
        Input input = read_input(reading, element, names, of_workflow);
        if (!input.name.empty()) inputs.push_back(std::move(input));  // one without a name has been reported
    }
    return inputs;
}

}  // namespace patina::format

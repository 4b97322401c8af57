// Functions of the library that MaterialX has a node for, by the table nodes.def: noise, patterns, adjustments of
// colours.
#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {
namespace {

struct Row {
    std::string_view function, category, inputs, type;
};
constexpr Row kRows[] = {
#define MTLX_NODE(function, category, inputs, type) {#function, category, inputs, type},
#include "compiler/exporters/mtlx/nodes.def"
#undef MTLX_NODE
};

const Row* row_of(std::string_view function) {
    const auto row =
        std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& each) { return each.function == function; });
    return row == std::end(kRows) ? nullptr : row;
}

// "jitter", "texcoord:vector2", "amount*3:vector3", "style:integer=1".
struct Input {
    std::string_view name{}, type{}, number{};
    std::size_t joins = 1;  // parameters, as one vector
};
Input input_of(std::string_view text, std::string_view otherwise) {
    Input made{.type = otherwise};
    const std::size_t equals = text.find('='), colon = text.find(':'), star = text.find('*');
    if (equals != text.npos) made.number = text.substr(equals + 1);
    if (colon != text.npos) made.type = text.substr(colon + 1, equals - colon - 1);
    if (star != text.npos) made.joins = static_cast<std::size_t>(text[star + 1] - '0');
    made.name = text.substr(0, std::min({equals, colon, star}));
    return made;
}

}  // namespace

bool has_node(std::string_view function) {
    return row_of(function) != nullptr;
}

std::optional<Ref> NodeWriter::called(ir::Value value) {
    const Row* const row = row_of(callee(value));
    if (!row) return std::nullopt;
    const auto args = function_.args(value);
    std::vector<Ref> given;
    for (const ir::Value each : args) given.push_back(this->value(each));
    const unsigned width = function_[value].type.width();
    const bool is_color = std::any_of(given.begin(), given.end(), [](const Ref& each) { return each.is_color(); });
    const std::string type = row->type.empty() ? type_word(width, is_color) : std::string(row->type);
    std::vector<Argument> arguments;
    std::vector<std::pair<std::string, std::string>> words;
    std::size_t at = 0;
    for (const std::string_view text : split(row->inputs, " ")) {
        const Input input = input_of(text, type);
        Argument made{.name = std::string(input.name), .type = std::string(input.type)};
        if (input.type == "string") {
            words.emplace_back(input.name, input.number);
            continue;
        }
        if (!input.number.empty()) {
            for (const std::string_view each : split(input.number, ","))
                made.value.numbers.push_back(read_number(each).value_or(0));
        } else if (input.joins > 1) {
            made.value = join({given.begin() + static_cast<std::ptrdiff_t>(at),
                               given.begin() + static_cast<std::ptrdiff_t>(at + input.joins)});
            at += input.joins;
        } else {
            made.value = given[at++];
        }
        const auto whole = input.type == "integer" ? whole_.find(made.value.name) : whole_.end();
        if (whole != whole_.end()) {
            made.value = whole->second;
        } else if (input.type == "integer" && !made.value.is_number()) {
            refuse(value, "a number of octaves that is computed");
            made.value = {.numbers = {3}};
        }
        arguments.push_back(std::move(made));
    }
    current_ = value;
    const Ref made = node(row->category, type, std::move(arguments), std::move(words));
    return width == 1 && width_of(type) > 1 ? component(made, 0) : as(made, type_word(width, made.is_color()));
}

}  // namespace patina::exporters::mtlx

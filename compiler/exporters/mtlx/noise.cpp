// Noise of the library that MaterialX has nodes for, by the table nodes.def.
#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {
namespace {

struct Row {
    std::string_view function, category, inputs, type;
};
constexpr Row kNoises[] = {
#define MTLX_NODE(function, category, inputs, type) {#function, category, inputs, type},
#include "compiler/exporters/mtlx/nodes.def"
#undef MTLX_NODE
};

const Row* row_of(std::string_view function) {
    const auto row = std::find_if(std::begin(kNoises), std::end(kNoises),
                                  [&](const Row& each) { return each.function == function; });
    return row == std::end(kNoises) ? nullptr : row;
}

}  // namespace

bool is_noise(std::string_view function) {
    return row_of(function) != nullptr;
}

std::optional<Ref> NodeWriter::noise(ir::Value value) {
    const Row* const row = row_of(callee(value));
    if (!row) return std::nullopt;
    std::vector<Argument> arguments;
    const auto args = function_.args(value);
    for (const std::string_view name : split(row->inputs, " ")) {
        if (const std::size_t equals = name.find('='); equals != name.npos) {
            const double number = read_number(name.substr(equals + 1)).value_or(0);
            arguments.push_back(
                {.name = std::string(name.substr(0, equals)), .value = {.numbers = {number}}, .type = "integer"});
            continue;
        }
        const ir::Value given = args[arguments.size()];
        Argument made{.name = std::string(name), .value = this->value(given), .type = "float"};
        if (name == "octaves") made.type = "integer";
        if (name == "texcoord" || name == "position") made.type = type_word(function_[given].type.width());
        const auto whole = name == "octaves" ? whole_.find(made.value.name) : whole_.end();
        if (whole != whole_.end()) {
            made.value = whole->second;
        } else if (name == "octaves" && !made.value.is_number()) {
            refuse(value, "a number of octaves that is computed");
            made.value = {.numbers = {3}};
        }
        arguments.push_back(std::move(made));
    }
    current_ = value;
    const std::string type = type_word(function_[value].type.width());
    return as(node(row->category, row->type.empty() ? type : std::string(row->type), std::move(arguments)), type);
}

}  // namespace patina::exporters::mtlx

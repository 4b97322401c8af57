#include "compiler/importers/mtlx/node_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers::mtlx {
namespace {

constexpr TableRow kRows[] = {
#define NODE(category, condition, inputs, outputs, remark) {category, condition, inputs, outputs, remark},
#include "compiler/importers/mtlx/nodes.def"
#undef NODE
};

struct SurfaceRow {
    std::string_view shader, workflow, lighting, inputs, outputs;
};
struct IgnoredRow {
    std::string_view shader, input, otherwise, text;
};
#define IGNORED(shader, input, otherwise, text)
constexpr SurfaceRow kSurfaces[] = {
#define SURFACE(shader, workflow, lighting, inputs, outputs) {shader, workflow, lighting, inputs, outputs},
#include "compiler/importers/mtlx/surfaces.def"
#undef SURFACE
};
#undef IGNORED
#define SURFACE(shader, workflow, lighting, inputs, outputs)
constexpr IgnoredRow kIgnored[] = {
#define IGNORED(shader, input, otherwise, text) {shader, input, otherwise, text},
#include "compiler/importers/mtlx/surfaces.def"
#undef IGNORED
};
#undef SURFACE

std::vector<Port> ports_of(std::string_view inputs) {
    std::vector<Port> made;
    for (const std::string_view part : split(inputs, ";")) {
        const std::string_view text = trimmed(part);
        const std::size_t equals = std::min(text.find('='), text.size()), colon = text.substr(0, equals).find(':');
        Port port{.name = std::string(text.substr(0, std::min(colon, equals)))};
        if (colon != text.npos) port.type = text.substr(colon + 1, equals - colon - 1);
        if (const std::size_t bracket = port.type.find('('); bracket != port.type.npos) {
            port.unit = port.type.substr(bracket + 1, port.type.size() - bracket - 2);
            port.type.resize(bracket);
        }
        if (equals < text.size()) port.otherwise = text.substr(equals + 1);
        made.push_back(std::move(port));
    }
    return made;
}

std::vector<Statement> statements_of(std::string_view outputs, bool is_surface) {
    std::vector<Statement> made;
    for (const std::string_view part : split(outputs, ";")) {
        std::string_view text = trimmed(part);
        Statement statement{.output = "out"};
        if (text.starts_with("$ = ")) {
            statement.output = "$";
            text.remove_prefix(4);
        } else if (const std::size_t colon = text.find(": ");
                   colon != text.npos && text.substr(0, colon).find_first_of(" ({?") == text.npos) {
            std::string_view output = text.substr(0, colon);
            const std::size_t bar = output.find('|');
            if (bar != output.npos) statement.otherwise = output.substr(bar + 1);
            statement.output = output.substr(0, bar);
            text.remove_prefix(colon + 2);
        }
        if (is_surface && text.starts_with('?')) {
            statement.only_if = text.substr(1, text.find(' ') - 1);
            text.remove_prefix(text.find(' ') + 1);
        }
        statement.text = text;
        made.push_back(std::move(statement));
    }
    return made;
}

using Table = std::map<std::string_view, std::vector<NodeRule>>;
const Table& table() {
    static const Table made = [] {
        Table all;
        for (const TableRow& row : kRows)
            all[row.category].push_back({.condition = row.condition,
                                         .inputs = ports_of(row.inputs),
                                         .statements = statements_of(row.outputs, false),
                                         .remark = row.remark});
        return all;
    }();
    return made;
}

const std::map<std::string_view, SurfaceRule>& surfaces() {
    static const std::map<std::string_view, SurfaceRule> made = [] {
        std::map<std::string_view, SurfaceRule> all;
        for (const SurfaceRow& row : kSurfaces)
            all[row.shader] = {
                .workflow = row.workflow,
                .lighting = row.lighting,
                .rule = {.inputs = ports_of(row.inputs), .statements = statements_of(row.outputs, true)}};
        for (const IgnoredRow& row : kIgnored) all[row.shader].ignored.push_back({row.input, row.otherwise, row.text});
        return all;
    }();
    return made;
}

bool is_one_of(std::string_view word, std::string_view alternatives) {
    return std::ranges::any_of(split(alternatives, "|"), [&](std::string_view each) { return each == word; });
}

bool holds(std::string_view condition, const NodeFacts& facts) {
    for (const std::string_view word : split(condition, " ")) {
        if (word.starts_with("set:")) {
            if (facts.type_of(word.substr(4)).empty()) return false;
        } else if (word.starts_with("unset:")) {
            if (!facts.type_of(word.substr(6)).empty()) return false;
        } else {
            const std::size_t equals = word.find('=');
            const std::string_view what = word.substr(0, equals), wanted = word.substr(equals + 1);
            if (what == "type") {
                if (!is_one_of(facts.type, wanted)) return false;
            } else if (what.ends_with(".type")) {
                if (!is_one_of(facts.type_of(what.substr(0, what.size() - 5)), wanted)) return false;
            } else if (!is_one_of(facts.word_of(what), wanted)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

const Port* NodeRule::input(std::string_view name) const {
    const auto found = std::ranges::find(inputs, name, &Port::name);
    return found == inputs.end() ? nullptr : &*found;
}

const NodeRule* rule_of(std::string_view category, const NodeFacts& facts) {
    const auto rules = table().find(category);
    if (rules == table().end()) return nullptr;
    const auto found =
        std::ranges::find_if(rules->second, [&](const NodeRule& rule) { return holds(rule.condition, facts); });
    return found == rules->second.end() ? nullptr : &*found;
}

bool is_in_table(std::string_view category) {
    return table().contains(category);
}

bool reads_input(std::string_view category, std::string_view input) {
    const auto asks = [&](std::string_view word) {
        if (word.starts_with("set:") || word.starts_with("unset:")) return word.substr(word.find(':') + 1) == input;
        return word.substr(0, word.find_first_of(".=")) == input;
    };
    const std::string choice = fmt::format("[{}|", input);
    return std::ranges::any_of(kRows, [&](const TableRow& row) {
        if (row.category != category) return false;
        const std::vector<Port> ports = ports_of(row.inputs);
        return std::ranges::find(ports, input, &Port::name) != ports.end() ||
               std::ranges::any_of(split(row.condition, " "), asks) || row.outputs.find(choice) != row.outputs.npos;
    });
}

std::span<const TableRow> table_rows() {
    return kRows;
}

const SurfaceRule* surface_rule(std::string_view shader) {
    const auto found = surfaces().find(shader);
    return found == surfaces().end() ? nullptr : &found->second;
}

std::vector<std::string_view> surface_shaders() {
    std::vector<std::string_view> made;
    for (const SurfaceRow& row : kSurfaces) made.push_back(row.shader);
    return made;
}

}  // namespace patina::importers::mtlx

#include "compiler/importers/shadergraph/node_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/values/types.h"
#include "compiler/importers/terms.h"

namespace patina::importers::shadergraph {
namespace {

struct Row {
    std::string_view kind, condition, outputs, remark;
};
constexpr Row kRows[] = {
#define NODE(kind, condition, outputs, remark) {kind, condition, outputs, remark},
#include "compiler/importers/shadergraph/nodes.def"
#undef NODE
};

struct InputsRow {
    std::string_view kind, inputs;
};
constexpr InputsRow kInputs[] = {
#define INPUTS(kind, inputs) {kind, inputs},
#include "compiler/importers/shadergraph/inputs.def"
#undef INPUTS
};

int number_in(std::string_view text) {
    int made = 0;
    std::from_chars(text.data(), text.data() + text.size(), made);
    return made;
}

std::vector<Statement> statements_of(std::string_view outputs) {
    std::vector<Statement> made;
    for (const std::string_view each : split(outputs, ";")) {
        const std::string_view text = trimmed(each);
        if (text.starts_with("$ = ")) {
            made.push_back({.text = std::string(text.substr(4))});
        } else {
            const std::size_t colon = text.find(": ");
            made.push_back({.output = number_in(text.substr(0, colon)), .text = std::string(text.substr(colon + 2))});
        }
    }
    return made;
}

using Table = std::map<std::string_view, std::vector<NodeRule>>;
const Table& table() {
    static const Table made = [] {
        Table all;
        for (const Row& row : kRows)
            all[row.kind].push_back(
                {.condition = row.condition, .statements = statements_of(row.outputs), .remark = row.remark});
        return all;
    }();
    return made;
}

// "m_Mode=1,2*": one of the values; the one with a star is that of a file without the setting.
bool is_set(std::string_view name, std::string_view values, const Node& node) {
    const bool is_there = member(node.json, name);
    const int set = whole_of(node.json, name);
    for (std::string_view each : split(values, ",")) {
        const bool is_default = each.ends_with('*');
        if (is_default) each.remove_suffix(1);
        if (is_there ? number_in(each) == set : is_default) return true;
    }
    return false;
}

bool holds(std::string_view condition, const Node& node, const NodeFacts& facts) {
    for (const std::string_view word : split(condition, " ")) {
        const std::size_t mark = word.find_first_of(":<=");
        const std::string_view what = word.substr(0, mark), value = word.substr(mark + 1);
        const bool is_true = word[mark] == '='   ? is_set(what, value, node)
                             : word[mark] == '<' ? node.version < number_in(value)
                             : what == "linked"  ? facts.is_linked(number_in(value))
                             : what == "stage"   ? facts.is_in_fragment
                             : what == "number"  ? facts.components(number_in(value)) == 1
                                                 : facts.is_used(number_in(value));
        if (!is_true) return false;
    }
    return true;
}

// What stands between "<" and ">".
std::string setting(std::string_view text, const Node& node, const NodeFacts& facts) {
    const std::size_t equals = text.find('=');
    const std::string_view otherwise = equals == text.npos ? std::string_view() : text.substr(equals + 1);
    text = text.substr(0, equals);
    if (text.size() > 2 && text[0] >= '2' && text[0] <= '4' && text[1] == ' ') {
        if (member(node.json, text.substr(2)))
            return constant(vector_of(node.json, text.substr(2), static_cast<std::size_t>(text[0] - '0'))).text();
        std::vector<double> numbers;
        for (const std::string_view each : split(otherwise, ",")) numbers.push_back(read_number(each).value_or(0));
        return constant(numbers).text();
    }
    const std::size_t colon = text.find(':');
    if (colon == text.npos) return digits(number_of(node.json, text, read_number(otherwise).value_or(0)));
    const std::size_t count = std::clamp<std::size_t>(facts.components(number_in(text.substr(colon + 1))), 1, 4);
    std::vector<double> flags;
    if (text[0] == '&') {
        const int bits = whole_of(node.json, text.substr(1, colon - 1), -1);
        for (std::size_t i = 0; i < count; ++i) flags.push_back((bits >> i) & 1);
    } else {
        for (const std::string_view each : split(text.substr(0, colon), ","))
            if (flags.size() < count) flags.push_back(flag_of(node.json, each) ? 1 : 0);
    }
    return constant(flags).text();
}

}  // namespace

const NodeRule* rule_of(const Node& node, const NodeFacts& facts) {
    const auto rules = table().find(node.kind);
    if (rules == table().end()) return nullptr;
    const auto found =
        std::ranges::find_if(rules->second, [&](const NodeRule& rule) { return holds(rule.condition, node, facts); });
    return found == rules->second.end() ? nullptr : &*found;
}

std::string_view value_without_slot(std::string_view kind, int slot) {
    const auto row = std::ranges::find(kInputs, kind, &InputsRow::kind);
    if (row == std::end(kInputs)) return {};
    for (const std::string_view each : split(row->inputs, ";")) {
        const std::string_view text = trimmed(each);
        if (number_in(text) == slot) return text.substr(text.find(": ") + 2);
    }
    return {};
}

int newest_version(std::string_view kind) {
    // All others have one version.
    static constexpr std::pair<std::string_view, int> kVersions[] = {
        {"ColorNode", 1},      {"ComputeDeformNode", 1}, {"CustomFunctionNode", 1}, {"GradientNoiseNode", 1},
        {"NoiseNode", 1},      {"NoiseSineWaveNode", 1}, {"PositionNode", 1},       {"LinearBlendSkinningNode", 1},
        {"SampleGradient", 1}, {"SwizzleNode", 1},       {"TransformNode", 2},      {"ViewDirectionNode", 1},
        {"VoronoiNode", 1}};
    const auto found = std::ranges::find_if(kVersions, [&](const auto& each) { return each.first == kind; });
    return found == std::end(kVersions) ? 0 : found->second;
}

bool is_in_table(std::string_view kind) {
    return table().contains(kind);
}

std::string fill_settings(std::string& text, const Node& node, const NodeFacts& facts) {
    for (std::size_t begin; (begin = text.find('[')) != text.npos;) {
        const std::size_t end = text.find(']', begin);
        std::string_view rest = std::string_view(text).substr(begin + 1, end - begin - 1);
        const auto next = [&] {
            const std::size_t bar = std::min(rest.find('|'), rest.size());
            const std::string_view word = rest.substr(0, bar);
            rest.remove_prefix(std::min(bar + 1, rest.size()));
            return word;
        };
        std::string_view name = next();
        const std::size_t equals = name.find('=');
        const int otherwise = equals == name.npos ? 0 : number_in(name.substr(equals + 1));
        name = name.substr(0, equals);
        const int chosen = whole_of(node.json, name, otherwise);
        for (int skipped = 0; skipped < chosen && !rest.empty(); ++skipped) next();
        if (chosen < 0 || rest.empty())
            return fmt::format("its setting '{}' is {}, which this importer does not know", name, chosen);
        text = text.substr(0, begin) + std::string(next()) + text.substr(end + 1);
    }
    for (std::size_t begin = 0; (begin = text.find('<', begin)) != text.npos; ++begin) {
        const char next = begin + 1 < text.size() ? text[begin + 1] : ' ';
        const std::size_t end = text.find('>', begin);
        const bool is_setting = next == '&' || (next >= '2' && next <= '4') || (next >= 'a' && next <= 'z');
        if (!is_setting || end == text.npos) continue;
        text.replace(begin, end - begin + 1,
                     setting(std::string_view(text).substr(begin + 1, end - begin - 1), node, facts));
    }
    return {};
}

}  // namespace patina::importers::shadergraph

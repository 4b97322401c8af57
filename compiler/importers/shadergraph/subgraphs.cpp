// Nodes that are sub-graphs: each sub-graph becomes a file, which all nodes that use it share.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// The slot of the node that gives a value to the input; nothing if the node has none.
const Slot* slot_of(const Node& node, const SubgraphPorts::Input& input) {
    const std::vector<Json>& guids = elements_of(node.json, "m_PropertyGuids");
    const std::vector<Json>& ids = elements_of(node.json, "m_PropertyIds");
    for (std::size_t i = 0; i < std::min(guids.size(), ids.size()); ++i)
        if (guids[i].string == input.guid && !input.guid.empty()) return node.slot(whole_of(&ids[i], ""));
    // The first versions have no lists.
    const auto found = std::ranges::find_if(
        node.slots, [&](const Slot& slot) { return slot.is_input && camel_case(slot.name) == input.name; });
    return guids.empty() && found != node.slots.end() ? &*found : nullptr;
}

// The word that the node chooses; empty: none.
std::string_view chosen_entry(const Node& node, const SubgraphPorts::Input& input) {
    const std::vector<Json>& names = elements_of(node.json, "m_Dropdowns");
    const std::vector<Json>& entries = elements_of(node.json, "m_DropdownSelectedEntries");
    for (std::size_t i = 0; i < std::min(names.size(), entries.size()); ++i)
        if (names[i].string == input.reference) return entries[i].string;
    return {};
}

bool is_default(const SubgraphPorts::Input& input, const Term& term) {
    if (!term.is_constant() || input.numbers.empty()) return false;
    for (std::size_t i = 0; i < input.numbers.size(); ++i)
        if (term.numbers[term.numbers.size() == 1 ? 0 : i] != input.numbers[i]) return false;
    return term.numbers.size() == 1 || term.numbers.size() == input.numbers.size();
}

}  // namespace

void make_subgraph_node(GraphMaker& maker, std::size_t index) {
    const Node& at = maker.node(index);
    const std::string guid = guid_in(text_of(at.json, "m_SerializedSubGraph"));
    const SubgraphPorts& ports = maker.project().subgraph(guid, at.name);
    if (!ports.error.empty()) {
        maker.refuse(index, ports.error);
        return;
    }
    if (!ports.remark.empty()) maker.approximate(index, ports.remark);
    ImportedNode made{.id = {}, .node = ports.file};
    Term holds;
    std::map<std::string_view, Term> textures;  // by the input that takes them
    for (const SubgraphPorts::Input& input : ports.inputs) {
        if (input.is_dropdown) {
            const std::string_view entry = chosen_entry(at, input);
            const auto found = std::ranges::find(input.entries, entry);
            const Term number = number_term(static_cast<double>(found - input.entries.begin()));
            if (found == input.entries.end() && !entry.empty())
                maker.approximate(index, fmt::format("the dropdown '{}' of the sub-graph has no entry '{}': it keeps "
                                                     "its default",
                                                     input.name, entry));
            else if (found != input.entries.end() && !is_default(input, number))
                made.inputs.push_back({input.name, number.value()});
            continue;
        }
        const Slot* slot = slot_of(at, input);
        const bool is_linked = slot && maker.is_linked(index, slot->id);
        if (!input.connected.empty() && is_linked) made.inputs.push_back({input.connected, flag_term(true).value()});
        const bool is_gradient = input.type == Type::Gradient;
        const bool is_sampler = input.type == Type::Sampler;
        if (is_sampler && !is_linked) continue;  // its default
        if (!is_value(input.type) && !is_gradient && !is_sampler && !is_texture(input.type)) {
            if (is_linked)
                maker.approximate(index,
                                  fmt::format("the input '{}' keeps its default, because a sub-graph cannot take {}",
                                              input.name, word(input.type)));
            continue;
        }
        if (!slot) {
            if (!is_texture(input.type)) continue;  // its default
            made.inputs.push_back({input.name, maker.texture_constant(index, input.type, nullptr, "", 0).value()});
            continue;
        }
        std::vector<Term> term = {maker.input(index, slot->id, true)};
        if (!term[0].transform.empty())
            maker.approximate(index,
                              fmt::format("the tiling and the offset of its texture '{}' count here", input.name));
        if (input.type == Type::Texture2D && input.is_normal_map) maker.sample(term[0], TextureMeaning::Normal);
        if (is_gradient && term[0].gradient && term[0].gradient->is_perceptual() != input.is_perceptual)
            maker.approximate(index, fmt::format("the sub-graph blends the gradient '{}' {}", input.name,
                                                 input.is_perceptual ? "in OkLab" : "as a picker shows its colours"));
        if (is_value(input.type)) term[0] = converted(term[0], input.type, true);
        if (is_texture(input.type)) textures[input.name] = term[0];
        maker.shorten(index, term, 0);
        holds.add_nodes(term[0]);
        if (!is_default(input, term[0])) made.inputs.push_back({input.name, term[0].value()});
    }
    const std::string id = maker.add_node(index, std::move(made));
    maker.written(holds, fmt::format("the node '{}'", id));
    for (const SubgraphPorts::Output& output : ports.outputs) {
        if (!maker.is_used(index, output.slot)) continue;
        if (is_value(output.type)) maker.set(index, output.slot, link(id + "." + output.name, output.type));
        if (const auto passed = textures.find(output.passes); passed != textures.end())
            maker.set(index, output.slot, passed->second);
    }
    for (const Slot& slot : at.slots)
        if (!slot.is_input && maker.is_used(index, slot.id) &&
            std::ranges::none_of(ports.outputs, [&](const SubgraphPorts::Output& each) {
                return each.slot == slot.id && (is_value(each.type) || textures.contains(each.passes));
            }))
            maker.approximate(index, fmt::format("the sub-graph has no output '{}' here: it is a constant, or a white "
                                                 "texture",
                                                 slot.name));
}

}  // namespace patina::importers::shadergraph

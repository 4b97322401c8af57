#include "compiler/importers/shadergraph/graph_maker.h"

#include <fmt/format.h>

#include <algorithm>

namespace patina::importers::shadergraph {
namespace {}  // namespace

GraphMaker::GraphMaker(Project& project, const ShaderGraph& graph, std::string name)
    : project_(project), graph_(graph), name_(std::move(name)), file_(name_), dynamic_types_(graph.nodes.size()) {
    // Names that nodes get which do not come from one node.
    for (const char* each : {"uv", "uv1", "uv2", "uv3"}) file_.ids.take(each);
    // A node of such a name would hide the sampler.
    for (const NamedSampler& each : kNamedSamplers) file_.ids.take(std::string(each.name));
    for (const Block& block : graph.blocks)
        if (const std::size_t hash = block.name.find('#'); block.is_vertex && hash != block.name.npos)
            if (std::string& id = interpolators_[block.name.substr(0, hash)]; id.empty())
                id = file_.ids.unique(camel_case(std::string_view(block.name).substr(0, hash)), "interpolator");
}

std::string GraphMaker::make() {
    file_.name = name_;
    for (const ShaderGraph::Problem& problem : graph_.problems)
        remark(problem.is_lost ? Remark::Kind::LeftOut : Remark::Kind::Changed, problem.part, problem.text,
               problem.place);
    read_precision();
    find_order();
    read_blackboard();
    for (const std::size_t node : order_) {
        evaluate(node);
        say_misread(node, take_misreads());
    }
    if (graph_.is_subgraph)
        make_outputs();
    else
        make_surface();
    finish_textures();
    drop_unread();
    make_layout();
    std::string error = refuse_invalid();
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        say_misread(i, node(i).misread);
        if (!node(i).lost.empty() && file_.outcomes[i].kind != Remark::Kind::LeftOut) {
            file_.outcomes[i] = {.kind = Remark::Kind::LeftOut, .text = node(i).lost};
            project_.has_refused = true;
        }
        if (const int newest = newest_version(node(i).kind); node(i).version > newest)
            approximate(i, fmt::format("it is of version {}; {} is the newest that is known: read as that",
                                       node(i).version, newest));
    }
    report_nodes();
    if (const std::string wrong = take_misreads(); !wrong.empty()) remark(Remark::Kind::Changed, "the file", wrong, {});
    return error;
}

// Nodes that an output depends on, each after what it reads. There are no circles.
void GraphMaker::find_order() {
    for (const Edge& edge : graph_.edges) {
        if (!edges_.try_emplace({edge.to, edge.to_slot}, Key{edge.from, edge.from_slot}).second)
            remark(Remark::Kind::Changed, fmt::format("edge to '{}'", node(edge.to).name),
                   fmt::format("a second value for '{}': the first one counts", node(edge.to).slot(edge.to_slot)->name),
                   edge.place);
    }
    std::vector<int> states(graph_.nodes.size(), 0);
    std::vector<std::pair<std::size_t, std::size_t>> path;
    for (const Block& block : graph_.blocks) path.push_back({block.node, 0});
    std::ranges::reverse(path);
    while (!path.empty()) {
        auto& [at, next] = path.back();
        const std::vector<Slot>& slots = node(at).slots;
        if (states[at] == 2 || next == slots.size()) {
            if (states[at] != 2) order_.push_back(at);
            states[at] = 2;
            path.pop_back();
            continue;
        }
        states[at] = 1;
        const auto found = edges_.find({at, slots[next++].id});
        if (found != edges_.end() && states[found->second.first] == 0) path.push_back({found->second.first, 0});
    }
    for (const auto& [to, from] : edges_)
        if (states[to.first] == 2) ++uses_[from];
    in_fragment_ = nodes_of_stage(false);
    in_vertex_ = nodes_of_stage(true);
}

// In the order, what a node reads comes before it.
std::set<std::size_t> GraphMaker::nodes_of_stage(bool is_vertex) const {
    std::set<std::size_t> made;
    for (const Block& block : graph_.blocks)
        if (block.is_vertex == is_vertex) made.insert(block.node);
    for (auto at = order_.rbegin(); at != order_.rend(); ++at)
        for (const Slot& slot : node(*at).slots)
            if (const auto found = edges_.find({*at, slot.id}); found != edges_.end() && made.contains(*at))
                made.insert(found->second.first);
    return made;
}

std::string_view GraphMaker::own_precision(std::size_t index) const {
    constexpr int kSingle = 1, kHalf = 2;
    const int wanted = whole_of(node(index).json, "m_Precision");
    if (wanted == kHalf && !is_half_) return "half";
    return wanted == kSingle && is_half_ ? "float" : "";
}

// Graphs before 2020.3 have another key for it.
void GraphMaker::read_precision() {
    is_half_ = member(graph_.json, "m_GraphPrecision") ? whole_in(graph_.json, "m_GraphPrecision", 1, 0, 2) == 2
                                                       : whole_in(graph_.json, "m_ConcretePrecision", 0, 0, 1) == 1;
    if (!is_half_) return;
    file_.more.push_back({"precision", "half"});
    remark(Remark::Kind::Taken, "setting 'Graph Precision'", "\"precision\": \"half\"", {});
}

std::size_t GraphMaker::uses(std::size_t index, int slot) const {
    const auto found = uses_.find({index, slot});
    return found == uses_.end() ? 0 : found->second;
}

void GraphMaker::say_misread(std::size_t index, std::string misread) {
    if (!misread.empty()) approximate(index, std::move(misread));
}

void GraphMaker::evaluate(std::size_t index) {
    const Node& at = node(index);
    const bool is_output = std::ranges::any_of(graph_.blocks, [&](const Block& block) { return block.node == index; });
    std::vector<Type> connected;
    for (const Slot& slot : at.slots) {
        if (type_of_slot(slot.kind).dynamic == Dynamic::No) continue;
        if (const auto term = slot.is_input ? linked_term(index, slot.id) : std::nullopt)
            connected.push_back(term->type);
    }
    dynamic_types_[index] = {.vector = dynamic_vector(connected), .matrix = dynamic_matrix(connected)};
    if (!at.lost.empty()) {
        refuse(index, at.lost);
        return;
    }
    if (is_output) return;
    if (apply_special(*this, index) || apply_rule(*this, index)) {
        for (const Slot& slot : at.slots)
            if (!slot.is_input && is_used(index, slot.id) && !terms_.contains({index, slot.id}) &&
                file_.outcomes[index].kind == Remark::Kind::Taken)
                approximate(index, fmt::format("its output '{}' is none that this importer knows: it is a constant",
                                               slot.name));
        return;
    }
    refuse(index, is_in_table(at.kind) ? "it has a setting with a value that this importer does not know"
                                       : reason_for_unknown(at));
}

Type GraphMaker::type_of(std::size_t index, const Slot& slot) const {
    const SlotType type = type_of_slot(slot.kind);
    if (type.dynamic == Dynamic::No) return type.type;
    return type.dynamic == Dynamic::Matrix ? dynamic_types_[index].matrix : dynamic_types_[index].vector;
}

std::optional<Term> GraphMaker::linked_term(std::size_t index, int slot) const {
    const auto edge = edges_.find({index, slot});
    if (edge == edges_.end()) return {};
    const auto found = terms_.find(edge->second);
    if (found != terms_.end()) return found->second;
    const Slot* from = node(edge->second.first).slot(edge->second.second);
    return stand_in(from ? type_of(edge->second.first, *from) : Type::Float);
}

Term GraphMaker::input(std::size_t index, int slot_id, bool may_stay_number) {
    const Slot* slot = node(index).slot(slot_id);
    if (!slot) return without_slot(index, slot_id);
    const Type type = type_of(index, *slot);
    if (std::optional<Term> term = linked_term(index, slot_id)) {
        // A value of another group stays there.
        if (term->owner && !term->is_short() && node(*term->owner).group != node(index).group &&
            !node(*term->owner).group.empty())
            term = named(*term);
        Term made = converted(*term, type, may_stay_number);
        if (made.type != Type::None || type == Type::None) return made;
        approximate(index, fmt::format("the input '{}' takes {} and is connected to {}: it has a constant", slot->name,
                                       word(type), word(term->type)));
        return is_texture(type) ? texture_constant(index, type, nullptr, "", 0) : stand_in(type);
    }
    const Json* json = slot->json;
    Term made;
    if (type == Type::Bool) {
        made = flag_term(flag_of(json, "m_Value"));
    } else if (is_matrix(type)) {
        made.type = type;
        const std::size_t rows = width(type);
        for (std::size_t i = 0; i < rows * rows; ++i)
            made.numbers.push_back(
                number_of(json, fmt::format("m_Value.e{}{}", i / rows, i % rows), i % (rows + 1) == 0 ? 1 : 0));
    } else if (is_vector(type)) {
        std::vector<double> values = vector_of(json, "m_Value", width(type));
        if (slot->kind == "DynamicValue")
            for (std::size_t i = 0; i < values.size(); ++i) values[i] = number_of(json, fmt::format("m_Value.e0{}", i));
        if (slot->kind.starts_with("ColorRGB") && whole_of(json, "m_ColorMode") == 0)
            for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), 3); ++i) values[i] = linear(values[i]);
        made = constant(std::move(values));
        made = bound(index, *slot, made);
        const bool is_same = made.is_constant() &&
                             std::ranges::all_of(made.numbers, [&](double each) { return each == made.numbers[0]; });
        if (is_same && may_stay_number && type_of_slot(slot->kind).dynamic != Dynamic::No)
            made = number_term(made.numbers[0]);
        made = converted(made, is_same && may_stay_number ? made.type : type);
    } else if (type == Type::Texture2D) {
        made = texture_constant(index, type, json, "m_Texture", whole_in(json, "m_DefaultType", 0, 0, 5));
    } else if (type == Type::Texture2DArray) {
        made = texture_constant(index, type, json, "m_TextureArray", 0);
    } else if (type == Type::Texture3D) {
        made = texture_constant(index, type, json, "m_Texture", 0);
    } else if (type == Type::Cubemap) {
        made = texture_constant(index, type, json, "m_Cubemap", 0);
    } else if (type == Type::Sampler) {
        return stand_in(type);
    } else if (type == Type::None) {
        approximate(index, fmt::format("the input '{}' is of the class '{}', which this importer does not know: it "
                                       "has a constant",
                                       slot->name, slot->kind));
        return stand_in(type);
    } else {
        made.type = type;
        if (type == Type::Gradient)
            made.gradient = std::make_shared<const Gradient>(gradient_of(member(json, "m_Value")));
    }
    return made;
}

void GraphMaker::set(std::size_t index, int slot, Term term, bool is_handed_on) {
    if (!is_handed_on || !term.owner) term.owner = index;
    term.nodes.insert(index);
    // Only a node of its own can be computed in half.
    const bool wants_name = !own_precision(index).empty() ? !is_handed_on : uses(index, slot) > 1 && !term.is_short();
    if (wants_name && is_value(term.type)) term = named(term);
    terms_[{index, slot}] = std::move(term);
}

Term GraphMaker::named(const Term& term) {
    if (term.is_constant() || term.is_link() || !term.owner) return term;
    return file_.named(
        term, [&] { return name_of_node(*term.owner, {}); }, {*term.owner}, of_precision(*term.owner));
}

std::string GraphMaker::name_of_node(std::size_t index, std::string_view wanted) {
    const Node& from = node(index);
    std::string_view kind = from.kind;
    if (kind.ends_with("Node")) kind.remove_suffix(4);
    return file_.ids.unique(wanted.empty() ? camel_case(from.name) : std::string(wanted), camel_case(kind));
}

GraphMembers GraphMaker::of_precision(std::size_t index) const {
    const std::string_view own = own_precision(index);
    return own.empty() ? GraphMembers() : GraphMembers{{"precision", own}};
}

std::string GraphMaker::add_node(std::size_t index, ImportedNode made, std::string_view wanted) {
    made.id = name_of_node(index, wanted);
    for (GraphMember& each : of_precision(index)) made.more.push_back(std::move(each));
    return file_.add(std::move(made), {index});
}

void GraphMaker::written(const Term& term, std::string_view where) {
    file_.written(term, where);
}

void GraphMaker::taken(std::size_t index, std::string where) {
    file_.taken(index, std::move(where));
}

void GraphMaker::approximate(std::size_t index, std::string difference) {
    file_.approximate(index, difference);
}

// What a refused node reads stays in the graph, for the node that its author puts in its place. In words, by its
// inputs.
std::string GraphMaker::kept_inputs(std::size_t index) {
    std::string made;
    for (const Slot& slot : node(index).slots) {
        if (!slot.is_input || !is_linked(index, slot.id)) continue;
        std::optional<Term> term = linked_term(index, slot.id);
        if (is_value(term->type)) term = named(*term);
        const std::string text = term->text();
        if (text.empty()) continue;
        made += fmt::format("{}{} = {}", made.empty() ? "" : ", ", slot.name, text);
        kept_.push_back(text);
    }
    return made;
}

void GraphMaker::refuse(std::size_t index, std::string reason) {
    project_.has_refused = true;
    const std::string reads = kept_inputs(index);
    const std::string note = "not imported: " + reason + (reads.empty() ? "" : ". It read " + reads);
    for (const Slot& slot : node(index).slots) {
        if (slot.is_input || !is_used(index, slot.id)) continue;
        const Type type = type_of(index, slot);
        Term value = stand_in(type);
        if (is_value(type)) {
            // A node, so that the place is seen in the graph, too.
            const std::string id = add_node(index, {.id = {}, .expression = value.text(), .more = {{"note", note}}});
            file_.types[id] = type;
            value = link(id, type);
        } else if (is_texture(type)) {
            value = texture_constant(index, type, nullptr, "", 0);
        } else {
            if (type != Type::Gradient) value = Term{.type = type};
        }
        set(index, slot.id, value);
    }
    file_.outcomes[index] = {.kind = Remark::Kind::LeftOut, .where = {}, .text = std::move(reason)};
}

std::string GraphMaker::node_file(const std::string& function, const std::string& text) {
    for (const TextFile& each : project_.files)
        if (each.text == text) return each.name;
    return project_.file_names.unique(function, "function") + ".node.hlsl";
}

void GraphMaker::keep_node_file(const std::string& file, const std::string& text) {
    if (std::ranges::find(project_.files, file, &TextFile::name) == project_.files.end())
        project_.files.push_back({.name = file, .text = text});
}

void GraphMaker::remark(Remark::Kind kind, std::string part, std::string text, Place place) {
    if (kind == Remark::Kind::LeftOut) project_.has_refused = true;
    project_.remarks.push_back(
        {.kind = kind, .part = std::move(part), .text = std::move(text), .line = place.line, .column = place.column});
}

}  // namespace patina::importers::shadergraph

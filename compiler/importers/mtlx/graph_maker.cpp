#include "compiler/importers/mtlx/graph_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/importers/mtlx/library.h"
#include "compiler/importers/patterns.h"
#include "compiler/importers/values.h"

namespace patina::importers::mtlx {
namespace {

constexpr std::size_t kDeepest = 120, kMostNodes = 20000;

}  // namespace

GraphMaker::GraphMaker(Import& import, std::string name) : import_(import), name_(std::move(name)), file_(name_) {
    scopes_.push_back(std::make_unique<Scope>(Scope{.element = &import.document.root}));
    count_uses(import.document.root, scopes_.front()->uses);
}

std::size_t GraphMaker::number_of(const Element& node) {
    const auto [found, is_new] = numbers_.try_emplace(&node, elements_.size());
    if (is_new) {
        elements_.push_back(&node);
        file_.outcomes[found->second].label = scope_label_;
    }
    return found->second;
}

const Element& GraphMaker::node_with(Element input, const Element& place) {
    input.category = "input";
    input.attributes.emplace_back("name", "in");
    Element& made = made_.emplace_back(Element{.category = place.category});
    if (place.has("name")) made.attributes.emplace_back("name", std::string(place.name()));
    made.line = place.line;
    made.column = place.column;
    made.children.push_back(std::move(input));
    return made;
}

std::size_t GraphMaker::note(const Element& node) {
    import_.reached.insert(&node);
    return number_of(node);
}

Term GraphMaker::evaluate(Scope& scope, const Element& node, std::string_view output) {
    Key key{scope.number, &node, std::string(output)};
    if (const auto found = values_.find(key); found != values_.end()) return found->second;
    import_.reached.insert(&node);
    const Type type = type_of_word(node.type());
    if (!open_.insert(key).second) {
        if (import_.error.empty())
            import_.error =
                fmt::format("{}:{}:{}: '{}' reads itself", import_.path, node.line, node.column, node.name());
        return terms::number_term(0);
    }
    const std::string label = scope_label_;
    scope_label_ = scope.element->category == "nodegraph"
                       ? std::string(scope.instance ? scope.instance->name() : scope.element->name()) + "/"
                       : "";
    number_of(node);
    Scope* const around = std::exchange(scope_, &scope);
    Term made;
    if (depth_ > kDeepest || ++evaluated_ > kMostNodes) {
        made = magenta(node, type,
                       depth_ > kDeepest ? fmt::format("it is read through more than {} nodes", kDeepest)
                                         : fmt::format("the material has more than {} nodes", kMostNodes));
    } else {
        ++depth_;
        made = computed(scope, node, output);
        --depth_;
    }
    made.nodes.insert(number_of(node));
    const bool is_coordinates = made.from_top && made.from_top->kind == nodelang::Expr::Kind::Semantic;
    if (made.name.empty() || (!made.is_link() && !is_coordinates)) made.name = terms::camel_case(node.name());
    // Outputs of one node are written again: they are links.
    if (uses(scope, node) > 1 && !made.is_short()) made = named(made);
    scope_label_ = label;
    scope_ = around;
    open_.erase(key);
    return values_[std::move(key)] = std::move(made);
}

// The first that knows the node: a function, the table, the document.
Term GraphMaker::computed(Scope& scope, const Element& node, std::string_view output) {
    const Type type = type_of_word(node.type());
    check_inputs(scope, node);
    if (auto made = apply_special(*this, scope, node, output)) return *made;
    if (auto made = apply_rule(*this, scope, node, output)) return *made;
    const Element* definition = nullptr;
    const Element* const graph = implementation(node, definition);
    if (graph) {
        Scope& inner = scope_of(*graph, *scopes_.front(), definition, &node, &scope);
        const Element* found = nullptr;
        for (const Element& each : graph->children)
            if (each.category == "output" && (each.name() == output || (!found && output == "out"))) found = &each;
        if (!found) return magenta(node, type, fmt::format("its implementation has no output '{}'", output));
        Term made;
        if (found->has("nodename") || found->has("nodegraph")) {
            made = connected(inner, *found);
            if (found->has("channels")) made = terms::swizzled(made, found->attribute("channels"));
        } else {
            Element value = *found;
            std::erase_if(value.attributes, [](const auto& each) { return each.first == "name"; });
            made =
                input(inner, node_with(std::move(value), *found), {.name = "in", .type = std::string(found->type())});
        }
        return made;
    }
    std::string reason = fmt::format("'{}' is no node of MaterialX that this importer knows", node.category);
    if (definition) reason = fmt::format("the document defines '{}', but not by a node graph", node.category);
    if (is_in_table(node.category))
        reason = fmt::format("'{}' has no such form that this importer knows", node.category);
    return magenta(node, type == Type::None ? Type::Float3 : type, reason);
}

Term GraphMaker::named(const Term& term) {
    if (term.is_constant() || term.is_link() || !term.tree) return term;
    return file_.named(
        term, [&] { return file_.ids.unique(term.name, "value"); }, term.nodes);
}

std::string GraphMaker::add_node(const Element& node, ImportedNode made, std::string_view wanted) {
    made.id = file_.ids.unique(wanted.empty() ? terms::camel_case(node.name()) : std::string(wanted),
                               terms::camel_case(node.category));
    return file_.add(std::move(made), {number_of(node)});
}

void GraphMaker::written(const Term& term, std::string_view where) {
    file_.written(term, where);
}

void GraphMaker::approximate(const Element& node, std::string difference) {
    file_.approximate(number_of(node), difference);
}

void GraphMaker::refuse(const Element& node, std::string reason) {
    import_.has_refused = true;
    file_.outcomes[number_of(node)] = {
        .kind = Remark::Kind::LeftOut, .where = {}, .text = std::move(reason), .label = scope_label_};
}

// What a refused node reads stays in the graph, for the node that its author puts in its place. In words, by its
// inputs.
std::string GraphMaker::kept_inputs(const Element& node) {
    std::string made;
    if (!scope_ || depth_ > kDeepest || evaluated_ > kMostNodes) return made;
    for (const Element& each : node.children) {
        const Type type = type_of_word(each.type());
        if (!mtlx::is_input(each) || type == Type::None || !is_set(*scope_, node, each.name())) continue;
        const Term term = input(*scope_, node, {.name = std::string(each.name()), .type = std::string(each.type())});
        if (term.is_constant()) continue;
        const Term kept = terms::is_vector(type) ? named(term) : term;
        written(kept, fmt::format("the note of '{}'", node.name()));
        made += fmt::format("{}{} = {}", made.empty() ? "" : ", ", each.name(), kept.text());
    }
    return made;
}

// A node of its own, so that the place is seen in the graph, too.
Term GraphMaker::magenta(const Element& node, Type type, std::string_view reason) {
    import_.has_refused = true;
    const bool is_input = node.category == "input" || node.category == "output" || node.category == "bindinput";
    const std::string reads = is_input ? std::string() : kept_inputs(node);
    if (!is_input) refuse(node, std::string(reason));
    const Term made = terms::stand_in(type);
    const std::string id = file_.ids.unique(terms::camel_case(node.name()), "refused");
    file_.types[id] = made.type;
    const std::string note = fmt::format("not imported: {}{}{}", reason, reads.empty() ? "" : ". It read ", reads);
    file_.nodes.push_back({.id = id, .expression = made.text(), .more = {{"note", note}}});
    return terms::link(id, made.type);
}

void GraphMaker::remark(Remark::Kind kind, std::string part, std::string text, const Element& place) {
    if (kind == Remark::Kind::LeftOut) import_.has_refused = true;
    Remark made{.kind = kind,
                .part = scope_label_ + std::move(part),
                .text = std::move(text),
                .line = place.line,
                .column = place.column};
    const bool is_there = std::ranges::any_of(import_.remarks, [&](const Remark& each) {
        return each.line == made.line && each.column == made.column && each.part == made.part && each.text == made.text;
    });
    if (!is_there) import_.remarks.push_back(std::move(made));
}

void GraphMaker::describe(const Element& input, ImportedProperty& property) {
    for (const auto& [from, to] :
         {std::pair("uiname", "label"), std::pair("uifolder", "group"), std::pair("doc", "help")})
        if (!input.attribute(from).empty()) property.more.push_back({to, input.attribute(from)});
}

// An input of a node graph that nothing connects can be set from outside.
Term GraphMaker::property_of(const Element& input) {
    const auto [found, is_new] = properties_.try_emplace(&input);
    if (!is_new) return found->second;
    import_.reached.insert(&input);
    const std::string type = std::string(input.type());
    const Term value = literal(input, type, input.attribute("value"));
    Term made = value;
    std::string word, suffix;
    if (type == "float" || type == "vector2" || type == "vector3" || type == "vector4") word = terms::word(value.type);
    if (type == "integer") word = "int";
    if (type == "boolean") word = "bool";
    if (is_color(type)) word = "color";
    if (!word.empty()) {
        ImportedProperty property{.name = file_.property_names.unique("_" + terms::pascal_case(input.name()), "_value"),
                                  .type = word};
        property.value = word == "int" ? GraphValue(value.numbers[0]) : value.value();
        if (word == "color" && value.is_all(value.numbers[0]))
            property.value =
                list_of(std::vector<float>(type == "color4" ? 4 : 3, static_cast<float>(value.numbers[0])));
        if (word.starts_with("float") && value.numbers.size() > 1)
            property.value = list_of(std::vector<float>(value.numbers.begin(), value.numbers.end()));
        const auto limit = [&](std::string_view name, std::string_view soft) {
            const std::string_view stated = input.has(soft) ? input.attribute(soft) : input.attribute(name);
            return stated.empty() ? Term{} : literal(input, "float", stated);
        };
        const Term low = limit("uimin", "uisoftmin"), high = limit("uimax", "uisoftmax");
        const auto limit_value = [&](double limit) {
            return word == "int" ? GraphValue(std::round(limit)) : GraphValue(static_cast<float>(limit));
        };
        const bool has_range = (type == "float" || type == "integer") && low.is_constant() && high.is_constant() &&
                               low.numbers[0] < high.numbers[0];
        const bool is_outside = has_range && (value.numbers[0] < low.numbers[0] || value.numbers[0] > high.numbers[0]);
        if (is_outside)
            remark(Remark::Kind::Changed, fmt::format("input '{}'", input.name()),
                   fmt::format("its limits, {} to {}, are left out: its value, {}, is outside of them",
                               terms::digits(low.numbers[0]), terms::digits(high.numbers[0]),
                               terms::digits(value.numbers[0])),
                   input);
        if (has_range && !is_outside)
            property.more.push_back(
                {"range", GraphValue::list({limit_value(low.numbers[0]), limit_value(high.numbers[0])})});
        describe(input, property);
        made = terms::link("$" + property.name, value.type);
        made.is_color = word == "color";
        if (type == "color3") {
            made.type = Type::Float4;
            made = terms::swizzled(made, "rgb");
        }
        if (type == "integer") made = terms::computed("float(a)", {made}, Type::Float);
        remark(Remark::Kind::Taken, fmt::format("input '{}'", input.name()),
               fmt::format("the property '{}'", property.name), input);
        file_.properties.push_back(std::move(property));
        property_places_.push_back(&input);
    }
    properties_[&input] = made;
    return made;
}

void GraphMaker::report_nodes() {
    for (const auto& [index, outcome] : file_.outcomes) {
        const Element& node = *elements_[index];
        if (outcome.kind == Remark::Kind::Taken && is_of_library(node)) continue;  // no part of the document
        std::string part = outcome.label + (node.name().empty() ? std::string(node.category)
                                                                : fmt::format("{} '{}'", node.category, node.name()));
        std::string text = outcome.text;
        if (outcome.kind != Remark::Kind::LeftOut) {
            const std::string where = outcome.where.empty() ? "a part of what reads it" : outcome.where;
            text = text.empty() ? where : where + ": " + text;
        }
        scope_label_.clear();
        remark(outcome.kind, std::move(part), std::move(text), node);
    }
}

// The document's order.
void GraphMaker::sort_properties() {
    std::unordered_map<const Element*, std::size_t>& order = import_.order;
    const auto count = [&](const auto& self, const Element& element) -> void {
        order.emplace(&element, order.size());
        for (const Element& each : element.children) self(self, each);
    };
    if (order.empty()) count(count, import_.document.root);
    std::vector<std::pair<std::size_t, std::size_t>> places;  // those of shaders of version 1.36 are copies: at the end
    for (std::size_t i = 0; i < property_places_.size(); ++i) {
        const auto found = order.find(property_places_[i]);
        places.emplace_back(found == order.end() ? order.size() : found->second, i);
    }
    std::ranges::sort(places);
    std::vector<ImportedProperty> sorted;
    for (const auto& [place, index] : places) sorted.push_back(std::move(file_.properties[index]));
    file_.properties = std::move(sorted);
}

void GraphMaker::make(const Element& material, const Element& shader, Scope& scope) {
    number_of(shader);
    import_.reached.insert(&shader);
    import_.reached.insert(&material);
    const std::size_t first_remark = import_.remarks.size();
    make_surface(scope, shader);
    sort_properties();
    if (import_.error.empty()) refuse_invalid(shader, first_remark);
    report_nodes();
    if (&material != &shader)
        remark(Remark::Kind::Taken, fmt::format("{} '{}'", material.category, material.name()),
               fmt::format("the graph '{}'", name_), material);
}

}  // namespace patina::importers::mtlx

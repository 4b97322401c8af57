// Nodes of the table: fills the templates of nodes.def.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/graph_maker.h"
#include "compiler/importers/patterns.h"

namespace patina::importers::mtlx {
namespace {

constexpr std::size_t kLongest = 80;  // of an expression, before its parts get names

// "{in.x}", "{in!}": which input, and in which form.
struct Placeholder {
    std::string name{}, components{};
    bool is_exact = false;
};

Placeholder placeholder(std::string_view text) {
    Placeholder made;
    if (text.ends_with('!')) {
        made.is_exact = true;
        text.remove_suffix(1);
    }
    const std::size_t dot = text.find('.');
    if (dot != text.npos) made.components = text.substr(dot + 1);
    made.name = text.substr(0, dot);
    return made;
}

// "[space|world=World|=Object]" by the string of an input, and "<T>" by the node's type.
void fill_words(std::string& text, const NodeFacts& facts, Type type) {
    for (std::size_t begin; (begin = text.find('[')) != text.npos;) {
        const std::size_t end = text.find(']', begin);
        if (end == text.npos) break;
        const std::string inner = text.substr(begin + 1, end - begin - 1);
        const std::vector<std::string_view> parts = split(inner, "|");
        const std::string word = facts.word_of(parts[0]);
        std::string chosen;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const std::size_t equals = parts[i].find('=');
            const std::string_view key = parts[i].substr(0, equals);
            if (chosen.empty() && (key == word || key.empty())) chosen = parts[i].substr(equals + 1);
        }
        text.replace(begin, end - begin + 1, chosen);
    }
    for (std::size_t at; (at = text.find("<T>")) != text.npos;) text.replace(at, 3, terms::word(type));
}

}  // namespace

std::vector<std::string> inputs_in(std::string_view text) {
    std::vector<std::string> made;
    for (const std::string& place : terms::pattern_of(text).places) made.push_back(placeholder(place).name);
    return made;
}

Term GraphMaker::filled(Scope& scope, const Element& node, const NodeRule& rule, const std::string& text, Type type,
                        std::map<std::string, std::size_t>& counts, const Term& self) {
    const terms::Pattern pattern = terms::pattern_of(text);
    std::vector<Placeholder> places;
    std::vector<Term> terms;
    for (const std::string& place : pattern.places) {
        const Placeholder each = placeholder(place);
        const Port* const port = rule.input(each.name);
        Term term =
            input(scope, node, port ? *port : Port{.name = each.name}, !each.is_exact && each.components.empty());
        if (counts[each.name] > 1 && !term.is_short() && (term.widths.empty() || each.components.empty()))
            term = named(term);
        if (!each.components.empty()) term = terms::swizzled(term, each.components);
        places.push_back(each);
        terms.push_back(std::move(term));
    }
    // Numbers stand for vectors, but not if all operands do: "float4(0, 0, 0, 0) + 1".
    const std::size_t width = terms::is_vector(type) ? terms::width(type) : 1;
    const auto is_wide = [&](const Term& each) { return terms::width(each.type) == width; };
    if (node.type() != "surfaceshader" && width > 1 && std::ranges::none_of(terms, is_wide)) {
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const Port* const port = rule.input(places[i].name);
            const Type stated = type_of_word(port && !port->type.empty() ? port->type : node.type());
            if (!terms[i].is_constant() || !places[i].components.empty() || terms::width(stated) != width) continue;
            terms[i] = terms::converted(terms[i], stated);
            break;
        }
    }
    // A line that would get too long gets names for its longest parts.
    for (;;) {
        std::size_t length = text.size(), longest = terms.size();
        for (std::size_t i = 0; i < terms.size(); ++i) {
            length += terms[i].text().size();
            if (terms[i].is_constant() || terms[i].is_link() || terms[i].name.empty()) continue;
            if (longest == terms.size() || terms[i].text().size() > terms[longest].text().size()) longest = i;
        }
        if (length <= kLongest || longest == terms.size()) break;
        const Term name = named(terms[longest]);
        if (name.text() == terms[longest].text()) break;
        terms[longest] = name;
    }
    const auto term_of = [&](const nodelang::Expr& part) -> const Term* {
        if (terms::is_self(part)) return &self;
        const auto place = terms::place_of(part);
        return place ? &terms[*place] : nullptr;
    };
    return terms::filled(pattern.tree, term_of, type);
}

std::optional<Term> apply_rule(GraphMaker& maker, Scope& scope, const Element& node, std::string_view output) {
    const NodeFacts facts{.type = node.type(),
                          .type_of = [&](std::string_view input) { return maker.type_of(scope, node, input); },
                          .word_of = [&](std::string_view input) { return maker.word_of(scope, node, input); }};
    const NodeRule* const rule = rule_of(node.category, facts);
    if (!rule) return {};
    Type type = type_of_word(node.type());
    if (rule->remark.starts_with("!")) return maker.magenta(node, type, rule->remark.substr(1));
    std::map<std::string, std::size_t> counts;
    const Statement* wanted = nullptr;
    for (const Statement& each : rule->statements) {
        if (each.output == output || (each.output == "out" && !wanted)) wanted = &each;
        if (each.output != "$") continue;
        for (const std::string& name : inputs_in(each.text)) ++counts[name];
    }
    if (!wanted)
        return maker.magenta(node, type == Type::None ? Type::Float : type,
                             fmt::format("it has no output '{}'", output));
    for (const std::string& name : inputs_in(wanted->text)) ++counts[name];
    if (wanted->output != "out") {
        type = Type::Float;  // one channel of several
        for (auto& [name, times] : counts) times = 2;
    }
    Term self;
    for (const Statement& each : rule->statements) {
        if (each.output != "$") continue;
        self = maker.filled(scope, node, *rule, each.text, Type::None, counts, self);
        if (self.is_constant() || self.is_link()) continue;
        self.name = terms::camel_case(node.name());
        if (self.name.empty()) self.name = terms::camel_case(node.category);
        self.name += "At";
        self = maker.named(self);
    }
    std::string text = wanted->text;
    fill_words(text, facts, type);
    Term made = maker.filled(scope, node, *rule, text, type, counts, self);
    if (rule->remark.starts_with("~")) maker.approximate(node, std::string(rule->remark.substr(1)));
    // A number, which served as a vector, or a semantic.
    if (made.type != type && type != Type::None) {
        Term converted = terms::converted(made, type);
        if (converted.type != Type::None) made = converted;
    }
    return made;
}

}  // namespace patina::importers::mtlx

// Nodes of the table: fills the templates of nodes.def.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/importers/mtlx/graph_maker.h"

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

void count(const std::string& text, std::map<std::string, std::size_t>& counts) {
    for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at)
        ++counts[placeholder(std::string_view(text).substr(at + 1, text.find('}', at) - at - 1)).name];
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

// "2 * 0.5" of numbers.
std::optional<Term> product(const std::string& text, const std::vector<Term>& terms) {
    const std::size_t star = text.find(" * ");
    if (star == text.npos || text.find_first_of("+-/(") != text.npos || text.find(" * ", star + 1) != text.npos)
        return {};
    std::vector<Term> factors;
    std::size_t next = 0;
    for (const std::string& side : {text.substr(0, star), text.substr(star + 3)}) {
        if (side.starts_with('{')) {
            factors.push_back(terms[next++]);
        } else if (const auto value = read_number(side)) {
            factors.push_back(terms::number_term(*value));
        } else {
            return {};
        }
    }
    // One is no factor.
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
        if (factors[i].is_all(1) && terms::width(factors[1 - i].type) >= terms::width(factors[i].type)) {
            Term made = factors[1 - i];
            made.add_nodes(factors[i]);
            return made;
        }
    if (!factors[0].is_constant() || !factors[1].is_constant()) return {};
    Term made = factors[terms::width(factors[0].type) >= terms::width(factors[1].type) ? 0 : 1];
    for (std::size_t i = 0; i < made.numbers.size(); ++i)
        made.numbers[i] = factors[0].numbers[std::min(i, factors[0].numbers.size() - 1)] *
                          factors[1].numbers[std::min(i, factors[1].numbers.size() - 1)];
    return made;
}

// "{a} + {b}" and "{a} - {b}" of numbers.
std::optional<Term> sum(const std::string& text, const std::vector<Term>& terms) {
    const std::size_t end = text.find('}');
    if (terms.size() != 2 || !text.starts_with('{') || !text.ends_with('}') || text.find('{', end) != end + 4)
        return {};
    const std::string sign = text.substr(end + 1, 3);
    const bool is_number = terms[0].is_constant() && terms[1].is_constant() && terms[0].numbers.size() == 1 &&
                           terms[1].numbers.size() == 1;
    if (!is_number || (sign != " + " && sign != " - ")) return {};
    const double second = terms[1].numbers[0];
    Term made = terms[0];
    made.numbers[0] += sign == " + " ? second : -second;
    made.add_nodes(terms[1]);
    return made;
}

// "{in} > 0 ? 1.0 : {other}" of a number.
std::optional<Term> choice(const std::string& text, const std::vector<Term>& terms) {
    const std::size_t question = text.find(" > 0 ? "), colon = text.find(" : ");
    if (question == text.npos || colon == text.npos || !text.starts_with('{') || !terms[0].is_constant()) return {};
    const bool is_first = terms[0].numbers[0] > 0;
    const std::string first = text.substr(question + 7, colon - question - 7), second = text.substr(colon + 3);
    if (const auto value = read_number(is_first ? first : second)) {
        Term made = terms::number_term(*value);
        made.add_nodes(terms[0]);
        return made;
    }
    return is_first || !first.starts_with('{') ? terms[1] : terms[2];
}

// "- 0" and "/ 1" are not written, if another operand has the size of the result.
bool adds_nothing(const std::vector<Term>& terms, std::size_t index, std::string_view before, std::string_view after) {
    const bool is_sum = before.ends_with(" + ") || before.ends_with(" - ");
    const bool is_product = before.ends_with(" * ") || before.ends_with(" / ");
    if (!(is_sum && terms[index].is_all(0)) && !(is_product && terms[index].is_all(1))) return false;
    // What follows may bind more strongly than a sum.
    if (is_sum && (after.starts_with(" *") || after.starts_with(" /"))) return false;
    for (std::size_t i = 0; i < terms.size(); ++i)
        if (i != index && !terms[i].is_constant() && terms::width(terms[i].type) >= terms::width(terms[index].type))
            return true;
    return false;
}

}  // namespace

Term GraphMaker::filled(Scope& scope, const Element& node, const NodeRule& rule, const std::string& text, Type type,
                        std::map<std::string, std::size_t>& counts, const Term& self) {
    std::vector<std::pair<std::size_t, Placeholder>> places;
    std::vector<Term> terms;
    for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
        const Placeholder each = placeholder(std::string_view(text).substr(at + 1, text.find('}', at) - at - 1));
        const Port* const port = rule.input(each.name);
        Term term =
            input(scope, node, port ? *port : Port{.name = each.name}, !each.is_exact && each.components.empty());
        if (counts[each.name] > 1 && !term.is_short() && (term.parts.empty() || each.components.empty()))
            term = named(term);
        if (!each.components.empty()) term = terms::swizzled(term, each.components);
        places.push_back({at, each});
        terms.push_back(std::move(term));
    }
    const bool is_whole = places.size() == 1 && text.starts_with('{') && text.find('}') + 1 == text.size();
    if (is_whole) return terms[0];
    if (auto made = product(text, terms)) return *made;
    if (auto made = sum(text, terms)) return *made;
    if (auto made = choice(text, terms)) return *made;
    // Numbers stand for vectors, but not if all operands do: "float4(0, 0, 0, 0) + 1".
    const std::size_t width = terms::is_vector(type) ? terms::width(type) : 1;
    const auto is_wide = [&](const Term& each) { return terms::width(each.type) == width; };
    if (node.type() != "surfaceshader" && width > 1 && std::ranges::none_of(terms, is_wide)) {
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const Port* const port = rule.input(places[i].second.name);
            const Type stated = type_of_word(port && !port->type.empty() ? port->type : node.type());
            if (!terms[i].is_constant() || !places[i].second.components.empty() || terms::width(stated) != width)
                continue;
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
    std::string made;
    Term holds{.type = type};
    std::size_t at = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t begin = places[i].first, end = text.find('}', begin) + 1;
        made += text.substr(at, begin - at);
        const std::string_view after = std::string_view(text).substr(end);
        if (adds_nothing(terms, i, made, after)) {
            made.resize(made.size() - 3);
            at = end;
            continue;
        }
        made += terms::bracketed(terms[i].text(), made, std::string_view(text).substr(end));
        holds.add_nodes(terms[i]);
        at = end;
    }
    made += text.substr(at);
    for (std::size_t place = 0; (place = made.find('$', place)) != made.npos; ++place) {
        // "$_Tint" is a property.
        if (place + 1 < made.size() && made[place + 1] == '_') continue;
        const std::string own = terms::bracketed(self.text(), std::string_view(made).substr(0, place),
                                                 std::string_view(made).substr(place + 1));
        made.replace(place, 1, own);
        place += own.size();
    }
    Term whole = terms::parsed(terms::folded(made), type);
    whole.add_nodes(holds);
    return whole;
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
        if (each.output == "$") count(each.text, counts);
    }
    if (!wanted)
        return maker.magenta(node, type == Type::None ? Type::Float : type,
                             fmt::format("it has no output '{}'", output));
    count(wanted->text, counts);
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

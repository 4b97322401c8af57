// Nodes of the table: fills the templates of nodes.def.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::size_t kLongest = 80;  // of an expression, before its parts get names

// "{1.x}": which input, and in which form.
struct Placeholder {
    int slot = 0;
    std::string components{};  // "xy"
    bool is_exact = false, from_top = false, symmetric = false;
};

class Rule {
public:
    Rule(GraphMaker& maker, std::size_t node, const NodeRule& rule) : maker_(maker), node_(node), rule_(rule) {}

    // False: a setting has a value that the table does not know.
    bool apply() {
        std::vector<Statement> statements;
        for (Statement each : rule_.statements) {
            if (each.output >= 0 && !maker_.is_used(node_, each.output)) continue;
            if (!fill_settings(each.text, maker_.node(node_), [&](int slot) { return components(slot); })) return false;
            statements.push_back(std::move(each));
        }
        for (const Statement& each : statements) count_uses(each);
        for (const Statement& each : statements) {
            if (each.output < 0 && statements.size() == 1) continue;  // nothing reads it
            Term made = value_of(each.text);
            if (each.output < 0) {
                self_ = made;
                continue;
            }
            const Slot* slot = maker_.node(node_).slot(each.output);
            if (!slot) continue;
            if (made.type == Type::None) made.type = maker_.type_of(node_, *slot);
            maker_.set(node_, each.output, std::move(made));
        }
        if (rule_.remark.starts_with("~")) maker_.approximate(node_, std::string(rule_.remark.substr(1)));
        return true;
    }

private:
    std::size_t components(int slot) const {
        const Slot* found = maker_.node(node_).slot(slot);
        return found ? width(maker_.type_of(node_, *found)) : 1;
    }

    Placeholder placeholder(std::string_view text) const {
        Placeholder made;
        while (!text.empty() && std::string_view("!^~").find(text.back()) != text.npos) {
            made.is_exact |= text.back() == '!';
            made.from_top |= text.back() == '^';
            made.symmetric |= text.back() == '~';
            text.remove_suffix(1);
        }
        const std::size_t dot = text.find('.');
        if (dot != text.npos) made.components = text.substr(dot + 1);
        text = text.substr(0, dot);
        if (text[0] >= '0' && text[0] <= '9') {
            std::from_chars(text.data(), text.data() + text.size(), made.slot);
        } else {
            made.slot = -1;
            for (const Slot& slot : maker_.node(node_).slots)
                if (slot.is_input && slot.name == text) made.slot = slot.id;
        }
        return made;
    }

    // How often each input is written, so that one that is written twice gets a name.
    void count_uses(const Statement& statement) {
        // A component is written again by each reader; anything longer that is read twice gets a name itself.
        const bool is_component =
            statement.text.starts_with("{") && statement.text.find('}') + 1 == statement.text.size();
        const std::size_t times = is_component ? std::max<std::size_t>(maker_.uses(node_, statement.output), 1) : 1;
        for (std::size_t at = 0; (at = statement.text.find('{', at)) != statement.text.npos; ++at) {
            const std::size_t end = statement.text.find('}', at);
            const Placeholder each = placeholder(std::string_view(statement.text).substr(at + 1, end - at - 1));
            counts_[each.slot] += times * (each.from_top ? 2 : 1);
        }
    }

    Term term_of(const Placeholder& each, bool may_stay_number) {
        Term made = maker_.input(node_, each.slot, may_stay_number && !each.is_exact && each.components.empty());
        if (counts_[each.slot] > 1 && made.from_top.empty() && (made.parts.empty() || each.components.empty()))
            made = maker_.named(made);
        if (each.from_top || (each.symmetric && !made.from_top.empty())) return flipped(converted(made, Type::Float2));
        if (each.components.empty()) return made;
        // A component that the value does not have is 0.
        const std::size_t has = std::max<std::size_t>(width(made.type), 1);
        const std::string_view xyzw = "xyzw";
        if (each.components.size() == 1 && xyzw.find(each.components[0]) >= has &&
            xyzw.find(each.components[0]) != xyzw.npos)
            return number_term(0);
        if (has < each.components.size()) return converted(made, vector_type(each.components.size()));
        return swizzled(made, each.components);
    }

    // The text with its placeholders and "$" filled in; `parts`: the widths of what is filled in, in order.
    std::string filled(const std::string& text, Term& holds) {
        std::vector<std::pair<std::size_t, Placeholder>> places;
        std::vector<Term> terms;
        for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
            const Placeholder each = placeholder(std::string_view(text).substr(at + 1, text.find('}', at) - at - 1));
            places.push_back({at, each});
            terms.push_back(term_of(each, true));
            note_texture(terms.back(), call_);
        }
        // A line that would get too long gets names for its longest parts.
        for (;;) {
            std::size_t length = text.size(), longest = terms.size();
            for (std::size_t i = 0; i < terms.size(); ++i) {
                length += terms[i].text().size();
                if (terms[i].is_constant() || terms[i].is_link() || !terms[i].owner || *terms[i].owner == node_)
                    continue;
                if (longest == terms.size() || terms[i].text().size() > terms[longest].text().size()) longest = i;
            }
            if (length <= kLongest || longest == terms.size()) break;
            const Term name = maker_.named(terms[longest]);
            if (name.text() == terms[longest].text()) break;
            terms[longest] = name;
        }
        std::string made;
        std::size_t at = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t begin = places[i].first, end = text.find('}', begin) + 1;
            made += text.substr(at, begin - at);
            made += bracketed(terms[i].text(), made, std::string_view(text).substr(end));
            holds.add_nodes(terms[i]);
            holds.is_color |= terms[i].is_color && width(terms[i].type) > 1;
            at = end;
        }
        made += text.substr(at);
        for (std::size_t place = 0; (place = made.find('$', place)) != made.npos; ++place) {
            // "$_Tint" is a property.
            const char next = place + 1 < made.size() ? made[place + 1] : ' ';
            if (next == '_' || (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z')) continue;
            made.replace(place, 1, self_.text());
            place += self_.text().size();
        }
        return made;
    }

    // In brackets, if an operator beside it binds more strongly.
    static std::string bracketed(const std::string& text, std::string_view before, std::string_view after) {
        while (before.ends_with(' ')) before.remove_suffix(1);
        while (after.starts_with(' ')) after.remove_prefix(1);
        const auto strength = [](char c) {
            if (c == '+' || c == '-') return kSum;
            if (c == '*' || c == '/' || c == '%') return kProduct;
            if (c == '!') return kUnary;
            if (c == '=' || c == '<' || c == '>') return kCompare;
            if (c == '&') return kAnd;
            if (c == '|') return kOr;
            if (c == '.' || c == '[') return kPrimary;
            return kChoice;
        };
        const char left = before.empty() ? ' ' : before.back(), right = after.empty() ? ' ' : after.front();
        int needed = std::max<int>(strength(right), strength(left));
        if (left == '-' || left == '/' || left == '%' || left == '*' || left == '=' || left == '<' || left == '>')
            ++needed;
        if (left == '?' || right == '?' || (left == ':' && precedence_of(text) == kChoice))
            needed = std::max<int>(needed, kOr);
        const bool has_operator = needed > kChoice;
        if (has_operator && text.starts_with("-") && strength(left) > kChoice) return "(" + text + ")";
        return at_least(text, static_cast<Precedence>(std::min<int>(needed, kPrimary)));
    }

    Term value_of(const std::string& text) {
        if (text.starts_with("^")) {
            const Term own = value_of(text.substr(1));
            Term made = flipped(own.type == Type::None ? link(own.text(), Type::Float2) : own);
            made.type = Type::Float2;
            made.from_top = own.text();
            return made;
        }
        if (text.starts_with("@") && text.find('(') != text.npos && text[1] >= 'A' && text[1] <= 'Z') return call(text);
        if (text.starts_with("{") && text.find('}') == text.size() - 1) {
            const Placeholder each = placeholder(std::string_view(text).substr(1, text.size() - 2));
            // A node that only hands on keeps what its value is.
            if (!each.is_exact && each.components.empty())
                if (const auto term = maker_.linked_term(node_, each.slot); term && !is_vector(term->type))
                    return *term;
            return term_of(each, false);
        }
        Term made;
        if (text == "$") {
            made = self_;
            made.type = Type::None;
            return made;
        }
        if (text.starts_with("$.") && text.find(' ') == text.npos && text.find('(') == text.npos) {
            made = self_;
            made.type = Type::None;
            const std::string_view rest = std::string_view(text).substr(2);
            made.base += "." + std::string(rest);
            return made;
        }
        made.base = filled(text, made);
        return with_parts(std::move(made));
    }

    // A number, a constant vector or a vector of parts is known as such.
    static Term with_parts(Term made) {
        if (made.base == "true" || made.base == "false") return flag_term(made.base == "true");
        if (const auto value = read_number(made.base)) {
            Term constant = number_term(*value);
            constant.nodes = made.nodes;
            return constant;
        }
        if (!made.base.starts_with("float") || made.base.size() < 8 || made.base[6] != '(' || !made.base.ends_with(')'))
            return made;
        const std::string_view inner = std::string_view(made.base).substr(7, made.base.size() - 8);
        const std::vector<std::string> arguments = arguments_of(inner);
        std::string joined;
        for (const std::string& each : arguments) joined += (joined.empty() ? "" : ", ") + each;
        if (joined != inner) return made;
        const std::size_t count = static_cast<std::size_t>(made.base[5] - '0');
        if (arguments.size() > count || arguments.size() < 2) return made;
        made.type = vector_type(count);
        std::vector<double> numbers;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            // Only the first can be a vector: float4(rgb, 1).
            made.parts.push_back({arguments[i], i == 0 ? count - arguments.size() + 1 : 1});
            if (const auto value = read_number(arguments[i])) numbers.push_back(*value);
        }
        if (numbers.size() == count) {
            Term all = constant(numbers);
            all.nodes = made.nodes;
            return all;
        }
        return made;
    }

    // "@Lerp(from={0}, to=1).second": a node of the library.
    Term call(const std::string& text) {
        const std::size_t open = text.find('('), close = text.rfind(')');
        GraphNode made{.id = {}, .node = text.substr(1, open - 1)};
        call_ = made.node;
        Term holds;
        for (const std::string& argument : arguments_of(std::string_view(text).substr(open + 1, close - open - 1))) {
            const std::size_t equals = argument.find('=');
            const std::string port = argument.substr(0, equals);
            std::string value = argument.substr(equals + 1), otherwise;
            if (const std::size_t question = value.rfind("?@"); question != value.npos) {
                otherwise = value.substr(question + 1);
                value.resize(question);
            }
            const bool is_word = value.find_first_of("{(<$@-0123456789") != 0 && value.find('(') == value.npos;
            if (is_word) {
                made.inputs.push_back({port, patina::importers::text(value)});
                continue;
            }
            Term term;
            if (value.starts_with("{") && value.find('}') == value.size() - 1) {
                term = term_of(placeholder(std::string_view(value).substr(1, value.size() - 2)), true);
            } else {
                term.base = filled(value, term);
                term = with_parts(std::move(term));
            }
            holds.add_nodes(term);
            note_texture(term, made.node);
            if (!otherwise.empty() && term.text() == otherwise) continue;
            made.inputs.push_back({port, term.value()});
        }
        const bool is_texel = made.node.starts_with("SampleTexture") || made.node.starts_with("Triplanar") ||
                              made.node.starts_with("SampleReflected");
        std::string wanted = wanted_;
        const std::string id = maker_.add_node(node_, std::move(made), wanted);
        maker_.written(holds, fmt::format("the node '{}'", id));
        Term term = link(id + text.substr(close + 1), Type::None);
        term.is_color = is_texel;
        return term;
    }

    // A node that samples a texture is called after it, and says how the texture is used.
    void note_texture(const Term& term, const std::string& sampling_node) {
        if (term.type < Type::Texture2D || term.type > Type::Cubemap) return;
        if (sampling_node.starts_with("Sample")) wanted_ = camel_case(std::string_view(term.text()).substr(1));
        std::optional<SamplerState> sampler;
        for (const Slot& slot : maker_.node(node_).slots)
            if (slot.is_input && type_of_slot(slot.kind).type == Type::Sampler)
                if (const auto linked = maker_.linked_term(node_, slot.id)) sampler = linked->sampler;
        const bool as_normal =
            sampling_node == "SampleNormalMap" || sampling_node == "TriplanarNormal" || sampling_node == "UnpackNormal";
        maker_.sample_with(node_, term, as_normal, sampler);
    }

    GraphMaker& maker_;
    const std::size_t node_;
    const NodeRule& rule_;
    std::map<int, std::size_t> counts_{};
    Term self_{};           // "$"
    std::string wanted_{};  // name of the node
    std::string call_{};    // the node of the library that is being made
};

}  // namespace

bool apply_rule(GraphMaker& maker, std::size_t node) {
    const NodeFacts facts{.is_linked = [&](int slot) { return maker.is_linked(node, slot); },
                          .is_used = [&](int slot) { return maker.is_used(node, slot); }};
    const NodeRule* rule = rule_of(maker.node(node), facts);
    if (!rule) return false;
    if (rule->remark.starts_with("!")) {
        maker.refuse(node, std::string(rule->remark.substr(1)));
        return true;
    }
    return Rule(maker, node, *rule).apply();
}

}  // namespace patina::importers::shadergraph

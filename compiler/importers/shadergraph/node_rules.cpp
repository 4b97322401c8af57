// Nodes of the table: fills the templates of nodes.def.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/importers/patterns.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

using terms::is_self;
using terms::Pattern;
using terms::pattern_of;
using terms::place_of;
using terms::Tree;

constexpr std::string_view kComponents = "xyzw";

// "{1.x}": which input, and in which form.
struct Placeholder {
    int slot = 0;
    std::string_view components{};  // "xy"
    std::string_view use{};         // of a texture: "data"
    bool is_exact = false, from_top = false, symmetric = false;
};

// The arguments of a node at the outer level: "from={0}, to=f(1, 2)".
std::vector<std::string> arguments_of(std::string_view list) {
    std::vector<std::string> made;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        if (i < list.size() && (list[i] == '(' || list[i] == '{' || list[i] == '[')) ++depth;
        if (i < list.size() && (list[i] == ')' || list[i] == '}' || list[i] == ']')) --depth;
        if (i < list.size() && (list[i] != ',' || depth > 0)) continue;
        const std::string_view part = trimmed(list.substr(begin, i - begin));
        if (!part.empty()) made.emplace_back(part);
        begin = i + 1;
    }
    return made;
}

bool is_constant_of(const Term& term, double value) {
    return term.is_constant() && std::ranges::all_of(term.numbers, [&](double each) { return each == value; });
}

// The port has this value if nothing is written at it.
bool is_default(const PortInfo& port, const Term& term) {
    if (port.default_value.empty()) return false;
    const auto number = read_number(port.default_value);
    return term.text() == port.default_value || (number && is_constant_of(term, *number));
}

bool samples_at_its_uv(std::string_view node) {
    return node.starts_with("SampleTexture2D") || node == "SampleNormalMap" || node == "GatherTexture2D" ||
           node == "CalculateLevel";
}

// The type of a port of the library; None: it follows from other ports.
Type type_of_port(std::string_view type) {
    for (const Type each : {Type::Bool, Type::Float, Type::Float2, Type::Float3, Type::Float4, Type::Texture2D,
                            Type::Texture2DArray, Type::Texture3D, Type::Cubemap})
        if (word(each) == type) return each;
    return Type::None;
}

class Rule {
public:
    Rule(GraphMaker& maker, std::size_t node, const NodeRule& rule, const NodeFacts& facts)
        : maker_(maker), node_(node), rule_(rule), facts_(facts) {}

    void apply() {
        std::vector<Statement> statements;
        for (Statement each : rule_.statements) {
            if (each.output >= 0 && !facts_.is_used(each.output)) continue;
            if (std::string wrong = fill_settings(each.text, maker_.node(node_), facts_); !wrong.empty())
                return maker_.refuse(node_, std::move(wrong));
            statements.push_back(std::move(each));
        }
        if (std::ranges::all_of(statements, [](const Statement& each) { return each.output < 0; })) return;
        for (const Statement& each : statements) count_uses(each);
        for (const Statement& each : statements) {
            is_step_ = &each != &statements.back() && each.output < 0 && (&each + 1)->output < 0;
            Term made = value_of(each.text);
            if (each.output < 0) {
                self_ = made;
                continue;
            }
            const Slot* slot = maker_.node(node_).slot(each.output);
            if (!slot) continue;
            if (made.type == Type::None) made.type = maker_.type_of(node_, *slot);
            maker_.set(node_, each.output, std::move(made), is_handed_on_);
        }
        if (rule_.remark.starts_with("~")) maker_.approximate(node_, std::string(rule_.remark.substr(1)));
    }

private:
    Placeholder placeholder(std::string_view text) const {
        Placeholder made;
        if (const std::size_t equals = text.find('='); equals != text.npos) {
            made.use = text.substr(equals + 1);
            text = text.substr(0, equals);
        }
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
    // The text is "{...}" and nothing more.
    std::optional<Placeholder> only_placeholder(std::string_view text) const {
        if (!text.starts_with('{') || text.find('}') + 1 != text.size()) return {};
        return placeholder(text.substr(1, text.size() - 2));
    }

    // How often each input is written, so that one that is written twice gets a name.
    void count_uses(const Statement& statement) {
        // A component is written again by each reader; anything longer that is read twice gets a name itself.
        const std::string_view text = statement.text;
        const std::size_t times =
            only_placeholder(text) ? std::max<std::size_t>(maker_.uses(node_, statement.output), 1) : 1;
        for (std::size_t at = 0; (at = text.find('{', at)) != text.npos; ++at) {
            const Placeholder each = placeholder(text.substr(at + 1, text.find('}', at) - at - 1));
            counts_[each.slot] += times * (each.from_top ? 2 : 1);
        }
    }

    Term term_of(const Placeholder& each, bool may_stay_number) {
        Term made = maker_.input(node_, each.slot, may_stay_number && !each.is_exact && each.components.empty());
        if (counts_[each.slot] > 1 && !made.from_top && (made.widths.empty() || each.components.empty()))
            made = maker_.named(made);
        if (each.from_top || (each.symmetric && made.from_top)) return flipped(converted(made, Type::Float2));
        if (each.components.empty()) return made;
        // A component that the value does not have is 0.
        const std::size_t has = std::max<std::size_t>(width(made.type), 1);
        if (each.components.size() == 1 && kComponents.find(each.components) >= has &&
            kComponents.find(each.components) != kComponents.npos)
            return number_term(0);
        if (has < each.components.size()) return converted(made, vector_type(each.components.size()));
        return swizzled(made, each.components);
    }

    Term value_of(std::string_view text, bool may_stay_number = false) {
        if (text.starts_with("^")) {
            const Term own = value_of(text.substr(1));
            Term made = flipped(own);
            made.type = Type::Float2;
            made.from_top = own.expression();
            return made;
        }
        if (text.starts_with("@") && text[1] >= 'A' && text[1] <= 'Z') return call(text.substr(1));
        const Pattern pattern = pattern_of(text);
        return value_of(pattern, pattern.tree, may_stay_number);
    }

    Term value_of(const Pattern& pattern, const Tree& tree, bool may_stay_number = false) {
        if (const auto at = place_of(*tree)) {
            const Placeholder only = placeholder(pattern.places[*at]);
            is_handed_on_ = !may_stay_number && !only.is_exact && only.components.empty();
            // A node that only hands on keeps what its value is.
            if (is_handed_on_)
                if (auto term = maker_.linked_term(node_, only.slot); term && !is_vector(term->type)) {
                    if (only.use == "alone" && is_tiled(*term)) {
                        term->transform = self_.text();
                        maker_.approximate(node_,
                                           "what samples the texture divides by its tiling, which must not be 0");
                    }
                    return *term;
                }
            return term_of(only, may_stay_number);
        }
        if (const auto member = member_of_self(tree)) {
            Term made = self_;
            if (member->empty()) return made;
            for (const std::string_view each : split(*member, "."))
                made.tree = nodelang::member(made.expression(), each);
            made.type = type_of_member(*member);
            made.is_color = false;
            return made;
        }
        if (tree->kind == nodelang::Expr::Kind::Call && tree->text.starts_with("float") && tree->text.size() == 6) {
            std::vector<Term> arguments;
            for (std::size_t i = 0; i < tree->args.size(); ++i)
                arguments.push_back(value_of(pattern, nodelang::arg(tree, i)));
            is_handed_on_ = false;
            maker_.shorten(node_, arguments, 0);
            return terms::vector_of(vector_type(static_cast<std::size_t>(tree->text[5] - '0')), arguments);
        }
        if (const auto other = with_neutral(pattern, *tree)) return *other;
        return filled(pattern, tree);
    }

    // "second.x" of "$.second.x"; empty: it is "$".
    static std::optional<std::string> member_of_self(const Tree& tree) {
        if (is_self(*tree)) return std::string();
        if (tree->kind != nodelang::Expr::Kind::Member) return {};
        const auto before = member_of_self(nodelang::arg(tree, 0));
        if (!before) return {};
        return *before + (before->empty() ? "" : ".") + std::string(tree->text);
    }

    // The texture may have a tiling and an offset of its own.
    bool is_tiled(const Term& texture) const {
        return std::ranges::any_of(maker_.graph().properties, [&](const Property& each) {
            return "$" + maker_.property_name(each) == texture.text() &&
                   (maker_.graph().is_subgraph || flag_of(each.json, "useTilingAndOffset"));
        });
    }
    // At a port of a node of the library, which samples the texture with its own transform: what leads to the place
    // that the node of the source samples.
    Term without_transform(const Term& term, std::string_view port, const std::string& transform) {
        const std::string_view pattern = port == "uv" ? "(a - b.offset) / b" : "a / b";
        return terms::computed(pattern, {term, link(transform, Type::None)}, Type::Float2);
    }

    // Of the node that was called last: an output, or components of one.
    Type type_of_member(std::string_view member) const {
        const auto port = std::ranges::find_if(
            call_->ports, [&](const PortInfo& each) { return each.is_output && each.name == member; });
        if (port != call_->ports.end()) return type_of_port(port->type);
        const std::string_view components = member.substr(member.rfind('.') + 1);
        const bool is_swizzle = components.find_first_not_of("xyzwrgba") == components.npos;
        return is_swizzle ? vector_type(components.size()) : Type::None;
    }

    // "{0} + {1}" with a 0, "{0} * {1}" with a 1: the other one. "{0} * {1}" with a 0: 0.
    std::optional<Term> with_neutral(const Pattern& pattern, const nodelang::Expr& tree) {
        if (tree.kind != nodelang::Expr::Kind::Binary) return {};
        const auto first = place_of(*tree.args[0]), second = place_of(*tree.args[1]);
        const char sign = tree.text[0];
        if (!first || !second || std::string_view("+-*/").find(sign) == std::string_view::npos) return {};
        const Placeholder left = placeholder(pattern.places[*first]), right = placeholder(pattern.places[*second]);
        const double neutral = sign == '+' || sign == '-' ? 0 : 1;
        const bool is_either = sign == '+' || sign == '*';
        for (const bool from_left : {true, false}) {
            if (!from_left && !is_either) continue;
            const Term dropped = maker_.input(node_, from_left ? right.slot : left.slot, true);
            if (sign == '*' && is_constant_of(dropped, 0)) {
                Term made = number_term(0);
                made.add_nodes(dropped);
                made.add_nodes(maker_.input(node_, from_left ? left.slot : right.slot, true));
                return made;
            }
            if (!is_constant_of(dropped, neutral)) continue;
            is_handed_on_ = true;
            Term made = term_of(from_left ? left : right, false);
            made.add_nodes(dropped);
            return made;
        }
        return {};
    }

    // An expression with its placeholders and "$" filled in.
    Term filled(const Pattern& pattern, const Tree& tree) {
        std::vector<Term> terms;
        std::map<std::size_t, std::size_t> numbers;  // of a placeholder: its term
        std::size_t length = printed(*tree).size();
        find_places(*tree, [&](std::size_t place, std::size_t written) {
            numbers.emplace(place, terms.size());
            terms.push_back(term_of(placeholder(pattern.places[place]), true));
            length += pattern.places[place].size() + 2 - written;
        });
        is_handed_on_ = false;
        maker_.shorten(node_, terms, length);
        Term made = terms::filled(
            tree,
            [&](const nodelang::Expr& part) -> const Term* {
                if (is_self(part)) return &self_;
                const auto place = place_of(part);
                return place ? &terms[numbers.at(*place)] : nullptr;
            },
            Type::None);
        for (const Term& each : terms) made.is_color |= each.is_color && width(each.type) > 1;
        return made;
    }

    static void find_places(const nodelang::Expr& tree, const std::function<void(std::size_t, std::size_t)>& found) {
        if (const auto place = place_of(tree)) found(*place, tree.text.size());
        for (const nodelang::Expr* const each : tree.args) find_places(*each, found);
    }

    // "Lerp(from={0}, to=1).second": a node of the library.
    Term call(std::string_view text) {
        const std::size_t open = text.find('('), close = text.rfind(')');
        ImportedNode made{.id = {}, .node = std::string(text.substr(0, open))};
        call_ = library().node(made.node);
        Term holds;
        std::string wanted;
        std::string transform;  // of a texture that is sampled without its own
        bool has_texel = false;
        for (const std::string& argument : arguments_of(text.substr(open + 1, close - open - 1))) {
            const std::size_t equals = argument.find('=');
            const std::string port = argument.substr(0, equals), value = argument.substr(equals + 1);
            const auto info = std::ranges::find_if(
                call_->ports, [&](const PortInfo& each) { return !each.is_output && each.name == port; });
            const bool is_word = value[0] >= 'A' && value[0] <= 'Z' && value.find('(') == value.npos;
            if (is_word) {
                if (info == call_->ports.end() || info->default_value != value) made.inputs.push_back({port, value});
                continue;
            }
            Term term = value_of(value, true);
            if (const Type type = info == call_->ports.end() ? Type::None : type_of_port(info->type);
                is_texture(type) && term.type != type) {
                maker_.approximate(node_, fmt::format("the node has no slot for its {}: it is white", word(type)));
                term = maker_.texture_constant(node_, type, nullptr, "", 0);
            }
            if (const auto only = only_placeholder(value); only && is_texture(term.type)) {
                transform = only->use == "size" ? "" : term.transform;
                if (only->use != "size") wanted = maker_.name_for_texture(std::string_view(term.text()).substr(1));
                has_texel |= only->use != "normal";
                note_texture(term, only->use);
            }
            holds.add_nodes(term);
            if (!transform.empty() && samples_at_its_uv(made.node) &&
                (port == "uv" || port == "right" || port == "down"))
                term = without_transform(term, port, transform);
            if (info == call_->ports.end() || !is_default(*info, term)) made.inputs.push_back({port, term.value()});
        }
        // Other nodes compute with the coordinates, too.
        if (!transform.empty() && !samples_at_its_uv(made.node))
            maker_.approximate(node_, "the tiling and the offset of its texture count here");
        const auto own = std::ranges::find(call_->ports, "sampler", &PortInfo::name);
        if (const auto sampler = maker_.linked_sampler(node_); sampler && own != call_->ports.end()) {
            holds.add_nodes(*sampler);
            made.inputs.push_back({"sampler", sampler->value()});
        }
        is_handed_on_ = false;
        if (is_step_ && !wanted.empty()) wanted += "Texel";
        if (is_step_) last_wanted_ = wanted.substr(0, wanted.size() - std::min<std::size_t>(wanted.size(), 5));
        if (!is_step_ && wanted.empty()) wanted = last_wanted_;
        const std::string id = maker_.add_node(node_, std::move(made), wanted);
        maker_.written(holds, fmt::format("the node '{}'", id));
        const bool is_first = close + 1 == text.size();
        Term term =
            link(id + std::string(text.substr(close + 1)), type_of_member(is_first ? "out" : text.substr(close + 2)));
        term.is_color = has_texel && term.type == Type::Float4;
        return term;
    }

    // A node that samples a texture says how the texture is used.
    void note_texture(const Term& term, std::string_view use) {
        if (use == "size") return;
        const TextureMeaning meaning = use == "normal" ? TextureMeaning::Normal
                                       : use == "data" ? TextureMeaning::Data
                                                       : TextureMeaning::Color;
        maker_.sample(term, meaning);
    }

    GraphMaker& maker_;
    const std::size_t node_;
    const NodeRule& rule_;
    const NodeFacts& facts_;
    std::map<int, std::size_t> counts_{};
    Term self_{};                     // "$"
    const NodeInfo* call_ = nullptr;  // the node of the library that was called last
    bool is_step_ = false;            // a further "$" reads this one
    std::string last_wanted_{};       // the name for what such a step leads to
    bool is_handed_on_ = false;       // the value is that of an input
};

}  // namespace

void GraphMaker::shorten(std::size_t index, std::vector<Term>& terms, std::size_t length) {
    constexpr std::size_t kLongest = 80;
    for (const Term& each : terms) length += each.text().size();
    while (length > kLongest) {
        Term* longest = nullptr;
        for (Term& each : terms)
            if (!each.is_constant() && !each.is_link() && each.owner && *each.owner != index &&
                (!longest || each.text().size() > longest->text().size()))
                longest = &each;
        if (!longest) return;
        const Term name = named(*longest);
        if (name.text() == longest->text()) return;
        length -= longest->text().size() - name.text().size();
        *longest = name;
    }
}

bool apply_rule(GraphMaker& maker, std::size_t node) {
    const NodeFacts facts{.is_linked = [&](int slot) { return maker.is_linked(node, slot); },
                          .is_used = [&](int slot) { return maker.is_used(node, slot); },
                          .components =
                              [&](int slot) {
                                  const Slot* found = maker.node(node).slot(slot);
                                  return found ? width(maker.type_of(node, *found)) : 1;
                              },
                          .is_in_fragment = maker.is_in_fragment(node)};
    const NodeRule* rule = rule_of(maker.node(node), facts);
    if (!rule) return false;
    if (rule->remark.starts_with("!"))
        maker.refuse(node, std::string(rule->remark.substr(1)));
    else
        Rule(maker, node, *rule, facts).apply();
    return true;
}

}  // namespace patina::importers::shadergraph

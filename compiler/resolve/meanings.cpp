#include "compiler/resolve/meanings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "compiler/resolve/meaning.h"

namespace patina::resolve {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;

using Kind = Meaning::Kind;

// The words of enumerations, as in Position(space).
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpaceWords = {
    {{"Object", "OS"}, {"World", "WS"}, {"View", "VS"}, {"Tangent", "TS"}}};

// A value: its meaning, and the textures on whose colours it depends.
struct Value {
    Meaning meaning{};
    const format::Property* texel_of = nullptr;  // Kind::Texel
    const format::Property* texture = nullptr;   // the value is this texture itself, or another property
    bool is_constant = false;                    // made of numbers alone
    std::set<const format::Property*> textures{};
    friend bool operator==(const Value&, const Value&) = default;
};
using Values = std::map<std::string_view, Value>;

const Attribute* attribute_of(std::span<const Attribute> attributes, std::string_view name) {
    const auto found =
        std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& each) { return each.name == name; });
    return found == attributes.end() ? nullptr : &*found;
}

// In how many ways a sub-graph is walked. Levels of sub-graphs that each give the next one another texture could have
// thousands.
constexpr std::size_t kMostWalks = 64;

// A graph during the walk: the material's, its lighting graph, or one use of a sub-graph.
struct Walk {
    const CheckedGraph& graph;
    Values inputs{};  // of a sub-graph
    std::vector<Value> values = std::vector<Value>(graph.nodes.size());
    std::vector<Values> outputs = std::vector<Values>(graph.nodes.size());  // of nodes that are sub-graphs
};

class Check {
public:
    Check(Session& session, const Material& material) : session_(session), material_(material) {}

    void run() {
        const format::Graph& graph = *material_.graph->graph;
        Walk walk{.graph = *material_.graph};
        walk_ = &walk;
        nodes();
        for (const format::PortValue& port : graph.surface) surface(port);
        for (const format::PortValue& port : graph.vertex) {
            if (!port.value) continue;
            const Value value = value_of(*port.value);
            compare(value, meaning_of(port.name), port.name, port.value_span);
            used_as_data(value);
        }
        for (const format::ExtraPass& pass : graph.passes) {
            for (const format::PortValue& port : pass.graph->surface) surface(port);
        }
        for (const format::PortValue& port : graph.lighting.inputs) {
            if (!port.value) continue;
            const Value value = value_of(*port.value);
            used_as_color(value);
        }
        if (material_.lighting && graph.lighting.inlined) lighting(*material_.lighting);
        for (const auto& [property, where] : data_) {
            const bool is_color = property->usage == TextureUsage::Color && !property->usage_span;
            if (!is_color || colors_.contains(property)) continue;
            session_.diagnostics
                .report(Code::WrongUsage, property->name_span, property->name, "a colour, decoded from sRGB")
                .note(
                    "all its uses are data: write \"usage\": \"data\", or \"usage\": \"color\" if it is meant to be "
                    "decoded");
        }
    }

private:
    // --- what nodes want and return

    // The meaning of a parameter or result: what its attribute says, or else its name.
    static Meaning declared(std::span<const Attribute> attributes, std::string_view name) {
        const Attribute* is = attribute_of(attributes, "is");
        return meaning_of(is ? nodelang::attribute_text(*is) : name);
    }

    // What a function is called with: the expression of a parameter; null: its default, or nothing.
    struct Argument {
        const ParamDecl* param = nullptr;
        const Expr* value = nullptr;
        Span where{};
    };

    // Of a node's result: [is("position", "space")] takes the space from the input `space`.
    static Meaning result_of(const FunctionDecl& function, std::span<const Argument> arguments) {
        const Attribute* is = function.attribute("is");
        if (!is) return {};
        Meaning made = meaning_of(nodelang::attribute_text(*is));
        if (is->args.size() < 2) return made;
        const std::string_view chosen = nodelang::attribute_text(*is, 1);
        std::string_view word;
        for (const ParamDecl& param : function.params) {
            if (param.name == chosen && param.initial) word = param.initial->text;
        }
        for (const Argument& argument : arguments) {
            if (argument.param->name == chosen) word = argument.value->text;
        }
        for (const auto& [name, space] : kSpaceWords) {
            if (name == word) made.space = space;
        }
        return made;
    }

    void nodes() {
        for (const std::uint32_t index : walk_->graph.order) node(index);
    }

    void node(std::uint32_t index) {
        const format::Node& node = walk_->graph.graph->nodes[index];
        const ResolvedNode& resolved = walk_->graph.nodes[index];
        if (!resolved.ok) return;
        node_ = node.id;
        if (node.is_expression) {
            if (node.expr) walk_->values[index] = value_of(*node.expr);
        } else if (resolved.function) {
            std::vector<Argument> arguments;
            for (const format::PortValue& port : node.inputs) {
                for (const ParamDecl& param : resolved.function->params) {
                    if (port.value && param.name == port.name)
                        arguments.push_back({.param = &param, .value = port.value, .where = port.value_span});
                }
            }
            walk_->values[index] = result(*resolved.function, arguments);
        } else if (resolved.subgraph) {
            sub_graph(index);
        }
        node_ = {};
    }

    Value result(const FunctionDecl& function, std::span<const Argument> arguments) {
        Value made{.meaning = result_of(function, arguments)};
        const format::Property* texture = nullptr;
        for (const Argument& argument : arguments) {
            const Value value = value_of(*argument.value);
            made.textures.insert(value.textures.begin(), value.textures.end());
            if (value.texture && is_texture(value.texture->type)) texture = value.texture;
            const Meaning wanted = declared(argument.param->attributes, argument.param->name);
            if (wanted.kind == Kind::NormalMap || wanted.kind == Kind::Texel)
                normal_map(wanted.kind == Kind::NormalMap ? value.texture : value.texel_of, argument.where);
            else if (wanted.kind == Kind::Data && value.texture)
                data_.emplace(value.texture, value.texture->name_span);
            else if (value.texture && argument.param->type.name.starts_with("Texture") &&
                     made.meaning.kind != Kind::Texel)
                colors_.insert(
                    value.texture);  // a node that does not declare a meaning may use the texture for anything
            else
                compare(value, wanted, argument.param->name, argument.where);
        }
        same_space(function, arguments);
        if (made.meaning.kind != Kind::Texel) return made;
        made.texel_of = texture;
        if (texture) made.textures.insert(texture);
        return made;
    }

    // What a parameter's default is: the value of a mesh, a camera or a light.
    Meaning default_of(const ParamDecl& param) const {
        if (!param.initial || param.is_out || attribute_of(param.attributes, "is")) return {};
        const Expr& initial = *param.initial;
        if (initial.kind == Expr::Kind::Name) return meaning_of(initial.text);
        const bool is_member = initial.kind == Expr::Kind::Member && initial.args[0]->kind == Expr::Kind::Name;
        return is_member ? member_of_semantic(initial.args[0]->text, initial.text) : Meaning{};
    }

    // "@light.direction": what the struct says of its member.
    Meaning member_of_semantic(std::string_view semantic, std::string_view member) const {
        const paths::SemanticDecl* declared_as = session_.paths->semantic(semantic);
        if (!declared_as) return {};
        const std::string_view type =
            declared_as->function ? declared_as->function->result.name : declared_as->variable->type.name;
        const nodelang::StructDecl* structure = session_.declarations->structure(type);
        if (!structure) return meaning_of(member);
        for (const auto& each : structure->members) {
            if (each.name == member) return declared(each.attributes, each.name);
        }
        return meaning_of(member);
    }

    // A node that takes several vectors wants them in one space. All spaces are equally good, but a vector without a
    // value has its default's space.
    void same_space(const FunctionDecl& function, std::span<const Argument> arguments) {
        std::vector<std::pair<Meaning, const Argument*>> vectors;  // with their defaults
        std::set<std::string_view> spaces;
        for (const ParamDecl& param : function.params) {
            const Meaning usual = default_of(param);
            if (!usual.is_vector()) continue;
            const auto given = std::find_if(arguments.begin(), arguments.end(),
                                            [&](const Argument& each) { return each.param == &param; });
            vectors.emplace_back(usual, given == arguments.end() ? nullptr : &*given);
            const Meaning now = given == arguments.end() ? usual : value_of(*given->value).meaning;
            if (now.is_vector() && !now.space.empty()) spaces.insert(now.space);
        }
        for (const auto& [usual, argument] : vectors) {
            if (!argument) continue;
            const Value value = value_of(*argument->value);
            const bool is_other_space = spaces.size() > 1 && value.meaning.space != usual.space;
            if (value.meaning.kind != usual.kind)
                compare(value, {.kind = usual.kind, .space = value.meaning.space}, argument->param->name,
                        argument->where);
            else if (is_other_space)
                compare(value, usual, argument->param->name, argument->where);
        }
    }

    // What is not known of outputs: anything may have been done to these textures.
    Values unknown_outputs(const Values& given, const std::vector<std::pair<Values, Values>>& known) {
        Value any;
        const auto add = [&](const Values& values) {
            for (const auto& [name, value] : values) {
                any.textures.insert(value.textures.begin(), value.textures.end());
                if (value.texture) any.textures.insert(value.texture);
            }
        };
        add(given);
        add(known.front().second);
        used_as_color(any);  // so that no texture seems to be used as data alone
        Values made = known.front().second;
        for (auto& [name, value] : made) value = any;
        return made;
    }

    // A sub-graph is walked with what it gets here. The same inputs give the same outputs.
    void sub_graph(std::uint32_t index) {
        const format::Node& node = walk_->graph.graph->nodes[index];
        const CheckedGraph& inside = *walk_->graph.nodes[index].subgraph;
        Values given;
        for (const format::PortValue& port : node.inputs) {
            if (!port.value) continue;
            given[port.name] = value_of(*port.value);
            compare(given[port.name], meaning_of(port.name), port.name, port.value_span);
        }
        auto& known = known_[&inside];
        auto found = std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == given; });
        if (found == known.end() && known.size() >= kMostWalks) {
            known.emplace_back(given, unknown_outputs(given, known));
            found = known.end() - 1;
        } else if (found == known.end()) {
            Walk walk{.graph = inside, .inputs = given};
            Walk* const outside = std::exchange(walk_, &walk);
            const std::string_view id = std::exchange(node_, {});
            nodes();
            Values made;
            for (const format::PortValue& output : inside.graph->outputs) {
                if (output.value) made[output.name] = value_of(*output.value);
                // If the value has no known meaning, the output has the meaning of its name.
                const Meaning said = meaning_of(output.name);
                if (output.value) compare(made[output.name], said, output.name, output.value_span);
                if (made[output.name].meaning.kind == Kind::Unknown) made[output.name].meaning = said;
            }
            walk_ = outside;
            node_ = id;
            known.emplace_back(std::move(given), std::move(made));
            found = known.end() - 1;
        }
        walk_->outputs[index] = found->second;
        if (found->second.size() == 1) walk_->values[index] = found->second.begin()->second;
    }

    // A lighting graph that the material states itself.
    void lighting(const CheckedGraph& graph) {
        Walk walk{.graph = graph};
        walk_ = &walk;
        nodes();
        for (const format::PortValue& port : graph.graph->outputs) {
            if (port.value) value_of(*port.value);
        }
    }

    // --- expressions

    Value property_of(const Expr& expr) const {
        if (const auto given = walk_->inputs.find(expr.text); given != walk_->inputs.end()) return given->second;
        const auto& all = walk_->graph.graph->properties;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const format::Property& each) { return each.name == expr.text; });
        return {.texture = found == all.end() ? nullptr : &*found};
    }

    Value member_of(const Expr& expr) {
        const Expr& whole = *expr.args[0];
        if (whole.kind == Expr::Kind::Name) {
            const auto found = walk_->graph.by_id.find(whole.text);
            if (found != walk_->graph.by_id.end()) {
                if (const std::optional<Value> output = output_of(found->second, expr.text)) return *output;
            }
        }
        const bool is_all = expr.text == "rgb" || expr.text == "xyz" || expr.text == "rgba" || expr.text == "xyzw";
        if (whole.kind == Expr::Kind::Semantic && !is_all)
            return {.meaning = member_of_semantic(whole.text, expr.text)};
        Value value = value_of(whole);
        value.texture = nullptr;
        if (is_alpha(expr.text, value.texel_of)) return {};  // alpha is never decoded
        if (!is_all) value.meaning = {}, value.texel_of = nullptr;
        return value;
    }

    // True for one component that is the alpha of the texture's file.
    static bool is_alpha(std::string_view component, const format::Property* texel_of) {
        const std::size_t at =
            std::min(std::string_view("rgba").find(component), std::string_view("xyzw").find(component));
        if (component.size() != 1 || at > 3) return false;
        return (texel_of && !texel_of->swizzle.empty() ? texel_of->swizzle[at] : "rgba"[at]) == 'a';
    }

    // A named output of a node, or of a sub-graph; nothing if it is not one.
    std::optional<Value> output_of(std::uint32_t node, std::string_view name) {
        const ResolvedNode& resolved = walk_->graph.nodes[node];
        if (resolved.subgraph) {
            const auto found = walk_->outputs[node].find(name);
            return found == walk_->outputs[node].end() ? std::nullopt : std::optional(found->second);
        }
        if (!resolved.function) return {};
        for (const ParamDecl& param : resolved.function->params) {
            if (!param.is_out || param.name != name) continue;
            return Value{.meaning = declared(param.attributes, param.name), .textures = walk_->values[node].textures};
        }
        return {};
    }

    // A node that an expression calls: the arguments follow its inputs, in their order.
    Value call(const FunctionDecl& function, const Expr& expr) {
        std::vector<Argument> arguments;
        auto next = expr.args.begin();
        for (const ParamDecl& param : function.params) {
            if (!param.is_input()) continue;
            if (next == expr.args.end()) break;
            arguments.push_back({.param = &param, .value = *next, .where = (*next)->span});
            ++next;
        }
        return result(function, arguments);
    }

    static bool is_constant(const Expr& expr, std::span<const Value> parts) {
        const bool is_operation = expr.kind == Expr::Kind::Unary || expr.kind == Expr::Kind::Binary;
        const bool is_vector =
            expr.kind == Expr::Kind::Call && (expr.text.starts_with("float") || expr.text.starts_with("half"));
        return (is_operation || is_vector) &&
               std::all_of(parts.begin(), parts.end(), [](const Value& part) { return part.is_constant; });
    }

    static bool is_sum(const Expr& expr) {
        return expr.kind == Expr::Kind::Binary && (expr.text == "+" || expr.text == "-");
    }

    // Vectors are added in one space: the first one's.
    void same_space(const Expr& sum, std::span<const Value> parts) {
        const Meaning &first = parts[0].meaning, &second = parts[1].meaning;
        if (!first.is_vector() || !second.is_vector()) return;
        const Meaning wanted{.kind = second.kind, .space = first.space};
        if (DiagnosticRecord* record = warn_of_other(parts[1], wanted, sum.text, sum.args[1]->span)) record->at(node_);
    }

    // The meaning of the result of an operation, from the meanings of its operands.
    static Meaning meaning_of_parts(const Expr& expr, std::span<const Value> parts) {
        const auto operand = [&](std::size_t i) {
            return Operand{.meaning = parts[i].meaning, .is_constant = parts[i].is_constant};
        };
        // A vector keeps its meaning if a number scales it. So it also keeps its meaning if a property, used as a
        // strength, scales it.
        const auto factor = [&](std::size_t i) {
            const bool is_strength = parts[i].texture && parts[i].texture->type == PropertyType::Float;
            return Operand{.meaning = parts[i].meaning, .is_constant = parts[i].is_constant || is_strength};
        };
        const bool is_call = expr.kind == Expr::Kind::Call;
        if (expr.kind == Expr::Kind::Unary && (expr.text == "-" || expr.text == "+")) return parts[0].meaning;
        if (is_sum(expr)) return sum_of(operand(0), operand(1), expr.text == "+");
        if (expr.kind == Expr::Kind::Binary && (expr.text == "*" || expr.text == "/"))
            return product_of(factor(0), factor(1), expr.text == "/");
        if (expr.kind == Expr::Kind::Ternary && parts.size() == 3) return mix_of(operand(1), operand(2));
        if (is_call && expr.text == "lerp" && parts.size() == 3) return mix_of(operand(0), operand(1));
        if (!is_call || expr.text != "normalize" || parts.size() != 1) return {};
        Meaning made = parts[0].meaning;
        if (made.kind == Kind::Position) made.kind = Kind::Direction;
        return made;
    }

    // The texture, if all texels among the parts are of one.
    static const format::Property* texel_of(std::span<const Value> parts) {
        const format::Property* found = nullptr;
        for (const Value& part : parts) {
            if (part.meaning.kind != Kind::Texel) continue;
            if (found && found != part.texel_of) return nullptr;
            found = part.texel_of;
        }
        return found;
    }

    Value value_of(const Expr& expr) {
        if (expr.kind == Expr::Kind::Name) {
            const auto found = walk_->graph.by_id.find(expr.text);
            return found == walk_->graph.by_id.end() ? Value() : walk_->values[found->second];
        }
        if (expr.kind == Expr::Kind::Number) return {.is_constant = true};
        if (expr.kind == Expr::Kind::Property) return property_of(expr);
        if (expr.kind == Expr::Kind::Semantic) return {.meaning = meaning_of(expr.text)};
        if (expr.kind == Expr::Kind::Member) return member_of(expr);
        if (expr.kind == Expr::Kind::Call) {
            if (const FunctionDecl* function = session_.library.declarations.function(expr.text))
                return call(*function, expr);
        }
        Value made;
        std::vector<Value> parts;
        for (const Expr* argument : expr.args) {
            parts.push_back(value_of(*argument));
            made.textures.insert(parts.back().textures.begin(), parts.back().textures.end());
        }
        if (is_sum(expr)) same_space(expr, parts);
        made.meaning = meaning_of_parts(expr, parts);
        made.is_constant = is_constant(expr, parts);
        if (made.meaning.kind == Kind::Texel) made.texel_of = texel_of(parts);
        return made;
    }

    // --- what is compared

    void surface(const format::PortValue& port) {
        if (!port.value) return;
        const Value value = value_of(*port.value);
        compare(value, meaning_of(port.name), port.name, port.value_span);
        bool is_color = true;
        for (const format::Input* input : material_.surface_inputs()) {
            if (input->name == port.name) is_color = input->type.starts_with("color");
        }
        if (is_color)
            used_as_color(value);
        else
            used_as_data(value);
    }

    void used_as_color(const Value& value) {
        colors_.insert(value.textures.begin(), value.textures.end());
        if (value.texture) colors_.insert(value.texture);
    }

    void used_as_data(const Value& value) {
        for (const format::Property* texture : value.textures) data_.emplace(texture, texture->name_span);
    }

    void normal_map(const format::Property* texture, Span where) {
        if (!texture) return;
        colors_.insert(texture);  // one warning is enough
        if (texture->usage != TextureUsage::Color) return;
        session_.diagnostics.report(Code::WrongUsage, where, texture->name, "a colour, decoded from sRGB")
            .at(node_)
            .note(texture->name_span, "it is a normal map: write \"usage\": \"normal\"");
    }

    void compare(const Value& value, const Meaning& wanted, std::string_view port, Span where) {
        if (DiagnosticRecord* record = warn_of_other(value, wanted, port, where)) record->at(node_, port);
    }

    // Null if the value may be what is wanted. `taker`: the port or the operator that takes it.
    DiagnosticRecord* warn_of_other(const Value& value, const Meaning& wanted, std::string_view taker, Span where) {
        if (!wanted.is_vector()) return nullptr;
        const Meaning& given = value.meaning;
        if (given.kind == Kind::Texel && wanted.kind == Kind::Direction) {
            colors_.insert(value.textures.begin(), value.textures.end());  // one warning is enough
            DiagnosticRecord& record = session_.diagnostics.report(Code::WrongMeaning, where, taker, described(wanted),
                                                                   "the texel of a texture");
            note_converter(record, {.kind = Kind::Texel}, wanted);
            return &record;
        }
        if (!given.is_vector()) return nullptr;
        const bool is_other_space = !given.space.empty() && !wanted.space.empty() && given.space != wanted.space;
        // A direction may be the offset of a position.
        const bool is_other_kind = given.kind != wanted.kind && wanted.space == given.space;
        if (!is_other_space && !is_other_kind) return nullptr;
        DiagnosticRecord& record =
            session_.diagnostics.report(Code::WrongMeaning, where, taker, described(wanted), described(given));
        note_converter(record, given, wanted);
        return &record;
    }

    // Names the library's nodes that take the one and return the other.
    void note_converter(DiagnosticRecord& record, const Meaning& from, const Meaning& to) const {
        std::string names;
        for (std::string_view name : session_.library.declarations.function_names()) {
            const FunctionDecl& function = *session_.library.declarations.function(name);
            const Attribute* is = function.attribute("is");
            if (!is || is->args.size() > 1 || meaning_of(nodelang::attribute_text(*is)) != to) continue;
            const bool takes = std::any_of(function.params.begin(), function.params.end(), [&](const ParamDecl& param) {
                if (param.is_out || param.type.name.starts_with("Texture")) return false;  // which is no value
                const Meaning wanted = declared(param.attributes, param.name);
                return wanted == from || (from.kind == Kind::Texel && wanted.kind == Kind::NormalMap);
            });
            if (takes) names += (names.empty() ? "'" : " or '") + std::string(name) + "'";
        }
        if (!names.empty()) record.note(fmt::format("convert it with {}", names));
        // No node brings a mesh's values into another space, because each is there in all of them.
        const std::string same = fmt::format("{}{}", to.kind == Kind::Position ? "position" : "normal", to.space);
        if (names.empty() && from.space != to.space && session_.paths->semantic(same))
            record.note(fmt::format("the mesh's own {} in this space is '@{}'",
                                    to.kind == Kind::Position ? "position" : "normal", same));
        if (from.kind == Kind::Position && to.kind == Kind::Direction)
            record.note("the direction from one position to another is their difference: normalize(b - a)");
        if (from.kind == Kind::Direction && to.kind == Kind::Position)
            record.note("a direction is an offset from a position: add it to one");
    }

    Session& session_;
    const Material& material_;
    Walk* walk_ = nullptr;
    std::string_view node_;  // the node that is being walked; empty: none
    std::map<const CheckedGraph*, std::vector<std::pair<Values, Values>>> known_;  // of sub-graphs: inputs, outputs
    std::map<const format::Property*, Span> data_;
    std::set<const format::Property*> colors_;
};

}  // namespace

void check_meanings(Session& session, const Material& material) {
    if (material.is_preview) return;
    Check(session, material).run();
}

}  // namespace patina::resolve

#include "compiler/resolve/meanings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace patina::graph {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;

enum class Kind : std::uint8_t { Unknown, Texel, NormalMap, Data, Direction, Position };
// The space as names end with it: "WS"; empty: not known.
struct Meaning {
    Kind kind = Kind::Unknown;
    std::string_view space{};
    friend bool operator==(const Meaning&, const Meaning&) = default;
};

constexpr std::array<std::string_view, 4> kSpaces = {"OS", "WS", "VS", "TS"};

// The words of enumerations, as in Position(space).
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kSpaceWords = {
    {{"Object", "OS"}, {"World", "WS"}, {"View", "VS"}, {"Tangent", "TS"}}};

std::string_view words_of_space(std::string_view space) {
    if (space == "OS") return "object space";
    if (space == "WS") return "world space";
    if (space == "VS") return "view space";
    return "tangent space";
}

// "normalTS", "positionWS", "texel"; of textures: "normalMap", "data"; without a space: "position", "direction".
Meaning meaning_of(std::string_view name) {
    if (name == "texel") return {.kind = Kind::Texel};
    if (name == "normalMap") return {.kind = Kind::NormalMap};
    if (name == "data") return {.kind = Kind::Data};
    Meaning made;
    if (name.size() > 2) {
        const std::string_view ending = name.substr(name.size() - 2);
        const auto space = std::find(kSpaces.begin(), kSpaces.end(), ending);
        if (space != kSpaces.end()) made.space = *space;
    }
    const bool is_position = name.find("osition") != name.npos || name.starts_with("point");
    if (made.space.empty() && name != "position" && name != "direction") return {};
    made.kind = is_position ? Kind::Position : Kind::Direction;
    return made;
}

std::string described(const Meaning& meaning) {
    const std::string_view what = meaning.kind == Kind::Position ? "a position" : "a direction";
    return meaning.space.empty() ? std::string(what) : fmt::format("{} in {}", what, words_of_space(meaning.space));
}

// A value: what it is, and the textures whose colours it depends on.
struct Value {
    Meaning meaning{};
    const Property* texel_of = nullptr;  // Kind::Texel
    std::set<const Property*> textures{};
};

const Attribute* attribute_of(std::span<const Attribute> attributes, std::string_view name) {
    const auto found =
        std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& each) { return each.name == name; });
    return found == attributes.end() ? nullptr : &*found;
}

class Check {
public:
    Check(Session& session, const Material& material)
        : session_(session), material_(material), graph_(*material.graph), values_(graph_.nodes.size()) {}

    void run() {
        for (const std::uint32_t index : graph_.order) node(index);
        for (const PortValue& port : graph_.graph->surface) surface(port);
        for (const PortValue& port : graph_.graph->vertex) {
            if (!port.value) continue;
            const Value value = value_of(*port.value);
            compare(value, meaning_of(port.name), port.name, port.value_span, {});
            used_as_data(value);
        }
        for (const ExtraPass& pass : graph_.graph->passes) {
            for (const PortValue& port : pass.graph->surface) surface(port);
        }
        for (const PortValue& port : graph_.graph->lighting.inputs) {
            if (!port.value) continue;
            const Value value = value_of(*port.value);
            colors_.insert(value.textures.begin(), value.textures.end());
            if (const Property* read = property_of(*port.value)) colors_.insert(read);
        }
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

    // Of a node's result: [is("position", "space")] takes the space from the input `space`.
    static Meaning result_of(const FunctionDecl& function, const Node& node) {
        const Attribute* is = function.attribute("is");
        if (!is) return {};
        Meaning made = meaning_of(nodelang::attribute_text(*is));
        if (is->args.size() < 2) return made;
        const std::string_view chosen = nodelang::attribute_text(*is, 1);
        std::string_view word;
        for (const ParamDecl& param : function.params) {
            if (param.name == chosen && param.initial) word = param.initial->text;
        }
        for (const PortValue& port : node.inputs) {
            if (port.name == chosen) word = port.value ? port.value->text : std::string_view();
        }
        for (const auto& [name, space] : kSpaceWords) {
            if (name == word) made.space = space;
        }
        return made;
    }

    void node(std::uint32_t index) {
        const Node& node = graph_.graph->nodes[index];
        const ResolvedNode& resolved = graph_.nodes[index];
        Value& made = values_[index];
        if (!resolved.ok) return;
        if (node.is_expression) {
            if (node.expr) made = value_of(*node.expr);
            return;
        }
        const Property* texture = nullptr;
        for (const PortValue& port : node.inputs) {
            if (!port.value) continue;
            const Value value = value_of(*port.value);
            made.textures.insert(value.textures.begin(), value.textures.end());
            const Property* read = property_of(*port.value);
            if (read && read->type == PropertyType::Texture2D) texture = read;
            if (!resolved.function) {
                if (read) colors_.insert(read);  // what a sub-graph does with a texture is not known
                compare(value, meaning_of(port.name), port.name, port.value_span, node.id);
                continue;
            }
            for (const ParamDecl& param : resolved.function->params) {
                if (param.name != port.name) continue;
                const Meaning wanted = declared(param.attributes, param.name);
                if (wanted.kind == Kind::NormalMap || wanted.kind == Kind::Texel)
                    normal_map(wanted.kind == Kind::NormalMap ? read : value.texel_of, node.id, port.value_span);
                else if (wanted.kind == Kind::Data && read)
                    data_.emplace(read, read->name_span);
                else if (read && param.type.name == "Texture2D" &&
                         result_of(*resolved.function, node).kind != Kind::Texel)
                    colors_.insert(read);  // nor what a node does with it that says nothing of it
                else
                    compare(value, wanted, port.name, port.value_span, node.id);
            }
        }
        if (!resolved.function) return;
        made.meaning = result_of(*resolved.function, node);
        if (made.meaning.kind != Kind::Texel) return;
        made.texel_of = texture;
        if (texture) made.textures.insert(texture);
    }

    // --- expressions

    const Property* property_of(const Expr& expr) const {
        if (expr.kind != Expr::Kind::Property) return nullptr;
        const auto& all = graph_.graph->properties;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Property& each) { return each.name == expr.text; });
        return found == all.end() ? nullptr : &*found;
    }

    Value member_of(const Expr& expr) {
        const Expr& whole = *expr.args[0];
        if (whole.kind == Expr::Kind::Name) {
            const auto found = graph_.by_id.find(whole.text);
            if (found != graph_.by_id.end()) {
                if (const std::optional<Value> output = output_of(found->second, expr.text)) return *output;
            }
        }
        Value value = value_of(whole);
        const bool is_alpha = expr.text == "a" || expr.text == "w";
        if (is_alpha) return {};  // alpha is never decoded
        const bool is_all = expr.text == "rgb" || expr.text == "xyz" || expr.text == "rgba" || expr.text == "xyzw";
        if (!is_all) value.meaning = {}, value.texel_of = nullptr;
        return value;
    }

    // A named output of a node, or of a sub-graph; nothing if it is not one.
    std::optional<Value> output_of(std::uint32_t node, std::string_view name) {
        const ResolvedNode& resolved = graph_.nodes[node];
        Value value{.textures = values_[node].textures};
        if (resolved.function) {
            for (const ParamDecl& param : resolved.function->params) {
                if (!param.is_out || param.name != name) continue;
                value.meaning = declared(param.attributes, param.name);
                return value;
            }
        } else if (resolved.subgraph) {
            for (const PortValue& output : resolved.subgraph->graph->outputs) {
                if (output.name != name) continue;
                value.meaning = meaning_of(name);
                return value;
            }
        }
        return {};
    }

    Value value_of(const Expr& expr) {
        if (expr.kind == Expr::Kind::Name) {
            const auto found = graph_.by_id.find(expr.text);
            return found == graph_.by_id.end() ? Value() : values_[found->second];
        }
        if (expr.kind == Expr::Kind::Semantic) return {.meaning = meaning_of(expr.text)};
        if (expr.kind == Expr::Kind::Member) return member_of(expr);
        Value made;
        std::vector<Value> parts;
        for (const Expr* argument : expr.args) {
            parts.push_back(value_of(*argument));
            made.textures.insert(parts.back().textures.begin(), parts.back().textures.end());
        }
        const auto is_vector = [](const Value& value) {
            return value.meaning.kind == Kind::Direction || value.meaning.kind == Kind::Position;
        };
        const bool is_sign = expr.kind == Expr::Kind::Unary && (expr.text == "-" || expr.text == "+");
        const bool is_normalize = expr.kind == Expr::Kind::Call && expr.text == "normalize";
        if ((is_sign || is_normalize) && parts.size() == 1 && is_vector(parts[0])) {
            made.meaning = parts[0].meaning;
            if (is_normalize) made.meaning.kind = Kind::Direction;
        }
        if (expr.kind == Expr::Kind::Binary && parts.size() == 2) {
            const bool is_sum = expr.text == "+" || expr.text == "-", is_scale = expr.text == "*" || expr.text == "/";
            const bool is_number = expr.args[1]->kind == Expr::Kind::Number;
            if (is_sum && is_vector(parts[0]) && parts[0].meaning == parts[1].meaning) made.meaning = parts[0].meaning;
            // The difference of positions is a direction.
            if (expr.text == "-" && made.meaning.kind == Kind::Position) made.meaning.kind = Kind::Direction;
            if (is_scale && is_number && is_vector(parts[0])) made.meaning = parts[0].meaning;
        }
        return made;
    }

    // --- what is compared

    void surface(const PortValue& port) {
        if (!port.value) return;
        const Value value = value_of(*port.value);
        compare(value, meaning_of(port.name), port.name, port.value_span, {});
        bool is_color = true;
        for (const Input* input : material_.surface_inputs()) {
            if (input->name == port.name) is_color = input->type.starts_with("color");
        }
        if (is_color)
            colors_.insert(value.textures.begin(), value.textures.end());
        else
            used_as_data(value);
    }

    void used_as_data(const Value& value) {
        for (const Property* texture : value.textures) data_.emplace(texture, texture->name_span);
    }

    void normal_map(const Property* texture, const std::string& node, Span where) {
        if (!texture) return;
        colors_.insert(texture);  // one warning is enough
        if (texture->usage != TextureUsage::Color) return;
        session_.diagnostics.report(Code::WrongUsage, where, texture->name, "a colour, decoded from sRGB")
            .at(node)
            .note(texture->name_span, "it is a normal map: write \"usage\": \"normal\"");
    }

    void compare(const Value& value, const Meaning& wanted, std::string_view port, Span where,
                 const std::string& node) {
        if (wanted.kind != Kind::Direction && wanted.kind != Kind::Position) return;
        const Meaning& given = value.meaning;
        if (given.kind == Kind::Texel && wanted.kind == Kind::Direction) {
            colors_.insert(value.textures.begin(), value.textures.end());  // one warning is enough
            DiagnosticRecord& record = session_.diagnostics.report(Code::WrongMeaning, where, port, described(wanted),
                                                                   "the texel of a texture");
            record.at(node, port);
            note_converter(record, {.kind = Kind::Texel}, wanted);
            return;
        }
        if (given.kind != Kind::Direction && given.kind != Kind::Position) return;
        const bool is_other_space = !given.space.empty() && !wanted.space.empty() && given.space != wanted.space;
        // A direction may be the offset of a position.
        const bool is_other_kind = given.kind != wanted.kind && wanted.space == given.space;
        if (!is_other_space && !is_other_kind) return;
        DiagnosticRecord& record =
            session_.diagnostics.report(Code::WrongMeaning, where, port, described(wanted), described(given));
        record.at(node, port);
        note_converter(record, given, wanted);
    }

    // Names the library's nodes that take the one and return the other.
    void note_converter(DiagnosticRecord& record, const Meaning& from, const Meaning& to) const {
        std::string names;
        for (std::string_view name : session_.library.declarations.function_names()) {
            const FunctionDecl& function = *session_.library.declarations.function(name);
            const Attribute* is = function.attribute("is");
            if (!is || is->args.size() > 1 || meaning_of(nodelang::attribute_text(*is)) != to) continue;
            const bool takes = std::any_of(function.params.begin(), function.params.end(), [&](const ParamDecl& param) {
                if (param.is_out) return false;
                const Meaning wanted = declared(param.attributes, param.name);
                return wanted == from || (from.kind == Kind::Texel && wanted.kind == Kind::NormalMap);
            });
            if (takes) names += (names.empty() ? "'" : " or '") + std::string(name) + "'";
        }
        if (!names.empty()) record.note(fmt::format("convert it with {}", names));
    }

    Session& session_;
    const Material& material_;
    const CheckedGraph& graph_;
    std::vector<Value> values_;
    std::map<const Property*, Span> data_;
    std::set<const Property*> colors_;
};

}  // namespace

void check_meanings(Session& session, const Material& material) {
    if (material.is_preview) return;
    Check(session, material).run();
}

}  // namespace patina::graph

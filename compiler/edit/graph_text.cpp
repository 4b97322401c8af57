#include "compiler/edit/graph_text.h"

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/format/color.h"
#include "compiler/format/read_graph.h"
#include "compiler/format/scene/read_scene.h"
#include "compiler/json/json_text.h"

namespace patina::edit {
namespace {

using nodelang::Expr;

// --- expressions

class Collector {
public:
    explicit Collector(std::vector<PlacedExpr>& out) : out_(out) {}

    void add(const format::Graph& graph) {
        for (const format::Node& node : graph.nodes) {
            add({"nodes", node.id, "expr"}, node.expr);
            add({"nodes", node.id, "in"}, node.inputs);
        }
        const char* inputs = graph.kind == format::GraphKind::Lighting ? "surface" : "inputs";
        for (const format::Input& input : graph.inputs) {
            add({inputs, input.name, "default"}, input.value);
            add({inputs, input.name, "as"}, input.as);
        }
        add(graph.kind == format::GraphKind::Lighting ? Path{} : Path{"outputs"}, graph.outputs);
        add_looks({}, graph);
        for (const format::ExtraPass& pass : graph.passes) add_looks({"passes", pass.name}, *pass.graph);
    }

private:
    void add(Path path, const Expr* expr) {
        if (expr) out_.push_back({std::move(path), expr});
    }
    void add(const Path& path, const std::vector<format::PortValue>& values) {
        for (const format::PortValue& value : values) {
            Path of_value = path;
            of_value.push_back(value.name);
            add(std::move(of_value), value.value);
        }
    }
    void add_looks(const Path& path, const format::Graph& graph) {
        const auto at = [&](std::initializer_list<const char*> keys) {
            Path longer = path;
            longer.insert(longer.end(), keys.begin(), keys.end());
            return longer;
        };
        add(at({"lighting", "in"}), graph.lighting.inputs);
        add(at({"vertex"}), graph.vertex);
        add(at({"surface"}), graph.surface);
    }

    std::vector<PlacedExpr>& out_;
};

bool is_same(const Expr& a, const Expr& b, const Renaming& renaming) {
    if (a.kind != b.kind || a.number_kind != b.number_kind || a.number != b.number || a.args.size() != b.args.size())
        return false;
    switch (a.kind) {
        case Expr::Kind::Color:          // #fc8 is #ffcc88
        case Expr::Kind::Number: break;  // 0.25 is 2.5e-1
        case Expr::Kind::Name:
            if (!renaming.nodes.match(a.text, b.text)) return false;
            break;
        case Expr::Kind::Property:
            if (!renaming.dollar.match(a.text, b.text)) return false;
            break;
        case Expr::Kind::Member:
            if (reads_surface(a) ? !renaming.surface.match(a.text, b.text) : a.text != b.text) return false;
            break;
        case Expr::Kind::Bool:
        case Expr::Kind::List:
        case Expr::Kind::Semantic:
        case Expr::Kind::Index:
        case Expr::Kind::Call:
        case Expr::Kind::Method:
        case Expr::Kind::Unary:
        case Expr::Kind::Binary:
        case Expr::Kind::Ternary:
        case Expr::Kind::File:
        case Expr::Kind::Object:
        case Expr::Kind::Assign:
        case Expr::Kind::AssignLater:
        case Expr::Kind::Sequence:
            if (a.text != b.text) return false;
    }
    for (std::size_t i = 0; i < a.args.size(); ++i) {
        if (!is_same(*a.args[i], *b.args[i], renaming)) return false;
    }
    return true;
}

// --- reading

// Where all numbers become floats, 1 is 1.0: in lists, and as the value of a surface's input.
const Expr* with_floats(const Expr& expr, GraphText& text) {
    if (expr.kind != Expr::Kind::Number && expr.kind != Expr::Kind::List) return &expr;
    Expr floats = expr;
    floats.number_kind = nodelang::NumberKind::Float;
    for (const Expr*& argument : floats.args) argument = with_floats(*argument, text);
    return &text.ast.exprs.emplace_back(std::move(floats));
}

// The values at ports, by their place. A string is an expression there, and a list a vector.
void note_values(const format::Graph& graph, GraphText& text) {
    const auto note = [&](Span span, const Expr* expr) {
        if (expr) text.values.emplace(span.begin, expr->kind == Expr::Kind::List ? with_floats(*expr, text) : expr);
    };
    const auto note_all = [&](const std::vector<format::PortValue>& values) {
        for (const format::PortValue& value : values) note(value.value_span, value.value);
    };
    for (const format::Node& node : graph.nodes) {
        note(node.expr_span, node.expr);
        note_all(node.inputs);
    }
    for (const format::Input& input : graph.inputs) note(input.default_span, input.value);
    note_all(graph.vertex);
    for (const format::PortValue& value : graph.surface) {
        if (value.value) note(value.value_span, with_floats(*value.value, text));
    }
    note_all(graph.outputs);
    note_all(graph.lighting.inputs);
    if (graph.lighting.inlined) note_values(*graph.lighting.inlined, text);
    for (const format::ExtraPass& pass : graph.passes) note_values(*pass.graph, text);
}

// The colours in the defaults of properties and in scenes: "#AABBCC" is "#abc".
void note_colors(const json::Json& json, GraphText& text) {
    if (json.kind == json::Json::Kind::String) {
        const std::optional<format::LinearColor> color = format::parse_color(json.string);
        if (!color) return;
        Expr value;
        value.kind = Expr::Kind::Color;
        for (const double component : color->value) {
            Expr number;
            number.number = component;
            number.kind = Expr::Kind::Number;
            value.args.push_back(&text.ast.exprs.emplace_back(std::move(number)));
        }
        text.values.emplace(json.span.begin, &text.ast.exprs.emplace_back(std::move(value)));
    }
    for (const json::Json& element : json.elements) note_colors(element, text);
    for (const json::JsonMember& member : json.members) note_colors(member.value, text);
}

TreeValue member_value(const TreeValue& object, const json::JsonMember& member) {
    TreeValue value{object.text, &member.value, format::ObjectKind::Free, false};
    if (const format::KeyInfo* key = format::find_key(object.kind, member.key)) {
        value.kind = format::value_kind(*key, member.value);
        value.is_set = key->is_set;
    }
    return value;
}

// If the string of a member is a name: the pairs of names for its kind.
const NamePairs* names_of(const TreeValue& object, const json::JsonMember& member, const Renaming& renaming) {
    if (member.key != format::identity_of(object.kind) || member.value.kind != json::Json::Kind::String) return nullptr;
    if (object.kind == format::ObjectKind::Node) return &renaming.nodes;
    if (object.kind == format::ObjectKind::Property) return &renaming.dollar;
    if (object.kind != format::ObjectKind::Input) return nullptr;
    return object.text->kind == format::ObjectKind::Lighting ? &renaming.surface : &renaming.dollar;
}

TreeValue child_at(const TreeValue& value, std::size_t i) {
    if (value.json->kind == json::Json::Kind::Object) return member_value(value, value.json->members[i]);
    return {value.text, &value.json->elements[i], value.kind, false};
}

// So many are listed in the time of one step.
constexpr std::size_t kChildrenOfAStep = 8;

bool is_same_object(const TreeValue& a, const TreeValue& b, const Renaming& renaming) {
    if (a.json->members.size() != b.json->members.size()) return false;
    std::unordered_map<std::string_view, const json::JsonMember*> others;
    for (const json::JsonMember& member : b.json->members) others.emplace(member.key, &member);
    return std::all_of(a.json->members.begin(), a.json->members.end(), [&](const json::JsonMember& member) {
        const auto found = others.find(member.key);
        if (found == others.end()) return false;
        const json::JsonMember& other = *found->second;
        if (const NamePairs* names = names_of(a, member, renaming);
            names && other.value.kind == json::Json::Kind::String)
            return names->match(member.value.string, other.value.string);
        return is_same(member_value(a, member), member_value(b, other), renaming);
    });
}

// Each child of the one is a child of the other. Lists without order are short.
bool is_same_set(const std::vector<TreeChild>& a, const std::vector<TreeChild>& b, const Renaming& renaming) {
    std::vector<bool> taken(b.size(), false);
    std::size_t first = 0;  // that is not taken
    for (const TreeChild& child : a) {
        while (first < b.size() && taken[first]) ++first;
        std::size_t i = first;
        while (i < b.size() && (taken[i] || !is_same(child.value, b[i].value, renaming))) ++i;
        if (i == b.size()) return false;
        taken[i] = true;
    }
    return true;
}

bool is_same_array(const TreeValue& a, const TreeValue& b, const Renaming& renaming) {
    if (a.json->elements.size() != b.json->elements.size()) return false;
    const Shape shape = shape_of(a);
    if (shape == Shape::ByContent) return is_same_set(children_of(a), children_of(b), renaming);
    if (shape == Shape::ByName && !format::is_ordered(a.kind)) {
        std::unordered_map<std::string, TreeValue> by_name;
        for (TreeChild& child : children_of(b)) by_name.emplace(child.name, child.value);
        const std::vector<TreeChild> children = children_of(a);
        return std::all_of(children.begin(), children.end(), [&](const TreeChild& child) {
            const auto other = by_name.find(child.name);
            return other != by_name.end() && is_same(child.value, other->second, renaming);
        });
    }
    for (std::size_t i = 0; i < a.json->elements.size(); ++i) {
        const TreeValue left{a.text, &a.json->elements[i], a.kind, false};
        const TreeValue right{b.text, &b.json->elements[i], b.kind, false};
        if (!is_same(left, right, renaming)) return false;
    }
    return true;
}

}  // namespace

std::unique_ptr<GraphText> read_graph_text(const std::string& path, std::string bytes) {
    auto text = std::make_unique<GraphText>();
    text->base = text->sources.add(path, std::move(bytes));
    text->json = json::parse_json(text->sources, text->base, text->diagnostics);
    if (!text->json) return text;
    text->kind = format::top_level_kind(*text->json);
    if (text->kind == format::ObjectKind::Scene) {
        const auto as_written = [](const std::string& name, Span) { return name; };
        const format::SceneFiles files{.find = as_written, .require = as_written, .require_graph = as_written};
        const format::Reading reading{text->sources, text->ast, text->diagnostics};
        format::read_scene(reading, *text->json, path, format::name_of_file(path), files);
        note_colors(*text->json, *text);
    } else {
        const std::shared_ptr<format::Graph> graph =
            format::read_graph(*text->json, path, text->sources, text->ast, text->diagnostics, std::nullopt);
        note_values(*graph, *text);
        if (const json::Json* properties = text->json->find("properties")) {
            for (const json::Json& property : properties->elements) {
                if (const json::Json* value = property.find("default")) note_colors(*value, *text);
            }
        }
        text->graph = graph;
    }
    text->ok = !text->diagnostics.has_errors();
    return text;
}

Shape shape_of(const TreeValue& value) {
    const json::Json& json = *value.json;
    if (json.kind == json::Json::Kind::Object) return Shape::ByKey;
    if (json.kind != json::Json::Kind::Array) return Shape::Whole;
    if (value.is_set) return Shape::ByContent;
    if (!format::identity_of(value.kind).empty()) return Shape::ByName;
    return value.kind == format::ObjectKind::Free ? Shape::Whole : Shape::ByPosition;
}

std::vector<TreeChild> children_of(const TreeValue& value) {
    Cancellation::step(1 + (value.json->members.size() + value.json->elements.size()) / kChildrenOfAStep);
    std::vector<TreeChild> children;
    for (const json::JsonMember& member : value.json->members)
        children.push_back({member.key, member_value(value, member)});
    const Shape shape = shape_of(value);
    for (std::size_t i = 0; i < value.json->elements.size(); ++i) {
        const json::Json& element = value.json->elements[i];
        std::string name = std::to_string(i);
        if (shape == Shape::ByName) {
            const json::Json* identity = element.find(format::identity_of(value.kind));
            name = identity ? identity->string : std::string();
        } else if (shape == Shape::ByContent) {
            name.clear();
            json::append_one_line(name, element, value.text->sources);
        }
        children.push_back({std::move(name), {value.text, &element, value.kind, false}});
    }
    return children;
}

bool NamePairs::match(std::string_view a, std::string_view b) const {
    if (const auto pair = pairs.find(a); pair != pairs.end()) return pair->second == b;
    if (any_of_a.count(a) && any_of_b.count(b)) return true;
    return a == b;
}

bool is_same(const TreeValue& a, const TreeValue& b, const Renaming& renaming) {
    Cancellation::step();
    const json::Json &left = *a.json, &right = *b.json;
    const auto left_value = a.text->values.find(left.span.begin), right_value = b.text->values.find(right.span.begin);
    if (left_value != a.text->values.end() && right_value != b.text->values.end())
        return is_same(*left_value->second, *right_value->second, renaming);
    if (left.kind != right.kind) return false;
    switch (left.kind) {
        case json::Json::Kind::Null: return true;
        case json::Json::Kind::Bool: return left.boolean == right.boolean;
        case json::Json::Kind::Number: return left.number == right.number;
        case json::Json::Kind::String: return left.string == right.string;
        case json::Json::Kind::Array: return is_same_array(a, b, renaming);
        case json::Json::Kind::Object: return a.kind == b.kind && is_same_object(a, b, renaming);
    }
    return false;
}

bool reads_surface(const Expr& expr) {
    return expr.kind == Expr::Kind::Member && expr.args[0]->kind == Expr::Kind::Semantic &&
           expr.args[0]->text == "surface";
}

std::string to_string(const Path& path) {
    std::string text;
    for (const std::string& part : path) text += (text.empty() ? "" : ".") + json::shown(part);
    return text;
}

bool starts_with(const Path& path, const Path& start) {
    return path.size() >= start.size() && std::equal(start.begin(), start.end(), path.begin());
}

TreeValue find(const GraphText& text, const Path& path) {
    TreeValue value = text.root();
    for (const std::string& name : path) {
        const auto [index, is_new] = text.children.try_emplace(value.json);
        if (is_new) {
            std::size_t i = 0;
            for (TreeChild& child : children_of(value)) index->second.emplace(std::move(child.name), i++);
        }
        const auto child = index->second.find(name);
        if (child == index->second.end()) return {};
        value = child_at(value, child->second);
    }
    return value;
}

Path path_at(const GraphText& text, std::uint32_t offset) {
    Path path;
    TreeValue value = text.root();
    for (bool is_inside = true; is_inside && shape_of(value) != Shape::Whole;) {
        is_inside = false;
        for (TreeChild& child : children_of(value)) {
            // A member's key belongs to it.
            std::uint32_t begin = child.value.json->span.begin;
            for (const json::JsonMember& member : value.json->members) {
                if (&member.value == child.value.json) begin = member.key_span.begin - 1;
            }
            if (offset < begin || offset >= child.value.json->span.end) continue;
            path.push_back(child.name);
            value = child.value;
            is_inside = true;
            break;
        }
    }
    return path;
}

std::vector<PlacedExpr> expressions_of(const format::Graph& graph) {
    std::vector<PlacedExpr> all;
    Collector(all).add(graph);
    return all;
}

}  // namespace patina::edit

#include "compiler/format/read_fields.h"
#include "compiler/format/read_graph.h"

namespace patina::format {
namespace {

void read_expression_node(Reading& reading, const json::Json& json, const json::Json& expr, Node& node) {
    node.is_expression = true;
    node.expr_span = expr.span;
    if (const json::JsonMember* in = find_member(json, "in")) {
        reading.diagnostics.report(Code::UnknownKey, in->key_span, "in", "an expression")
            .note("an expression reads other nodes by their ids");
    }
    const std::string* text = read_string(reading, expr, "'expr'");
    if (!text) return;
    if (text->empty()) {
        reading.diagnostics.report(Code::Syntax, expr.span, "an expression", "an empty string");
    } else if (text->starts_with('=')) {
        reading.diagnostics.report(Code::BadCharacter, Span{expr.span.begin + 1, expr.span.begin + 2}, "'='")
            .note("'expr' is an expression already: leave out the '='");
    } else {
        node.expr = read_expression(reading, expr, 0);
    }
}

void read_library_node(Reading& reading, const json::Json& json, const json::Json& type, Node& node) {
    if (const std::string* text = read_string(reading, type, "'node'")) node.type = *text;
    node.type_span = type.kind == json::Json::Kind::String ? inside(type.span) : type.span;
    if (const json::Json* in = json.find("in")) node.inputs = read_ports(reading, *in, "'in'", node.id);
}

// The id comes first: every later message names the node by it.
void read_id(Reading& reading, const json::Json& json, Node& node, UniqueNames& ids) {
    const json::Json* id = json.find("id");
    if (!id) return;
    node.id = read_identifier(reading, *id, "'id'");
    node.id_span = id->kind == json::Json::Kind::String ? inside(id->span) : id->span;
    reading.diagnostics.set_context(node.id, {});
    if (id->kind == json::Json::Kind::String) ids.add(reading, *id, "node");
}

Node read_node(Reading& reading, const json::Json& json, UniqueNames& ids) {
    Node node;
    node.span = json.span;
    read_id(reading, json, node, ids);
    check_keys(reading, json, ObjectKind::Node);

    const json::JsonMember* type = find_member(json, "node");
    const json::JsonMember* expr = find_member(json, "expr");
    if (type && expr) {
        reading.diagnostics.report(Code::ConflictingInputs, expr->key_span, "node", "expr");
    } else if (expr) {
        read_expression_node(reading, json, expr->value, node);
    } else if (type) {
        read_library_node(reading, json, type->value, node);
    } else {
        const std::string what = node.id.empty() ? "a node" : fmt::format("the node '{}'", json::shown(node.id));
        reading.diagnostics.report(Code::MissingKey, opening(json), what, "node")
            .note("or the key 'expr', with an expression");
    }

    if (const json::Json* stage = read_word(reading, json, "stage", "a stage", node.stage))
        node.stage_span = stage->span;
    read_word(reading, json, "precision", "a precision", node.precision);
    node.note = read_text(reading, json, "note");
    return node;
}

}  // namespace

std::vector<Node> read_nodes(Reading& reading, const json::Json& array) {
    std::vector<Node> nodes;
    if (!expect(reading, array, json::Json::Kind::Array, "'nodes'")) return nodes;
    UniqueNames ids;
    nodes.reserve(array.elements.size());
    for (const json::Json& element : array.elements) {
        if (expect(reading, element, json::Json::Kind::Object, "a node"))
            nodes.push_back(read_node(reading, element, ids));
        reading.diagnostics.set_context({}, {});
    }
    return nodes;
}

}  // namespace patina::format

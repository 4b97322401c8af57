#include "compiler/api/describe/describe.h"

#include <algorithm>

#include "compiler/base/letters.h"
#include "compiler/resolve/check_graph.h"

namespace patina {

using nodelang::Expr;

namespace {

constexpr std::string_view kSpaces = " \t\r";

// "@uv0" for a semantic default, the source text for a constant.
std::string default_text(const Expr& expr, const EvaluationContext& context) {
    const Expr* root = &expr;
    while (root->kind == Expr::Kind::Member) root = root->args[0];
    const bool by_name = root->kind == Expr::Kind::Name && context.library.paths.semantic_index.contains(root->text);
    std::string text(context.sources.text(expr.span));
    return by_name ? "@" + text : text;
}

std::string doc_line(std::string_view doc) {
    doc = trimmed(doc, kSpaces);
    while (doc.starts_with('/') || doc.starts_with('<')) doc.remove_prefix(1);
    return std::string(trimmed(doc, kSpaces));
}

// An `inout` parameter is two ports.
PortInfo describe_param(const nodelang::ParamDecl& param, bool is_output, const EvaluationContext& context) {
    PortInfo port{.name = std::string(param.name),
                  .type = std::string(param.type.name),
                  .is_output = is_output,
                  .default_value = {},
                  .range = {},
                  .unit = {},
                  .doc = doc_line(param.doc),
                  .enumerators = {}};
    if (param.initial) port.default_value = default_text(*param.initial, context);
    port.range = resolve::range_of(param.attributes);
    for (const nodelang::Attribute& attribute : param.attributes) {
        if (attribute.name == "unit") port.unit = nodelang::attribute_text(attribute);
    }
    if (const nodelang::EnumDecl* enumeration = context.declarations.enumeration(param.type.name)) {
        for (std::size_t i = 0; i < enumeration->values.size(); ++i) {
            const std::string_view doc = i < enumeration->docs.size() ? enumeration->docs[i] : std::string_view();
            port.enumerators.push_back({.name = std::string(enumeration->values[i]), .doc = doc_line(doc)});
        }
    }
    return port;
}

std::string_view rate(paths::SemanticSource source) {
    switch (source) {
        case paths::SemanticSource::Attribute:
        case paths::SemanticSource::Vertex: return "vertex";
        case paths::SemanticSource::Builtin:
        case paths::SemanticSource::Pixel: return "pixel";
        case paths::SemanticSource::Extern:
        case paths::SemanticSource::Uniform: return "uniform";
        case paths::SemanticSource::Given: return "lighting";
    }
    return {};
}

}  // namespace

Doc read_doc(std::string_view comment) {
    Doc doc;
    std::size_t at = 0;
    while (at < comment.size()) {
        const std::size_t end = std::min(comment.find('\n', at), comment.size());
        std::string_view line = comment.substr(at, end - at);
        at = end + 1;
        line = trimmed(line, kSpaces);
        while (line.starts_with('/')) line.remove_prefix(1);
        line = trimmed(line, kSpaces);
        const auto keyword = [&](std::string_view word, std::string& into) {
            if (!line.starts_with(word)) return false;
            if (!into.empty()) into += "\n";
            into += trimmed(line.substr(word.size()), kSpaces);
            return true;
        };
        if (line.starts_with("test:")) {
            const std::string_view text = trimmed(line.substr(5), kSpaces);
            doc.tests.push_back({.text = text, .offset = static_cast<std::uint32_t>(text.data() - comment.data())});
        } else if (!keyword("formula:", doc.formula) && !keyword("source:", doc.source) && !keyword("use:", doc.use) &&
                   !keyword("unit:", doc.unit) && !keyword("space:", doc.space) && !keyword("block:", doc.block)) {
            doc.text += line;
            doc.text += '\n';
        }
    }
    while (!doc.text.empty() && doc.text.back() == '\n') doc.text.pop_back();
    return doc;
}

NodeInfo describe_node(const nodelang::FunctionDecl& function, const EvaluationContext& context) {
    NodeInfo node;
    node.name = function.name;
    const std::string_view path = nodelang::attribute_text(*function.attribute("node"));
    node.category = path.substr(0, path.rfind('/') == std::string_view::npos ? path.size() : path.rfind('/'));
    if (const nodelang::Attribute* also = function.attribute("also")) {
        for (const nodelang::Expr* name : also->args) node.also.emplace_back(name->text);
    }
    Doc doc = read_doc(function.doc);
    node.doc = std::move(doc.text);
    node.formula = std::move(doc.formula);
    node.source = std::move(doc.source);
    for (const Doc::TestLine& test : doc.tests) node.tests.emplace_back(test.text);
    node.file = context.sources.file(function.name_span.begin);
    for (const nodelang::ParamDecl& param : function.params) {
        const bool hidden = std::any_of(param.attributes.begin(), param.attributes.end(),
                                        [](const nodelang::Attribute& a) { return a.name == "hidden"; });
        if (param.is_input() && !hidden) node.ports.push_back(describe_param(param, false, context));
    }
    if (function.result.name != "void") {
        node.ports.push_back({.name = "out",
                              .type = std::string(function.result.name),
                              .is_output = true,
                              .default_value = {},
                              .range = resolve::range_of(function.attributes),
                              .unit = {},
                              .doc = {},
                              .enumerators = {}});
    }
    for (const nodelang::ParamDecl& param : function.params) {
        if (param.is_out) node.ports.push_back(describe_param(param, true, context));
    }
    return node;
}

std::vector<SemanticInfo> describe_semantics(const resolve::Library& library) {
    std::vector<SemanticInfo> all;
    for (const paths::SemanticDecl& semantic : library.paths.semantics) {
        if (semantic.is_of_pass) continue;  // no graph can read it
        const std::string_view type = semantic.function ? semantic.function->result.name : semantic.variable->type.name;
        const std::string_view doc = semantic.function ? semantic.function->doc : semantic.variable->doc;
        all.push_back({.name = std::string(semantic.name),
                       .type = std::string(type),
                       .doc = read_doc(doc).text,
                       .rate = std::string(rate(semantic.source))});
        // The members of a [given] struct are what a lighting graph reads: @surface.roughness.
        const nodelang::StructDecl* structure = library.declarations.structure(type);
        if (!structure) continue;
        for (const nodelang::MemberDecl& member : structure->members) {
            all.push_back({.name = fmt::format("{}.{}", semantic.name, member.name),
                           .type = std::string(member.type.name),
                           .doc = doc_line(member.doc),
                           .rate = std::string(rate(semantic.source))});
        }
        for (const nodelang::FunctionDecl* function : all_functions(library)) {
            if (!function->attribute("member") || function->params.empty() || function->params[0].type.name != type)
                continue;
            all.push_back({.name = fmt::format("{}.{}", semantic.name, function->name),
                           .type = std::string(function->result.name),
                           .doc = read_doc(function->doc).text,
                           .rate = std::string(rate(semantic.source))});
        }
    }
    return all;
}

}  // namespace patina

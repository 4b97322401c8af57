// Checks the functions of a pass file: which attributes each function may have, the values that it gives to other
// passes, and the recipes of semantics.
#include <fmt/format.h>

#include <array>
#include <set>

#include "compiler/base/text.h"
#include "compiler/paths/declaration_check.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Declarations;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;
using nodelang::TypeName;

// The attributes of a pass's fragment function; others have a meaning on other functions, too.
constexpr std::array<std::string_view, 19> kOfFragment = {
    "draws",   "each",   "lights",   "camera", "fallback", "cull",  "blend", "depth",    "depthTarget", "depthBias",
    "stencil", "target", "optional", "extra",  "alone",    "along", "needs", "excludes", "lacks"};
// The attributes of a node: a graph finds none in a pass file.
constexpr std::array<std::string_view, 4> kOfNode = {"node", "also", "is", "range"};
constexpr std::array<std::string_view, 12> kVaryings = {"float", "float2", "float3", "float4", "half", "half2",
                                                        "half3", "half4",  "int",    "int2",   "int3", "int4"};
constexpr WrapWord kWraps[] = {{"position", "float4", WrapDecl::What::Position},
                               {"fragCoord", "float4", WrapDecl::What::Pixel},
                               {"reads", "float2", WrapDecl::What::Reads}};
constexpr std::size_t kMaxDepth = 64;  // how deep semantics may read other semantics

class FunctionCheck : DeclarationCheck {
public:
    using DeclarationCheck::DeclarationCheck;

    void run() {
        for (const FunctionDecl& each : ast_.functions) function(each);
        for (const FunctionDecl& each : ast_.functions) {
            if (each.attribute("semantic")) follow_recipe(each);
        }
    }

private:
    void function(const FunctionDecl& decl) {
        for (const Attribute& attribute : decl.attributes) {
            if (attribute.name == "pass") pass_name(attribute);
            if (attribute.name == "gives") gives(decl, attribute);
            if (attribute.name == "wraps") wraps(decl, attribute);
            place(decl, attribute);
            if (attribute.name == "fallback") fallback(decl, attribute);
            if (attribute.name == "needs") {
                if (attribute.args.empty()) bad(attribute.span, "needs", "is written like this: [needs(\"added\")]");
                for (const Expr* given : attribute.args) slot(*given);
            }
        }
        again(decl);
        if (const Attribute* attribute = decl.attribute("foreign")) foreign_function(decl, *attribute);
        texts_of(decl.attributes, diagnostics_);
        const Attribute* of_object = decl.attribute("perObject");
        if (of_object && !decl.attribute("foreign"))
            bad(of_object->span, "perObject", "applies only to a value of the engine or a [foreign] function");
        for (const Attribute& attribute : decl.attributes) {
            const bool is_engines = attribute.name == "text" || attribute.name == "tag" || attribute.name == "decodes";
            if (is_engines && !is_of_engine(attribute.span)) foreign(attribute, attribute.span);
        }
        if (const Attribute* attribute = decl.attribute("semantic")) recipe(decl, *attribute);
        if (decl.attribute("pass") && decl.attribute("vertex") && decl.result.name != "float4" &&
            !(decl.attribute("text") && decl.result.name == "void"))
            diagnostics_.report(Code::TypeMismatch, decl.result.span, "the result of a [vertex] function",
                                decl.result.name, "float4");
    }

    // An attribute that says nothing of such a function would do nothing.
    void place(const FunctionDecl& decl, const Attribute& attribute) {
        const std::string_view name = attribute.name;
        const bool is_pass = decl.attribute("pass") != nullptr;
        const bool is_fragment = is_pass && decl.attribute("fragment") != nullptr;
        if (name == "vertex" && !is_pass) bad(attribute.span, name, "needs [pass] on the same function");
        if (name == "fragment" && !is_pass && !decl.attribute("gives"))
            bad(attribute.span, name, "needs [pass] or [gives] on the same function");
        if (name == "gives" && is_pass)
            bad(attribute.span, name, "is on a function of a pass: put it on a function of its own");
        if (name == "with" && !decl.attribute("wraps"))
            bad(attribute.span, name, "on a function needs [wraps] on the same function");
        const bool is_part = is_derivation(name) && !decl.attribute("slot");
        if (is_part) bad(attribute.span, name, "needs [slot] on the same function");
        if (is_in(kOfNode, name) && is_of_pass(sources_, decl.span))
            bad(attribute.span, name,
                "has no effect in a pass file, where graphs find no nodes: put nodes into a .node.hlsl file");
        if (is_fragment) return;
        const bool is_of_slot = decl.attribute("slot") && (name == "holds" || name == "otherwise");
        const bool is_stated = is_in(kOfFragment, name) || name == "holds" || name == "otherwise" || name == "lighting";
        if (is_stated && !is_of_slot) bad(attribute.span, name, "applies only to the [fragment] function of a pass");
    }

    // Every pass goes through it, so a file of passes has none.
    void wraps(const FunctionDecl& decl, const Attribute& attribute) {
        if (is_of_pass(sources_, decl.span))
            return bad(attribute.span, "wraps",
                       "is not allowed in a pass file: the library wraps what all passes have");
        const std::span<const WrapWord> rows = wrap_words();
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const WrapWord& each) {
            return each.text == nodelang::attribute_text(attribute);
        });
        if (row == rows.end()) return bad(attribute.span, "wraps", "takes \"position\", \"fragCoord\" or \"reads\"");
        const bool fits = decl.params.size() == 1 && decl.params[0].type.name == row->type &&
                          decl.result.name == row->type && !decl.params[0].is_out;
        if (!fits) bad(attribute.span, "wraps", fmt::format("needs a function from {0} to {0}", row->type));
    }

    void foreign_function(const FunctionDecl& decl, const Attribute& attribute) {
        foreign(attribute, decl.name_span);
        if (decl.has_body) bad(attribute.span, "foreign", "applies only to a function without a body");
        for (const ParamDecl& param : decl.params) {
            if (param.is_out || param.is_const || param.type.name == "floatN")
                bad(param.span, "foreign", "applies only to a function that takes plain values");
        }
    }

    // A file may declare the recipe of a semantic or the derivation of a slot again: all readers get the new one.
    void again(const FunctionDecl& decl) {
        const FunctionDecl* older = declarations_.parent ? declarations_.parent->function(decl.name) : nullptr;
        if (!older) return;
        if (decl.attribute("slot") && older->attribute("slot")) {
            if (!is_like(decl, *older))
                diagnostics_.report(Code::Redefinition, decl.name_span, decl.name)
                    .note(older->name_span,
                          "the library's slot is here: one of this name needs the same parameters and result");
        } else if (decl.attribute("semantic") && older->attribute("semantic")) {
            if (!is_same(decl.result, older->result))
                diagnostics_
                    .report(Code::TypeMismatch, decl.result.span, fmt::format("the semantic '{}'", decl.name),
                            decl.result.name, older->result.name)
                    .note(older->name_span, "the library's declaration is here");
        } else if (is_taken(older) || older->attribute("slot")) {
            DiagnosticRecord& record = twice(decl.name_span, decl.name, older->name_span);
            if (older->attribute("extern"))
                record.note(fmt::format("in a pass, [gives(\"{}\", \"PASS\")] replaces it", decl.name));
        }
    }

    // The name becomes part of file names.
    void pass_name(const Attribute& attribute) {
        const std::string_view name = nodelang::attribute_text(attribute);
        const auto is_plain = [](char c) { return is_identifier(std::string("_") + c) || c == '-'; };
        if (!name.empty() && !std::all_of(name.begin(), name.end(), is_plain))
            bad(attribute.span, "pass", "takes a name of letters, digits, - and _");
    }

    void fallback(const FunctionDecl& decl, const Attribute& attribute) {
        if (attribute.args.size() != 1) return;  // reported when it was read
        const std::vector<std::string_view> known = paths_.names();
        one_of(*attribute.args[0], known, "a rendering path");
        for (const Attribute& each : decl.attributes) {
            const PassDecl* own = each.name == "pass" ? paths_.pass(nodelang::attribute_text(each)) : nullptr;
            if (own && own->path == attribute.args[0]->text)
                return bad(attribute.span, "fallback", "names its own path: name another path");
        }
    }

    void recipe(const FunctionDecl& decl, const Attribute& attribute) {
        const bool is_varying = nodelang::attribute_text(attribute) == "vertex";
        if (is_varying ? !is_in(kVaryings, decl.result.name) : decl.result.name == "void")
            diagnostics_.report(Code::TypeMismatch, decl.result.span, fmt::format("the semantic '{}'", decl.name),
                                decl.result.name,
                                is_varying ? "a number or vector, which can be interpolated," : "a value");
    }

    // A file gives values to the passes of its own path, and to passes that are drawn together with them. It may also
    // name other passes, because it may be a copy of a file of the library.
    void drawn_along(const Attribute& attribute) {
        if (!declarations_.parent || attribute.args.size() < 2) return;
        for (std::size_t i = 1; i < attribute.args.size(); ++i) {
            const PassDecl* to = paths_.pass(attribute.args[i]->text);
            if (!to || paths_.is_drawn_along(stem_of(attribute.span), *to)) return;
        }
        const Expr& first = *attribute.args[1];
        bad(first.span, "gives",
            fmt::format("names '{}', a pass of the path '{}', which is not drawn along with this one", first.text,
                        paths_.pass(first.text)->path));
    }
    std::string stem_of(Span span) const { return stem(sources_.resolve(span.begin).file); }

    void gives(const FunctionDecl& decl, const Attribute& attribute) {
        if (attribute.args.empty()) return;  // reported when it was read
        const Expr& what = *attribute.args[0];
        if (attribute.args.size() == 1 && !is_of_engine(attribute.span))
            return bad(attribute.span, "gives",
                       "takes a semantic or function, and passes: [gives(\"positionWS\", \"mine\")]");
        drawn_along(attribute);
        for (std::size_t i = 1; i < attribute.args.size(); ++i) {
            const Expr& to = *attribute.args[i];
            if (!pass(to)) continue;
            const auto first = std::find_if(paths_.given.begin(), paths_.given.end(), [&](const GivenDecl& each) {
                return each.what == what.text && is_in(each.passes, to.text);
            });
            if (first != paths_.given.end() && first->function != &decl)
                diagnostics_
                    .report(Code::BadAttribute, to.span, "gives",
                            fmt::format("names '{}' a second time for the pass '{}'", what.text, to.text))
                    .note(first->function->name_span, "the first one is here");
        }
        const FunctionDecl* replaced = declarations_.function(what.text);
        if (const SemanticDecl* semantic = paths_.semantic(what.text)) {
            const TypeName& type = semantic->function ? semantic->function->result : semantic->variable->type;
            if (semantic->source == SemanticSource::Extern || semantic->source == SemanticSource::Given) {
                bad(what.span, "gives",
                    fmt::format("names '{}', which is not a semantic that a pass computes", what.text));
            } else if (!is_same(type, decl.result)) {
                diagnostics_.report(Code::TypeMismatch, decl.result.span, fmt::format("the recipe of '{}'", what.text),
                                    decl.result.name, type.name);
            }
        } else if (!replaced || !(is_of_engine(attribute.span) || replaced->attribute("extern"))) {
            std::vector<std::string_view> known;
            for (const SemanticDecl& each : paths_.semantics) known.push_back(each.name);
            for (const Declarations* scope = &declarations_; scope; scope = scope->parent) {
                for (const auto& [name, each] : scope->functions) {
                    if (each->attribute("extern")) known.push_back(name);
                }
            }
            diagnostics_
                .report(
                    Code::BadAttribute, what.span, "gives",
                    fmt::format("names '{}', which is neither a semantic nor a function marked [extern]", what.text))
                .note(Diagnostics::suggestion(what.text, known));
        }
    }
    // The semantics that a recipe reads are the defaults of its parameters.
    void follow_recipe(const FunctionDecl& recipe) {
        if (!followed_.insert(&recipe).second) return;
        if (active_.size() >= kMaxDepth) {
            diagnostics_.report(Code::TooDeep, recipe.name_span, kMaxDepth);
            return;
        }
        active_.push_back(&recipe);
        for (const ParamDecl& param : recipe.params) {
            if (param.initial) follow_default(*param.initial);
        }
        active_.pop_back();
    }

    void follow_default(const Expr& expr) {
        for (const Expr* argument : expr.args) follow_default(*argument);
        if (expr.kind != Expr::Kind::Name && expr.kind != Expr::Kind::Semantic) return;
        const SemanticDecl* read = paths_.semantic(expr.text);
        if (!read || !read->function) return;
        if (!is_circle(active_, *read->function, expr.span)) follow_recipe(*read->function);
    }

    std::vector<const FunctionDecl*> active_;
    std::set<const FunctionDecl*> followed_;
};

}  // namespace

std::span<const WrapWord> wrap_words() {
    return kWraps;
}

void check_functions(const nodelang::Ast& ast, const Declarations& declarations, const SourceMap& sources,
                     const PathDeclarations& paths, Diagnostics& diagnostics) {
    FunctionCheck(ast, declarations, sources, paths, diagnostics).run();
}

}  // namespace patina::paths

// Checks the declarations of a pass file before anything is made of them: names in attributes, types that a stage can
// pass on, slots that are derived from each other. The words of attributes are checked where they are read
// (pass_state.cpp).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "compiler/base/text.h"
#include "compiler/format/words.h"
#include "compiler/paths/reading.h"

namespace patina::graph {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;
using nodelang::StructDecl;
using nodelang::TypeName;
using nodelang::VariableDecl;
using Words = std::span<const std::string_view>;

constexpr std::array<std::string_view, 4> kParts = {"part", "without", "pack", "unpack"};
// The attributes of a pass's fragment function; others have a meaning on other functions, too.
constexpr std::array<std::string_view, 17> kOfFragment = {
    "draws",     "each",    "lights", "camera",   "fallback", "cull",  "blend", "depth",   "depthTarget",
    "depthBias", "stencil", "target", "optional", "extra",    "alone", "needs", "excludes"};
constexpr StaticWord kStatics[] = {{"surface", StaticDecl::About::Surface}, {"cull", StaticDecl::About::Cull},
                                   {"slot", StaticDecl::About::Slot},       {"pass", StaticDecl::About::Pass},
                                   {"clip", StaticDecl::About::Clip},       {"uvOrigin", StaticDecl::About::UvOrigin}};
// The types that std140 can lay out.
constexpr std::array<std::string_view, 14> kUniforms = {"float", "float2", "float3",   "float4",  "int",
                                                        "int2",  "int3",   "int4",     "uint",    "uint2",
                                                        "uint3", "uint4",  "float3x3", "float4x4"};
constexpr std::array<std::string_view, 12> kVaryings = {"float", "float2", "float3", "float4", "half", "half2",
                                                        "half3", "half4",  "int",    "int2",   "int3", "int4"};
constexpr std::size_t kMaxDepth = 64;  // how deep semantics may read other semantics
constexpr BuiltinWord kBuiltins[] = {{"frontFacing", "bool", ir::Builtin::FrontFacing},
                                     {"fragCoord", "float4", ir::Builtin::FragCoord},
                                     {"vertexIndex", "int", ir::Builtin::VertexIndex},
                                     {"instanceIndex", "int", ir::Builtin::InstanceIndex}};

template <class Row, std::size_t N>
std::vector<std::string_view> words_of(std::span<const Row, N> rows) {
    std::vector<std::string_view> made;
    for (const Row& row : rows) made.push_back(row.text);
    return made;
}

bool is_in(Words words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// The attribute that says how a slot is derived.
const Attribute* making(const FunctionDecl& slot) {
    for (const Attribute& attribute : slot.attributes) {
        if (is_in(kParts, attribute.name)) return &attribute;
    }
    return nullptr;
}

bool is_same(const TypeName& a, const TypeName& b) {
    return a.name == b.name && !a.array_size == !b.array_size;
}

class Check {
public:
    Check(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
          const PathDeclarations& paths, Diagnostics& diagnostics)
        : ast_(ast), declarations_(declarations), sources_(sources), paths_(paths), diagnostics_(diagnostics) {}

    void run() {
        for (const StructDecl& each : ast_.structs) structure(each);
        for (const nodelang::EnumDecl& each : ast_.enums) enumeration(each);
        for (const VariableDecl& each : ast_.variables) variable(each);
        for (const FunctionDecl& each : ast_.functions) function(each);
        for (const FunctionDecl& each : ast_.functions) {
            if (each.attribute("semantic")) follow_recipe(each);
            if (each.attribute("slot")) follow_slot(each, each.name_span);
        }
    }

private:
    void bad(Span span, std::string_view attribute, std::string_view why) {
        diagnostics_.report(Code::BadAttribute, span, attribute, why);
    }

    // Reports an argument that is not in `words`.
    void one_of(const Expr& given, Words words, std::string_view what) {
        if (!is_in(words, given.text))
            diagnostics_.report(Code::UnknownWord, given.span, given.text, what)
                .note(Diagnostics::suggestion(given.text, words));
    }

    bool pass(const Expr& given) {
        if (paths_.pass(given.text)) return true;
        std::vector<std::string_view> known;
        for (const PassDecl& each : paths_.passes) known.push_back(each.name);
        diagnostics_.report(Code::UnknownPass, given.span, given.text).note(Diagnostics::suggestion(given.text, known));
        return false;
    }

    const FunctionDecl* find_slot(std::string_view name) const {
        const SlotDecl* found = paths_.slot(name);
        return found ? found->function : nullptr;
    }

    const FunctionDecl* slot(const Expr& given) {
        if (const FunctionDecl* found = find_slot(given.text)) return found;
        std::vector<std::string_view> known;
        for (const SlotDecl& each : paths_.slots) known.push_back(each.name());
        diagnostics_.report(Code::UnknownName, given.span, "slot", given.text)
            .note(Diagnostics::suggestion(given.text, known));
        return nullptr;
    }

    // --- structs and variables

    // What the library declares outside of pass files keeps its meaning for graphs and for the library's functions, so
    // a file cannot declare something else of that name.
    template <class Decl>
    bool is_taken(const Decl* older) const {
        return older && !is_of_pass(sources_, older->span);
    }

    DiagnosticRecord& twice(Span span, std::string_view name, Span older) {
        return diagnostics_.report(Code::Redefinition, span, name)
            .note(older, "the library's declaration is here: give this one another name");
    }

    void structure(const StructDecl& decl) {
        const StructDecl* older = declarations_.parent ? declarations_.parent->structure(decl.name) : nullptr;
        if (is_taken(older)) twice(decl.span, decl.name, older->span);
    }

    void enumeration(const nodelang::EnumDecl& decl) {
        const nodelang::EnumDecl* older = declarations_.parent ? declarations_.parent->enumeration(decl.name) : nullptr;
        if (is_taken(older)) twice(decl.span, decl.name, older->span);
    }

    // True for a declaration in an engine's passes. The engine reads the text that they state (engines/engine.h).
    bool is_of_engine(Span span) const {
        return std::string_view(sources_.resolve(span.begin).file).starts_with("nodes/engines/");
    }

    // The text of [foreign] has a meaning only for an included file, and the engine provides the rest.
    void foreign(const Attribute& attribute, Span span) {
        if (!is_of_engine(span))
            bad(attribute.span, attribute.name, "is allowed only in the passes of an engine, nodes/engines/");
        else if (attribute.args.size() > 1)
            bad(attribute.span, "foreign",
                "is written like this: [foreign] or, with its spelling, [foreign(\"v.vertex.xyz\")]");
    }

    // A value that an included file declares replaces an attribute or a value of the engine.
    void gives(const VariableDecl& decl, const Attribute& attribute) {
        const std::string_view what = nodelang::attribute_text(attribute);
        const VariableDecl* given = declarations_.variable(what);
        if (!decl.attribute("foreign") || attribute.args.size() != 1)
            return bad(attribute.span, "gives",
                       "is written like this: [foreign(\"_Time.y\")] [gives(\"time\")] float seconds");
        if (!given || !(given->attribute("attribute") || given->attribute("extern")))
            return bad(attribute.span, "gives",
                       fmt::format("names '{}', which is neither an attribute nor a value of the engine", what));
        if (!is_same(given->type, decl.type))
            diagnostics_.report(Code::TypeMismatch, decl.type.span, fmt::format("'{}'", decl.name), decl.type.name,
                                given->type.name);
    }

    void variable(const VariableDecl& decl) {
        const bool is_read = decl.attribute("extern") || decl.attribute("reads");
        if (const Attribute* attribute = decl.attribute("with"); attribute && !is_read)
            bad(attribute->span, "with", "applies only to a value of the engine or a target that is read");
        if (const Attribute* attribute = decl.attribute("perObject"); attribute && !is_read)
            bad(attribute->span, "perObject", "applies only to a value of the engine or a [foreign] function");
        if (const Attribute* attribute = decl.attribute("foreign")) {
            foreign(*attribute, decl.span);
            if (!is_in(kUniforms, decl.type.name) || decl.type.array_size)
                bad(decl.type.span, "foreign", "applies only to floats, ints, float3x3 or float4x4");
        }
        if (const Attribute* attribute = decl.attribute("gives")) gives(decl, *attribute);
        if (const Attribute* attribute = decl.attribute("text")) {
            texts_of(decl.attributes, diagnostics_);
            if (!decl.attribute("foreign"))
                bad(attribute->span, "text", "applies only to a [foreign] value or a function");
        }
        again(decl);
        if (is_of_pass(sources_, decl.span)) {
            for (const std::string_view name : {"attribute", "given", "vertexOutput", "uv"}) {
                if (const Attribute* attribute = decl.attribute(name))
                    bad(attribute->span, name,
                        "is not allowed in a pass file: only the library defines what meshes and lighting graphs hold");
            }
        }
        if (const Attribute* attribute = decl.attribute("static")) {
            is_bool(decl, *attribute);
            statics(*attribute);
        }
        if (const Attribute* attribute = decl.attribute("switch")) {
            is_bool(decl, *attribute);
            if (!attribute->args.empty()) pass(*attribute->args[0]);
        }
        if (const Attribute* attribute = decl.attribute("builtin")) builtin(decl, *attribute);
        const Attribute* reads = decl.attribute("reads");
        if (reads) target(decl, *reads);
        if (const Attribute* attribute = decl.attribute("extern"); attribute && !reads) uniform(decl, *attribute);
    }

    // A copy of a library file repeats the library's declarations, and may not change them.
    void again(const VariableDecl& decl) {
        const VariableDecl* older = declarations_.parent ? declarations_.parent->variable(decl.name) : nullptr;
        if (!older) return;
        if (decl.is_const || older->is_const) {
            if (is_taken(older) || decl.is_const != older->is_const) twice(decl.span, decl.name, older->span);
        } else if (!is_same(older->type, decl.type) || !has_same_attributes(*older, decl)) {
            diagnostics_.report(Code::Redefinition, decl.span, decl.name)
                .note(older->span, "the library's declaration is here: a file may only repeat it unchanged");
        }
    }

    static bool has_same_attributes(const VariableDecl& a, const VariableDecl& b) {
        const auto is_alike = [](const Attribute& x, const Attribute& y) {
            return x.name == y.name && attribute_words(x) == attribute_words(y);
        };
        return std::is_permutation(a.attributes.begin(), a.attributes.end(), b.attributes.begin(), b.attributes.end(),
                                   is_alike);
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

    void is_bool(const VariableDecl& decl, const Attribute& attribute) {
        if (decl.type.name != "bool" || decl.type.array_size)
            bad(decl.type.span, attribute.name, "applies only to a bool");
    }

    void statics(const Attribute& attribute) {
        if (attribute.args.size() < 2)
            return bad(attribute.span, "static", "is written like this: [static(\"surface\", \"cutout\")]");
        const Expr& key = *attribute.args[0];
        one_of(key, words_of(static_words()), "a query of [static]");
        for (std::size_t i = 1; i < attribute.args.size(); ++i) {
            const Expr& given = *attribute.args[i];
            if (key.text == "surface") one_of(given, texts<SurfaceKind>(), "a surface kind");
            if (key.text == "cull") one_of(given, texts<Cull>(), "a cull mode");
            if (key.text == "slot") slot(given);
            if (key.text == "pass") pass(given);
            if (key.text == "clip") one_of(given, texts<ClipDepth>(), "a convention of clip space");
            if (key.text == "uvOrigin") one_of(given, texts<UvOrigin>(), "an origin of texture coordinates");
        }
    }

    void builtin(const VariableDecl& decl, const Attribute& attribute) {
        if (attribute.args.size() != 1)
            return bad(attribute.span, "builtin", "is written like this: [builtin(\"frontFacing\")]");
        one_of(*attribute.args[0], words_of(builtin_words()), "a value of the rasteriser");
        for (const BuiltinWord& row : kBuiltins) {
            if (row.text == attribute.args[0]->text && (row.type != decl.type.name || decl.type.array_size))
                diagnostics_.report(Code::TypeMismatch, decl.type.span, fmt::format("'{}'", decl.name), decl.type.name,
                                    row.type);
        }
    }

    void target(const VariableDecl& decl, const Attribute& attribute) {
        if (decl.type.name != "Texture2D" || decl.type.array_size)
            return bad(decl.type.span, "reads", "applies only to a Texture2D");
        if (attribute.args.size() != 1)
            return bad(attribute.span, "reads", "takes the name of a target: [reads(\"depth\")]");
        std::vector<std::string_view> known;
        for (const PassDecl& each : paths_.passes) {
            known.push_back(each.state.depth_target);
            for (const RenderTarget& written : each.state.targets) known.push_back(written.name);
        }
        std::sort(known.begin(), known.end());
        known.erase(std::unique(known.begin(), known.end()), known.end());
        one_of(*attribute.args[0], known, "a target of a pass");
    }

    void uniform(const VariableDecl& decl, const Attribute& attribute) {
        if (decl.type.name == "Texture2D" || decl.type.name == "TextureCube") {
            if (decl.type.array_size) bad(decl.type.span, "extern", "applies only to a texture or a number of a block");
            return;
        }
        if (!is_in(kUniforms, decl.type.name))
            return bad(decl.type.span, "extern",
                       "applies only to a texture, or to floats, ints, float3x3, float4x4 or arrays of them");
        const std::string_view block = nodelang::attribute_text(attribute);
        if (attribute.args.size() != 1)
            return bad(attribute.span, "extern", "takes the name of a uniform block: [extern(\"Camera\")]");
        if (!is_identifier(block)) diagnostics_.report(Code::BadIdentifier, attribute.args[0]->span, block);
        if (block == "Material")
            bad(attribute.args[0]->span, "extern", "names 'Material', the block of the properties");
    }

    // --- functions

    void function(const FunctionDecl& decl) {
        for (const Attribute& attribute : decl.attributes) {
            if (attribute.name == "pass") pass_name(attribute);
            if (attribute.name == "gives") gives(decl, attribute);
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
        if (const Attribute* attribute = decl.attribute("slot")) part(decl, *attribute);
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
        const bool is_part = is_in(kParts, name) && !decl.attribute("slot");
        if (is_part) bad(attribute.span, name, "needs [slot] on the same function");
        if (is_fragment) return;
        const bool is_of_slot = decl.attribute("slot") && (name == "holds" || name == "otherwise");
        const bool is_stated = is_in(kOfFragment, name) || name == "holds" || name == "otherwise" || name == "lighting";
        if (is_stated && !is_of_slot) bad(attribute.span, name, "applies only to the [fragment] function of a pass");
    }

    void foreign_function(const FunctionDecl& decl, const Attribute& attribute) {
        foreign(attribute, decl.name_span);
        if (decl.has_body) bad(attribute.span, "foreign", "applies only to a function without a body");
        for (const ParamDecl& param : decl.params) {
            if (param.is_out || param.is_const || param.type.name == "floatN")
                bad(param.span, "foreign", "applies only to a function that takes plain values");
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

    // A file gives to the passes of its own path, and to those that are drawn along with it. It may name others beside
    // them, as a copy of a file of the library does.
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
    using Declarations = nodelang::Declarations;

    // --- slots

    void part(const FunctionDecl& decl, const Attribute& attribute) {
        const Attribute* made = making(decl);
        if (!made) {
            if (is_of_pass(sources_, decl.span))
                bad(attribute.span, "slot",
                    "needs [part], [without], [pack] or [unpack] in a pass file: nothing else fills the slot");
            return;
        }
        if (made->name == "pack") return pack(decl, *made);
        if (made->name == "unpack") return unpack(decl, *made);
        if (made->args.size() < 2 || made->args.size() > 3)
            return bad(made->span, made->name,
                       fmt::format("is written like this: [{}(\"final\", \"sum.direct\")]", made->name));
        const FunctionDecl* whole = slot(*made->args[0]);
        if (whole && derives(decl, *whole, made->span, made->name)) part_source(decl, *made->args[1]);
    }

    // "sum.direct", or a function. Each lighting model decides which members a lighting surface has
    // (check_members.cpp).
    void part_source(const FunctionDecl& decl, const Expr& given) {
        const std::size_t dot = given.text.find('.');
        if (dot == given.text.npos) {
            if (!declarations_.function(given.text))
                diagnostics_.report(Code::UnknownName, given.span, "function", given.text)
                    .note("write a member of a parameter like this: \"sum.direct\"");
            return;
        }
        const std::string_view name = given.text.substr(0, dot), member = given.text.substr(dot + 1);
        const auto param = std::find_if(decl.params.begin(), decl.params.end(),
                                        [&](const ParamDecl& each) { return each.name == name; });
        std::vector<std::string_view> known;
        if (param == decl.params.end()) {
            for (const ParamDecl& each : decl.params) known.push_back(each.name);
            diagnostics_.report(Code::UnknownName, given.span, "parameter", name)
                .note(Diagnostics::suggestion(name, known));
            return;
        }
        const StructDecl* structure = declarations_.structure(param->type.name);
        if (!structure || is_surface(param->type)) return;
        for (const auto& each : structure->members) known.push_back(each.name);
        if (!is_in(known, member))
            diagnostics_.report(Code::UnknownName, given.span, "member", given.text)
                .note(Diagnostics::suggestion(member, known));
    }

    static bool is_like(const FunctionDecl& a, const FunctionDecl& b) {
        const auto same = [](const ParamDecl& x, const ParamDecl& y) {
            return is_same(x.type, y.type) && x.name == y.name;
        };
        return is_same(a.result, b.result) &&
               std::equal(a.params.begin(), a.params.end(), b.params.begin(), b.params.end(), same);
    }

    bool derives(const FunctionDecl& decl, const FunctionDecl& whole, Span span, std::string_view attribute) {
        if (is_like(decl, whole)) return true;
        diagnostics_
            .report(
                Code::BadAttribute, span, attribute,
                fmt::format("derives '{}' from '{}' and must keep its parameters and result", decl.name, whole.name))
            .note(whole.name_span, "the original slot is here");
        return false;
    }

    // True for the struct that every slot takes first.
    bool is_surface(const TypeName& type) const {
        return std::any_of(paths_.slots.begin(), paths_.slots.end(), [&](const SlotDecl& each) {
            return each.function->params.empty() && !each.is_derived() && is_same(each.function->result, type);
        });
    }

    void pack(const FunctionDecl& decl, const Attribute& attribute) {
        const StructDecl* room = declarations_.structure(decl.result.name);
        const bool fits = room && !room->members.empty() &&
                          std::all_of(room->members.begin(), room->members.end(), [](const auto& member) {
                              return member.type.name == "float4" && !member.type.array_size;
                          });
        if (decl.params.size() != 1 || !is_surface(decl.params[0].type) || !fits)
            return bad(attribute.span, "pack",
                       "needs a function that takes a lighting surface and returns a struct of float4");
        if (attribute.args.empty() || !decl.attribute("holds"))
            return bad(attribute.span, "pack",
                       "names slots, and needs [holds] with the members that are stored already: [pack(\"direct\")] "
                       "[holds(\"f0\")]");
        for (const Expr* given : attribute.args) slot(*given);
    }

    void unpack(const FunctionDecl& decl, const Attribute& attribute) {
        if (attribute.args.size() != 1)
            return bad(attribute.span, "unpack", "is written like this: [unpack(\"packSurface\")]");
        const FunctionDecl* packer = slot(*attribute.args[0]);
        if (!packer) return;
        if (!packer->attribute("pack"))
            return bad(attribute.args[0]->span, "unpack",
                       fmt::format("names '{}', which does not pack anything", packer->name));
        if (decl.params.size() != 2 || !is_surface(decl.params[0].type) || !is_surface(decl.result) ||
            !is_same(decl.params[1].type, packer->result))
            bad(attribute.span, "unpack",
                fmt::format("needs a function that takes a lighting surface and the result of '{}', and returns a "
                            "lighting surface",
                            packer->name));
    }

    // --- circles

    template <class Decl>
    bool is_circle(std::vector<const Decl*>& active, const Decl& next, Span span) {
        const auto first = std::find(active.begin(), active.end(), &next);
        if (first == active.end()) return false;
        std::string chain;
        for (auto each = first; each != active.end(); ++each) chain += fmt::format("{} > ", (*each)->name);
        diagnostics_.report(Code::Recursion, span, chain + std::string(next.name));
        return true;
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

    void follow_slot(const FunctionDecl& slot, Span span) {
        const Attribute* made = making(slot);
        if (!made || is_circle(active_, slot, span) || !followed_.insert(&slot).second) return;
        active_.push_back(&slot);
        const std::size_t count =
            made->name == "pack" ? made->args.size() : std::min<std::size_t>(made->args.size(), 1);
        for (std::size_t i = 0; i < count; ++i) {
            if (const FunctionDecl* next = find_slot(made->args[i]->text)) follow_slot(*next, made->args[i]->span);
        }
        active_.pop_back();
    }

    const nodelang::Ast& ast_;
    const nodelang::Declarations& declarations_;
    const SourceMap& sources_;
    const PathDeclarations& paths_;
    Diagnostics& diagnostics_;
    std::vector<const FunctionDecl*> active_;
    std::set<const FunctionDecl*> followed_;
};

}  // namespace

bool is_of_pass(const SourceMap& sources, Span span) {
    return std::string_view(sources.resolve(span.begin).file).ends_with(".pass.hlsl");
}

std::span<const StaticWord> static_words() {
    return kStatics;
}

std::span<const BuiltinWord> builtin_words() {
    return kBuiltins;
}

void check_declarations(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                        const PathDeclarations& paths, Diagnostics& diagnostics) {
    Check(ast, declarations, sources, paths, diagnostics).run();
}

}  // namespace patina::graph

// Checks the structs, enums and variables of a pass file before other code uses them: names in attributes, and types
// that a block or a stage can have. The words of the attributes of passes are checked where they are read
// (pass_state.cpp).
#include <fmt/format.h>

#include "compiler/base/text.h"
#include "compiler/format/clipped_blend.h"
#include "compiler/format/words.h"
#include "compiler/ir/texture_kinds.h"
#include "compiler/paths/declaration_check.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::StructDecl;
using nodelang::VariableDecl;

constexpr StaticWord kStatics[] = {{"surface", StaticDecl::About::Surface},  {"cull", StaticDecl::About::Cull},
                                   {"slot", StaticDecl::About::Slot},        {"reads", StaticDecl::About::Reads},
                                   {"pass", StaticDecl::About::Pass},        {"clip", StaticDecl::About::Clip},
                                   {"uvOrigin", StaticDecl::About::UvOrigin}};
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

class VariableCheck : DeclarationCheck {
public:
    using DeclarationCheck::DeclarationCheck;

    void run() {
        for (const StructDecl& each : ast_.structs) structure(each);
        for (const nodelang::EnumDecl& each : ast_.enums) enumeration(each);
        for (const VariableDecl& each : ast_.variables) variable(each);
    }

private:
    void structure(const StructDecl& decl) {
        const StructDecl* older = declarations_.parent ? declarations_.parent->structure(decl.name) : nullptr;
        if (is_taken(older)) twice(decl.span, decl.name, older->span);
    }

    void enumeration(const nodelang::EnumDecl& decl) {
        const nodelang::EnumDecl* older = declarations_.parent ? declarations_.parent->enumeration(decl.name) : nullptr;
        if (is_taken(older)) twice(decl.span, decl.name, older->span);
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
            if (!is_uniform_type(decl.type.name) || decl.type.array_size)
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
        const nodelang::FunctionDecl* function =
            declarations_.parent ? declarations_.parent->function(decl.name) : nullptr;
        if (function && function->attribute("slot")) return (void)twice(decl.span, decl.name, function->name_span);
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
            if (key.text == "surface" && given.text != kChosenKind && given.text != format::kClippedKind)
                one_of(given, format::texts<SurfaceKind>(), "a surface kind");
            if (key.text == "cull") one_of(given, format::texts<Cull>(), "a cull mode");
            if (key.text == "slot") slot(given);
            if (key.text == "pass") pass(given);
            if (key.text == "clip") one_of(given, format::texts<ClipDepth>(), "a convention of clip space");
            if (key.text == "uvOrigin") one_of(given, format::texts<UvOrigin>(), "an origin of texture coordinates");
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
        if (ir::texture_kind(decl.type.name)) {
            if (decl.type.array_size) bad(decl.type.span, "extern", "applies only to a texture or a number of a block");
            return;
        }
        if (!is_uniform_type(decl.type.name))
            return bad(decl.type.span, "extern",
                       "applies only to a texture, or to floats, ints, float3x3, float4x4 or arrays of them");
        const std::string_view block = nodelang::attribute_text(attribute);
        if (attribute.args.size() != 1)
            return bad(attribute.span, "extern", "takes the name of a uniform block: [extern(\"Camera\")]");
        if (!is_identifier(block)) diagnostics_.report(Code::BadIdentifier, attribute.args[0]->span, block);
        if (block == "Material")
            bad(attribute.args[0]->span, "extern", "names 'Material', the block of the properties");
    }
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
    VariableCheck(ast, declarations, sources, paths, diagnostics).run();
    check_functions(ast, declarations, sources, paths, diagnostics);
    check_slots(ast, declarations, sources, paths, diagnostics);
}

}  // namespace patina::paths

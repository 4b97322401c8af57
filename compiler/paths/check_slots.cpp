// Checks how the slots of a file are derived from each other: by [part], [without], [pack] and [unpack].
#include <fmt/format.h>

#include <array>
#include <set>

#include "compiler/paths/declaration_check.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;
using nodelang::StructDecl;
using nodelang::TypeName;

constexpr std::array<std::string_view, 4> kDerivations = {"part", "without", "pack", "unpack"};

// The attribute that says how a slot is derived.
const Attribute* making(const FunctionDecl& slot) {
    for (const Attribute& attribute : slot.attributes) {
        if (is_derivation(attribute.name)) return &attribute;
    }
    return nullptr;
}

class SlotCheck : DeclarationCheck {
public:
    using DeclarationCheck::DeclarationCheck;

    void run() {
        for (const FunctionDecl& each : ast_.functions) {
            if (const Attribute* attribute = each.attribute("slot")) part(each, *attribute);
        }
        for (const FunctionDecl& each : ast_.functions) {
            if (each.attribute("slot")) follow(each, each.name_span);
        }
    }

private:
    void part(const FunctionDecl& decl, const Attribute& attribute) {
        const Attribute* made = making(decl);
        if (!made) {
            if (is_of_pass(sources_, decl.span))
                bad(attribute.span, "slot",
                    "needs [part], [without], [pack] or [unpack] in a pass file: nothing else fills the slot");
            return;
        }
        for (const Attribute& other : decl.attributes) {
            if (&other == made || !is_derivation(other.name)) continue;
            return bad(other.span, other.name, fmt::format("derives '{}' a second time", decl.name));
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

    void follow(const FunctionDecl& slot, Span span) {
        const Attribute* made = making(slot);
        if (!made || is_circle(active_, slot, span) || !followed_.insert(&slot).second) return;
        active_.push_back(&slot);
        const std::size_t count =
            made->name == "pack" ? made->args.size() : std::min<std::size_t>(made->args.size(), 1);
        for (std::size_t i = 0; i < count; ++i) {
            if (const FunctionDecl* next = find_slot(made->args[i]->text)) follow(*next, made->args[i]->span);
        }
        active_.pop_back();
    }

    std::vector<const FunctionDecl*> active_;
    std::set<const FunctionDecl*> followed_;
};

}  // namespace

bool is_derivation(std::string_view attribute) {
    return std::find(kDerivations.begin(), kDerivations.end(), attribute) != kDerivations.end();
}

void check_slots(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                 const PathDeclarations& paths, Diagnostics& diagnostics) {
    SlotCheck(ast, declarations, sources, paths, diagnostics).run();
}

}  // namespace patina::paths

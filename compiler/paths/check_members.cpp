// Checks the members of the lighting surface that a pass file names.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/paths/reading.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::StructDecl;

// The struct that is the slots' first parameter.
const StructDecl* lighting_surface(const PathDeclarations& paths, const nodelang::Declarations& declarations) {
    for (const SlotDecl& slot : paths.slots) {
        if (slot.function->params.empty()) return declarations.structure(slot.function->result.name);
    }
    return nullptr;
}

// True if something asks whether a material has this slot.
bool is_asked_for(const PathDeclarations& paths, std::string_view slot) {
    const auto has = [&](const std::vector<std::string_view>& words) {
        return std::find(words.begin(), words.end(), slot) != words.end();
    };
    return std::any_of(paths.passes.begin(), paths.passes.end(),
                       [&](const PassDecl& pass) { return has(pass.needs); }) ||
           std::any_of(paths.statics.begin(), paths.statics.end(), [&](const StaticDecl& each) {
               return each.about == StaticDecl::About::Slot && has(each.words);
           });
}

}  // namespace

void check_members(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const PathDeclarations& paths,
                   std::span<const std::string_view> inputs, Diagnostics& diagnostics) {
    const StructDecl* surface = lighting_surface(paths, declarations);
    if (!surface) return;
    std::vector<std::string_view> known;
    for (const auto& member : surface->members) known.push_back(member.name);
    known.insert(known.end(), inputs.begin(), inputs.end());
    std::vector<std::string_view> held = known;
    for (const SlotDecl& slot : paths.slots) held.push_back(slot.name());
    // Another lighting model may declare a member that this model lacks, and then a pass need not have the member. So
    // only a word that is close to a known one is an error.
    const auto check = [&](const Expr& given, std::string_view word, const std::vector<std::string_view>& words,
                           bool may_be_absent) {
        if (std::find(words.begin(), words.end(), word) != words.end()) return;
        const std::string_view near = nearest(word, words);
        if (!near.empty() || !may_be_absent)
            diagnostics.report(Code::UnknownName, given.span, "member", given.text)
                .note(near.empty() ? Diagnostics::suggestion(word, words) : fmt::format("did you mean '{}'?", near));
    };
    for (const FunctionDecl& function : ast.functions) {
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name == "holds") {
                for (const Expr* given : attribute.args) check(*given, given->text, held, true);
            }
            const bool is_part = attribute.name == "part" || attribute.name == "without";
            if (!is_part || attribute.args.size() < 2) continue;
            const Expr& given = *attribute.args[1];
            const std::size_t dot = given.text.find('.');
            for (const nodelang::ParamDecl& param : function.params) {
                if (dot != given.text.npos && param.name == given.text.substr(0, dot) &&
                    param.type.name == surface->name)
                    check(given, given.text.substr(dot + 1), known, is_asked_for(paths, function.name));
            }
        }
    }
}

}  // namespace patina::paths

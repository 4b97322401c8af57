// What the checks of a file's declarations share (declaration_check.h).
#include "compiler/paths/declaration_check.h"

#include <fmt/format.h>

#include <array>

namespace patina::paths {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::ParamDecl;

bool is_uniform_type(std::string_view name) {
    constexpr std::array<std::string_view, 14> kTypes = {"float", "float2", "float3",   "float4",  "int",
                                                         "int2",  "int3",   "int4",     "uint",    "uint2",
                                                         "uint3", "uint4",  "float3x3", "float4x4"};
    return std::find(kTypes.begin(), kTypes.end(), name) != kTypes.end();
}

void DeclarationCheck::one_of(const Expr& given, Words words, std::string_view what) {
    if (!is_in(words, given.text))
        diagnostics_.report(Code::UnknownWord, given.span, given.text, what)
            .note(Diagnostics::suggestion(given.text, words));
}

bool DeclarationCheck::pass(const Expr& given) {
    if (paths_.pass(given.text)) return true;
    std::vector<std::string_view> known;
    for (const PassDecl& each : paths_.passes) known.push_back(each.name);
    diagnostics_.report(Code::UnknownPass, given.span, given.text).note(Diagnostics::suggestion(given.text, known));
    return false;
}

const FunctionDecl* DeclarationCheck::slot(const Expr& given) {
    if (const FunctionDecl* found = find_slot(given.text)) return found;
    std::vector<std::string_view> known;
    for (const SlotDecl& each : paths_.slots) known.push_back(each.name());
    diagnostics_.report(Code::UnknownName, given.span, "slot", given.text)
        .note(Diagnostics::suggestion(given.text, known));
    return nullptr;
}

void DeclarationCheck::foreign(const Attribute& attribute, Span span) {
    if (!is_of_engine(span))
        bad(attribute.span, attribute.name, "is allowed only in the passes of an engine, nodes/engines/");
    else if (attribute.args.size() > 1)
        bad(attribute.span, "foreign",
            "is written like this: [foreign] or, with its spelling, [foreign(\"v.vertex.xyz\")]");
}

bool DeclarationCheck::is_like(const FunctionDecl& a, const FunctionDecl& b) {
    const auto same = [](const ParamDecl& x, const ParamDecl& y) {
        return is_same(x.type, y.type) && x.name == y.name;
    };
    return is_same(a.result, b.result) &&
           std::equal(a.params.begin(), a.params.end(), b.params.begin(), b.params.end(), same);
}

bool DeclarationCheck::is_circle(std::span<const FunctionDecl* const> active, const FunctionDecl& next, Span span) {
    const auto first = std::find(active.begin(), active.end(), &next);
    if (first == active.end()) return false;
    std::string chain;
    for (auto each = first; each != active.end(); ++each) chain += fmt::format("{} > ", (*each)->name);
    diagnostics_.report(Code::Recursion, span, chain + std::string(next.name));
    return true;
}

}  // namespace patina::paths

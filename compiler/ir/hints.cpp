#include "compiler/ir/hints.h"

#include <fmt/format.h>

#include "compiler/base/spelling.h"

namespace patina::ir {
namespace {

// No identifier holds it: "callee/local" is a local, "callee/local/" the result.
constexpr char kBetween = '/';

}  // namespace

Hint hint_of(const Module& module, NameId id) {
    if (!id) return {};
    const std::string_view whole = module.names[id.index];
    const std::size_t first = whole.find(kBetween);
    if (first == whole.npos) return {.name = whole, .local = whole};
    const std::string_view callee = whole.substr(0, first);
    const std::string_view local = whole.substr(first + 1, whole.find(kBetween, first + 1) - first - 1);
    const bool is_result = whole.ends_with(kBetween);
    return {.name = is_result && !local.empty() ? callee : local, .callee = callee, .local = local};
}

NameId inlined_local(Module& module, std::string_view callee, NameId name) {
    const Hint hint = hint_of(module, name);
    if (hint.name.empty() || !hint.callee.empty()) return name;
    return module.intern(fmt::format("{}{}{}", camel_case(callee), kBetween, hint.name));
}

NameId inlined_result(Module& module, std::string_view callee, NameId name) {
    return module.intern(fmt::format("{}{}{}{}", camel_case(callee), kBetween, hint_of(module, name).local, kBetween));
}

}  // namespace patina::ir

// All target languages. A target is a row here and a folder of its own.
#include <algorithm>

#include "compiler/languages/glsl/glsl.h"
#include "compiler/languages/hlsl/hlsl.h"
#include "compiler/languages/print.h"

namespace patina::targets {
namespace {

constexpr TargetInfo kTargets[] = {
    {.name = "glsl", .extension = "glsl", .legalize = glsl::legalize, .print = glsl::print},
    {.name = "hlsl", .extension = "hlsl", .legalize = hlsl::legalize, .print = hlsl::print},
};

}  // namespace

std::span<const TargetInfo> all_targets() {
    return kTargets;
}

const TargetInfo* find_target(std::string_view name) {
    const auto found =
        std::find_if(std::begin(kTargets), std::end(kTargets), [&](const TargetInfo& t) { return t.name == name; });
    return found == std::end(kTargets) ? nullptr : found;
}

}  // namespace patina::targets

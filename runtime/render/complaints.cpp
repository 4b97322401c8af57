#include "runtime/render/complaints.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/scene/view.h"
#include "runtime/values/engine_values.h"

namespace patina::runtime {

Diagnostic complaint(const std::string& file, Severity severity, std::string code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.file = file;
    return diagnostic;
}

std::optional<Diagnostic> anisotropy_warning(const std::string& graph, const Reflection& reflection,
                                             std::string_view pass) {
    std::string names;
    for (const Texture& texture : reflection.textures) {
        const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& each) {
            return (pass.empty() || each.name == pass) &&
                   std::count(each.textures.begin(), each.textures.end(), texture.name) > 0;
        });
        if (is_read && texture.sampler.anisotropy > 1) names += (names.empty() ? "'" : ", '") + texture.name + "'";
    }
    if (names.empty()) return std::nullopt;
    return complaint(graph, Severity::Warning, "no-anisotropy",
                     "the CPU reference samples without anisotropy: " + names);
}

std::vector<Diagnostic> cookie_warnings(const std::string& graph, const Reflection& reflection, const Scene& view) {
    std::vector<Diagnostic> warnings;
    const auto cookies =
        std::count_if(view.lights.begin(), view.lights.end(), [](const Light& light) { return has_cookie(light); });
    for (const Pass& pass : reflection.passes) {
        const bool is_read = std::count(pass.textures.begin(), pass.textures.end(), "lightCookie") > 0;
        if (cookies < 2 || !is_read || pass.each != PassEach::Once || pass.lights != PassLights::All) continue;
        warnings.push_back(complaint(graph, Severity::Warning, "one-cookie",
                                     fmt::format("the pass '{}' draws all lights at once and uses only the first of "
                                                 "their {} cookies: use a path that draws each light separately",
                                                 pass.name, cookies)));
    }
    return warnings;
}

std::vector<Diagnostic> unknown_value_warnings(const std::string& pass_file, const Reflection& reflection) {
    std::vector<Diagnostic> warnings;
    const std::vector<std::string> known = engine_value_names();
    for (const Block& block : reflection.blocks) {
        const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
            return std::count(pass.blocks.begin(), pass.blocks.end(), block.name) > 0;
        });
        if (block.is_material || !is_read) continue;
        for (const BlockMember& member : block.members) {
            if (std::find(known.begin(), known.end(), member.name) != known.end()) continue;
            Diagnostic& unknown = warnings.emplace_back(complaint(
                pass_file, Severity::Warning, "no-engine-value",
                fmt::format("there is no value for '{}' of the block '{}': it is 0", member.name, block.name)));
            if (std::string advice = suggestion(member.name, known); advice.starts_with("did you mean")) {
                Diagnostic& note = unknown.notes.emplace_back();
                note.severity = Severity::Note;
                note.message = std::move(advice);
            }
        }
    }
    return warnings;
}

}  // namespace patina::runtime

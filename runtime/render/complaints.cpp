#include "runtime/render/complaints.h"

#include <algorithm>

#include "runtime/scene/view.h"
#include "runtime/values/engine_values.h"

namespace patina::runtime {

Diagnostic complaint(const std::string& file, Severity severity, Complaint what,
                     std::initializer_list<std::string_view> words) {
    Diagnostic diagnostic = patina::complaint(what, words);
    diagnostic.severity = severity;
    diagnostic.file = file;
    return diagnostic;
}

Diagnostic note(std::string message) {
    Diagnostic made;
    made.severity = Severity::Note;
    made.message = std::move(message);
    return made;
}

std::optional<Diagnostic> anisotropy_warning(const std::string& graph, const Reflection& reflection,
                                             std::string_view pass) {
    std::string names;
    const auto add = [&](const std::string& name) { names += (names.empty() ? "'" : ", '") + name + "'"; };
    for (const Texture& texture : reflection.textures) {
        const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& each) {
            return (pass.empty() || each.name == pass) &&
                   std::count(each.textures.begin(), each.textures.end(), texture.name) > 0;
        });
        if (is_read && texture.sampler.anisotropy > 1) add(texture.name);
    }
    for (const BoundSampler& sampler : reflection.samplers)
        if (sampler.sampler.anisotropy > 1) add(sampler.name);
    if (names.empty()) return std::nullopt;
    return complaint(graph, Severity::Warning, Complaint::NoAnisotropy, {names});
}

std::vector<Diagnostic> cookie_warnings(const std::string& graph, const Reflection& reflection, const Scene& view) {
    std::vector<Diagnostic> warnings;
    const auto cookies =
        std::count_if(view.lights.begin(), view.lights.end(), [](const Light& light) { return has_cookie(light); });
    for (const Pass& pass : reflection.passes) {
        const bool is_read = std::count(pass.textures.begin(), pass.textures.end(), "lightCookie") > 0;
        if (cookies < 2 || !is_read || pass.each != PassEach::Once || pass.lights != PassLights::All) continue;
        warnings.push_back(
            complaint(graph, Severity::Warning, Complaint::OneCookie, {pass.name, std::to_string(cookies)}));
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
            Diagnostic& unknown = warnings.emplace_back(
                complaint(pass_file, Severity::Warning, Complaint::NoEngineValue, {member.name, block.name}));
            if (std::string advice = suggestion(member.name, known); advice.starts_with("did you mean"))
                unknown.notes.push_back(note(std::move(advice)));
        }
    }
    return warnings;
}

}  // namespace patina::runtime

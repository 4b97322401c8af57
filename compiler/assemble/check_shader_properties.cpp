// What a ShaderLab file cannot say of a property. Its name is what materials keep its value under: it is never changed,
// and where Unity has it already the property is refused.
#include <fmt/format.h>

#include "compiler/assemble/shader_file.h"
#include "compiler/graph/words.h"
#include "compiler/targets/shaderlab/shaderlab.h"

namespace patina::assemble {
namespace {

using graph::PropertyType;
using targets::shaderlab::is_taken;
using targets::shaderlab::keyword_of;

constexpr std::string_view kUnity = "one of Unity's includes";

void check_name(const graph::Property& property, bool is_keyword, Diagnostics& diagnostics) {
    std::string taken = is_taken(property.name) ? property.name : "";
    if (is_keyword && property.values.empty() && is_taken(keyword_of(property.name, {})))
        taken = keyword_of(property.name, {});
    for (const std::string& value : property.values) {
        if (is_keyword && is_taken(keyword_of(property.name, value))) taken = keyword_of(property.name, value);
    }
    if (taken.empty()) return;
    DiagnosticRecord& refused = diagnostics.report(Code::TakenName, property.name_span, taken, kUnity);
    if (taken != property.name) refused.note(fmt::format("it is the keyword of '{}'", property.name));
}

void check_list(const graph::Property& property, bool is_keyword, Diagnostics& diagnostics) {
    const std::size_t most = is_keyword ? kMostKeywords : kMostPairs;
    if (property.type != PropertyType::Enum || property.values.size() <= most) return;
    DiagnosticRecord& told =
        diagnostics.report(Code::InspectorLimit, property.name_span, property.name,
                           fmt::format("it lists {} values at most, and these are {}", most, property.values.size()));
    if (is_keyword) told.note("the number sets no keyword: a script has to enable the one that is meant");
}

}  // namespace

void check_shader_properties(const graph::Material& material, const graph::Lowered& lowered, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const graph::MaterialProperty& entry = material.properties[i];
        const graph::Property& property = *entry.property;
        const graph::PropertyGlobals& globals = lowered.property_globals[i];
        const ir::GlobalId id = globals.texture ? globals.texture : globals.value;
        if (!id && !globals.keyword) continue;  // it has been decided
        const ir::Global* global = id ? &lowered.module.globals[id.index] : nullptr;
        const bool is_theirs = global && global->in_block() &&
                               !lowered.module.blocks[global->block].members[global->member].declared_in.empty();
        if (!is_theirs) check_name(property, !id, diagnostics);
        check_list(property, !id, diagnostics);
        if (entry.is_file)
            diagnostics.report(Code::NoFileDefault, property.default_span, property.name, default_word(property));
    }
}

}  // namespace patina::assemble

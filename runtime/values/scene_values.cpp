#include "runtime/values/scene_values.h"

#include <algorithm>

#include "runtime/values/material_values.h"

namespace patina::runtime {
namespace {

Diagnostic unknown_property(const WorldMaterial& material, const SceneValue& value,
                            const std::vector<std::string>& known) {
    Diagnostic unknown = diagnostic_at(value.property_location, "unknown-property",
                                       "'" + material.graph + "' has no property '" + value.property + "'");
    if (std::string advice = suggestion(value.property, known); !advice.empty()) {
        Diagnostic& note = unknown.notes.emplace_back();
        note.severity = Severity::Note;
        note.message = std::move(advice);
    }
    return unknown;
}

}  // namespace

SceneFaults check_values(const Reflection& reflection, const WorldMaterial& material) {
    SceneFaults faults;
    const auto error = [&](Diagnostic diagnostic) {
        faults.diagnostics.push_back(std::move(diagnostic));
        faults.ok = false;
    };
    const std::vector<std::string> known = property_names(reflection);
    for (const SceneValue& value : material.set) {
        if (std::find(known.begin(), known.end(), value.property) == known.end()) {
            error(unknown_property(material, value, known));
            continue;
        }
        const Outcome<MaterialValues> alone =
            material_values(reflection, {{value.property, value.words}}, Spelling::Json);
        if (!alone) error(diagnostic_at(value.value_location, "impossible-value", alone.error));
        for (const std::string& warning : alone.value.warnings) {
            faults.diagnostics.push_back(diagnostic_at(value.value_location, "soft-range", warning));
            faults.diagnostics.back().severity = Severity::Warning;
        }
    }
    return faults;
}

SceneFaults check_values(const Reflection& reflection, const WorldMaterial& material, const WorldInstance& instance) {
    SceneFaults faults = check_values(reflection, WorldMaterial{.graph = material.graph, .set = instance.set});
    for (const SceneValue& value : instance.set) {
        const auto property = std::find_if(reflection.properties.begin(), reflection.properties.end(),
                                           [&](const Property& p) { return p.name == value.property; });
        const bool is_known =
            property != reflection.properties.end() || lighting_option(reflection, value.property) != nullptr;
        if (!is_known || (property != reflection.properties.end() && property->instance_stride > 0)) continue;
        faults.diagnostics.push_back(diagnostic_at(
            value.property_location, "impossible-value",
            "'" + value.property + "' of '" + material.graph +
                "' has one value for all instances; set \"as\": \"instance\" to give each instance its own"));
        faults.ok = false;
    }
    return faults;
}

const FileLocation* place_of_value(const WorldMaterial& material, const std::string& property) {
    const auto found = std::find_if(material.set.begin(), material.set.end(),
                                    [&](const SceneValue& value) { return value.property == property; });
    return found == material.set.end() ? nullptr : &found->value_location;
}

}  // namespace patina::runtime

// Checks the values that a scene file sets in its materials against their reflections; errors have a location in the
// file.
//
//   SceneFaults faults = check_values(reflection, world.materials[0]);
//   if (faults.ok) use(material_values(reflection, world.materials[0].overrides));
#pragma once

#include "patina/patina.h"
#include "runtime/scene/world.h"

namespace patina::runtime {

struct SceneFaults {
    bool ok = true;                         // no errors among them
    std::vector<Diagnostic> diagnostics{};  // warnings too: values outside the usual range
};

// Of a material that no scene file holds: nothing.
SceneFaults check_values(const Reflection& reflection, const WorldMaterial& material);
// The same of an instance of an object, whose values only properties of instances can have.
SceneFaults check_values(const Reflection& reflection, const WorldMaterial& material, const WorldInstance& instance);
// Where the file gives the property its value; null if it does not.
const FileLocation* place_of_value(const WorldMaterial& material, const std::string& property);

}  // namespace patina::runtime

// `patina --licences`: whose code is in Patina's programs and libraries, and under which terms. The build writes the
// list from package/components.cmake and embeds the texts in the program. So a copy of the program alone has them, too.
#pragma once

#include <span>
#include <string_view>

#include "compiler/cli/program.h"

namespace patina::cli {

struct ComponentLicence {
    std::string_view name;       // "glslang"
    std::string_view version;    // "12.0.0", or "NOASSERTION"
    std::string_view licence;    // as SPDX writes it
    std::string_view code_in;    // "patina, patina-render"; empty: no code of it is in Patina
    std::string_view loaded_by;  // the programs that load its shared library
    std::string_view text;       // of the licence; empty if no code of it is in Patina
};
// Written by package/licences.cmake.
std::span<const ComponentLicence> component_licences();
// Patina's own licence.
std::string_view own_licence();

// --licences and --licenses, which end the program.
void add_licences_option(Program& program);

}  // namespace patina::cli

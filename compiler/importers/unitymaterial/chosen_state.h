// The render state that a material has chosen of a shader graph that lets it ("materialOverride").
#pragma once

#include <optional>

#include "compiler/importers/unitymaterial/material_maker.h"
#include "compiler/json/json.h"

namespace patina::importers::unitymaterial {

// The text of the graph, with the material's state instead of the graph's own. Nothing if the two are the same, or the
// graph does not let materials choose. `text`: of the graph, which `root` is made of; it begins at `begin`.
std::optional<std::string> with_chosen_state(MaterialMaker& maker, const json::Json& root, std::uint32_t begin,
                                             std::string_view text);

}  // namespace patina::importers::unitymaterial

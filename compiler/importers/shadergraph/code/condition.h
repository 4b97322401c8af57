// Conditions of the preprocessor: "defined(A) && !B", "X >= 2". Nothing is defined but what the text defines: the
// engine's own words are for its previews and its pipelines.
//
//   Macros macros = {{"MODE", "2"}};
//   decided("MODE == 2 && !defined(A)", macros).holds;   // true
//   decided("UNITY_VERSION > 202210", macros).error;     // "it compares 'UNITY_VERSION', whose value only the engine
//   knows"
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace patina::importers::shadergraph {

using Macros = std::map<std::string, std::string, std::less<>>;

struct Decision {
    bool holds = false;
    std::string error{};  // why it cannot be decided; empty: it can
};
Decision decided(std::string_view condition, const Macros& macros);

}  // namespace patina::importers::shadergraph

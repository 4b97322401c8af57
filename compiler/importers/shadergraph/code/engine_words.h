// Words that the engine declares: what stands for them in the node language.
#pragma once

#include <string>

namespace patina::importers::shadergraph {

// Puts what stands for them in their place, and adds the parameters that bring it: "[hidden] float engineTime = time".
void with_engine_words(std::string& code, std::string& parameters);

// For messages: the names of the engine again in the place of what stands for them.
std::string as_written(std::string text);

}  // namespace patina::importers::shadergraph

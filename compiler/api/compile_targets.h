// One compilation for each engine that is asked for, and their results as one.
#pragma once

#include <functional>

#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

// Compiles with targets of one engine.
using CompileForEngine = std::function<Result(const CompileOptions&)>;

// Engines that draw the library's paths come first: the reflection is theirs, and so are the switches of passes. An
// engine with passes of its own compiles all combinations of variants into its file, and has no use for switches of
// passes.
Result compile_targets(const graph::Library& library, const CompileOptions& options, const CompileForEngine& compile);

// Removes the switches of the reflection's path from what was given.
void without_switches(std::vector<std::pair<std::string, std::string>>& given, const Reflection& of_path);

// The targets of engines whose files hold all combinations of variants; and the others.
bool holds_variants(const graph::Library& library, const Target& target);

}  // namespace patina

// Runs one compilation for each requested engine, and joins their results.
#pragma once

#include <functional>

#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

// Compiles with targets of one engine.
using CompileForEngine = std::function<Result(const CompileOptions&)>;

// Engines that draw the library's paths come first. The result has their reflection, with its switches of passes. An
// engine with passes of its own compiles all combinations of variants into its file, and ignores switches of passes.
Result compile_targets(const resolve::Library& library, const CompileOptions& options, const CompileForEngine& compile);

// True if the program has cancelled the compilation, which then says so.
bool is_cancelled(const Result& result);

// Two sorted lists as one, each path once.
std::vector<std::string> joined(const std::vector<std::string>& a, const std::vector<std::string>& b);

// Removes the switches of the reflection's path from the given values.
void without_switches(std::vector<std::pair<std::string, std::string>>& given, const Reflection& of_path);

// True for a target whose engine writes all combinations of variants into one file.
bool holds_variants(const resolve::Library& library, const Target& target);

}  // namespace patina

// Temporary files that a run has left because it was killed. The next run that writes to their folder removes them.
#pragma once

#include <string>
#include <string_view>

namespace patina::runtime {

// The name of a new temporary file: ".patina-4711-18f3a2c0b1d2e3f4-0": the process, the time at which it began, and the
// number of the file. The time distinguishes processes with equal numbers. It is short, because the name of the final
// file may have the greatest possible length.
std::string temporary_name(unsigned number);
// True for the name of a temporary file of another run, also of an older version: ".patina-4711-0".
bool is_temporary_of_another(std::string_view name);

// Removes those of the folder. `is_locked`: no other process writes to the folder, so each temporary file is a
// leftover. Otherwise only a file is removed that is too old for any run to be writing it. A process looks once into
// each folder, which may hold thousands of files.
void remove_leftovers(const std::string& folder, bool is_locked);

}  // namespace patina::runtime

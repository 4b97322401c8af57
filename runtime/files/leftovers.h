// Temporary files that a run has left because it was killed. The next run that writes to their folder removes them.
#pragma once

#include <string>
#include <string_view>

namespace patina::runtime {

// The name of a new temporary file: ".patina-4711-18f3a2c0b1d2e3f4-0", of the process, of the time at which it began,
// which tells processes of one number apart, and of the file. It is short: that of the file that it becomes may have
// the greatest length that there is.
std::string temporary_name(unsigned number);
// True for the name of a temporary file of another run, also of an older version: ".patina-4711-0".
bool is_temporary_of_another(std::string_view name);

// Removes those of the folder. `is_locked`: nobody else writes to it, so each is a leftover; else only one that is so
// old that no run can still be writing it. A process looks once into each folder, which may hold thousands of files.
void remove_leftovers(const std::string& folder, bool is_locked);

}  // namespace patina::runtime

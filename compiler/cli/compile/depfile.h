// Dependency files for make and Ninja (--depfile): what outputs were made from, and the folders in which a file may
// appear that they would be made from instead.
//
// make and Ninja take a dependency that is not there for one that has changed, in every build. So a file that was
// looked for and is not there is named by its folder, whose time changes when a file is added; if the folder is
// missing, too, by the nearest one that is there. Folders that a build changes itself would never be older than what is
// made: those that the command writes to, and the one in which Ninja keeps its log. They are left out.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "runtime/outcome.h"

namespace patina::cli {

// What the outputs of one graph were made from, as Result has it.
struct FilesRead {
    std::vector<std::string> dependencies{}, missing{};
};

// A rule in Makefile syntax, as make's `include` and ninja's `depfile` want it: "target: a.json b.json". Each
// dependency has an empty rule of its own, so that make goes on when one of them has been removed. A failure: a rule
// cannot hold one of the names.
runtime::Outcome<std::string> make_rule(std::string_view target, std::span<const std::string> dependencies);

// The folders that say whether one of the missing files appears, or one of `searched` gets another entry. `written`:
// the folders that the command writes to.
std::vector<std::string> folders_to_watch(std::span<const std::string> missing, std::span<const std::string> searched,
                                          std::span<const std::string> written);

}  // namespace patina::cli

// Dependency files for make and Ninja (--depfile). They list the files from which outputs were made, and the folders in
// which other files may appear that would be used instead.
//
// make and Ninja take a dependency that is not there for one that has changed, in every build. So a file that was
// searched for and does not exist is represented by its folder, whose time changes when a file is added; if the folder
// is missing, too, by the nearest existing folder. Some folders change in each build, and so would never be older than
// the outputs: the command's output folders, and the folder of Ninja's log. They are left out.
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
// dependency has an empty rule of its own, so that make continues if one of them has been removed. A failure: a rule
// cannot hold one of the names.
runtime::Outcome<std::string> make_rule(std::string_view target, std::span<const std::string> dependencies);

// The folders that say whether one of the missing files appears, or one of `searched` gets another entry. `written`:
// the folders that the command writes to.
std::vector<std::string> folders_to_watch(std::span<const std::string> missing, std::span<const std::string> searched,
                                          std::span<const std::string> written);

}  // namespace patina::cli

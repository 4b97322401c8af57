// Texts of functions that earlier printings made. Most functions of a shader are the library's, or belong to the
// lighting model: they come back in each shader, while the graph changes.
//
//   print_kept(writer, id, entry, [&] { ... });   // appends the kept text, or prints and keeps it
#pragma once

#include <functional>

#include "compiler/base/remembered.h"
#include "compiler/languages/writer.h"

namespace patina::languages {

struct KeptText {
    std::string text;
    // An entry at the first line and at each line where the origin changes. Lines count from 0. An origin is a number:
    // its place in the order in which the function mentions origins.
    std::vector<PrintedLine> lines;
    std::vector<int> light_loops;  // lines at which a loop over lights begins, counted as those of `lines`
    Names::Asked asked;
};

// Appends the kept text of a function. If there is none, prints the function by `print`, and keeps what was printed.
// `entry`: null if it is not the stage's entry function.
void print_kept(Writer& writer, ir::FunctionId id, const EntryPoint* entry, const std::function<void()>& print);

}  // namespace patina::languages

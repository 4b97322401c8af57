// The errors of the library and of an embedder's overlay.
#pragma once

#include "compiler/resolve/library.h"
#include "patina/patina.h"

namespace patina {

// Checks the types in the overlay's functions, and returns all errors of the overlay: those of its syntax and names,
// too. A graph that uses its models finds theirs.
std::vector<Diagnostic> check_overlay(resolve::Library& library);

}  // namespace patina

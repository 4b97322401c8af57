// Keeps the stages that link_pass() made, for the next material that is linked to the same IR: one whose text was laid
// out anew, that has other defaults, or that is a variant with the same program.
//
// link_pass() reads a linked material, one of its passes and the engine, and nothing else. The key holds all of these
// but places in files: functions with their instructions, types, constants, names, globals, the nodes by name, the
// recipes of semantics, and the addresses of the library's declarations and of the engine, which live as long as the
// compiler. The stages hold no places in files either (Stages). So equal keys give equal stages.
#pragma once

#include <string>

#include "compiler/base/remembered.h"
#include "compiler/link/link.h"

namespace patina::link {

using KnownPasses = Remembered<std::string, Stages>;

// What link_pass() reads of a material and the engine.
std::string key_of(const Linked& linked, const engines::Engine& engine);
// The same, and what it reads of the pass. Only for passes of the library: a user's file does not live long enough.
std::string key_of(const std::string& key_of_material, const graph::LoweredPass& pass);
// Of the stages of that key with the key itself, about.
std::size_t bytes_of(const std::string& key);

}  // namespace patina::link

// The room `api` serves the public classes (patina/*.h): it turns what they are asked into calls of the other rooms,
// and what these make into public values. It compiles nothing itself.
//
// A Compilation is what the stages of compile.cpp hand to each other. Each stage is a function here, whose body is
// little more than a call of the room that does the work.
#pragma once

#include "compiler/engines/writers.h"
#include "compiler/resolve/material.h"

namespace patina {

struct Compilation {
    graph::Session& session;
    std::uint32_t source = 0;  // where the graph's text begins in the session's sources
    std::string path;          // of its file
    Result& result;

    const output::Writer* writer = nullptr;
    graph::MaterialFile file{};
    std::vector<const graph::Material*> materials{};  // the material itself, then the passes that it adds and shows
    std::vector<graph::Lowered> lowered{};            // of each, until it is linked
    std::vector<assemble::Linked> linked{};           // of each
    std::vector<assemble::LinkedPass> passes{};       // of all of them
};

// The list of stages (compile.cpp). False: it stopped, and the session's diagnostics say why.
bool compile(Compilation& c);

bool accept(Compilation& c);
bool find_path(Compilation& c);
bool read_material(Compilation& c);
bool lower_material(Compilation& c);
bool lower_passes(Compilation& c);
bool link_materials(Compilation& c);
bool link_stages(Compilation& c);
bool check_stages(Compilation& c);
bool order_passes(Compilation& c);
bool reflect(Compilation& c);
bool check_files(Compilation& c);
bool write_files(Compilation& c);
bool keep_programs(Compilation& c);

}  // namespace patina

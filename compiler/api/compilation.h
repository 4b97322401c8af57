// The room `api` implements the public classes (patina/*.h). It turns a request into calls of the other rooms, and
// their results into public values. It compiles nothing itself.
//
// A Compilation is the state that the steps of compile.cpp share. Each step is a function here, which does little more
// than call the room that does the work.
#pragma once

#include "compiler/resolve/material.h"
#include "compiler/seam/seam.h"
#include "compiler/writers/writers.h"

namespace patina {

struct Compilation {
    resolve::Session& session;
    std::uint32_t source = 0;  // where the graph's text begins in the session's sources
    std::string path;          // of its file
    Result& result;
    ShortName& pass;  // that is worked on now

    const output::Writer* writer = nullptr;
    resolve::MaterialFile file{};
    std::vector<const resolve::Material*> materials{};  // the material itself, then its extra passes that are drawn
    std::vector<lower::Lowered> lowered{};              // of each material, until it is linked
    std::vector<link::Linked> linked{};                 // of each material
    std::vector<link::LinkedPass> passes{};             // of all materials
};

// The list of steps (compile.cpp). False if it stopped; the session's diagnostics say why.
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

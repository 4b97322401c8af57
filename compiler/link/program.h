// The unoptimised stages of a compiled material: what the CPU reference runs.
#pragma once
#include <map>

#include "compiler/ir/ir.h"
#include "patina/patina.h"
namespace patina {
struct ProgramStage {
    std::string pass;
    Stage stage;
    ir::Module module;
};
// The place in the graphs that a probe of a stage belongs to.
struct ProgramPlace {
    std::string file;
    int line = 0, column = 0;
};
struct Program {
    std::vector<ProgramStage> stages;
    std::map<std::uint32_t, ProgramPlace> places{};  // by the begin of the probe's span
};
}  // namespace patina

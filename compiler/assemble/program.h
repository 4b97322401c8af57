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
struct Program {
    std::vector<ProgramStage> stages;
};
}  // namespace patina

#include <utility>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/verify.h"

namespace patina::ir {
namespace {

struct Pass {
    const char* name;
    Module (*run)(Module);
};
constexpr Pass kPasses[] = {
#define PASS(function) {#function, function},
#include "compiler/ir/passes/passes.def"
#undef PASS
};

}  // namespace

Module tidy(Module module) {
    for (const Pass& pass : kPasses) {
        module = pass.run(std::move(module));
        if (is_verifying()) check(module, pass.name);
    }
    return module;
}

}  // namespace patina::ir

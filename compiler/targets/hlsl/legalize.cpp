#include "compiler/targets/legalize.h"

#include "compiler/targets/hlsl/hlsl.h"

namespace patina::targets::hlsl {

// The shared rules are all that HLSL needs: the IR's operations are its own.
void legalize(ir::Module& module) {
    targets::legalize(module, {});
}

}  // namespace patina::targets::hlsl

#include "compiler/languages/legalize.h"

#include "compiler/languages/hlsl/hlsl.h"

namespace patina::targets::hlsl {

// The shared rules are all that HLSL needs: the IR's operations are its own.
std::optional<ir::Module> legalize(const ir::Module& module) {
    return targets::legalize(module, {});
}

}  // namespace patina::targets::hlsl

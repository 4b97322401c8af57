#include "compiler/languages/legalize.h"

#include "compiler/languages/hlsl/hlsl.h"

namespace patina::languages::hlsl {

// HLSL needs the shared rules only, because it has all operations of the IR.
std::optional<ir::Module> legalize(const ir::Module& module) {
    return languages::legalize(module, {});
}

}  // namespace patina::languages::hlsl

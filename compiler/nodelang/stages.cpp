#include "compiler/nodelang/stages.h"

namespace patina::nodelang {

bool is_stage(const FunctionDecl& function) {
    return function.attribute("pass") != nullptr;
}

}  // namespace patina::nodelang

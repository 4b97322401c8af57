// Finds a stage that an earlier compilation has linked and tidied from the same functions, in the same pass.
#pragma once

#include <functional>

#include "compiler/link/kept_results.h"
#include "compiler/link/link.h"

namespace patina::link {

// The stage of the pass that `make` makes by linking and tidying. `fragment`: null for the fragment stage itself; the
// vertex stage is also made of the inputs of the finished fragment stage. `kept`: may be null.
ir::Module kept_stage(KeptResults* kept, const Linked& linked, const graph::LoweredPass& pass,
                      const ir::Module* fragment, const std::function<ir::Module()>& make);

}  // namespace patina::link

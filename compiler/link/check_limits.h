// Reports materials that need more than the engine allows: bytes of a uniform block, samplers of a stage.
#pragma once

#include "compiler/link/link.h"
#include "compiler/resolve/session.h"

namespace patina::link {

// Reports the first property that is over a limit of the engine. The samplers of a file with all passes are the
// business of its writer, because its own text needs some, too.
void check_limits(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered,
                  std::span<const LinkedPass> passes);

}  // namespace patina::link

// One snapshot: draws it, compares it with its references, and accepts it on request.
//
//   SnapshotCase result = run_case(compiler, planned, options, machine);
#pragma once

#include "runtime/snapshot/find_cases.h"
#include "runtime/snapshot/snapshot.h"

namespace patina::runtime {

// What is thrown fails this case alone.
SnapshotCase run_case(const Compiler& compiler, const PlannedCase& planned, const SnapshotOptions& options,
                      RenderMachine& machine);

}  // namespace patina::runtime

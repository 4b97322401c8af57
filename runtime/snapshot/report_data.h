// The results of snapshots for programs: as JSON, and as JUnit XML, which build servers show.
//
//   write_file("results.xml", report_junit(report, "art"));
#pragma once

#include <string>

#include "runtime/snapshot/snapshot.h"

namespace patina::runtime {

// The same for the same results: in the order of the cases, without times.
//   { "ok": false, "passed": 1, "failed": 1, "missing": 0, "updated": 0, "cases": [ { "name": "rust",
//     "file": "art/rust.graph.json", "state": "failed", "message": "...", "reference": "art/rust.reference.png",
//     "received": "received/rust.received.png", "difference": "received/rust.difference.png",
//     "gates": { "share": { "value": 0.4, "limit": 0.001, "ok": false }, ... },
//     "device": "llvmpipe (LLVM 15.0.6, 256 bits)", "driver": "...", "referenceDevice": "...", "referenceDriver":
//     "...", "otherDriver": false, "spirvBytes": 5120, "referenceSpirvBytes": 5000, "changedLines": 3 } ] }
// What is not known is left out.
std::string report_json(const SnapshotReport& report);

// A test suite named `suite`, with the seconds of each case. A case that cannot be drawn is an error, one that differs
// or has no reference a failure.
std::string report_junit(const SnapshotReport& report, const std::string& suite);

}  // namespace patina::runtime

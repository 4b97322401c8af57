// The results of snapshots as one HTML page that needs no other file: its pictures are inside. Failed cases come first.
// Each has its reference, the received picture, their difference, a slider between both, its figures, the difference of
// the shaders' texts, and the cost of the shaders before and now. page/page.html is its frame.
//
//   write_file("report.html", report_page(report, "art"));   // the report was run with keeps_pictures
#pragma once

#include <string>

#include "runtime/snapshot/snapshot.h"

namespace patina::runtime {

std::string report_page(const SnapshotReport& report, const std::string& folder);

}  // namespace patina::runtime

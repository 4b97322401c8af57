// The page that report_page() fills: report.html, with @TITLE@, @SUMMARY@ and @CASES@.
#pragma once

#include <string_view>

namespace patina::runtime {

extern const std::string_view kReportFrame;

}  // namespace patina::runtime

// The room `page` makes pages of HTML and drawings. It renders nothing.
//
// The page that report_page() fills: page.html, with @TITLE@, @SUMMARY@ and @CASES@.
#pragma once

#include <string_view>

namespace patina::runtime {

extern const std::string_view kPageFrame;

}  // namespace patina::runtime

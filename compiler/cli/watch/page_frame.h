// The page that page_text() fills: live_page.html, with @PICTURE@ and @STATE@.
#pragma once

#include <string_view>

namespace patina::cli {

extern const std::string_view kLivePage;

}  // namespace patina::cli

// The frame that make_page() fills: page.html, with @TITLE@, @TOOLS@ and @CONTENT@.
#pragma once

#include <string_view>

namespace patina::runtime {

extern const std::string_view kPageFrame;

}  // namespace patina::runtime

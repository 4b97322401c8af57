// A folder's graphs as one HTML page that needs no other file: an overview, then a card for each.
#pragma once

#include <string>

#include "runtime/sheet/sheet.h"

namespace patina::runtime {

std::string sheet_page(const Sheet& sheet, const std::string& folder);

}  // namespace patina::runtime

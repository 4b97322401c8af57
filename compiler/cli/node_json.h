// A node of the library as JSON, for `nodes --json` and `node --json`. Everything in NodeInfo, empty fields left out.
#pragma once

#include <string>

#include "patina/patina.h"

namespace patina::cli {

std::string to_json(const NodeInfo& node);
std::string to_json(std::span<const NodeInfo* const> nodes);

}  // namespace patina::cli

// Text as it stands in XML and HTML, between tags and in attributes.
//
//   "<td>" + escaped("a < b") + "</td>"
#pragma once

#include <string>
#include <string_view>

namespace patina::runtime {

// XML 1.0 has no control characters but tab, line feed and carriage return: others become '?'.
std::string escaped(std::string_view text);

}  // namespace patina::runtime

// Files of the disk, for those who need the reason why one cannot be read.
#pragma once

#include <optional>
#include <string>

namespace patina {

// The text of a file. Nothing if it cannot be read: `why` is the reason of the system then.
std::optional<std::string> read_from_disk(const std::string& path, std::string& why);
bool is_on_disk(const std::string& path);

}  // namespace patina

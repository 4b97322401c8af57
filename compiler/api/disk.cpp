// disk(): the disk as a FileSystem.
#include "compiler/base/disk.h"

#include <filesystem>
#include <stdexcept>

#include "compiler/base/file_names.h"
#include "patina/options.h"

namespace patina {

FileSystem disk() {
    const auto read = [](const std::string& path) {
        std::string why;
        std::optional<std::string> text = read_from_disk(path, why);
        std::error_code ignored;
        if (!text && std::filesystem::exists(path, ignored)) throw std::runtime_error(why);
        return text;
    };
    return {.resolve = join_names, .exists = is_on_disk, .read = read};
}

}  // namespace patina

// disk(): the disk, or a part of it, as a FileSystem.
#include <algorithm>

#include "compiler/base/file_names.h"
#include "compiler/json/json.h"
#include "compiler/resolve/files.h"

namespace patina {

FileSystem disk(const DiskOptions& options) {
    resolve::DiskPart part{.root = nullptr, .most_bytes = std::min(options.most_bytes, json::kMaxJsonBytes)};
    if (!options.root.empty()) part.root = std::make_shared<const Root>(options.root);
    return {.resolve = join_names, .exists = resolve::FindOnDisk{part}, .read = resolve::ReadFromDisk{part}};
}

FileSystem disk() {
    return disk(DiskOptions{});
}

}  // namespace patina

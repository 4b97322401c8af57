// disk(): the disk, or a part of it, as a FileSystem.
#include <algorithm>

#include "compiler/base/file_names.h"
#include "compiler/json/json.h"
#include "compiler/resolve/files.h"

namespace patina {

FileSystem disk(const DiskOptions& options) {
    graph::DiskPart part{.root = nullptr, .most_bytes = std::min(options.most_bytes, graph::kMaxJsonBytes)};
    if (!options.root.empty()) part.root = std::make_shared<const Root>(options.root);
    return {.resolve = join_names, .exists = graph::FindOnDisk{part}, .read = graph::ReadFromDisk{part}};
}

FileSystem disk() {
    return disk(DiskOptions{});
}

}  // namespace patina

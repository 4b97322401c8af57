#include "compiler/cli/render/model_file.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "compiler/base/disk/disk.h"

namespace patina::cli {

runtime::Outcome<ModelFile> import_model(const std::string& path, importers::Options options) {
    using importers::Remark;
    const importers::Source source{.path = path, .start = read_beginning(path, importers::kStart).bytes.value_or("")};
    const importers::Importer* importer = importers::importer_of(source);
    if (!importer) return runtime::Failure{"'" + path + "' is no model that can be read"};
    options.folder = path;
    importers::Imported made = importers::read_verified(*importer, source, options);
    if (!made.error.empty()) return runtime::Failure{made.error};
    if (made.scene.empty())
        return runtime::Failure{"'" + path + "' shows no triangles: import it, and draw its graphs"};

    runtime::MemoryFiles files;
    const auto name_of = [&](const std::string& name) {
        return (std::filesystem::path(path) / name).lexically_normal().generic_string();
    };
    for (importers::TextFile& each : made.graphs) files[name_of(each.name)] = std::move(each.text);
    for (importers::BinaryFile& each : made.copies) files[name_of(each.name)] = std::move(each.bytes);
    const auto refused = std::count_if(made.remarks.begin(), made.remarks.end(),
                                       [](const Remark& remark) { return remark.kind == Remark::Kind::LeftOut; });
    return ModelFile{.scene = (std::filesystem::path(path) / made.scene).generic_string(),
                     .files = std::make_shared<const runtime::MemoryFiles>(std::move(files)),
                     .refused = static_cast<std::size_t>(refused)};
}

}  // namespace patina::cli

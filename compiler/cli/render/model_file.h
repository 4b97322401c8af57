// Models of other programs for `patina render`: they are imported in memory, into files with paths "inside" the model:
// chair.glb/chair.scene.json. The picture is that of the scene that `patina import` writes.
//
//   runtime::Outcome<ModelFile> model = import_model("chair.glb", {.camera = "Front"});
//   request.graph = model.value.scene;
//   request.options.files = model.value.files;
#pragma once

#include <memory>
#include <string>

#include "compiler/importers/importer.h"
#include "runtime/outcome.h"
#include "runtime/picture/image.h"

namespace patina::cli {

struct ModelFile {
    std::string scene{};  // its name among the files
    std::shared_ptr<const runtime::MemoryFiles> files{};
    std::size_t refused = 0;  // properties that the picture does not show
};
runtime::Outcome<ModelFile> import_model(const std::string& path, importers::Options options);

}  // namespace patina::cli

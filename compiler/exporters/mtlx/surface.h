// The surface shader of a material, and what its inputs read.
#pragma once

#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {

// Elements of the document after the node graph. The writer has the node graph afterwards. Reports what the document
// cannot say.
struct SurfaceParts {
    Element shader{};
    std::vector<Element> outputs{};  // of the node graph
};
SurfaceParts write_surface(resolve::Session& session, const resolve::Material& material, const ir::Module& module,
                           NodeWriter& writer, const std::string& graph_name, const std::string& shader_name);

}  // namespace patina::exporters::mtlx

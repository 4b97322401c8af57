// The list of importers: one row each.
#include <algorithm>

#include "compiler/importers/gltf/gltf_importer.h"
#include "compiler/importers/importer.h"
#include "compiler/importers/merl/merl_importer.h"
#include "compiler/importers/mtlx/mtlx_importer.h"
#include "compiler/importers/shadergraph/shadergraph_importer.h"
#include "compiler/importers/unitymaterial/unitymaterial_importer.h"

namespace patina::importers {

std::span<const Importer> importers() {
    static const Importer kImporters[] = {
        gltf_importer(), merl_importer(), mtlx_importer(), shadergraph_importer(), unitymaterial_importer(),
    };
    return kImporters;
}

const Importer* importer_of(const Source& source) {
    const std::span<const Importer> all = importers();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Importer& importer) { return importer.recognises(source); });
    return found == all.end() ? nullptr : &*found;
}

std::string_view to_string(Remark::Kind kind) {
    switch (kind) {
        case Remark::Kind::Taken: return "exact";
        case Remark::Kind::Changed: return "approximate";
        case Remark::Kind::LeftOut: return "refused";
    }
    return {};
}

}  // namespace patina::importers

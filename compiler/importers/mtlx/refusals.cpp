// What the compiler refuses of a graph becomes a constant, and is reported at the nodes that are written there.
#include <fmt/format.h>

#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {

void GraphMaker::refuse_invalid(const Element& shader, std::size_t first_remark) {
    scope_label_.clear();
    // An input of the surface has remarks of the inputs of the shader.
    const auto report = [&](const Diagnostic& wrong, const std::string& reason) {
        const std::string place = fmt::format("'{}.{}'", wrong.node, wrong.port);
        bool is_said = false;
        for (std::size_t i = first_remark; i < import_.remarks.size(); ++i) {
            Remark& each = import_.remarks[i];
            if (each.kind != Remark::Kind::Taken || each.text != place) continue;
            each.kind = Remark::Kind::LeftOut;
            each.text = reason;
            is_said = true;
        }
        if (!is_said) remark(Remark::Kind::LeftOut, place, reason, shader);
    };
    const std::string error = file_.refuse_invalid({}, report);
    if (!error.empty() && import_.error.empty())
        import_.error = fmt::format("{}:{}:{}: {}", import_.path, shader.line, shader.column, error);
}

}  // namespace patina::importers::mtlx

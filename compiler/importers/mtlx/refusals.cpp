// What the compiler refuses of a graph becomes a constant, and is reported at the nodes that are written there.
#include "compiler/importers/refusals.h"

#include <fmt/format.h>

#include "compiler/importers/mtlx/graph_maker.h"

namespace patina::importers::mtlx {

void GraphMaker::refuse_invalid(const Element& shader, std::size_t first_remark) {
    const auto type_of = [&](const Diagnostic& wrong) {
        const auto found = types_.find(wrong.node == "surface" ? "surface." + wrong.port : wrong.node);
        return found == types_.end() ? Type::Float3 : found->second;
    };
    const auto report = [&](const Diagnostic& wrong, const std::string& reason) {
        import_.has_refused = true;
        scope_label_.clear();
        if (const auto owners = owners_.find(wrong.node); owners != owners_.end() && !owners->second.empty()) {
            for (const std::size_t each : owners->second) {
                outcomes_[each].kind = Remark::Kind::LeftOut;
                outcomes_[each].text = reason;
            }
            return;
        }
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
    const std::string error = importers::refuse_invalid(
        file_, {}, [&](const Diagnostic& wrong) { return has_constant(file_, wrong, type_of(wrong)); }, report);
    if (!error.empty() && import_.error.empty())
        import_.error = fmt::format("{}:{}:{}: {}", import_.path, shader.line, shader.column, error);
}

}  // namespace patina::importers::mtlx

// What the compiler refuses becomes a constant. So a file whose slots are not those of its nodes is imported as far as
// it makes sense.
#include "compiler/importers/refusals.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// In an object whose text is ready.
bool has_constant_in(std::string& object, const std::string& key, const Value& constant) {
    const std::string before = text(key).json + ": \"";
    const std::size_t begin = object.find(before);
    const std::size_t end = begin == object.npos ? begin : object.find('"', begin + before.size());
    if (end == object.npos) return false;
    object.replace(begin + before.size() - 1, end + 2 - begin - before.size(), constant.json);
    return true;
}

}  // namespace

bool GraphMaker::has_constant_for(const Diagnostic& wrong) {
    if (wrong.node == "surface") {
        const bool is_color = wrong.port == "baseColor" || wrong.port == "color";
        return has_constant(file_, wrong, is_color ? Type::Float3 : Type::Float);
    }
    if (const auto part = std::ranges::find(file_.more, wrong.node, &Member::key); part != file_.more.end()) {
        const auto output = std::ranges::find(ports_.outputs, wrong.port, &SubgraphPorts::Output::name);
        const Term constant = stand_in(output == ports_.outputs.end() ? Type::Float3 : output->type);
        return has_constant_in(part->value.json, wrong.port, text("= " + constant.text()));
    }
    const auto type = types_.find(wrong.node);
    return has_constant(file_, wrong, type == types_.end() ? Type::Float4 : type->second);
}

std::string GraphMaker::refuse_invalid() {
    const auto report = [&](const Diagnostic& wrong, const std::string& reason) {
        const auto owner = owners_.find(wrong.node);
        if (owner == owners_.end()) {
            remark(Remark::Kind::LeftOut, fmt::format("'{}.{}'", wrong.node, wrong.port), reason, {});
            return;
        }
        outcomes_[owner->second] = {.kind = Remark::Kind::LeftOut, .text = reason};
        project_.has_refused = true;
    };
    const std::string error = importers::refuse_invalid(
        file_, project_.files, [&](const Diagnostic& wrong) { return has_constant_for(wrong); }, report);
    return error.empty() ? error : fmt::format("{}: {}", graph_.path, error);
}

}  // namespace patina::importers::shadergraph

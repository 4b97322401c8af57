#include "proof/lowered.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/format/read_graph.h"
#include "compiler/json/json.h"
#include "proof/term.h"

namespace patina::proof {

std::string material_of(std::string_view model, std::string_view workflow) {
    return fmt::format(R"({{ "patina": 1, "workflow": "{}", "lighting": "{}", "surface": {{}} }})", workflow, model);
}

namespace {

CompileOptions options_for(const std::string& rendering_path) {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = rendering_path};
    return options;
}

}  // namespace

LoweredMaterial::LoweredMaterial(std::string text, const std::string& path, ir::BuildOptions build,
                                 const std::string& rendering_path)
    : options_(options_for(rendering_path)), session_(library(), options_) {
    const std::uint32_t base = session_.sources.add(path, std::move(text));
    const auto json = json::parse_json(session_.sources, base, session_.diagnostics);
    if (json) {
        graph_ = format::read_graph(*json, path, session_.sources, session_.ast, session_.diagnostics,
                                    format::GraphKind::Material);
    }
    if (graph_) material_ = resolve::resolve_material(session_, graph_, std::nullopt);
    if (material_) lowered_ = lower::lower(session_, *material_, build);
    for (const DiagnosticRecord& record : session_.diagnostics.records()) {
        if (session_.diagnostics.has_errors()) ADD_FAILURE() << path << ": " << record.message;
    }
    ok_ = material_ && !session_.diagnostics.has_errors();
}

ir::FunctionId LoweredMaterial::function(std::string_view name) const {
    for (std::uint32_t i = 0; i < lowered_.module.functions.size(); ++i) {
        if (lowered_.module.functions[i].name == name) return {i};
    }
    return {};
}

std::uint32_t LoweredMaterial::surface_member(std::string_view name) const {
    const ir::Module& module = lowered_.module;
    const ir::Type type = module[slot("final")].params[0].type;
    const std::vector<ir::Member>& members = module.structs[type.ref].members;
    const auto found = std::ranges::find(members, name, &ir::Member::name);
    EXPECT_NE(found, members.end()) << name;
    return static_cast<std::uint32_t>(found - members.begin());
}

}  // namespace patina::proof

#include "compiler/cli/pages/model_cost.h"

#include <fmt/format.h>

#include <algorithm>

#include "patina/cost.h"

namespace patina::cli {
namespace {

constexpr std::string_view kWorkflow = "metallic-roughness";
constexpr std::string_view kPass = "forward";

// Not for an input whose default is a semantic, nor for one that is another form of an input.
bool takes_property(const ModelInputInfo& input) {
    return input.gives.empty() && input.default_value.find('@') == std::string::npos;
}

std::string material_of(const Compiler& compiler, const ModelInfo& model) {
    std::string properties, surface;
    const auto add = [&](const std::vector<ModelInputInfo>& inputs) {
        for (const ModelInputInfo& input : inputs) {
            if (!takes_property(input)) continue;
            const std::string_view comma = properties.empty() ? "" : ", ";
            const bool is_color = input.type == "color3";
            properties += fmt::format(R"({}{{ "name": "_{}", "type": "{}" }})", comma, input.name,
                                      is_color ? "color" : input.type);
            surface += fmt::format(R"({}"{}": "$_{}{}")", comma, input.name, input.name, is_color ? ".rgb" : "");
        }
    };
    const std::vector<ModelInfo>& workflows = compiler.workflows();
    const auto workflow = std::ranges::find(workflows, kWorkflow, &ModelInfo::name);
    if (workflow != workflows.end()) add(workflow->inputs);
    add(model.inputs);
    return fmt::format(
        R"({{ "patina": 1, "workflow": "{}", "lighting": "{}", "properties": [ {} ], "surface": {{ {} }} }})",
        kWorkflow, model.name, properties, surface);
}

}  // namespace

ModelCost cost_of(const Compiler& compiler, const ModelInfo& model) {
    ModelCost cost{.workflow = std::string(kWorkflow), .pass = std::string(kPass)};
    CompileOptions options;
    options.targets = {Target::Glsl};
    options.request = CompileOptions::Passes{.only = {cost.pass}};
    const Result result = compiler.compile_text("cost.graph.json", material_of(compiler, model), options);
    for (const Shader& shader : result.shaders) {
        if (shader.stage == Stage::Fragment) cost.fragment = measure(shader);
    }
    return cost;
}

}  // namespace patina::cli

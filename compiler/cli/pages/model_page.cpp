// The page of one lighting model.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/cli/pages/model_cost.h"
#include "compiler/cli/pages/pages.h"

namespace patina::cli {
namespace {

Entry describe(const ModelInputInfo& input) {
    std::vector<std::string> facts;
    if (input.range) facts.push_back(fmt::format("{} to {}", (*input.range)[0], (*input.range)[1]));
    if (!input.values.empty()) {
        const std::vector<std::string_view> words(input.values.begin(), input.values.end());
        facts.push_back(enumerate(words));
    }
    if (!input.default_value.empty()) facts.push_back("default " + input.default_value);
    if (input.is_variant) facts.push_back("known when the graph is compiled");
    return {
        .name = input.name, .type = input.type, .facts = fmt::format("{}", fmt::join(facts, "; ")), .doc = input.doc};
}

Section inputs_section(std::string title, const std::vector<ModelInputInfo>& inputs) {
    Section section{.title = std::move(title)};
    for (const ModelInputInfo& input : inputs) section.entries.push_back(describe(input));
    return section;
}

// What an expression reads by '@': "surface.f0", "normalWS". If no semantic has such a member, it is a swizzle.
void collect_semantics(std::string_view text, std::span<const SemanticInfo> known, std::vector<bool>& read) {
    for (std::size_t at = text.find('@'); at != text.npos; at = text.find('@', at + 1)) {
        std::size_t end = at + 1;
        while (end < text.size() && is_word_letter(text[end])) ++end;
        std::size_t whole = end;
        if (whole < text.size() && text[whole] == '.') {
            do ++whole;
            while (whole < text.size() && is_word_letter(text[whole]));
        }
        for (std::string_view name : {text.substr(at + 1, whole - at - 1), text.substr(at + 1, end - at - 1)}) {
            const auto found = std::ranges::find(known, name, &SemanticInfo::name);
            // If the struct has no such member, it is an input that the model declares.
            const bool has_members = std::ranges::any_of(
                known, [&](const SemanticInfo& info) { return info.name.starts_with(std::string(name) + "."); });
            if (found == known.end() || has_members) continue;
            // If the lit surface has a value of the same name, a lighting graph reads that.
            const auto lit = std::ranges::find(known, "surface." + std::string(name), &SemanticInfo::name);
            read[static_cast<std::size_t>((lit == known.end() ? found : lit) - known.begin())] = true;
            break;
        }
    }
}

Section reads_section(const Compiler& compiler, const ModelInfo& model) {
    const std::vector<SemanticInfo>& known = compiler.semantics();
    Section section{.title = "What it reads"};
    for (const std::string& name : semantics_read(compiler, model)) {
        const auto found = std::ranges::find(known, name, &SemanticInfo::name);
        section.entries.push_back({.name = "@" + name, .type = found->type, .doc = first_sentence(found->doc)});
    }
    return section;
}

Section nodes_section(const ModelInfo& model) {
    Section section{.title = "Nodes"};
    for (const ModelNodeInfo& node : model.nodes) {
        Entry entry{.name = node.id, .type = node.node, .doc = node.doc};
        entry.facts = node.expr;
        for (const auto& [port, value] : node.inputs) {
            entry.facts += (entry.facts.empty() ? "" : "; ") + port + ": " + value;
        }
        section.entries.push_back(std::move(entry));
    }
    return section;
}

// The lines "formula:" of the comment, if there are any, and the graph's own outputs.
std::string equation(const ModelInfo& model) {
    std::string text = model.formula;
    if (!text.empty()) text += "\n\n";
    for (const auto& [name, value] : model.outputs) {
        text += name + " " + (value.starts_with("=") ? value : "= " + value) + "\n";
    }
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

constexpr std::string_view kUnits =
    "`direct` is the radiance that one light adds, `indirect` that of the environment; both are linear. A light's\n"
    "`radiance` and the ambient irradiance are E/pi, the radiance of a white Lambertian surface, so a BRDF is "
    "multiplied "
    "by\n"
    "pi. Angles are in radians, directions are unit vectors in world space.";

std::string cost_text(const Compiler& compiler, const ModelInfo& model) {
    const ModelCost cost = cost_of(compiler, model);
    const CostCounts& once = cost.fragment.once;
    const CostCounts& light = cost.fragment.per_light;
    const std::string for_lights = light.instructions == 0
                                       ? ""
                                       : fmt::format(", and {} for each light, of them {} transcendental",
                                                     light.instructions, light.transcendental);
    return fmt::format(
        "{} SPIR-V instructions for each pixel, of them {} transcendental{}. Texture reads: {}. Registers: {}.\n"
        "This is the fragment shader of the pass '{}' in the workflow '{}', with a property at every input, after "
        "`spirv-opt -O`.",
        once.instructions, once.transcendental, for_lights, once.textures + light.textures, cost.fragment.registers,
        cost.pass, cost.workflow);
}

}  // namespace

std::vector<std::string> semantics_read(const Compiler& compiler, const ModelInfo& model) {
    const std::vector<SemanticInfo>& known = compiler.semantics();
    std::vector<bool> read(known.size(), false);
    for (const ModelNodeInfo& node : model.nodes) {
        collect_semantics(node.expr, known, read);
        for (const auto& [port, value] : node.inputs) collect_semantics(value, known, read);
        const NodeInfo* info = compiler.node(node.node);
        if (!info) continue;
        for (const PortInfo& port : info->ports) {
            const bool is_given = std::ranges::any_of(node.inputs, [&](const auto& i) { return i.first == port.name; });
            if (!is_given) collect_semantics(port.default_value, known, read);
        }
    }
    for (const auto& [name, value] : model.outputs) collect_semantics(value, known, read);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (read[i]) names.push_back(known[i].name);
    }
    return names;
}

Page model_page(const Compiler& compiler, const ModelInfo& model) {
    Page page{.title = model.name, .place = "Lighting models", .sections = {}};
    page.sections = {
        {.title = {}, .text = model.doc},
        {.title = "When to use it", .text = model.use},
        {.title = "Equation", .code = equation(model)},
        {.title = "Units", .text = std::string(kUnits)},
        {.title = "Source", .text = model.source},
        inputs_section("Inputs of its own", model.inputs),
        inputs_section("Properties", model.properties),
        reads_section(compiler, model),
        nodes_section(model),
        {.title = "Cost", .text = cost_text(compiler, model)},
        {.title = "In a graph", .code = "\"lighting\": \"" + model.name + "\""},
        {.title = "File", .text = model.file},
    };
    return page;
}

}  // namespace patina::cli

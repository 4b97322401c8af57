#include "compiler/cli/pages/cost_page.h"

#include <fmt/format.h>

#include "patina/output_name.h"

namespace patina::cli {
namespace {

constexpr std::string_view kColumns = "  {:<40} {:>8} {:>7} {:>7} {:>8} {:>6} {:>6}";

std::string line(std::string_view first, const Instructions& cost) {
    return fmt::format(fmt::runtime(kColumns), first, cost.total(), cost.arithmetic, cost.transcendental, cost.texture,
                       cost.derivative, cost.other);
}

std::string stage_lines(const PassCost& pass, Stage stage) {
    const StageCost& cost = stage == Stage::Vertex ? pass.vertex : pass.fragment;
    const std::string_view each = stage == Stage::Vertex ? "vertex" : "pixel";
    std::string text = line(fmt::format("{}, for a {}", pass.name, each), cost.once) +
                       fmt::format(" {:>8} {:>9}\n", cost.varyings, cost.registers);
    if (cost.per_light.total() > 0)
        text += line(fmt::format("{}, for a light of a {}", pass.name, each), cost.per_light) + "\n";
    return text;
}

// "albedo", "unity-brdf1: fresnel", "= albedo.rgb * 0.5"
std::string label(const NodeCost& node, std::string_view graph) {
    if (node.file.empty()) return "(rendering path, mesh, lights)";
    constexpr std::size_t kMost = 38;
    std::string text = node.file == graph ? "" : output_name(node.file) + ": ";
    text += node.node.empty() ? node.source : node.node;
    return text.size() > kMost ? text.substr(0, kMost - 3) + "..." : text;
}

std::string node_lines(const PassCost& pass, Stage stage, std::string_view graph) {
    const StageCost& cost = stage == Stage::Vertex ? pass.vertex : pass.fragment;
    if (cost.nodes.empty()) return {};
    const std::string heading = fmt::format("{}, {} stage: shares", pass.name, to_string(stage));
    std::string text =
        fmt::format("\n  {:<40} {:>8} {:>7} {:>7} {:>8} {:>6}\n", heading, "", "once", "light", "transc.", "tex.");
    for (const NodeCost& node : cost.nodes)
        text += fmt::format("  {:<40} {:>6.1f} % {:>7} {:>7} {:>8} {:>6}\n", label(node, graph),
                            100.0 * node.total() / cost.total(), node.once.total(), node.per_light.total(),
                            node.once.transcendental + node.per_light.transcendental,
                            node.once.texture + node.per_light.texture);
    return text;
}

}  // namespace

std::string cost_page(const MaterialCost& cost, std::string_view graph) {
    std::string text =
        fmt::format("{}\n", graph) +
        fmt::format(fmt::runtime(kColumns), "instructions", "all", "arith.", "transc.", "texture", "deriv.", "other") +
        fmt::format(" {:>8} {:>9}\n", "varyings", "registers");
    std::string nodes;
    for (const PassCost& pass : cost.passes) {
        for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
            text += stage_lines(pass, stage);
            nodes += node_lines(pass, stage, graph);
        }
        text += fmt::format("  {}, textures: {}; bytes of the material's uniforms: {}\n", pass.name, pass.textures,
                            pass.uniform_bytes);
    }
    return text + nodes;
}

}  // namespace patina::cli

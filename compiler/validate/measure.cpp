#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "compiler/validate/compile.h"
#include "compiler/validate/counts.h"
#include "compiler/validate/inlined.h"
#include "compiler/validate/owners.h"
#include "patina/complaints.h"
#include "patina/cost.h"

namespace patina {
namespace {

using Part = CostShare::Part;

// The owners of a material's instructions (owners.h): the pass, lighting, the surface, then its nodes.
constexpr std::uint32_t kPass = 0, kLighting = 1, kSurface = 2, kFirstNode = 3;

class Nodes {
public:
    explicit Nodes(const Result& compiled) {
        if (!compiled.dependencies.empty()) graph_ = compiled.dependencies.front();
        for (std::size_t i = 0; i < compiled.nodes.size(); ++i)
            index_.emplace(compiled.nodes[i], static_cast<std::uint32_t>(i));
    }

    // Nothing: the function that the line is in works for its callers.
    std::optional<std::uint32_t> owner_of(const LineOrigin& origin) const {
        if (origin.node.empty() && origin.file.empty()) return std::nullopt;
        const std::size_t slash = origin.node.find('/');
        // Nodes of a sub-graph are in a file of their own.
        const bool is_own = origin.file == graph_ || slash != std::string::npos;
        if (is_own && origin.node.empty()) return kSurface;
        const auto found = is_own ? index_.find(origin.node.substr(0, slash)) : index_.end();
        return found == index_.end() ? kLighting : kFirstNode + found->second;
    }

private:
    std::string graph_{};
    std::map<std::string, std::uint32_t, std::less<>> index_{};
};

// By line of the text. A line without an entry belongs to the one before it.
std::vector<LineOwner> owners_of(const Shader& shader, const Nodes& nodes) {
    std::vector<LineOwner> lines(static_cast<std::size_t>(std::ranges::count(shader.text, '\n')) + 2);
    for (std::size_t i = 0; i < shader.line_map.size(); ++i) {
        const auto begin = static_cast<std::size_t>(shader.line_map[i].line);
        const bool is_last = i + 1 == shader.line_map.size();
        const std::size_t end = is_last ? lines.size() : static_cast<std::size_t>(shader.line_map[i + 1].line);
        const std::optional<std::uint32_t> owner = nodes.owner_of(shader.line_map[i]);
        for (std::size_t line = begin; line < std::min(end, lines.size()); ++line) lines[line].owner = owner;
    }
    for (const int line : shader.light_loops)
        if (static_cast<std::size_t>(line) < lines.size()) lines[static_cast<std::size_t>(line)].is_light_loop = true;
    return lines;
}

MeasuredStage measure(const Shader& shader, const Result& compiled, const Nodes& nodes) {
    const std::vector<std::uint32_t> spirv = spirv_with_lines(shader);
    if (spirv.empty() || too_large(shader, spirv)) return {};
    const std::size_t owners = kFirstNode + compiled.nodes.size();
    const SpirvCounts counts = count(optimised(with_owners(spirv, owners_of(shader, nodes))), shader.stage, owners);
    MeasuredStage made{.ok = true, .cost = counts.total};
    const auto add = [&](Part part, std::string node, std::size_t owner) {
        const SpirvCounts::Share& share = counts.shares[owner];
        made.shares.push_back(
            {.part = part, .node = std::move(node), .once = share.once, .per_light = share.per_light});
    };
    for (std::size_t i = 0; i < compiled.nodes.size(); ++i) add(Part::Node, compiled.nodes[i], kFirstNode + i);
    add(Part::Surface, {}, kSurface);
    add(Part::Lighting, {}, kLighting);
    add(Part::Pass, {}, kPass);
    return made;
}

std::uint32_t uniform_bytes(const Reflection& reflection, const Pass& pass) {
    std::uint32_t bytes = 0;
    for (const Block& block : reflection.blocks)
        if (block.is_material && std::ranges::find(pass.blocks, block.name) != pass.blocks.end()) bytes += block.size;
    return bytes;
}

void check(const MeasuredPass& pass, Stage stage, std::uint32_t figure, std::string_view what,
           const std::optional<Budget::Limit>& limit, std::vector<Diagnostic>& diagnostics) {
    if (!limit || figure <= limit->most) return;
    Diagnostic made = complaint(
        Complaint::OverCost, {to_string(stage), pass.name, what, std::to_string(figure), std::to_string(limit->most)});
    const FileLocation& place = limit->place;
    if (!place.file.empty()) made = diagnostic_at(place, made.code, made.message);
    diagnostics.push_back(std::move(made));
}

}  // namespace

std::vector<MeasuredPass> measure(const Result& compiled) {
    const auto is_of = [&](std::string_view language) {
        return [language](const Shader& shader) {
            return shader.has_main && shader.target.engine.empty() && shader.target.language == language;
        };
    };
    const bool has_glsl = std::ranges::any_of(compiled.shaders, is_of("glsl"));
    const auto is_measured = is_of(has_glsl ? "glsl" : "hlsl");
    const Nodes nodes(compiled);
    std::vector<MeasuredPass> made;
    for (const Pass& pass : compiled.reflection.passes) {
        MeasuredPass measured{.name = pass.name};
        bool is_there = false;
        for (const Shader& shader : compiled.shaders) {
            if (shader.pass != pass.name || !is_measured(shader)) continue;
            is_there = true;
            (shader.stage == Stage::Vertex ? measured.vertex : measured.fragment) = measure(shader, compiled, nodes);
        }
        if (!is_there) continue;
        measured.cost = {.vertex = measured.vertex.cost,
                         .fragment = measured.fragment.cost,
                         .uniform_bytes = uniform_bytes(compiled.reflection, pass)};
        made.push_back(std::move(measured));
    }
    return made;
}

std::vector<Diagnostic> refusals(const Result& compiled, std::span<const MeasuredPass> passes) {
    std::vector<Diagnostic> made;
    if (std::ranges::all_of(passes, [](const MeasuredPass& pass) { return pass.vertex.ok && pass.fragment.ok; }))
        return made;
    for (const Shader& shader : compiled.shaders) {
        Validated validated = validate(shader);
        std::ranges::move(validated.diagnostics, std::back_inserter(made));
        if (!validated.ok || !shader.has_main) continue;
        if (std::optional<Diagnostic> why = too_large(shader, validated.spirv)) made.push_back(std::move(*why));
    }
    return made;
}

StageCost measure(const Shader& shader) {
    const Result nothing;
    return measure(shader, nothing, Nodes(nothing)).cost;
}

std::vector<Diagnostic> over_budget(std::span<const MeasuredPass> passes, const Budget& budget) {
    std::vector<Diagnostic> diagnostics;
    for (const MeasuredPass& pass : passes) {
        for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
            const CostCounts cost = (stage == Stage::Vertex ? pass.cost.vertex : pass.cost.fragment).total();
            check(pass, stage, cost.instructions, "instructions", budget.instructions, diagnostics);
            check(pass, stage, cost.textures, "texture reads", budget.textures, diagnostics);
        }
    }
    return diagnostics;
}

}  // namespace patina

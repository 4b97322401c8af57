// Measures what shaders cost. A node's share is what is left, after `spirv-opt -O`, of the lines that come from it: the
// line map says which lines these are, and OpLine which instructions.
#include "patina/cost.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "compiler/validate/count.h"
#include "compiler/validate/expand_calls.h"
#include "compiler/validate/numbers.h"
#include "patina/validate.h"

namespace patina {
namespace {

// The place in the graph that owns an instruction: that of its line or, if this is a line of the library, that of the
// line that calls it. Null: the rendering path owns it.
const LineOrigin* owner_of(const Shader& shader, const spirv::Instruction& at) {
    const LineOrigin* origin = origin_of(shader, int(at.line));
    return origin ? origin : origin_of(shader, int(at.call_line));
}

// What the graph says at a place.
std::string source_at(const LineOrigin& origin) {
    const std::size_t begin = std::size_t(std::max(origin.source_column - 1, 0));
    if (begin >= origin.source_text.size()) return {};
    const std::size_t end = std::size_t(std::max(origin.source_end_column - 1, 0));
    return origin.source_text.substr(begin, end > begin ? end - begin : origin.source_text.npos);
}

// The nodes of a stage, by where they stand.
class Shares {
public:
    explicit Shares(const Shader& shader) : shader_(shader) {}

    void add(const spirv::Instruction& at, bool per_light) {
        NodeCost& node = share_of(owner_of(shader_, at));
        spirv::add(per_light ? node.per_light : node.once, at);
    }

    std::vector<NodeCost> take() {
        std::vector<NodeCost> made;
        for (auto& [key, node] : nodes_)
            if (node.total() > 0) made.push_back(std::move(node));
        std::ranges::stable_sort(made, std::ranges::greater(), &NodeCost::total);
        return made;
    }

private:
    NodeCost& share_of(const LineOrigin* owner) {
        if (!owner) return nodes_[{}];
        const bool is_node = !owner->node.empty();
        NodeCost& node =
            nodes_[{owner->file, owner->node, is_node ? 0 : owner->source_line, is_node ? 0 : owner->source_column}];
        if (node.file.empty())
            node = {.node = owner->node,
                    .source = is_node ? "" : source_at(*owner),
                    .file = owner->file,
                    .line = owner->source_line};
        return node;
    }

    const Shader& shader_;
    std::map<std::tuple<std::string, std::string, int, int>, NodeCost> nodes_;
};

std::uint32_t material_bytes(const Reflection& reflection, const Pass& pass) {
    std::uint32_t bytes = 0;
    for (const Block& block : reflection.blocks)
        if (block.is_material && std::ranges::find(pass.blocks, block.name) != pass.blocks.end()) bytes += block.size;
    return bytes;
}

}  // namespace

Instructions& Instructions::operator+=(const Instructions& more) {
    arithmetic += more.arithmetic;
    transcendental += more.transcendental;
    texture += more.texture;
    derivative += more.derivative;
    other += more.other;
    return *this;
}

std::optional<StageCost> measure_cost(const Shader& shader, std::vector<Diagnostic>& diagnostics) {
    const Validated validated = validate(shader, HlslSamplers::Separate, true);
    diagnostics.insert(diagnostics.end(), validated.diagnostics.begin(), validated.diagnostics.end());
    if (!validated.ok) return std::nullopt;
    const auto is_owner = [&](std::uint32_t line) { return origin_of(shader, int(line)) != nullptr; };
    const spirv::Spirv module = spirv::parse(optimised(spirv::expand_calls(spirv::parse(validated.spirv), is_owner)));
    const bool is_vertex = shader.stage == Stage::Vertex;
    StageCost cost{
        .varyings = spirv::interface_numbers(module, is_vertex ? spv::StorageClassOutput : spv::StorageClassInput),
        .registers = spirv::live_numbers(module)};
    Shares shares(shader);
    // The loops of a rendering path are over lights; those of nodes are not.
    const auto is_light_loop = [&](const spirv::Instruction& loop) { return owner_of(shader, loop) == nullptr; };
    spirv::for_each_run(module, is_light_loop, [&](const spirv::Instruction& at, bool per_light) {
        spirv::add(per_light ? cost.per_light : cost.once, at);
        shares.add(at, per_light);
    });
    cost.nodes = shares.take();
    return cost;
}

MaterialCost measure_cost(const Result& compiled) {
    MaterialCost measured{.ok = compiled.ok};
    for (const Pass& pass : compiled.reflection.passes) {
        PassCost& cost = measured.passes.emplace_back();
        cost.name = pass.name;
        cost.textures = std::uint32_t(pass.textures.size());
        cost.uniform_bytes = material_bytes(compiled.reflection, pass);
        for (const Shader& shader : compiled.shaders) {
            if (shader.pass != pass.name || shader.target != Target::Glsl) continue;
            std::optional<StageCost> stage = measure_cost(shader, measured.diagnostics);
            measured.ok &= stage.has_value();
            if (stage) (shader.stage == Stage::Vertex ? cost.vertex : cost.fragment) = std::move(*stage);
        }
    }
    return measured;
}

}  // namespace patina

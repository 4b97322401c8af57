#include "compiler/lower/place.h"

#include <algorithm>

namespace patina::graph {
namespace {

bool is_texture(const ir::Global& global) {
    return global.type.kind == ir::Kind::Texture2D || global.type.kind == ir::Kind::TextureCube;
}

bool is_sampler(const ir::Global& global) {
    return global.type.kind == ir::Kind::Sampler;
}

}  // namespace

std::vector<SetShifts> place_globals(ir::Module& module, const engines::Engine& engine) {
    std::vector<SetShifts> shifts;
    for (const ir::Group group : {ir::Group::Engine, ir::Group::Material, ir::Group::Targets}) {
        const engines::Places& places = engine.places_of(group);
        const auto count = [&](const auto& all, const auto& is_kind) {
            return static_cast<std::uint32_t>(std::count_if(
                all.begin(), all.end(), [&](const auto& each) { return each.group == group && is_kind(each); }));
        };
        const std::uint32_t blocks = count(module.blocks, [](const ir::UniformBlock&) { return true; });
        SetShifts first{.set = places.set, .buffers = places.buffers.value_or(0)};
        first.textures = places.textures.value_or(first.buffers + blocks);
        first.samplers = places.samplers.value_or(first.textures + count(module.globals, is_texture));
        // Owners that share a set share its registers, so these have one distance from the bindings.
        auto shift =
            std::find_if(shifts.begin(), shifts.end(), [&](const SetShifts& each) { return each.set == places.set; });
        if (shift == shifts.end()) shift = shifts.insert(shift, first);
        const auto place = [&](std::uint32_t binding, std::uint32_t distance) {
            return ir::Place{.set = places.set, .binding = binding, .slot = binding - distance};
        };
        for (ir::UniformBlock& block : module.blocks) {
            if (block.group != group) continue;
            block.place = place(first.buffers++, shift->buffers);
            block.matrices_by_rows = engine.matrices == MatrixOrder::Rows;
        }
        for (ir::Global& global : module.globals) {
            if (global.group != group || global.in_block()) continue;
            if (is_texture(global)) global.place = place(first.textures++, shift->textures);
            if (is_sampler(global)) global.place = place(first.samplers++, shift->samplers);
        }
    }
    return shifts;
}

}  // namespace patina::graph

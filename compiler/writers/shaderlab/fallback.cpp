// Unity takes passes that a shader lacks from its fallback. Only surfaces that cast shadows have one.
#include <algorithm>
#include <array>

#include "compiler/writers/shaderlab/shader_file.h"

namespace patina::writers::shaderlab {
namespace {

std::string_view fallback_of(SurfaceKind kind) {
    switch (kind) {
        case SurfaceKind::Opaque: return "\"VertexLit\"";
        case SurfaceKind::Cutout: return "\"Legacy Shaders/Transparent/Cutout/VertexLit\"";
        case SurfaceKind::Fade:
        case SurfaceKind::Transparent:
        case SurfaceKind::Additive:
        case SurfaceKind::Multiply: break;
    }
    return "Off";
}

bool is_caster(const lower::LoweredPass& pass) {
    return pass.declaration->state.targets.empty();
}

bool discards(const ir::Module& stage) {
    return std::any_of(stage.functions.begin(), stage.functions.end(), [](const ir::Function& function) {
        return std::any_of(function.insts.begin(), function.insts.end(),
                           [](const ir::Inst& inst) { return inst.op == ir::Op::DiscardIf; });
    });
}

}  // namespace

bool is_in_fallback(const LinkedPass& pass) {
    const auto& render = pass.material->graph->graph->render;
    const bool moves = !pass.vertex.stage.outputs.empty();  // VertexLit computes the position by the same macro
    const bool is_offset = render.depth_offset && *render.depth_offset != std::array{0.0, 0.0};
    return is_caster(*pass.pass) && render.surface == SurfaceKind::Opaque && render.cull == Cull::Back && !is_offset &&
           !moves && !discards(pass.fragment) && !render.is_overridable;
}

std::string_view fallback_word(const resolve::Material& material, const lower::Lowered& lowered,
                               std::span<const LinkedPass> passes) {
    const bool has_caster =
        std::any_of(passes.begin(), passes.end(), [](const LinkedPass& pass) { return is_caster(*pass.pass); });
    // A pass that the file lacks was refused, or the fallback has it.
    const bool is_left_out = std::any_of(lowered.passes.begin(), lowered.passes.end(), is_caster) && !has_caster;
    const SurfaceKind kind = material.graph->graph->render.surface;
    return has_caster || (is_left_out && kind == SurfaceKind::Opaque) ? fallback_of(kind) : "Off";
}

}  // namespace patina::writers::shaderlab

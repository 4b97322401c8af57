// Decides when the passes of a ShaderLab file are drawn. Unity has one queue for all of them, and draws them in the
// order of the file.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "compiler/writers/shaderlab/shader_file.h"
#include "compiler/writers/shaderlab/share_vertex.h"

namespace patina::writers::shaderlab {
namespace {

constexpr int kLastOpaque = 2500;  // up to this queue Unity draws from near to far, and before the sky

int number(std::string_view digits) {
    int value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

// The lowest queue in which everything that a stage reads is available.
int least_queue(const ir::Module& stage) {
    int least = 0;
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op != ir::Op::Call) continue;
            for (const ir::StageText& text : stage.functions[inst.data].texts) {
                if (text.place == "queue") least = std::max(least, number(text.line));
            }
        }
    }
    return least;
}

bool is_kept_by_depth(const Pass& pass) {
    return pass.depth_test == Compare::Less || pass.depth_test == Compare::LessEqual ||
           pass.depth_test == Compare::Equal;
}

// True if the depth test alone decides what is visible of the pass, whenever it is drawn.
bool is_solid(const Pass& pass) {
    const bool blends = !pass.targets.empty() && pass.targets.front().blend.is_on();
    return !blends && pass.depth_write && is_kept_by_depth(pass) && !pass.stencil.is_used();
}

// True if the pass covers only pixels in which the material itself has written depth.
bool is_within(const resolve::Material& pass, const resolve::Material& material) {
    const format::Graph &added = *pass.graph->graph, &own = *material.graph->graph;
    const auto is_same = [](const format::PortValue& a, const format::PortValue& b) {
        return a.name == b.name && a.value_span.begin == b.value_span.begin;
    };
    return own.render.surface == SurfaceKind::Opaque && !own.render.stencil &&
           (own.render.cull == Cull::Off || own.render.cull == added.render.cull) &&
           std::equal(own.vertex.begin(), own.vertex.end(), added.vertex.begin(), added.vertex.end(), is_same);
}

std::string what_differs(int queue, int shader) {
    if (shader <= kLastOpaque && queue > kLastOpaque)
        return "the sky and later opaque objects are drawn over it where no depth hides them";
    if (queue <= kLastOpaque && shader > kLastOpaque) return "opaque objects and the sky are drawn before it";
    return fmt::format("objects with a queue in between are drawn {} it", queue < shader ? "before" : "after");
}

}  // namespace

void order_passes(std::vector<LinkedPass>& passes) {
    const auto queue = [](const LinkedPass& pass) { return output::queue_of(pass.material->graph->graph->render); };
    std::stable_sort(passes.begin(), passes.end(),
                     [&](const LinkedPass& a, const LinkedPass& b) { return queue(a) < queue(b); });
    share_vertex_stages(passes);
}

int shader_queue(const resolve::Material& material, std::span<const LinkedPass> passes) {
    int queue = output::queue_of(material.graph->graph->render);
    for (const LinkedPass& pass : passes)
        queue = std::max({queue, least_queue(pass.vertex), least_queue(pass.fragment)});
    return queue;
}

void check_queues(const resolve::Material& material, std::span<const LinkedPass> passes, const Reflection& reflection,
                  Diagnostics& diagnostics) {
    const int shader = shader_queue(material, passes);
    const bool fills_depth =
        shader <= kLastOpaque && std::any_of(reflection.passes.begin(), reflection.passes.end(),
                                             [](const Pass& pass) { return !pass.is_extra && is_solid(pass); });
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const Pass& pass = reflection.passes[i];
        const bool crosses = (pass.queue <= kLastOpaque) != (shader <= kLastOpaque);
        if (!pass.is_extra || pass.queue == shader || (is_solid(pass) && !crosses)) continue;
        if (fills_depth && pass.queue > shader && is_kept_by_depth(pass) && is_within(*passes[i].material, material))
            continue;
        diagnostics
            .report(Code::QueueLimit, passes[i].material->pass->name_span, pass.name, shader, pass.queue,
                    what_differs(pass.queue, shader))
            .note(
                "Unity has one queue for all passes of a shader: to use another queue, draw the mesh with a second "
                "material");
    }
}

}  // namespace patina::writers::shaderlab

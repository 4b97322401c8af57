#include "runtime/cpu/cpu_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/cpu/fixed_state.h"
#include "runtime/frame/frame_check.h"
#include "runtime/frame/tiles.h"
#include "runtime/jobs/shares.h"

namespace patina::runtime {
namespace {

Interpreter& bound_stage(const CpuStep& step, std::optional<Interpreter>& place, Stage stage) {
    if (!place) place.emplace(*step.step->stages.program, step.step->pass->name, stage, step.precision);
    for (const BlockBytes& block : step.step->blocks) place->set_block(block.name, block.bytes);
    for (const ConstantValue& constant : step.step->constants)
        place->set_value(constant.name, std::array{double(constant.value)});
    for (const LoadedTexture& texture : step.textures) place->set_texture(texture.name, texture.data);
    for (const BoundSampler& sampler : step.step->reflection->samplers)
        place->set_sampler(sampler.identifier, step.step->state_of(sampler));
    return *place;
}

// --- before the pixels

// What Vulkan adds to the depth of each of the triangle's pixels: `depthBias` times the smallest difference of depths
// near the largest depth of the corners, plus `depth_slope_bias` times the change of depth from pixel to pixel. For
// 32-bit floats the smallest difference is 2^(exponent - 23).
double depth_offset(const Pass& pass, const ScreenTriangle& triangle) {
    if (pass.depth_bias == 0 && pass.depth_slope_bias == 0) return 0;
    std::array<double, 3> z{};
    for (int i = 0; i < 3; i++) z[i] = triangle.corners[i].position.z / triangle.corners[i].position.w;
    const auto largest = float(std::max({z[0], z[1], z[2]}));
    const double least_difference = largest > 0 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0;

    const glm::dvec2 a = triangle.exact[1] - triangle.exact[0], b = triangle.exact[2] - triangle.exact[0];
    const double dx = ((z[1] - z[0]) * b.y - (z[2] - z[0]) * a.y) / triangle.area,
                 dy = ((z[2] - z[0]) * a.x - (z[1] - z[0]) * b.x) / triangle.area;
    return least_difference * pass.depth_bias + std::max(std::abs(dx), std::abs(dy)) * pass.depth_slope_bias;
}

bool is_drawn(const ScreenTriangle& triangle, Cull cull) {
    return cull != (triangle.is_front ? Cull::Front : Cull::Back);
}

std::vector<CpuTriangle> visible_triangles(const FrameStep& step, const PixelArea& area,
                                           const std::vector<ClipVertex>& vertices, std::uint32_t instance) {
    std::vector<CpuTriangle> visible;
    const std::vector<std::uint32_t>& indices = step.mesh->indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) -> const ClipVertex& { return vertices[indices[i + k]]; };
        for (ScreenTriangle& t :
             clip_to_screen(corner(0), corner(1), corner(2), area.width, area.height, {area.x, area.y})) {
            if (!is_drawn(t, step.pass->cull)) continue;
            const double offset = depth_offset(*step.pass, t);
            visible.push_back({.screen = std::move(t), .index = i / 3, .instance = instance, .depth_offset = offset});
        }
    }
    return visible;
}

PixelBounds intersection(const PixelArea& area, const PixelBounds& window) {
    return {.left = std::max(area.x, window.left),
            .top = std::max(area.y, window.top),
            .right = std::min(area.x + area.width, window.right),
            .bottom = std::min(area.y + area.height, window.bottom)};
}

// --- pixels

// The result of a sample's depth and stencil tests, and the new stencil value.
struct Tested {
    bool is_visible = true;
    std::optional<StencilOp> stencil{};  // nothing: there is no stencil
};

Tested test_sample(const CpuStep& step, int x, int y, double depth) {
    if (!step.depth) return {};
    const Pass& pass = *step.step->pass;
    const auto seen = [&](std::uint8_t value) { return float(value & pass.stencil.read_mask); };
    if (!holds(pass.stencil.test, seen(step.step->stencil_reference),
               seen(step.depth->stencil[step.depth->index(x, y)])))
        return {.is_visible = false, .stencil = pass.stencil.fail};
    if (!holds(pass.depth_test, float(depth), step.depth->load(x, y).x))
        return {.is_visible = false, .stencil = pass.stencil.depth_fail};
    return {.stencil = pass.stencil.pass};
}

void change_stencil(const CpuStep& step, StencilOp op, int x, int y) {
    std::uint8_t& there = step.depth->stencil[step.depth->index(x, y)];
    const int wanted = changed(op, there, step.step->stencil_reference), mask = step.step->pass->stencil.write_mask;
    there = std::uint8_t((wanted & mask) | (there & ~mask));
}

void write_color(CpuTarget& target, const Blend& blend, int x, int y, glm::vec4 source) {
    if (!blend.is_on()) return target.store(x, y, source);
    if (target.format->is_normalized) source = glm::clamp(source, 0.0f, 1.0f);
    target.store(x, y, blended(blend, source, target.load(x, y)));
}

// `outputs`: of the fragment stage, one after the other, each for the target of its number.
void write_pixel(const CpuStep& step, const std::vector<StageValue>& outputs, int x, int y, double depth,
                 const std::vector<double>& numbers) {
    std::size_t at = 0;
    for (std::size_t i = 0; i < step.colors.size(); i++) {
        glm::vec4 source(0, 0, 0, 1);
        for (unsigned c = 0; c < std::min(outputs[i].components, 4u); c++) source[int(c)] = float(numbers[at + c]);
        at += outputs[i].components;
        write_color(*step.colors[i], step.step->pass->targets[i].blend, x, y, source);
    }
    if (!step.depth) return;
    if (step.step->pass->depth_write) step.depth->store(x, y, glm::vec4(float(depth)));
}

void shade_quad(const CpuStep& step, Interpreter& fragment, const CpuTriangle& triangle, const Quad& quad,
                QuadInputs& inputs) {
    if (step.is_over_budget->load(std::memory_order_relaxed)) return;
    // The stage never writes depth, so testing before it gives the same picture as testing after it.
    std::array<Tested, 4> tested{};
    bool is_needed = false;
    for (int lane = 0; lane < 4; lane++) {
        if (quad.covered[lane])
            tested[lane] = test_sample(step, quad.x + lane % 2, quad.y + lane / 2, quad.depth[lane]);
        const bool marks = tested[lane].stencil.value_or(StencilOp::Keep) != StencilOp::Keep;
        is_needed |= quad.covered[lane] && (tested[lane].is_visible || marks || step.on_fragment);
    }
    if (!is_needed) return;

    gather_inputs(step.sources, triangle.screen, quad, step.precision, inputs, step.origin);
    const QuadOutputs outputs = fragment.run(inputs);
    if (outputs.is_over_budget) return step.is_over_budget->store(true);
    for (int lane = 0; lane < 4; lane++) {
        if (!quad.covered[lane]) continue;
        const int x = quad.x + lane % 2, y = quad.y + lane / 2;
        const bool is_discarded = outputs.discarded[lane], is_visible = tested[lane].is_visible;
        if (step.on_fragment)
            step.on_fragment({.triangle = &triangle,
                              .quad = quad,
                              .lane = lane,
                              .is_discarded = is_discarded,
                              .is_hidden = !is_visible});
        if (is_discarded) continue;
        if (tested[lane].stencil) change_stencil(step, *tested[lane].stencil, x, y);
        if (is_visible) write_pixel(step, fragment.outputs(), x, y, quad.depth[lane], outputs.lanes[lane]);
    }
}

}  // namespace

Interpreter& fragment_stage(const CpuStep& step, CpuStages& stages, std::size_t thread) {
    return bound_stage(step, stages.fragments[thread], Stage::Fragment);
}

Interpreter& vertex_stage(const CpuStep& step, CpuStages& stages) {
    return bound_stage(step, stages.vertex, Stage::Vertex);
}

Outcome<CpuStep> make_cpu_step(const Frame& frame, const FrameStep& step, std::vector<CpuTarget>& targets,
                               CpuStages& stages, Precision precision) {
    const Pass& pass = *step.pass;
    if (!step.stages.program) return Failure{"the material was compiled without its program"};
    const PixelArea area = full_area(step, frame);
    const PixelBounds& window = targets[attachments(step).front()].window;
    CpuStep made{.step = &step, .precision = precision, .bounds = intersection(area, window)};
    if (frame.tile != 0 && is_of_picture(frame, step)) made.origin = {window.left, window.top};
    for (std::size_t target : step.targets) made.colors.push_back(&targets[target]);
    if (step.depth >= 0) made.depth = &targets[std::size_t(step.depth)];
    if (step.clears_stencil && made.depth) std::fill(made.depth->stencil.begin(), made.depth->stencil.end(), 0);
    made.textures.assign(step.textures.begin(), step.textures.end());
    for (const FrameRead& read : step.reads)  // after the loaded ones: the last of a name counts
        made.textures.push_back({.name = read.texture, .data = texture_of(targets[read.target])});

    Interpreter& vertex = vertex_stage(made, stages);
    const Interpreter& fragment = fragment_stage(made, stages, 0);
    const std::size_t written = fragment.outputs().size(), wanted = pass.targets.size();
    if (vertex.outputs().empty() || (written == 0 && wanted > 0))
        return Failure{fmt::format("the program has no stages for the pass '{}'", pass.name)};
    if (written < wanted)
        return Failure{
            fmt::format("the fragment stage of the pass '{}' writes {} of its {} targets", pass.name, written, wanted)};
    Outcome<std::vector<InputSource>> sources = fragment_sources(vertex, fragment);
    if (!sources) return Failure{sources.error};
    made.sources = std::move(sources.value);
    for (std::uint32_t instance = 0; instance < step.instances; instance++) {
        Outcome<std::vector<ClipVertex>> vertices = run_vertices(vertex, *step.mesh, instance);
        if (!vertices) return Failure{vertices.error};
        if (step.clip_depth() == ClipDepth::Symmetric)
            for (ClipVertex& v : vertices.value) v.position.z = (v.position.z + v.position.w) / 2;
        for (CpuTriangle& triangle : visible_triangles(step, area, vertices.value, instance))
            made.triangles.push_back(std::move(triangle));
    }
    return made;
}

void shade_rows(const CpuStep& step, Interpreter& fragment, int first_row, int row_step) {
    QuadInputs inputs;
    for (std::size_t i = 0; i < step.triangles.size(); i++) {
        const CpuTriangle& triangle = step.triangles[i];
        if (first_row == 0 && i % 64 == 0 && step.progress) step.progress(double(i) / double(step.triangles.size()));
        for_each_quad(triangle.screen, step.bounds, first_row, row_step, [&](const Quad& quad) {
            if (triangle.depth_offset == 0) return shade_quad(step, fragment, triangle, quad, inputs);
            Quad moved = quad;
            for (double& depth : moved.depth) depth = std::clamp(depth + triangle.depth_offset, 0.0, 1.0);
            shade_quad(step, fragment, triangle, moved, inputs);
        });
    }
}

CpuStages stages_for(int threads) {
    return {.vertex = {}, .fragments = std::vector<std::optional<Interpreter>>(std::size_t(threads))};
}

// Rows of quads are dealt out in turn.
void shade(const CpuStep& step, CpuStages& stages) {
    const int threads = int(stages.fragments.size());
    const auto share = [&](int i) { shade_rows(step, fragment_stage(step, stages, std::size_t(i)), i, threads); };
    on_threads(threads, share);
}

std::string shade_error(const CpuStep& step) {
    if (!step.is_over_budget->load()) return {};
    return fmt::format(
        "the fragment stage of the pass '{}' takes more than {} steps for four pixels: the CPU does not "
        "draw it",
        step.step->pass->name, Interpreter::kMostSteps);
}

}  // namespace patina::runtime

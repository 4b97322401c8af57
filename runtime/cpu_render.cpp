#include "runtime/cpu_render.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <thread>

#include "runtime/raster.h"
#include "runtime/vertex_inputs.h"

namespace patina::runtime {
namespace {

using DepthTest = bool (*)(float, float);

struct DepthWord {
    std::string_view word;
    DepthTest test;
};
constexpr DepthWord kDepthTests[] = {
    {"never", [](float, float) { return false; }},
    {"less", [](float a, float b) { return a < b; }},
    {"equal", [](float a, float b) { return a == b; }},
    {"lessEqual", [](float a, float b) { return a <= b; }},
    {"greater", [](float a, float b) { return a > b; }},
    {"notEqual", [](float a, float b) { return a != b; }},
    {"greaterEqual", [](float a, float b) { return a >= b; }},
    {"always", [](float, float) { return true; }},
};

// A blend factor as base + slope * source alpha.
struct BlendWord {
    std::string_view word;
    float base, slope;
};
constexpr BlendWord kBlendFactors[] = {
    {"one", 1, 0}, {"zero", 0, 0}, {"src_alpha", 0, 1}, {"one_minus_src_alpha", 1, -1}};

// The pass's words for state, looked up.
struct State {
    DepthTest depth_test = nullptr;
    bool depth_write = true;
    bool draws_front = true, draws_back = false;
    BlendWord source = kBlendFactors[0], destination = kBlendFactors[1];
};

template <class Table>
auto* find_word(const Table& table, std::string_view word) {
    auto found =
        std::find_if(std::begin(table), std::end(table), [&](const auto& entry) { return entry.word == word; });
    return found == std::end(table) ? nullptr : found;
}

Outcome<State> pass_state(const Pass& pass) {
    const DepthWord* depth = find_word(kDepthTests, pass.depth_test);
    if (!depth) return Failure{"'" + pass.depth_test + "' is not a depth test"};
    const RenderTarget& target = pass.targets.front();
    const BlendWord* source = find_word(kBlendFactors, target.blend_source);
    if (!source) return Failure{"'" + target.blend_source + "' is not a blend factor"};
    const BlendWord* destination = find_word(kBlendFactors, target.blend_destination);
    if (!destination) return Failure{"'" + target.blend_destination + "' is not a blend factor"};
    if (pass.cull != "back" && pass.cull != "front" && pass.cull != "off")
        return Failure{"'" + pass.cull + "' is not a way to cull"};
    return State{.depth_test = depth->test,
                 .depth_write = pass.depth_write,
                 .draws_front = pass.cull != "front",
                 .draws_back = pass.cull != "back",
                 .source = *source,
                 .destination = *destination};
}

Interpreter make_interpreter(const Draw& draw, Stage stage, Precision precision) {
    Interpreter interpreter(*draw.program, draw.pass, stage, precision);
    for (const BlockBytes& block : draw.blocks) interpreter.set_block(block.name, block.bytes);
    for (const LoadedTexture& texture : draw.textures) interpreter.set_texture(texture.name, texture.data);
    return interpreter;
}

// --- the vertex stage

// The numbers that a vertex has for an input, filled up to its width as Vulkan fills a missing y, z and w: 0, 0, 1.
void append_attribute(const Vertex& vertex, const VertexSource& source, unsigned components, std::vector<double>& out) {
    float numbers[4] = {0, 0, 0, 1};
    std::memcpy(numbers, reinterpret_cast<const char*>(&vertex) + source.offset, source.components * sizeof(float));
    out.insert(out.end(), numbers, numbers + std::min(components, 4u));
}

Outcome<std::vector<ClipVertex>> run_vertices(Interpreter& stage, const Mesh& mesh) {
    std::vector<const VertexSource*> sources;
    for (const StageValue& input : stage.inputs()) {
        sources.push_back(vertex_source(input.name));
        if (!sources.back()) return Failure{"the preview meshes have no vertex input '" + input.name + "'"};
    }
    std::vector<ClipVertex> result;
    for (std::size_t first = 0; first < mesh.vertices.size(); first += 4) {
        std::size_t count = std::min<std::size_t>(4, mesh.vertices.size() - first);
        QuadInputs quad;
        for (std::size_t lane = 0; lane < 4; lane++) {
            const Vertex& vertex = mesh.vertices[first + std::min(lane, count - 1)];
            for (std::size_t i = 0; i < sources.size(); i++)
                append_attribute(vertex, *sources[i], stage.inputs()[i].components, quad.lanes[lane]);
        }
        QuadOutputs outputs = stage.run(quad);
        for (std::size_t lane = 0; lane < count; lane++) {
            ClipVertex vertex;
            std::size_t at = 0;
            for (const StageValue& output : stage.outputs()) {
                const double* numbers = outputs.lanes[lane].data() + at;
                if (output.is_builtin && output.name == "position")
                    vertex.position = {numbers[0], numbers[1], numbers[2], numbers[3]};
                else
                    vertex.varyings.insert(vertex.varyings.end(), numbers, numbers + output.components);
                at += output.components;
            }
            result.push_back(std::move(vertex));
        }
    }
    return result;
}

// --- the fragment stage

// Where each fragment input comes from.
struct InputSource {
    enum class Kind { Varying, FrontFacing, FragCoord } kind = Kind::Varying;
    std::size_t offset = 0;  // in ClipVertex::varyings
    unsigned components = 1;
};

Outcome<std::vector<InputSource>> fragment_sources(const Interpreter& vertex, const Interpreter& fragment) {
    std::vector<InputSource> result;
    for (const StageValue& input : fragment.inputs()) {
        InputSource source{.components = input.components};
        if (input.is_builtin) {
            if (input.name == "front_facing")
                source.kind = InputSource::Kind::FrontFacing;
            else if (input.name == "frag_coord")
                source.kind = InputSource::Kind::FragCoord;
            else
                return Failure{"the CPU renderer has no '" + input.name + "'"};
            result.push_back(source);
            continue;
        }
        bool found = false;
        for (const StageValue& output : vertex.outputs()) {
            if (output.is_builtin) continue;
            if ((found = output.name == input.name)) break;
            source.offset += output.components;
        }
        if (!found)
            return Failure{"the fragment stage reads '" + input.name + "', and the vertex stage writes no such value"};
        result.push_back(source);
    }
    return result;
}

struct Canvas {
    Image color;
    std::vector<float> depth;
};

// Everything that the threads share and only read, and the canvas, in which each has rows of its own.
struct Job {
    const Draw* draw = nullptr;
    State state{};
    Precision precision = Precision::Float;
    std::vector<InputSource> sources{};
    std::vector<ScreenTriangle> triangles{};
    Canvas* canvas = nullptr;
};

void gather_inputs(const Job& job, const ScreenTriangle& triangle, const Quad& quad, QuadInputs& inputs) {
    for (int lane = 0; lane < 4; lane++) {
        std::vector<double>& out = inputs.lanes[lane];
        out.clear();
        for (const InputSource& source : job.sources) {
            switch (source.kind) {
                case InputSource::Kind::FrontFacing: out.push_back(triangle.is_front ? 1 : 0); break;
                case InputSource::Kind::FragCoord: {
                    double coord[4] = {quad.x + lane % 2 + 0.5, quad.y + lane / 2 + 0.5, quad.depth[lane],
                                       quad.inverse_w[lane]};
                    out.insert(out.end(), coord, coord + std::min(source.components, 4u));
                    break;
                }
                case InputSource::Kind::Varying:
                    for (unsigned c = 0; c < source.components; c++) {
                        double value = 0;
                        for (int corner = 0; corner < 3; corner++)
                            value += quad.weights[lane][corner] * triangle.corners[corner].varyings[source.offset + c];
                        out.push_back(job.precision == Precision::Float ? double(float(value)) : value);
                    }
                    break;
            }
        }
    }
}

void write_pixel(const State& state, std::span<float> pixel, const std::vector<double>& outputs) {
    std::array<float, 4> source = {0, 0, 0, 1};
    for (std::size_t c = 0; c < std::min<std::size_t>(4, outputs.size()); c++) source[c] = float(outputs[c]);
    float from = state.source.base + state.source.slope * source[3];
    float keep = state.destination.base + state.destination.slope * source[3];
    // A factor of 0 drops its side even where that is NaN, as a GPU does with blending off.
    for (int c = 0; c < 4; c++) pixel[c] = (from == 0 ? 0 : source[c] * from) + (keep == 0 ? 0 : pixel[c] * keep);
}

void shade_rows(const Job& job, int first_row, int row_step) {
    Interpreter fragment = make_interpreter(*job.draw, Stage::Fragment, job.precision);
    Canvas& canvas = *job.canvas;
    int width = canvas.color.width, height = canvas.color.height;
    QuadInputs inputs;
    for (std::size_t i = 0; i < job.triangles.size(); i++) {
        const ScreenTriangle& triangle = job.triangles[i];
        if (first_row == 0 && i % 64 == 0 && job.draw->progress)
            job.draw->progress(double(i) / double(job.triangles.size()));
        for_each_quad(triangle, width, height, first_row, row_step, [&](const Quad& quad) {
            // The stage never writes depth, so testing before it gives the same picture as testing after it.
            std::array<bool, 4> visible{};
            for (int lane = 0; lane < 4; lane++) {
                if (!quad.covered[lane]) continue;
                std::size_t at = std::size_t(quad.y + lane / 2) * width + quad.x + lane % 2;
                visible[lane] = job.state.depth_test(float(quad.depth[lane]), canvas.depth[at]);
            }
            if (!visible[0] && !visible[1] && !visible[2] && !visible[3]) return;

            gather_inputs(job, triangle, quad, inputs);
            QuadOutputs outputs = fragment.run(inputs);
            for (int lane = 0; lane < 4; lane++) {
                if (!visible[lane] || outputs.discarded[lane]) continue;
                int x = quad.x + lane % 2, y = quad.y + lane / 2;
                write_pixel(job.state, canvas.color.at(x, y), outputs.lanes[lane]);
                if (job.state.depth_write) canvas.depth[std::size_t(y) * width + x] = float(quad.depth[lane]);
            }
        });
    }
}

}  // namespace

Outcome<Image> cpu_draw(const Draw& draw, Precision precision) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    if (!draw.program) return Failure{"the material was compiled without its program"};
    Outcome<State> state = pass_state(*pass.value);
    if (!state) return Failure{state.error};

    Interpreter vertex = make_interpreter(draw, Stage::Vertex, precision);
    Interpreter fragment = make_interpreter(draw, Stage::Fragment, precision);
    if (vertex.outputs().empty() || fragment.outputs().empty())
        return Failure{"the program has no stages for the pass '" + draw.pass + "'"};
    Outcome<std::vector<InputSource>> sources = fragment_sources(vertex, fragment);
    if (!sources) return Failure{sources.error};
    const Scene& scene = *draw.scene;
    Outcome<std::vector<ClipVertex>> vertices = run_vertices(vertex, scene.mesh);
    if (!vertices) return Failure{vertices.error};

    int width = scene.width * scene.samples, height = scene.height * scene.samples;
    const glm::vec4& back = scene.background;
    Canvas canvas{.color = make_image(width, height, back.r, back.g, back.b, back.a),
                  .depth = std::vector<float>(std::size_t(width) * height, 1.0f)};
    Job job{.draw = &draw,
            .state = state.value,
            .precision = precision,
            .sources = std::move(sources.value),
            .canvas = &canvas};
    const std::vector<std::uint32_t>& indices = scene.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        auto corner = [&](std::size_t k) -> const ClipVertex& { return vertices.value[indices[i + k]]; };
        for (ScreenTriangle& t : clip_to_screen(corner(0), corner(1), corner(2), width, height))
            if (t.is_front ? job.state.draws_front : job.state.draws_back) job.triangles.push_back(std::move(t));
    }

    // Rows of quads are dealt out in turn. No two threads touch one pixel, so the picture does not depend on their
    // number.
    int threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    std::vector<std::thread> others;
    for (int i = 1; i < threads; i++) others.emplace_back([&, i] { shade_rows(job, i, threads); });
    shade_rows(job, 0, threads);
    for (std::thread& other : others) other.join();
    return box_filtered(canvas.color, scene.samples);
}

}  // namespace patina::runtime

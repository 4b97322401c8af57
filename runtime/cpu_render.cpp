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

// A part of the picture, in samples.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;

    bool holds(int at_x, int at_y) const { return at_x >= x && at_y >= y && at_x < x + width && at_y < y + height; }
};

struct Canvas {
    Window window;
    Image color;
    std::vector<float> depth;

    std::span<float> color_at(int x, int y) { return color.at(x - window.x, y - window.y); }
    float& depth_at(int x, int y) { return depth[std::size_t(y - window.y) * window.width + (x - window.x)]; }
};

// A sample that passed the depth test, and what computed it.
struct Fragment {
    const ScreenTriangle* triangle = nullptr;
    std::size_t index = 0;  // of the triangle, among the mesh's
    Quad quad;
    int lane = 0;
    bool is_discarded = false;
};

// Everything that the threads share and only read, and the canvas, in which each has rows of its own.
struct Job {
    const Draw* draw = nullptr;
    State state{};
    Precision precision = Precision::Float;
    std::vector<InputSource> sources{};
    std::vector<ScreenTriangle> triangles{};
    std::vector<std::size_t> sources_of{};  // by triangle: the mesh's, before clipping
    int width = 0, height = 0;              // of the picture, in samples
    Canvas* canvas = nullptr;
    std::function<void(const Fragment&)> on_fragment{};  // told of every fragment, if there is one thread only
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
    QuadInputs inputs;
    for (std::size_t i = 0; i < job.triangles.size(); i++) {
        const ScreenTriangle& triangle = job.triangles[i];
        if (first_row == 0 && i % 64 == 0 && job.draw->progress)
            job.draw->progress(double(i) / double(job.triangles.size()));
        for_each_quad(triangle, job.width, job.height, first_row, row_step, [&](const Quad& quad) {
            // The stage never writes depth, so testing before it gives the same picture as testing after it.
            std::array<bool, 4> visible{};
            for (int lane = 0; lane < 4; lane++) {
                int x = quad.x + lane % 2, y = quad.y + lane / 2;
                if (!quad.covered[lane] || !canvas.window.holds(x, y)) continue;
                visible[lane] = job.state.depth_test(float(quad.depth[lane]), canvas.depth_at(x, y));
            }
            if (!visible[0] && !visible[1] && !visible[2] && !visible[3]) return;

            gather_inputs(job, triangle, quad, inputs);
            QuadOutputs outputs = fragment.run(inputs);
            for (int lane = 0; lane < 4; lane++) {
                if (!visible[lane]) continue;
                if (job.on_fragment) {
                    job.on_fragment({.triangle = &triangle,
                                     .index = job.sources_of[i],
                                     .quad = quad,
                                     .lane = lane,
                                     .is_discarded = outputs.discarded[lane]});
                }
                if (outputs.discarded[lane]) continue;
                int x = quad.x + lane % 2, y = quad.y + lane / 2;
                write_pixel(job.state, canvas.color_at(x, y), outputs.lanes[lane]);
                if (job.state.depth_write) canvas.depth_at(x, y) = float(quad.depth[lane]);
            }
        });
    }
}

Canvas make_canvas(const Scene& scene, const Window& window) {
    const glm::vec4& back = scene.background;
    return {.window = window,
            .color = make_image(window.width, window.height, back.r, back.g, back.b, back.a),
            .depth = std::vector<float>(std::size_t(window.width) * window.height, 1.0f)};
}

// Everything up to the fragment stage; the canvas is the caller's.
Outcome<Job> make_job(const Draw& draw, Precision precision) {
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

    Job job{.draw = &draw,
            .state = state.value,
            .precision = precision,
            .sources = std::move(sources.value),
            .width = scene.width * scene.samples,
            .height = scene.height * scene.samples};
    const std::vector<std::uint32_t>& indices = scene.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        auto corner = [&](std::size_t k) -> const ClipVertex& { return vertices.value[indices[i + k]]; };
        for (ScreenTriangle& t : clip_to_screen(corner(0), corner(1), corner(2), job.width, job.height)) {
            if (!(t.is_front ? job.state.draws_front : job.state.draws_back)) continue;
            job.triangles.push_back(std::move(t));
            job.sources_of.push_back(i / 3);
        }
    }
    return job;
}

// --- one pixel, watched

// The fragment that each sample of a pixel shows; where all were discarded, the nearest of those.
struct Sample {
    std::optional<Fragment> drawn, discarded;

    void add(const Fragment& fragment) {
        if (!fragment.is_discarded) {
            drawn = fragment;
        } else if (!discarded || fragment.quad.depth[fragment.lane] < discarded->quad.depth[discarded->lane]) {
            discarded = fragment;
        }
    }
};

// Of the samples that `has`, the one nearest to the middle of the pixel; -1: none has.
template <class Predicate>
int most_central(int samples, Predicate has) {
    int best = -1;
    double least = 0;
    for (int i = 0; i < samples * samples; i++) {
        double x = i % samples + 0.5 - samples * 0.5, y = i / samples + 0.5 - samples * 0.5;
        if (!has(i) || (best >= 0 && x * x + y * y >= least)) continue;
        best = i;
        least = x * x + y * y;
    }
    return best;
}

// The vertex stage of one vertex of the mesh.
std::vector<TracedValue> trace_vertex(Interpreter& stage, const Vertex& vertex) {
    QuadInputs quad;
    for (std::vector<double>& lane : quad.lanes) {
        for (const StageValue& input : stage.inputs())
            append_attribute(vertex, *vertex_source(input.name), input.components, lane);
    }
    return stage.trace(quad, 0);
}

}  // namespace

Outcome<Image> cpu_draw(const Draw& draw, Precision precision) {
    Outcome<Job> job = make_job(draw, precision);
    if (!job) return Failure{job.error};
    Canvas canvas = make_canvas(*draw.scene, {.width = job.value.width, .height = job.value.height});
    job.value.canvas = &canvas;

    // Rows of quads are dealt out in turn. No two threads touch one pixel, so the picture does not depend on their
    // number.
    int threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    std::vector<std::thread> others;
    for (int i = 1; i < threads; i++) others.emplace_back([&, i] { shade_rows(job.value, i, threads); });
    shade_rows(job.value, 0, threads);
    for (std::thread& other : others) other.join();
    return box_filtered(canvas.color, draw.scene->samples);
}

Outcome<PixelTrace> cpu_trace(const Draw& draw, int x, int y, Precision precision) {
    Outcome<Job> made = make_job(draw, precision);
    if (!made) return Failure{made.error};
    Job& job = made.value;
    const Scene& scene = *draw.scene;
    int samples = scene.samples;
    Canvas canvas = make_canvas(scene, {.x = x * samples, .y = y * samples, .width = samples, .height = samples});
    const Window& window = canvas.window;
    std::vector<Sample> shown(std::size_t(samples) * samples);
    job.canvas = &canvas;
    job.on_fragment = [&](const Fragment& fragment) {
        int column = fragment.quad.x + fragment.lane % 2 - window.x,
            row = fragment.quad.y + fragment.lane / 2 - window.y;
        shown[std::size_t(row) * samples + column].add(fragment);
    };
    for (int row = window.y / 2; row <= (window.y + samples - 1) / 2; row++) shade_rows(job, row, job.height);

    PixelTrace trace;
    auto copy_color = [](std::span<const float> from, std::array<float, 4>& to) {
        std::copy_n(from.begin(), to.size(), to.begin());
    };
    copy_color(box_filtered(canvas.color, samples).at(0, 0), trace.color);
    int sample = most_central(samples, [&](int i) { return shown[i].drawn.has_value(); });
    if (sample < 0) sample = most_central(samples, [&](int i) { return shown[i].discarded.has_value(); });
    if (sample < 0) return trace;
    trace.is_covered = true;
    trace.is_discarded = !shown[sample].drawn;
    trace.sample_x = sample % samples;
    trace.sample_y = sample / samples;
    copy_color(canvas.color.at(trace.sample_x, trace.sample_y), trace.sample_color);

    const Fragment& fragment = trace.is_discarded ? *shown[sample].discarded : *shown[sample].drawn;
    Interpreter stage = make_interpreter(draw, Stage::Fragment, precision);
    QuadInputs inputs;
    gather_inputs(job, *fragment.triangle, fragment.quad, inputs);
    trace.values = stage.trace(inputs, unsigned(fragment.lane));
    Interpreter vertices = make_interpreter(draw, Stage::Vertex, precision);
    for (std::size_t corner = 0; corner < 3; corner++) {
        std::uint32_t index = scene.mesh.indices[3 * fragment.index + corner];
        trace.corners[corner] = trace_vertex(vertices, scene.mesh.vertices[index]);
    }
    return trace;
}

}  // namespace patina::runtime

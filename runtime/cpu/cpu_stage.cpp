#include "runtime/cpu/cpu_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include "runtime/values/vertex_inputs.h"

namespace patina::runtime {
namespace {

// The numbers that a vertex has for an input, filled up to its width as Vulkan fills a missing y, z and w: 0, 0, 1.
void append_attribute(const Vertex& vertex, const VertexSource& source, unsigned components, std::vector<double>& out) {
    float numbers[4] = {0, 0, 0, 1};
    std::memcpy(numbers, reinterpret_cast<const char*>(&vertex) + source.offset, source.components * sizeof(float));
    out.insert(out.end(), numbers, numbers + std::min(components, 4u));
}

// Which vertex of the mesh, and which instance of the draw.
struct Drawn {
    std::size_t vertex = 0;
    std::uint32_t instance = 0;
};

// The value of an index that the stage reads; null: it is an attribute of the mesh.
std::optional<double> index_of(const StageValue& input, const Drawn& drawn) {
    if (input.is_builtin && input.name == "vertexIndex") return double(drawn.vertex);
    if (input.is_builtin && input.name == "instanceIndex") return double(drawn.instance);
    return {};
}

// `sources`: by input; null for an index.
void append_inputs(const Interpreter& stage, std::span<const VertexSource* const> sources, const Mesh& mesh,
                   const Drawn& drawn, std::vector<double>& out) {
    for (std::size_t i = 0; i < sources.size(); i++) {
        const StageValue& input = stage.inputs()[i];
        if (const std::optional<double> index = index_of(input, drawn))
            out.push_back(*index);
        else
            append_attribute(mesh.vertices[drawn.vertex], *sources[i], input.components, out);
    }
}

}  // namespace

Outcome<std::vector<ClipVertex>> run_vertices(Interpreter& stage, const Mesh& mesh, std::uint32_t instance) {
    std::vector<const VertexSource*> sources;
    for (const StageValue& input : stage.inputs()) {
        sources.push_back(vertex_source(input.name));
        if (!sources.back() && !index_of(input, {}))
            return Failure{"the preview meshes have no vertex input '" + input.name + "'"};
    }
    std::vector<ClipVertex> result;
    for (std::size_t first = 0; first < mesh.vertices.size(); first += 4) {
        std::size_t count = std::min<std::size_t>(4, mesh.vertices.size() - first);
        QuadInputs quad;
        for (std::size_t lane = 0; lane < 4; lane++) {
            const std::size_t vertex = first + std::min(lane, count - 1);
            append_inputs(stage, sources, mesh, {.vertex = vertex, .instance = instance}, quad.lanes[lane]);
        }
        QuadOutputs outputs = stage.run(quad);
        if (outputs.is_over_budget)
            return Failure{"the vertex stage takes more than " + std::to_string(Interpreter::kMostSteps) +
                           " steps for four vertices: the CPU does not draw it"};
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

std::vector<TracedValue> trace_vertex(Interpreter& stage, const Mesh& mesh, std::uint32_t vertex,
                                      std::uint32_t instance) {
    std::vector<const VertexSource*> sources;
    for (const StageValue& input : stage.inputs()) sources.push_back(vertex_source(input.name));
    QuadInputs quad;
    for (std::vector<double>& lane : quad.lanes)
        append_inputs(stage, sources, mesh, {.vertex = vertex, .instance = instance}, lane);
    return stage.trace(quad, 0);
}

Outcome<std::vector<InputSource>> fragment_sources(const Interpreter& vertex, const Interpreter& fragment) {
    std::vector<InputSource> result;
    for (const StageValue& input : fragment.inputs()) {
        InputSource source{.kind = input.is_flat ? InputSource::Kind::Flat : InputSource::Kind::Varying,
                           .components = input.components};
        if (input.is_builtin) {
            if (input.name == "frontFacing")
                source.kind = InputSource::Kind::FrontFacing;
            else if (input.name == "fragCoord")
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
            return Failure{"the fragment stage reads '" + input.name + "', which the vertex stage does not write"};
        result.push_back(source);
    }
    return result;
}

void gather_inputs(const std::vector<InputSource>& sources, const ScreenTriangle& triangle, const Quad& quad,
                   Precision precision, QuadInputs& inputs, glm::ivec2 origin) {
    for (int lane = 0; lane < 4; lane++) {
        std::vector<double>& out = inputs.lanes[lane];
        out.clear();
        for (const InputSource& source : sources) {
            switch (source.kind) {
                case InputSource::Kind::FrontFacing: out.push_back(triangle.is_front ? 1 : 0); break;
                case InputSource::Kind::FragCoord: {
                    double coord[4] = {quad.x - origin.x + lane % 2 + 0.5, quad.y - origin.y + lane / 2 + 0.5,
                                       quad.depth[lane], quad.inverse_w[lane]};
                    out.insert(out.end(), coord, coord + std::min(source.components, 4u));
                    break;
                }
                case InputSource::Kind::Flat:  // the same at all corners, where clipping made some of them too
                    for (unsigned c = 0; c < source.components; c++)
                        out.push_back(std::round(triangle.corners[0].varyings[source.offset + c]));
                    break;
                case InputSource::Kind::Varying:
                    for (unsigned c = 0; c < source.components; c++) {
                        double value = 0;
                        for (int corner = 0; corner < 3; corner++)
                            value += quad.weights[lane][corner] * triangle.corners[corner].varyings[source.offset + c];
                        out.push_back(precision == Precision::Float ? double(float(value)) : value);
                    }
                    break;
            }
        }
    }
}

}  // namespace patina::runtime

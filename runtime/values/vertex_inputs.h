// Which part of a preview mesh's vertex each vertex input of a shader reads, by the input's name. One table for the
// GPU's pipeline and the CPU's rasteriser.
//
//   const VertexSource* source = vertex_source("tangentOS");   // 4 floats at offsetof(Vertex, tangent)
#pragma once

#include <cstddef>
#include <string_view>

#include "runtime/mesh/mesh.h"

namespace patina::runtime {

struct VertexSource {
    std::string_view name;
    std::size_t offset = 0;  // in Vertex
    unsigned components = 0;
};

// Null: no mesh has such an input.
inline const VertexSource* vertex_source(std::string_view name) {
    static constexpr VertexSource kSources[] = {
        {"positionOS", offsetof(Vertex, position), 3},
        {"normalOS", offsetof(Vertex, normal), 3},
        {"tangentOS", offsetof(Vertex, tangent), 4},
        {"vertexColor", offsetof(Vertex, color), 4},
        {"uv0", offsetof(Vertex, uv0), 2},
        {"uv1", offsetof(Vertex, uv1), 2},
        {"uv2", offsetof(Vertex, uv2), 2},
        {"uv3", offsetof(Vertex, uv3), 2},
    };
    for (const VertexSource& source : kSources)
        if (source.name == name) return &source;
    return nullptr;
}

}  // namespace patina::runtime

#include "runtime/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace patina::runtime {
namespace {

struct SinCos {
    float sine, cosine;
};

// k/n of a full turn. The same for k and k + n, and exact at quarter turns, so that seams close and poles are points.
SinCos turn(int k, int n) {
    k = ((k % n) + n) % n;
    if (4 * k % n == 0) {
        constexpr std::array<SinCos, 4> kQuarters = {{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
        return kQuarters[4 * k / n];
    }
    double angle = 2 * std::numbers::pi * k / n;
    return {float(std::sin(angle)), float(std::cos(angle))};
}

// Appends a grid of columns x rows cells; vertex(i, j) is asked at the corners, i to the right (+u), j down (+v).
template <class VertexAt>
void add_grid(Mesh& mesh, int columns, int rows, VertexAt vertex) {
    auto first = std::uint32_t(mesh.vertices.size());
    for (int j = 0; j <= rows; j++)
        for (int i = 0; i <= columns; i++) {
            mesh.vertices.push_back(vertex(i, j));
            Vertex& added = mesh.vertices.back();
            added.uv1 = added.uv2 = added.uv3 = added.uv0;
        }

    auto add_triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const glm::vec3& pa = mesh.vertices[a].position;
        const glm::vec3& pb = mesh.vertices[b].position;
        const glm::vec3& pc = mesh.vertices[c].position;
        if (pa == pb || pb == pc || pc == pa) return;  // at a pole, where a row of vertices is one point
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    };
    for (int j = 0; j < rows; j++) {
        for (int i = 0; i < columns; i++) {
            std::uint32_t top_left = first + j * (columns + 1) + i;
            std::uint32_t bottom_left = top_left + columns + 1;
            add_triangle(top_left, bottom_left, bottom_left + 1);
            add_triangle(top_left, bottom_left + 1, top_left + 1);
        }
    }
}

// A point of the outline that revolve() turns about the y axis, listed from the top down.
struct OutlinePoint {
    float radius, y;
    float normal_radius, normal_y;
    float v;
};

// u = 0.5 looks at +z, and the seam is behind. Each column has pole vertices of its own: a tangent shared by all
// columns would have no direction there, and shade as a dark dot.
Mesh revolve(const std::vector<OutlinePoint>& outline, int segments) {
    Mesh mesh;
    add_grid(mesh, segments, int(outline.size()) - 1, [&](int i, int j) {
        auto [s, c] = turn(2 * i + segments, 2 * segments);
        const OutlinePoint& p = outline[j];
        return Vertex{.position = {p.radius * s, p.y, p.radius * c},
                      .normal = {p.normal_radius * s, p.normal_y, p.normal_radius * c},
                      .tangent = {c, 0, -s, 1},
                      .uv0 = {float(i) / segments, p.v}};
    });
    return mesh;
}

// A flat square: `normal` and `right` are axes, `distance` is how far it lies along the normal.
void add_square(Mesh& mesh, glm::vec3 normal, glm::vec3 right, float distance, float half, int segments) {
    glm::vec3 up = glm::cross(normal, right);
    add_grid(mesh, segments, segments, [&](int i, int j) {
        // From the middle, so that squares that share an edge have the same vertices there, to the last bit.
        const float x = float(2 * i - segments) / segments, y = float(segments - 2 * j) / segments;
        return Vertex{.position = normal * distance + right * (half * x) + up * (half * y),
                      .normal = normal,
                      .tangent = {right, 1},
                      .uv0 = {float(i) / segments, float(j) / segments}};
    });
}

}  // namespace

Mesh make_sphere(float radius, int segments, int rings) {
    std::vector<OutlinePoint> outline;
    for (int j = 0; j <= rings; j++) {
        auto [s, c] = turn(j, 2 * rings);
        outline.push_back({radius * s, radius * c, s, c, float(j) / rings});
    }
    return revolve(outline, segments);
}

Mesh make_capsule(float radius, float length, int segments, int rings) {
    // v runs along the outline at an even pace: two quarter circles and the straight part between them.
    float quarter = radius * float(std::numbers::pi) / 2;
    float total = 2 * quarter + length;
    std::vector<OutlinePoint> outline;
    for (int j = 0; j <= rings; j++) {
        auto [s, c] = turn(j, 4 * rings);
        outline.push_back({radius * s, length / 2 + radius * c, s, c, quarter * j / rings / total});
    }
    for (int j = 0; j <= rings; j++) {
        auto [s, c] = turn(rings + j, 4 * rings);
        outline.push_back(
            {radius * s, radius * c - length / 2, s, c, (quarter + length + quarter * j / rings) / total});
    }
    return revolve(outline, segments);
}

Mesh make_torus(float radius, float tube, int segments, int sides) {
    Mesh mesh;
    add_grid(mesh, segments, sides, [&](int i, int j) {
        auto [s, c] = turn(i, segments);                     // clockwise from the top, seen from +z
        auto [front, out] = turn(4 * j - sides, 4 * sides);  // around the tube; v = 0.5 faces +z
        glm::vec3 outward = {s, c, 0};
        glm::vec3 normal = outward * out + glm::vec3(0, 0, front);
        return Vertex{.position = outward * radius + normal * tube,
                      .normal = normal,
                      .tangent = {c, -s, 0, 1},
                      .uv0 = {float(i) / segments, float(j) / sides}};
    });
    return mesh;
}

Mesh make_plane(float size, int segments) {
    Mesh mesh;
    add_square(mesh, {0, 0, 1}, {1, 0, 0}, 0, size / 2, segments);
    return mesh;
}

Mesh make_cube(float size, int segments) {
    constexpr std::array<std::array<glm::vec3, 2>, 6> kFaces = {{
        // normal, right
        {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0)},
        {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)},
        {glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)},
        {glm::vec3(-1, 0, 0), glm::vec3(0, 0, 1)},
        {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)},
        {glm::vec3(0, -1, 0), glm::vec3(1, 0, 0)},
    }};
    Mesh mesh;
    for (const auto& [normal, right] : kFaces) add_square(mesh, normal, right, size / 2, size / 2, segments);
    return mesh;
}

Mesh make_fullscreen() {
    Mesh mesh;
    add_square(mesh, {0, 0, 1}, {1, 0, 0}, 0, 1, 1);
    return mesh;
}

std::span<const std::string_view> mesh_names() {
    static constexpr std::array<std::string_view, 5> kNames = {"sphere", "plane", "cube", "capsule", "torus"};
    return kNames;
}

std::optional<Mesh> make_mesh(std::string_view name, int segments) {
    // As many rows as keep the shape of the cells, and the mesh a solid.
    const auto share = [&](int numerator, int denominator, int least) {
        return std::max(segments * numerator / denominator, least);
    };
    const bool as_usual = segments == 0;
    if (name == "sphere") return as_usual ? make_sphere() : make_sphere(1, segments, share(1, 2, 2));
    if (name == "plane") return as_usual ? make_plane() : make_plane(2, segments);
    if (name == "cube") return as_usual ? make_cube() : make_cube(1.5f, segments);
    if (name == "capsule") return as_usual ? make_capsule() : make_capsule(0.6f, 1, segments, share(1, 4, 1));
    if (name == "torus") return as_usual ? make_torus() : make_torus(0.75f, 0.32f, segments, share(3, 8, 3));
    return std::nullopt;
}

float bounding_radius(const Mesh& mesh) {
    float radius = 0;
    for (const Vertex& vertex : mesh.vertices) radius = std::max(radius, glm::length(vertex.position));
    return radius;
}

}  // namespace patina::runtime

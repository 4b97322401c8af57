#include "runtime/mesh/tangents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace patina::runtime {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{};

struct Triangle {
    std::array<std::uint32_t, 3> points{};                         // welded
    std::array<std::uint32_t, 3> neighbours{kNone, kNone, kNone};  // across the edge from corner i to corner i + 1
    glm::vec3 along_u{0};                                          // the direction of growing u, of any length
    bool is_mirrored = false;
    bool fits_any = false;  // it has no area in uv0, and takes the handedness of its neighbours
    bool is_point = false;  // it has no area at all
};

// The same position, normal and uv0, under any index.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
    const auto key = [&](std::uint32_t i) {
        const Vertex& v = mesh.vertices[i];
        return std::array{v.position.x, v.position.y, v.position.z, v.normal.x,
                          v.normal.y,   v.normal.z,   v.uv0.x,      v.uv0.y};
    };
    std::vector<std::uint32_t> order(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
    return first;
}

Triangle make_triangle(const Mesh& mesh, const std::array<std::uint32_t, 3>& points) {
    const Vertex &a = mesh.vertices[points[0]], &b = mesh.vertices[points[1]], &c = mesh.vertices[points[2]];
    const glm::vec3 ab = b.position - a.position, ac = c.position - a.position;
    // v grows downwards; the method wants it upwards.
    const glm::vec2 uv_ab(b.uv0.x - a.uv0.x, a.uv0.y - b.uv0.y), uv_ac(c.uv0.x - a.uv0.x, a.uv0.y - c.uv0.y);
    const float area = uv_ab.x * uv_ac.y - uv_ab.y * uv_ac.x;
    Triangle made{.points = points};
    made.is_point = a.position == b.position || b.position == c.position || c.position == a.position;
    made.is_mirrored = area < 0;
    made.along_u = (ab * uv_ac.y - ac * uv_ab.y) * (made.is_mirrored ? -1.0f : 1.0f);
    made.fits_any = area == 0 || glm::dot(made.along_u, made.along_u) == 0;
    return made;
}

struct Side {
    std::uint32_t low, high;  // the points of the edge
    bool is_upward;           // from `low` to `high`
    std::uint32_t triangle;
    std::uint8_t corner;
};

// Two triangles that run along an edge in opposite directions are neighbours there. A third one is nobody's.
void find_neighbours(std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint8_t i = 0; i < 3 && !triangles[t].is_point; ++i) {
            const auto [low, high] = std::minmax(triangles[t].points[i], triangles[t].points[(i + 1) % 3]);
            sides.push_back({low, high, triangles[t].points[i] == low, t, i});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::tie(a.low, a.high, a.triangle, a.corner) < std::tie(b.low, b.high, b.triangle, b.corner);
    });
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end = std::find_if(
            begin, sides.end(), [&](const Side& side) { return side.low != begin->low || side.high != begin->high; });
        const auto middle = std::stable_partition(begin, end, [](const Side& side) { return side.is_upward; });
        for (auto up = begin, down = middle; up != middle && down != end; ++up, ++down) {
            triangles[up->triangle].neighbours[up->corner] = down->triangle;
            triangles[down->triangle].neighbours[down->corner] = up->triangle;
        }
        begin = end;
    }
}

std::size_t corner_of(const Triangle& triangle, std::uint32_t point) {
    return static_cast<std::size_t>(std::find(triangle.points.begin(), triangle.points.end(), point) -
                                    triangle.points.begin());
}

// Vectors of no length stay so.
glm::vec3 unit(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0 ? v / length : glm::vec3(0);
}

glm::vec3 in_plane(const glm::vec3& v, const glm::vec3& normal) {
    return v - normal * glm::dot(normal, v);
}

class Tangents {
public:
    explicit Tangents(const Mesh& mesh) : mesh_(mesh) {
        const std::vector<std::uint32_t> points = welded(mesh);
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            triangles_.push_back(make_triangle(
                mesh, {points[mesh.indices[i]], points[mesh.indices[i + 1]], points[mesh.indices[i + 2]]}));
        find_neighbours(triangles_);
        corners_.resize(triangles_.size());
        stamps_.resize(triangles_.size());
        known_.resize(mesh.vertices.size());
    }

    Mesh run() {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (!triangles_[t].fits_any && !triangles_[t].is_point && !is_done(t, i)) average(t, i);
            }
        }
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                glm::vec4& known = known_[triangles_[t].points[i]];
                if (is_done(t, i) && known.w == 0) known = corners_[t][i];
            }
        }
        return split();
    }

private:
    bool is_done(std::uint32_t triangle, std::size_t corner) const { return corners_[triangle][corner].w != 0; }

    // The triangles around a corner's point that are reached over edges at it and have the corner's handedness.
    std::vector<std::uint32_t> group_of(std::uint32_t triangle, std::size_t corner) {
        const std::uint32_t point = triangles_[triangle].points[corner];
        const bool is_mirrored = triangles_[triangle].is_mirrored;
        std::vector<std::uint32_t> group = {triangle};
        stamps_[triangle] = ++stamp_;
        for (std::size_t k = 0; k < group.size(); ++k) {
            const Triangle& at = triangles_[group[k]];
            const std::size_t i = corner_of(at, point);
            for (const std::uint32_t next : {at.neighbours[i], at.neighbours[(i + 2) % 3]}) {
                if (next == kNone || stamps_[next] == stamp_ || is_done(next, corner_of(triangles_[next], point)))
                    continue;
                if (!triangles_[next].fits_any && triangles_[next].is_mirrored != is_mirrored) continue;
                stamps_[next] = stamp_;
                group.push_back(next);
            }
        }
        return group;
    }

    void average(std::uint32_t triangle, std::size_t corner) {
        const std::uint32_t point = triangles_[triangle].points[corner];
        const glm::vec3 normal = mesh_.vertices[point].normal;
        const std::vector<std::uint32_t> group = group_of(triangle, corner);
        glm::vec3 sum(0);
        for (const std::uint32_t each : group) {
            const Triangle& at = triangles_[each];
            if (at.fits_any) continue;
            const std::size_t i = corner_of(at, point);
            const glm::vec3 from = mesh_.vertices[at.points[i]].position;
            const auto towards = [&](std::size_t k) {
                return unit(in_plane(mesh_.vertices[at.points[(i + k) % 3]].position - from, normal));
            };
            const float angle = std::acos(std::clamp(glm::dot(towards(1), towards(2)), -1.0f, 1.0f));
            sum += unit(in_plane(at.along_u, normal)) * angle;
        }
        glm::vec3 tangent = unit(sum);
        if (tangent == glm::vec3(0)) tangent = perpendicular(normal);
        for (const std::uint32_t each : group)
            corners_[each][corner_of(triangles_[each], point)] =
                glm::vec4(tangent, triangles_[triangle].is_mirrored ? -1 : 1);
    }

    static glm::vec3 perpendicular(const glm::vec3& normal) {
        const glm::vec3 axis = std::abs(normal.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        const glm::vec3 found = unit(in_plane(axis, normal));
        return found == glm::vec3(0) ? axis : found;
    }

    glm::vec4 tangent_at(std::uint32_t triangle, std::size_t corner) const {
        if (is_done(triangle, corner)) return corners_[triangle][corner];
        const std::uint32_t point = triangles_[triangle].points[corner];
        return known_[point].w == 0 ? glm::vec4(perpendicular(mesh_.vertices[point].normal), 1) : known_[point];
    }

    // A vertex of the mesh for each vertex and tangent.
    Mesh split() const {
        Mesh made;
        made.indices.reserve(mesh_.indices.size());
        std::vector<std::uint32_t> first(mesh_.vertices.size(), kNone), next;  // the copies of a vertex
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = mesh_.indices[3 * std::size_t(t) + i];
                const glm::vec4 tangent = tangent_at(t, i);
                std::uint32_t* copy = &first[vertex];
                while (*copy != kNone && made.vertices[*copy].tangent != tangent) copy = &next[*copy];
                if (*copy == kNone) {
                    *copy = static_cast<std::uint32_t>(made.vertices.size());
                    made.indices.push_back(*copy);
                    next.push_back(kNone);  // `copy` may point into it
                    made.vertices.push_back(mesh_.vertices[vertex]);
                    made.vertices.back().tangent = tangent;
                } else {
                    made.indices.push_back(*copy);
                }
            }
        }
        return made;
    }

    const Mesh& mesh_;
    std::vector<Triangle> triangles_;
    std::vector<std::array<glm::vec4, 3>> corners_;  // w is 0 until it is known
    std::vector<std::uint32_t> stamps_;              // by triangle: the last group that it was asked for
    std::uint32_t stamp_ = 0;
    std::vector<glm::vec4> known_;  // by point: what triangles without area take; w is 0: nothing
};

}  // namespace

Mesh with_tangents(const Mesh& mesh) {
    return Tangents(mesh).run();
}

}  // namespace patina::runtime

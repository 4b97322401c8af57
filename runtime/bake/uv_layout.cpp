#include "runtime/bake/uv_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace patina::runtime {
namespace {

// Beyond 0 and 1 by no more than this, coordinates count as on the border.
constexpr float kBorder = 1e-4f;
// Parts of a texel to which corners are rounded, so that an edge that two triangles share is the same for both.
constexpr int kSteps = 256;

using Point = std::array<std::int64_t, 2>;

// Twice the signed area; above 0 if a, b, c turn clockwise where y grows downwards.
std::int64_t area(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// If an edge goes exactly through a texel, one of the two triangles at the edge has the texel: the triangle of which
// this is a left or an upper edge.
bool is_top_left(const Point& from, const Point& to) {
    return (from[1] == to[1] && to[0] > from[0]) || to[1] < from[1];
}

// Counts the triangles over the centre of each texel.
class Coverage {
public:
    explicit Coverage(int size) : size_(size), counts_(std::size_t(size) * std::size_t(size)) {}

    void add(const std::array<glm::vec2, 3>& uvs) {
        std::array<Point, 3> points{};
        for (std::size_t i = 0; i < 3; i++)
            for (int axis = 0; axis < 2; axis++)
                points[i][std::size_t(axis)] = std::llround(double(uvs[i][axis]) * size_ * kSteps);
        if (area(points[0], points[1], points[2]) < 0) std::swap(points[1], points[2]);
        if (area(points[0], points[1], points[2]) == 0) return;
        const auto texels = [&](std::size_t axis) {
            const auto [low, high] = std::minmax({points[0][axis], points[1][axis], points[2][axis]});
            return std::array<int, 2>{int(std::clamp<std::int64_t>(low / kSteps - 1, 0, size_)),
                                      int(std::clamp<std::int64_t>(high / kSteps + 1, 0, size_))};
        };
        const std::array<int, 2> across = texels(0), down = texels(1);
        for (int y = down[0]; y < down[1]; y++)
            for (int x = across[0]; x < across[1]; x++)
                if (covers(points, {std::int64_t(x) * kSteps + kSteps / 2, std::int64_t(y) * kSteps + kSteps / 2}))
                    counts_[std::size_t(y) * std::size_t(size_) + std::size_t(x)]++;
    }

    double overlap() const {
        std::size_t covered = 0, several = 0;
        for (const std::uint32_t count : counts_) {
            covered += count > 0;
            several += count > 1;
        }
        return covered == 0 ? 0 : double(several) / double(covered);
    }

private:
    static bool covers(const std::array<Point, 3>& points, const Point& centre) {
        for (std::size_t i = 0; i < 3; i++) {
            const Point &from = points[i], &to = points[(i + 1) % 3];
            const std::int64_t side = area(from, to, centre);
            if (side < 0 || (side == 0 && !is_top_left(from, to))) return false;
        }
        return true;
    }

    int size_;
    std::vector<std::uint32_t> counts_;
};

// Empty, or what is wrong.
std::string range_error(const Mesh& mesh) {
    glm::vec2 low(std::numeric_limits<float>::max()), high(-low);
    for (const Vertex& vertex : mesh.vertices) {
        if (!std::isfinite(vertex.uv0.x) || !std::isfinite(vertex.uv0.y))
            return "its texture coordinates (TEXCOORD_0) are not all finite numbers";
        low = glm::min(low, vertex.uv0);
        high = glm::max(high, vertex.uv0);
    }
    if (low.x >= -kBorder && low.y >= -kBorder && high.x <= 1 + kBorder && high.y <= 1 + kBorder) return "";
    return fmt::format(
        "its texture coordinates (TEXCOORD_0) go from {:.3g}, {:.3g} to {:.3g}, {:.3g}, and a texture reaches from 0 "
        "to "
        "1: unwrap the mesh into that square, without overlaps",
        low.x, low.y, high.x, high.y);
}

}  // namespace

Outcome<UvLayout> uv_layout(const Mesh& mesh, int size) {
    if (std::string error = range_error(mesh); !error.empty()) return Failure{error};
    UvLayout layout{.mesh = {.vertices = mesh.vertices, .indices = {}}};
    Coverage coverage(size);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<std::uint32_t, 3> corners{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        std::array<glm::vec2, 3> uvs{};
        for (std::size_t k = 0; k < 3; k++) uvs[k] = mesh.vertices[corners[k]].uv0;
        const glm::dvec2 u(uvs[1] - uvs[0]), v(uvs[2] - uvs[0]);
        const double turn = u.x * v.y - u.y * v.x;
        if (turn == 0) continue;
        // v grows downwards: what turns clockwise there turns against the clock where y grows upwards.
        if (turn > 0) std::swap(corners[1], corners[2]);
        layout.mesh.indices.insert(layout.mesh.indices.end(), corners.begin(), corners.end());
        coverage.add(uvs);
    }
    if (layout.mesh.indices.empty())
        return Failure{"it has no texture coordinates (TEXCOORD_0) that cover any area: unwrap the mesh"};
    layout.overlap = coverage.overlap();
    return layout;
}

}  // namespace patina::runtime

#include "runtime/cpu/raster.h"

#include <algorithm>
#include <cmath>

namespace patina::runtime {
namespace {

constexpr int kSubpixels = 256;  // VkPhysicalDeviceLimits::subPixelPrecisionBits is 8 on every device of today

// A clip-space half-space: dot(normal, position) >= offset.
struct Plane {
    glm::dvec4 normal{};
    double offset = 0;
};
// The sides are cut far outside the screen, only to keep snapped coordinates within 64 bits; the smallest w is there
// for vertex graphs that give odd positions.
constexpr double kGuard = 64;
constexpr double kSmallestW = 1e-6;
const std::array<Plane, 6> kPlanes = {{
    {{0, 0, 1, 0}, 0},  // near
    {{0, 0, 0, 1}, kSmallestW},
    {{1, 0, 0, kGuard}, 0},   // left
    {{-1, 0, 0, kGuard}, 0},  // right
    {{0, 1, 0, kGuard}, 0},   // bottom
    {{0, -1, 0, kGuard}, 0},  // top
}};

double distance(const Plane& plane, const ClipVertex& vertex) {
    return glm::dot(plane.normal, vertex.position) - plane.offset;
}

ClipVertex between(const ClipVertex& a, const ClipVertex& b, double t) {
    ClipVertex result{.position = glm::mix(a.position, b.position, t), .varyings = a.varyings};
    for (std::size_t i = 0; i < a.varyings.size(); i++) result.varyings[i] += (b.varyings[i] - a.varyings[i]) * t;
    return result;
}

// Sutherland and Hodgman, "Reentrant Polygon Clipping", 1974: one plane after the other.
std::vector<ClipVertex> clipped(std::vector<ClipVertex> polygon) {
    for (const Plane& plane : kPlanes) {
        std::vector<ClipVertex> kept;
        for (std::size_t i = 0; i < polygon.size(); i++) {
            const ClipVertex& from = polygon[i];
            const ClipVertex& to = polygon[(i + 1) % polygon.size()];
            double a = distance(plane, from), b = distance(plane, to);
            if (a >= 0) kept.push_back(from);
            if ((a >= 0) != (b >= 0)) kept.push_back(between(from, to, a / (a - b)));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

// Twice the area of a, b, c: above 0 if they go clockwise on the screen. For snapped and for exact places.
template <class Number>
Number doubled_area(glm::tvec2<Number> a, glm::tvec2<Number> b, glm::tvec2<Number> c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_inside(const ClipVertex& vertex) {
    return std::all_of(kPlanes.begin(), kPlanes.end(),
                       [&](const Plane& plane) { return distance(plane, vertex) >= 0; });
}

bool is_finite(const ClipVertex& vertex) {
    const glm::dvec4& p = vertex.position;
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

void add_triangle(std::vector<ScreenTriangle>& result, const ClipVertex& a, const ClipVertex& b, const ClipVertex& c,
                  int width, int height, glm::ivec2 origin) {
    ScreenTriangle t{.corners = {a, b, c}};
    for (int i = 0; i < 3; i++) {
        const glm::dvec4& p = t.corners[i].position;
        t.exact[i] = {(p.x / p.w * 0.5 + 0.5) * width + origin.x, (0.5 - p.y / p.w * 0.5) * height + origin.y};
        t.snapped[i] = {std::llround(t.exact[i].x * kSubpixels), std::llround(t.exact[i].y * kSubpixels)};
    }
    std::int64_t snapped_area = doubled_area(t.snapped[0], t.snapped[1], t.snapped[2]);
    if (snapped_area == 0) return;
    t.is_front = snapped_area < 0;
    if (t.is_front) {
        std::swap(t.corners[1], t.corners[2]);
        std::swap(t.snapped[1], t.snapped[2]);
        std::swap(t.exact[1], t.exact[2]);
    }
    t.area = doubled_area(t.exact[0], t.exact[1], t.exact[2]);
    if (t.area <= 0) return;  // a sliver that only snapping gave an area
    result.push_back(std::move(t));
}

// Fills in one lane; false if its centre is outside.
bool sample(const ScreenTriangle& t, int px, int py, Quad& quad, int lane) {
    glm::dvec2 center(px + 0.5, py + 0.5);
    glm::i64vec2 snapped_center(std::int64_t(px) * kSubpixels + kSubpixels / 2,
                                std::int64_t(py) * kSubpixels + kSubpixels / 2);
    bool covered = true;
    std::array<double, 3> linear{};
    for (int i = 0; i < 3; i++) {
        const glm::i64vec2 &from = t.snapped[(i + 1) % 3],
                           &to = t.snapped[(i + 2) % 3];  // the edge across from corner i
        std::int64_t side = doubled_area(from, to, snapped_center);
        bool is_top = from.y == to.y && to.x > from.x;
        bool is_left = to.y < from.y;
        covered = covered && (side > 0 || (side == 0 && (is_top || is_left)));
        linear[i] = doubled_area(t.exact[(i + 1) % 3], t.exact[(i + 2) % 3], center) / t.area;
    }
    double depth = 0, inverse_w = 0;
    for (int i = 0; i < 3; i++) {
        const glm::dvec4& p = t.corners[i].position;
        depth += linear[i] * (p.z / p.w);
        linear[i] /= p.w;
        inverse_w += linear[i];
    }
    for (int i = 0; i < 3; i++) quad.weights[lane][i] = linear[i] / inverse_w;
    quad.depth[lane] = depth;
    quad.inverse_w[lane] = inverse_w;
    return covered && depth <= 1;  // beyond the far plane there is nothing to see
}

}  // namespace

std::vector<ScreenTriangle> clip_to_screen(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, int width,
                                           int height, glm::ivec2 origin) {
    std::vector<ScreenTriangle> result;
    if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return result;
    if (is_inside(a) && is_inside(b) && is_inside(c)) {  // nearly all: no polygon needed
        add_triangle(result, a, b, c, width, height, origin);
        return result;
    }
    std::vector<ClipVertex> polygon = clipped({a, b, c});
    for (std::size_t i = 2; i < polygon.size(); i++)
        add_triangle(result, polygon[0], polygon[i - 1], polygon[i], width, height, origin);
    return result;
}

void for_each_quad(const ScreenTriangle& t, const PixelBounds& bounds, int first_row, int row_step,
                   const std::function<void(const Quad&)>& visit) {
    auto [left, right] = std::minmax({t.snapped[0].x, t.snapped[1].x, t.snapped[2].x});
    auto [top, bottom] = std::minmax({t.snapped[0].y, t.snapped[1].y, t.snapped[2].y});
    auto quad_of = [](std::int64_t position, int first, int end) {
        return int(std::clamp(position, std::int64_t(first) * kSubpixels, std::int64_t(end) * kSubpixels - 1) /
                   (2 * kSubpixels));
    };
    if (right < std::int64_t(bounds.left) * kSubpixels || bottom < std::int64_t(bounds.top) * kSubpixels) return;
    if (bounds.left >= bounds.right || bounds.top >= bounds.bottom) return;
    int first_column = quad_of(left, bounds.left, bounds.right),
        last_column = quad_of(right, bounds.left, bounds.right);
    int row = quad_of(top, bounds.top, bounds.bottom), last_row = quad_of(bottom, bounds.top, bounds.bottom);
    row += ((first_row - row) % row_step + row_step) % row_step;
    for (; row <= last_row; row += row_step) {
        for (int column = first_column; column <= last_column; column++) {
            Quad quad{.x = 2 * column, .y = 2 * row};
            for (int lane = 0; lane < 4; lane++) {
                int x = quad.x + lane % 2, y = quad.y + lane / 2;
                quad.covered[lane] = sample(t, x, y, quad, lane) && bounds.holds(x, y);
            }
            if (quad.covered[0] || quad.covered[1] || quad.covered[2] || quad.covered[3]) visit(quad);
        }
    }
}

}  // namespace patina::runtime

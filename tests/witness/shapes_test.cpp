// Shapes with edges one pixel wide, against a closed form: 32 x 32 pixels, the GPU through both languages and the CPU
// in both precisions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "witness/pixels.h"

namespace patina::witness {
namespace {

class ShapesTest : public PixelsTest {
protected:
    using Measure = std::function<double(double, double)>;  // of uv

    static double uv_of(int pixel) { return (pixel + 0.5) / kSide; }

    // How much a measure changes over the 2 x 2 quad of a pixel.
    static double fwidth(const Measure& measure, int x, int y) {
        const int left = x / 2 * 2, upper = y / 2 * 2;
        const double across = measure(uv_of(left + 1), uv_of(y)) - measure(uv_of(left), uv_of(y));
        const double down = measure(uv_of(x), uv_of(upper + 1)) - measure(uv_of(x), uv_of(upper));
        return std::abs(across) + std::abs(down);
    }

    static double inside_one(const Measure& measure, int x, int y) {
        return std::clamp((1 - measure(uv_of(x), uv_of(y))) / std::max(fwidth(measure, x, y), 1e-6), 0.0, 1.0);
    }

    static constexpr const char* kUv = R"({ "id": "uv", "expr": "@fragCoord.xy / 32" })";
};

TEST_F(ShapesTest, EllipsePolygonAndRoundedRectangleFadeOverOnePixel) {
    const auto witnesses = all_witnesses(
        kUv, "float3(Ellipse(uv, 0.75, 0.5), Polygon(uv, 5, 0.9, 0.8), RoundedRectangle(uv, 0.8, 0.6, 0.2))",
        "Polygon(uv, 3)", white());
    const Measure ellipse = [](double u, double v) { return std::hypot((2 * u - 1) / 0.75, (2 * v - 1) / 0.5); };
    const auto polygon = [](int sides, double width, double height) {
        return [=](double u, double v) {
            // The largest distance along the normals of the sides; one of them points down.
            const double inner = std::cos(M_PI / sides);
            const double x = (2 * u - 1) / width / inner, y = (2 * v - 1) / height / inner;
            double most = 0;
            for (int i = 0; i < sides; ++i) {
                const double angle = 2 * M_PI * i / sides;
                most = std::max(most, x * std::sin(angle) + y * std::cos(angle));
            }
            return most;
        };
    };
    const Measure rounded = [](double u, double v) {
        const double x = std::max(std::abs(2 * u - 1) - 0.8 + 0.4, 0.0);
        const double y = std::max(std::abs(2 * v - 1) - 0.6 + 0.4, 0.0);
        return std::hypot(x, y) / 0.4;
    };
    expect_all(witnesses, 2e-3, [&](int x, int y) -> std::array<double, 4> {
        return {inside_one(ellipse, x, y), inside_one(polygon(5, 0.9, 0.8), x, y), inside_one(rounded, x, y),
                inside_one(polygon(3, 0.5, 0.5), x, y)};
    });
}

// The share of a pixel between both edges of a direction, by its ends.
double covered(double middle, double width) {
    const double pixel = 1.0 / 32, low = 0.5 - width / 2, high = 0.5 + width / 2;
    const double share = std::min(middle + pixel / 2, high) - std::max(middle - pixel / 2, low);
    return std::max(share, 0.0) / pixel;
}

TEST_F(ShapesTest, ANiceRectangleCoversWhatItCoversOfEachPixel) {
    const auto witnesses = all_witnesses(
        kUv, "float3(Rectangle(uv, 0.52, 0.3, Nicest), Rectangle(uv, 0.01, 1.2, Nicest), Rectangle(uv, 0.52, 0.3))",
        "1", white());
    expect_all(witnesses, 2e-3, [](int x, int y) -> std::array<double, 4> {
        const double u = uv_of(x), v = uv_of(y);
        // Thinner than a pixel, in the joint of two pixels: each edge is taken for itself, so each of both has a little
        // less.
        const double thin = std::min(std::clamp(0.5 + (0.005 - std::abs(u - 0.5)) * 32, 0.0, 1.0), 0.01 * 32);
        const auto faded = [](double place, double size) { return 1 - (std::abs(2 * place - 1) - size) * 16; };
        return {covered(u, 0.52) * covered(v, 0.3), thin, std::clamp(std::min(faded(u, 0.52), faded(v, 0.3)), 0.0, 1.0),
                1};
    });
}

TEST_F(ShapesTest, AMaskCoversHalfOfAPixelOnTheEdge) {
    const auto witnesses = all_witnesses(
        kUv, "float3(SdfMask((@fragCoord.x - 10.25) / 32), SdfMask(uv.x - 0.5, 0.25), SdfMask(SdfCircle(uv, 0.3)))",
        "1", white());
    const Measure circle = [](double u, double v) { return std::hypot(u - 0.5, v - 0.5) - 0.3; };
    expect_all(witnesses, 2e-3, [&](int x, int y) -> std::array<double, 4> {
        const double change = std::max(fwidth(circle, x, y), 1e-6);
        return {std::clamp(0.5 - (x + 0.5 - 10.25), 0.0, 1.0), std::clamp(0.5 - (uv_of(x) - 0.5) * 4, 0.0, 1.0),
                std::clamp(0.5 - circle(uv_of(x), uv_of(y)) / change, 0.0, 1.0), 1};
    });
}

TEST_F(ShapesTest, ACheckerboardIsGreyWhereItsSquaresAreSmallerThanAPixel) {
    const auto witnesses = all_witnesses(kUv,
                                         "float3(CheckerboardUnity(uv, 0, 1, 2).r, CheckerboardUnity(uv, float3(0.2), "
                                         "float3(0.6), 64).g, CheckerboardUnity(uv, 1, 0, 2).b)",
                                         "1", white());
    expect_all(witnesses, 2e-3, [](int x, int y) -> std::array<double, 4> {
        // Two pairs of squares: each is eight pixels wide, and its middle is far from every edge.
        const auto triangle = [](double place) {
            return 4 * std::abs(place + 0.25 - std::floor(place + 0.25) - 0.5) - 1;
        };
        const double pixel = 2.0 / 32;
        const double across = std::clamp(triangle((uv_of(x) + 0.5) * 2) * 0.35 / pixel, -1.0, 1.0);
        const double down = std::clamp(triangle((uv_of(y) + 0.5) * 2) * 0.35 / pixel, -1.0, 1.0);
        const double second = std::clamp(0.5 + 0.5 * across * down * std::sqrt(std::min(1.1 - pixel, 1.0)), 0.0, 1.0);
        return {second, 0.4, 1 - second, 1};
    });
}

}  // namespace
}  // namespace patina::witness

// The CPU rasteriser against closed forms.
#include "runtime/cpu/raster.h"

#include <gtest/gtest.h>

#include <cmath>

namespace patina::runtime {
namespace {

constexpr int kSize = 16;

ClipVertex corner(double x, double y, double z = 0.5, double w = 1, double varying = 0) {
    return {.position = {x * w, y * w, z * w, w}, .varyings = {varying}};
}

struct Hit {
    int count = 0;
    double varying = 0, depth = 0;
    bool is_front = false;
};

// What each pixel of a kSize square got from the triangles.
class Canvas {
public:
    void draw(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, int rows = 1) {
        for (const ScreenTriangle& t : clip_to_screen(a, b, c, kSize, kSize))
            for (int row = 0; row < rows; row++)
                for_each_quad(t, kSize, kSize, row, rows, [&](const Quad& quad) { take(t, quad); });
    }
    const Hit& at(int x, int y) const { return hits_[y * kSize + x]; }
    int total() const {
        int sum = 0;
        for (const Hit& hit : hits_) sum += hit.count;
        return sum;
    }

private:
    void take(const ScreenTriangle& t, const Quad& quad) {
        for (int lane = 0; lane < 4; lane++) {
            if (!quad.covered[lane]) continue;
            Hit& hit = hits_[(quad.y + lane / 2) * kSize + quad.x + lane % 2];
            hit.count++;
            hit.varying = 0;
            for (int i = 0; i < 3; i++) hit.varying += quad.weights[lane][i] * t.corners[i].varyings[0];
            hit.depth = quad.depth[lane];
            hit.is_front = t.is_front;
        }
    }
    std::array<Hit, kSize * kSize> hits_{};
};

TEST(Raster, NeighboursShareAnEdgeWithoutGapOrOverlap) {
    // A fan about a point that is a pixel's centre, with edges through centres along rows, columns and diagonals.
    ClipVertex middle = corner(1.0 / kSize, -1.0 / kSize);
    const double ring[][2] = {{-1, -1}, {0.0625, -1}, {1, -1}, {1, -0.0625},
                              {1, 1},   {0.0625, 1},  {-1, 1}, {-1, -0.0625}};
    Canvas canvas;
    for (int i = 0; i < 8; i++) {
        const double *a = ring[i], *b = ring[(i + 1) % 8];
        canvas.draw(middle, corner(a[0], a[1]), corner(b[0], b[1]));
    }
    for (int y = 0; y < kSize; y++)
        for (int x = 0; x < kSize; x++) EXPECT_EQ(canvas.at(x, y).count, 1) << x << ", " << y;
}

TEST(Raster, TopLeftRule) {
    // A square whose sides run through pixel centres owns those at its top and left only.
    auto place = [](double pixel) { return pixel / kSize * 2 - 1; };
    double left = place(2.5), right = place(5.5), top = -place(3.5), bottom = -place(6.5);
    Canvas canvas;
    canvas.draw(corner(left, top), corner(left, bottom), corner(right, bottom));
    canvas.draw(corner(left, top), corner(right, bottom), corner(right, top));
    for (int y = 0; y < kSize; y++)
        for (int x = 0; x < kSize; x++)
            EXPECT_EQ(canvas.at(x, y).count, x >= 2 && x < 5 && y >= 3 && y < 6 ? 1 : 0) << x << ", " << y;
}

TEST(Raster, CounterClockwiseIsFront) {
    Canvas canvas;
    canvas.draw(corner(-1, -1), corner(1, -1), corner(-1, 1));
    EXPECT_TRUE(canvas.at(1, 14).is_front);
    canvas.draw(corner(-1, -1), corner(-1, 1), corner(1, -1));
    EXPECT_FALSE(canvas.at(1, 14).is_front);
    EXPECT_EQ(canvas.at(14, 1).count, 0);  // y is up in clip space: the upper right is empty
}

TEST(Raster, VaryingsAreCorrectInPerspective) {
    // The varying is 0 at the left (w 1) and 1 at the right (w 3): at screen share s it is (s / 3) / (1 - s + s / 3).
    Canvas canvas;
    canvas.draw(corner(-1, -1, 0.5, 1, 0), corner(1, -1, 0.5, 3, 1), corner(1, 1, 0.5, 3, 1));
    canvas.draw(corner(-1, -1, 0.5, 1, 0), corner(1, 1, 0.5, 3, 1), corner(-1, 1, 0.5, 1, 0));
    for (int x = 0; x < kSize; x++) {
        double s = (x + 0.5) / kSize;
        EXPECT_NEAR(canvas.at(x, 7).varying, s / 3 / (1 - s + s / 3), 1e-12);
    }
}

TEST(Raster, DepthIsLinearOnTheScreen) {
    Canvas canvas;
    canvas.draw(corner(-1, -1, 0, 1), corner(3, -1, 1, 4), corner(-1, 3, 0, 1));
    for (int x = 0; x < kSize; x++) EXPECT_NEAR(canvas.at(x, 8).depth, (x + 0.5) / kSize / 2, 1e-12);
}

TEST(Raster, CutsAtTheNearPlane) {
    // Depth runs from -1 at the left to 1 at the right: the right half is left, and its varyings are those of the
    // whole.
    Canvas canvas;
    canvas.draw(corner(-1, -1, -1, 1, 0), corner(1, -1, 1, 1, 1), corner(1, 1, 1, 1, 1));
    canvas.draw(corner(-1, -1, -1, 1, 0), corner(1, 1, 1, 1, 1), corner(-1, 1, -1, 1, 0));
    EXPECT_EQ(canvas.total(), kSize * kSize / 2);
    for (int x = kSize / 2; x < kSize; x++) EXPECT_NEAR(canvas.at(x, 5).varying, (x + 0.5) / kSize, 1e-12);
}

TEST(Raster, DropsWhatIsBehindTheCameraOrTooFar) {
    Canvas canvas;
    canvas.draw({.position = {-1, -1, -1, -1}, .varyings = {0}}, {.position = {1, -1, -1, -1}, .varyings = {0}},
                {.position = {0, 1, -1, -1}, .varyings = {0}});
    canvas.draw(corner(-1, -1, 1.5), corner(1, -1, 1.5), corner(0, 1, 1.5));
    EXPECT_EQ(canvas.total(), 0);
}

TEST(Raster, SurvivesOddPositions) {
    double nan = std::nan(""), huge = 1e30;
    Canvas canvas;
    canvas.draw(corner(nan, 0), corner(1, 0), corner(0, 1));
    canvas.draw(corner(0, 0), corner(0, 0), corner(0, 0));
    EXPECT_EQ(canvas.total(), 0);
    canvas.draw(corner(-huge, -huge), corner(huge, -huge), corner(0, huge));
    for (int y = 0; y < kSize; y++)
        for (int x = 0; x < kSize; x++) EXPECT_LE(canvas.at(x, y).count, 1);
    canvas.draw(corner(-50, -50), corner(50, -50), corner(0, 50));
    EXPECT_GE(canvas.total(), kSize * kSize);
}

TEST(Raster, RowsAreDealtOutOnce) {
    Canvas one, three;
    one.draw(corner(-0.9, -0.8), corner(0.7, -0.9), corner(0.3, 0.95), 1);
    three.draw(corner(-0.9, -0.8), corner(0.7, -0.9), corner(0.3, 0.95), 3);
    for (int y = 0; y < kSize; y++)
        for (int x = 0; x < kSize; x++) EXPECT_EQ(one.at(x, y).count, three.at(x, y).count);
    EXPECT_GT(one.total(), 80);
}

}  // namespace
}  // namespace patina::runtime

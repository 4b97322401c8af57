#include "runtime/bake/padding.h"

#include <algorithm>
#include <limits>
#include <span>

namespace patina::runtime {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Nearest {
public:
    Nearest(const std::vector<std::uint8_t>& covered, int width, int height)
        : width_(width), height_(height), from_(covered.size(), kNone) {
        for (std::size_t i = 0; i < covered.size(); i++)
            if (covered[i]) from_[i] = std::uint32_t(i);
    }

    // Down and up again: each row takes from the row before it, then from both sides.
    std::vector<std::uint32_t> run() {
        for (int y = 0; y < height_; y++) row(y, y - 1);
        for (int y = height_ - 1; y >= 0; y--) row(y, y + 1);
        return std::move(from_);
    }

private:
    void row(int y, int before) {
        if (before >= 0 && before < height_) {
            for (int x = 0; x < width_; x++)
                for (const int column : {x - 1, x, x + 1}) take(x, y, column, before);
        }
        for (int x = 1; x < width_; x++) take(x, y, x - 1, y);
        for (int x = width_ - 2; x >= 0; x--) take(x, y, x + 1, y);
    }

    void take(int x, int y, int other_x, int other_y) {
        if (other_x < 0 || other_x >= width_) return;
        const std::uint32_t offered = from_[index(other_x, other_y)];
        std::uint32_t& own = from_[index(x, y)];
        if (offered == kNone || offered == own) return;
        if (own == kNone || distance(x, y, offered) < distance(x, y, own)) own = offered;
    }

    std::size_t index(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }
    std::int64_t distance(int x, int y, std::uint32_t to) const {
        const std::int64_t across = std::int64_t(to) % width_ - x, down = std::int64_t(to) / width_ - y;
        return across * across + down * down;
    }

    int width_, height_;
    std::vector<std::uint32_t> from_;
};

}  // namespace

std::vector<std::uint32_t> nearest_covered(const std::vector<std::uint8_t>& covered, int width, int height) {
    return Nearest(covered, width, height).run();
}

void fill(Image& image, const std::vector<std::uint32_t>& from) {
    for (std::size_t i = 0; i < from.size(); i++)
        if (from[i] != i && from[i] != kNone)
            std::copy_n(image.pixels.begin() + std::ptrdiff_t(4 * std::size_t(from[i])), 4,
                        image.pixels.begin() + std::ptrdiff_t(4 * i));
}

}  // namespace patina::runtime

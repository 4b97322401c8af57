// Uses patina::lighting without the compiler: a grey sky gives grey light.
#include <patina/lighting.h>
#include <patina/version.h>

#include <cmath>
#include <cstdio>

static_assert(PATINA_VERSION >= PATINA_MAKE_VERSION(0, 1, 0));

int main() {
    const std::vector<float> grey(3 * 16 * 8, 0.5f);
    const patina::lighting::Environment sky = patina::lighting::prefilter({.width = 16, .height = 8, .numbers = grey});
    if (!sky.error.empty()) return std::fprintf(stderr, "%s\n", sky.error.c_str()), 1;
    if (sky.levels.size() != 6 || std::abs(sky.levels.back().texels[0] - 0.5f) > 1e-4f) return 1;
    if (patina::lighting::prefilter({.width = 16, .height = 9, .numbers = grey}).error.empty()) return 1;
    std::printf("lighting %zu %d\n", sky.levels.size(), patina::lighting::split_sum_table().size);
    return 0;
}

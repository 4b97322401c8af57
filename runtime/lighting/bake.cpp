// Computes the tables of baked.cpp while Patina is built, and writes them to a file.
// Usage: patina_bake OUT
#include <cstdio>
#include <fstream>
#include <vector>

#include "runtime/lighting/environment.h"
#include "runtime/lighting/split_sum.h"
#include "runtime/lighting/studio.h"

int main(int argc, char** argv) {
    using namespace patina::runtime;
    if (argc != 2) {
        std::fputs("usage: patina_bake OUT\n", stderr);
        return 2;
    }
    std::vector<float> numbers = split_sum_numbers();
    const auto map = Environment(studio_radiance, kStudioSize).map();
    for (std::size_t level = 1; level < map->levels.size(); ++level) {
        const std::vector<float>& texels = map->levels[level].texels;
        for (std::size_t i = 0; i < texels.size(); i += 4)
            numbers.insert(numbers.end(), {texels[i], texels[i + 1], texels[i + 2]});
    }
    std::ofstream file(argv[1], std::ios::binary);
    file.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(numbers.size() * sizeof(float)));
    file.close();
    if (file) return 0;
    std::fprintf(stderr, "cannot write '%s'\n", argv[1]);
    return 1;
}

// patina_textures DIR: paints the textures of the example graphs and writes them. The files are committed;
// this program is how they came to be, and how to change them.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "examples/textures/sets.h"

int main(int argc, char** argv) {
    if (argc != 2 || std::string_view(argv[1]).starts_with("-")) {
        std::fputs("usage: patina_textures DIR\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);

    using namespace textures;
    for (Set (*paint)() : {rusted_steel, painted_tiles, mossy_rock, ivy_leaves, bricks, quilt, light_ramps, lit_ball}) {
        for (const Texture& texture : paint()) {
            const std::string path = (folder / (texture.name + ".png")).string();
            if (std::string error = save(texture.picture, texture.channels, path); !error.empty()) {
                std::fprintf(stderr, "%s: %s\n", path.c_str(), error.c_str());
                return 1;
            }
            std::puts(path.c_str());
        }
    }
    const std::string table = (folder / "satin_paint.exr").string();
    if (std::string error = save_satin_paint(table); !error.empty()) {
        std::fprintf(stderr, "%s: %s\n", table.c_str(), error.c_str());
        return 1;
    }
    std::puts(table.c_str());
}

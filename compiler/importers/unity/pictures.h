// Pictures that a file of Unity names by GUID, with what their import settings ("FILE.meta") say of them. The importers
// of Unity's formats share it.
//
//   Pictures pictures(assets, output_folder);
//   const Picture& wood = pictures.find("0f6a...");
//   if (wood.file.empty()) ...                         // wood.missing says why
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/imported_graph.h"
#include "compiler/importers/unity/assets.h"

namespace patina::importers {

struct Picture {
    std::string file{};     // relative to the output folder; empty: it was not found
    std::string missing{};  // then: why, in words
    bool has_settings = false;
    bool is_srgb = true, is_normal_map = false;
    bool repeats = true;                     // in both directions
    GraphMembers more{};                     // keys of the property: "sampler", "swizzle"
    GraphMembers layers{};                   // of a texture with layers: "grid"
    bool flips_green = false;                // of a normal map
    std::vector<std::string> differences{};  // settings that the graph cannot say
};

class Pictures {
public:
    Pictures(Assets& assets, std::string folder) : assets_(assets), folder_(std::move(folder)) {}

    // `file`: which one of those that are in Unity itself.
    const Picture& find(std::string_view guid, std::int64_t file = 0);

private:
    Picture read(std::string_view guid, std::int64_t file);

    Assets& assets_;
    std::string folder_;
    std::map<std::string, Picture> known_{};  // by GUID and file
};

}  // namespace patina::importers

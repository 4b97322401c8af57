// Pictures that a material names by GUID, with what their import settings ("FILE.meta") say of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/importers/graph_writer.h"
#include "compiler/importers/unity_assets.h"
#include "compiler/importers/unitymaterial/material_file.h"

namespace patina::importers::unitymaterial {

struct Picture {
    std::string file{};     // relative to the output folder; empty: it was not found
    std::string missing{};  // then: why, in words
    bool has_settings = false;
    bool is_srgb = true, is_normal_map = false;
    bool repeats = true;                     // in both directions
    std::vector<Member> more{};              // keys of the property: "sampler", "swizzle"
    bool flips_green = false;                // of a normal map
    std::vector<std::string> differences{};  // settings that the graph cannot say
};

class Pictures {
public:
    Pictures(Assets& assets, std::string folder) : assets_(assets), folder_(std::move(folder)) {}

    const Picture& find(const AssetId& id);

private:
    Picture read(const AssetId& id);

    Assets& assets_;
    std::string folder_;
    std::map<std::string, Picture> known_{};  // by GUID
};

}  // namespace patina::importers::unitymaterial

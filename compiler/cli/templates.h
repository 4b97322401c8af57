// The starting files of `patina new`: templates/. CMake embeds them when it configures the build.
#pragma once

#include <span>
#include <string_view>

namespace patina::cli {

struct Template {
    std::string_view kind;     // "metal"
    std::string_view ending;   // of its file's name: ".graph.json"
    std::string_view summary;  // one line for --help
    std::string_view text;
};
std::span<const Template> templates();

}  // namespace patina::cli

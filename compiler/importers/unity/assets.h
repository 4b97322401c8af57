// Files of a project of Unity that another file names by GUID. The GUID of a file lies in "FILE.meta" beside it. The
// importers of Unity's formats share it.
//
//   Assets assets("Assets/Shaders/x.shadergraph", {});
//   if (const auto found = assets.find(guid, "Noise", kGraphs)) read(found->path);
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace patina::importers {

inline constexpr std::string_view kGraphs[] = {".shadersubgraph", ".shadergraph"};
inline constexpr std::string_view kIncludes[] = {".hlsl", ".cginc", ".cg", ".hlslinc"};
inline constexpr std::string_view kPictures[] = {".png", ".jpg",  ".jpeg", ".tga",  ".exr", ".hdr",
                                                 ".tif", ".tiff", ".bmp",  ".webp", ".psd"};

inline constexpr std::string_view kMetas[] = {".meta"};

class Assets {
public:
    // `folders`: where to search; none: the folder of the source, or the nearest one above it that is called Assets.
    Assets(const std::string& source, std::vector<std::string> folders);

    struct Found {
        std::string path;
        bool is_by_name = false;  // no file has the GUID; this one has the name
        std::string other{};      // a second file with the same GUID
    };
    // The file with the GUID, or else with the name and one of the endings.
    std::optional<Found> find(std::string_view guid, std::string_view name, std::span<const std::string_view> endings);
    const std::vector<std::string>& searched() const { return folders_; }
    // Where it searches, for messages.
    std::string folders() const;

private:
    struct Index {
        std::map<std::string, std::vector<std::string>, std::less<>> by_guid{}, by_name{};
    };
    const Index& index(std::span<const std::string_view> endings);

    std::vector<std::string> folders_;
    std::map<std::string_view, Index> indexes_;  // by the first ending
};

// "0f6a...", 32 hexadecimal digits, of JSON that names an asset: {"fileID":2800000,"guid":"...","type":3}
std::string guid_in(std::string_view json);

// The path as a file in the folder names it: "./wood.png", "../Textures/wood.png"; empty: it has no such path.
std::string path_from(const std::string& folder, const std::string& path);

}  // namespace patina::importers

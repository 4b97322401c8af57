// Reads NAME.snapshot.json: the graph or scene, its view, and the tolerance of the comparison. snapshot.h runs it.
//
//   { "patina": 1, "graph": "rust.graph.json", "mesh": "torus", "size": 128, "samples": 2, "time": 0, "node": "mask",
//     "camera": { "fov": 40 }, "lights": ["directional direction=0,1,1"], "ambient": "0.2", "via": "glsl",
//     "environment": { "file": "sunset.hdr", "rotation": 90 }, "background": "none", "lighting": "phong",
//     "path": "forward", "set": { "_Roughness": 0.2, "_Tint": [1, 0, 0], "_MainTex": "rust.png" },
//     "sweep": { "_Metallic": [0, 0.5, 1] }, "text": true, "tolerance": { "share": 0.001, "average": 0.002 } }
//
// All keys except "patina" are optional; the default graph is NAME.graph.json, or NAME.scene.json if only that exists.
// A path may be a file, "./mine.pass.hlsl". A scene brings its own meshes, so "mesh", "set" and "sweep" are for graphs.
// Several paths ("path": ["forward", "deferred"]) and a sweep's values are pictures of their own: variations().
// // comments and trailing commas are accepted.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/render/render_request.h"
#include "runtime/snapshot/gates.h"

namespace patina::runtime {

// The values that a property has, one a picture.
struct PropertySweep {
    std::string property{};
    std::vector<std::string> values{};  // in the words of the command line
};

struct SnapshotFile {
    // Its files are resolved against the snapshot's folder; 128 pixels and 2 samples where the file does not say.
    RenderRequest request{};
    Tolerance tolerance{};
    std::vector<std::string> paths{};  // if the file lists them; `request` has the first
    std::vector<PropertySweep> sweeps{};
    bool text = false;  // the shaders' text is compared, too
};

inline constexpr std::string_view kSnapshotEnding = ".snapshot.json";
// The size of a snapshot whose file does not say, or that has no file.
RenderRequest default_request();

// One picture of a snapshot. `name` is empty, or distinguishes it from the others: "deferred", "_Metallic=0.5".
struct Variation {
    std::string name{};
    RenderRequest request{};
};
inline constexpr std::size_t kMostVariations = 1000;
// Each path with each combination of the sweeps' values, the last sweep changing fastest.
std::vector<Variation> variations(const SnapshotFile& file);

struct ReadSnapshot {
    std::optional<SnapshotFile> file;
    Diagnostic error;  // without a file: what is wrong, and where
    // Where the file has each key, for what is found out when the picture is drawn: "path", "node", "set/_Roughness".
    std::map<std::string, FileLocation> places{};
};
ReadSnapshot read_snapshot(const std::string& path);

}  // namespace patina::runtime

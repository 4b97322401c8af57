// Reads NAME.snapshot.json: the graph or scene, its view, and the tolerance of the comparison. snapshot.h runs it.
//
//   { "patina": 1, "graph": "rust.graph.json", "mesh": "torus", "size": 128, "samples": 2, "time": 0, "node": "mask",
//     "camera": { "fov": 40 }, "lights": ["directional direction=0,1,1"], "ambient": "0.2", "via": "glsl",
//     "path": "forward", "set": { "_Roughness": 0.2, "_Tint": [1, 0, 0], "_MainTex": "rust.png" },
//     "tolerance": { "pixel": 0.0118, "share": 0.001, "average": 0.002 } }
//
// All keys except "patina" are optional; the default graph is NAME.graph.json, or NAME.scene.json if only that exists.
// A path may be a file, "./mine.pass.hlsl". A scene brings its own meshes, so "mesh", "set" and "node" are for graphs.
// // comments and trailing commas are accepted.
#pragma once

#include <optional>
#include <string>

#include "runtime/render/render_request.h"

namespace patina::runtime {

struct Tolerance {
    double pixel = 3.01 / 255;  // a pixel differs if any channel, sRGB-encoded, is off by more
    double share = 0.001;       // of pixels that may differ
    double average = 0.002;     // mean absolute error over all channels
};

struct SnapshotFile {
    // Its files are resolved against the snapshot's folder; 128 pixels and 2 samples where the file does not say.
    RenderRequest request{};
    Tolerance tolerance{};
};

struct ReadSnapshot {
    std::optional<SnapshotFile> file;
    Diagnostic error;         // without a file: what is wrong, and where
    ScenePlace path_place{};  // where the snapshot names its path; of its file alone if it names none
};
ReadSnapshot read_snapshot(const std::string& path);

}  // namespace patina::runtime

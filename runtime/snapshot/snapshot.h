// The room `snapshot`: finds picture tests, has them rendered and compares. It draws nothing itself.
//
// Picture tests as files. Each NAME.snapshot.json in a folder describes how a graph or scene is drawn.
// NAME.reference.png next to it is the expected picture, and NAME.reference.glsl has the expected shaders if the file
// asks for them. A graph or scene without such a file is a test, too. A plain run never writes there: what was received
// and the difference are written to `received_dir`, as NAME.received.png and NAME.difference.png.
//
//   { "patina": 1, "mesh": "torus", "size": 128, "set": { "_Roughness": 0.2 }, "tolerance": { "share": 0.01 } }
//
//   SnapshotReport report = run_snapshots(compiler, "tests/graphs/metal", {.received_dir = "out"});
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "patina/text_diff.h"
#include "runtime/render/render_request.h"
#include "runtime/snapshot/gates.h"

namespace patina::runtime {

enum class SnapshotState { Passed, Failed, Missing, Updated };
std::string_view to_string(SnapshotState state);  // "passed" ...

// What a reference picture records: the device, its driver, and the size of the shaders.
struct PictureRecord {
    std::string device{}, driver{};  // empty: not noted
    std::size_t spirv_bytes = 0;     // of all shaders (DrawnShader); 0: not noted
};

struct SnapshotCase {
    std::string name{};  // NAME, with the folder below `dir` if there is one; of several pictures: "rust.deferred"
    std::string file{};  // path of NAME.snapshot.json, or of the graph or scene
    SnapshotState state = SnapshotState::Failed;
    std::string reference{};  // path of NAME.reference.png
    std::string received{};   // written pictures; empty: none
    std::string difference{};
    std::string message{};  // why it failed; empty where `diagnostics` say it
    std::vector<Diagnostic> diagnostics{};
    std::vector<Gate> gates{};  // empty if no two pictures of one size were compared
    PictureRecord now{}, then{};
    bool other_driver = false;          // than the reference's: the limits are wider
    std::vector<DiffLine> text_diff{};  // from the shaders' reference; empty: equal, or not compared
    double seconds = 0;
    bool missing_machine = false;
    // The files' bytes, where SnapshotOptions::keeps_pictures; empty: none.
    std::string reference_png{}, received_png{}, difference_png{};

    bool ok() const { return state == SnapshotState::Passed || state == SnapshotState::Updated; }
};

// One part of the cases, so that several machines share them. Every case is in one part.
struct Shard {
    std::size_t index = 1, count = 1;  // 1 to count
};

struct SnapshotOptions {
    std::string received_dir = "received";  // made when needed
    bool update = false;                    // writes references that differ or are missing; nothing else ever does
    std::string only{};  // the one case to run, or all pictures of one file; empty: all. An unknown one is an error
    std::string via{};   // overrides what the files say; then no text is compared
    std::string device{};
    bool validation = false;
    std::vector<std::string> include_dirs{};
    std::map<std::string, double> tolerance{};  // by ToleranceKey::name; overrides what the files say
    Shard shard{};
    int jobs = 0;  // cases at once; 0: as many as the machine has cores, at most 4
    bool keeps_pictures = false;
    // Called for one case after the other, in their order, as soon as each can be; `index` from 0.
    std::function<void(const SnapshotCase&, std::size_t index, std::size_t count)> on_case{};
};

struct SnapshotReport {
    std::string error;                   // the folder cannot be read, or holds no (such) case
    std::vector<SnapshotCase> cases{};   // by name
    std::vector<std::string> orphans{};  // reference pictures of no case
    bool ok() const;                     // no error, and every case passed or was updated
    std::size_t count(SnapshotState state) const;
};

// Looks into folders below `dir` too.
SnapshotReport run_snapshots(const Compiler& compiler, const std::string& dir, const SnapshotOptions& options);

}  // namespace patina::runtime

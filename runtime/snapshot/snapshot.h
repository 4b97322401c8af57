// The room `snapshot`: reads such files, has them rendered and compares. It draws nothing itself.
//
// Picture tests as files: each NAME.snapshot.json in a folder names a graph and a scene, and NAME.reference.png next to
// it is the expected picture. A plain run never writes there: the rendered picture and the difference are written to
// `received_dir`, as NAME.received.png and NAME.difference.png.
//
//   { "patina": 1, "mesh": "torus", "size": 128, "set": { "_Roughness": 0.2 }, "tolerance": { "share": 0.01 } }
//
//   SnapshotReport report = run_snapshots(compiler, "tests/graphs/metal", {.received_dir = "out"}, machine);
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/picture/compare.h"
#include "runtime/render/render_request.h"
#include "runtime/snapshot/snapshot_file.h"

namespace patina::runtime {

enum class SnapshotState { Passed, Failed, Missing, Updated };
std::string_view to_string(SnapshotState state);  // "passed" ...

struct SnapshotCase {
    std::string name{};  // NAME, with the folder below `dir` if there is one
    std::string file{};  // path of NAME.snapshot.json
    SnapshotState state = SnapshotState::Failed;
    std::string reference{};  // path of NAME.reference.png
    std::string received{};   // written pictures; empty: none
    std::string difference{};
    std::string message{};  // why it failed; empty where `diagnostics` say it
    std::vector<Diagnostic> diagnostics{};
    std::optional<Comparison> comparison{};  // of two pictures of one size
    Tolerance tolerance{};
    bool missing_machine = false;
};

struct SnapshotOptions {
    std::string received_dir = "received";  // made when needed
    bool update = false;                    // writes references that differ or are missing; nothing else ever does
    std::string only{};                     // the one case to run; empty: all. An unknown one is an error of the report
    std::string via{};                      // overrides what the files say
    std::string device{};
    bool validation = false;
    std::vector<std::string> include_dirs{};
};

struct SnapshotReport {
    std::string error;                // the folder cannot be read, or holds no (such) case
    std::vector<SnapshotCase> cases;  // by name
    bool ok() const;                  // no error, and every case passed or was updated
};

// Looks into folders below `dir` too.
SnapshotReport run_snapshots(const Compiler& compiler, const std::string& dir, const SnapshotOptions& options,
                             RenderMachine& machine);

}  // namespace patina::runtime

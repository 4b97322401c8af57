// The room `cli/diff` compares two versions of a graph for `patina diff`, and shows the differences: in the graph, then
// in its shaders and their size, then in its picture.
//
//   DiffReport report{.graph = diff_graphs(before, after)};
//   add_shader_changes(compiler, before, after, options, report);
//   print(report_text(report, console.output_colors));
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/cli/console.h"
#include "patina/graph_diff.h"
#include "patina/text_diff.h"

namespace patina::cli {

struct ShaderChange {
    std::string pass{};  // empty: a file that holds all passes
    Stage stage = Stage::Vertex;
    Target target{};
    bool was_there = true, is_there = true;
    bool computes_same = false;     // only the text differs: names and comments
    std::vector<DiffLine> lines{};  // of the text
    StageCost before{}, after{};    // all 0: not measured
};

struct PictureChange {
    std::string path;    // of the comparison
    double share = 0;    // of the pixels that differ by more than 3/255
    double largest = 0;  // difference of a channel of a pixel, 0 to 1
};

struct DiffReport {
    std::string before{}, after{};  // names
    GraphDiff graph{};
    bool same_text = false;
    bool has_shaders = false;             // they were compiled and compared
    std::vector<ShaderChange> shaders{};  // that differ
    std::optional<PictureChange> picture{};

    bool differs() const;
};

std::string report_text(const DiffReport& report, bool colors);
// One object, with a line for each change.
std::string report_json(const DiffReport& report);

// A version of a graph, and its path: files that the graph names are searched in the path's folder.
struct Version {
    std::string path;
    std::string text;
};

// A comparison of the pictures of both, in a file.
struct PictureWish {
    std::string output{};  // .png or .exr; empty: none
    int size = 256;        // pixels of each side
    CompileOptions options{};
};

// Compiles both, and compares the shaders that they have. False: one does not compile; `diagnostics` says why.
bool add_shader_changes(const Compiler& compiler, const Version& before, const Version& after,
                        const CompileOptions& options, DiffReport& report, std::vector<Diagnostic>& diagnostics);

// Draws both. Nothing: that failed, and it has complained. In patina-render alone.
std::optional<PictureChange> compare_pictures(const Console& console, const Version& before, const Version& after,
                                              const PictureWish& wish);

}  // namespace patina::cli

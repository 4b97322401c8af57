// The room `sheet`: what there is to see of a folder's graphs, and the page that shows it. It draws nothing itself.
//
// Each graph and scene of a folder: its picture, its nodes as a drawing with a picture in each, its properties, the
// cost of its passes, and its shaders. A file that is wrong is there, too, with what is wrong.
//
//   Sheet sheet = make_sheet(compiler, "art", {.size = 256});
//   write_file("index.html", sheet_page(sheet, "art"));
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "patina/cost.h"
#include "runtime/render/render_request.h"

namespace patina::runtime {

struct SheetOptions {
    RenderRequest request{};  // how all pictures are drawn: light, device, path; `graph` and `size` are not used
    int size = 256;           // pixels of a picture's sides
    bool node_pictures = true;
    int jobs = 0;  // graphs at once; 0: as many as the machine has cores, at most 4
    std::function<void(std::size_t index, std::size_t count, const std::string& name)> progress{};
};

struct SheetEntry {
    std::string name{};  // "metal/rust": its path below the folder, without the ending
    std::string file{};
    std::string kind{};  // "material", "sub-graph", "lighting graph", "workflow", "scene"
    // The bytes of PNG files: the picture, and the same with half its size; empty: there is none.
    std::string picture{}, thumbnail{};
    std::string drawing{};        // SVG; empty: there is none
    std::string without_nodes{};  // why there is no drawing, or no picture in some of its nodes
    std::string ranges{};         // of the values that the pictures of nodes show if not 0 to 1: "phase -1 to 3"
    std::vector<std::string> nodes{};
    Reflection reflection{};  // of what was compiled: of scenes nothing
    std::vector<MeasuredPass> passes{};
    std::vector<Shader> shaders{};
    std::vector<Diagnostic> diagnostics{};
    std::string error{};  // an error in addition to them
    bool ok = false;
    bool missing_machine = false;
};

struct Sheet {
    std::string error{};                // the folder cannot be read, or has nothing to show
    std::vector<SheetEntry> entries{};  // by name
};

// Graphs, scenes, sub-graphs, lighting graphs and workflows in `folder` and below it, but not in hidden folders.
Sheet make_sheet(const Compiler& compiler, const std::string& folder, const SheetOptions& options);

}  // namespace patina::runtime

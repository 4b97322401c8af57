// One import: the graph that was asked for, the sub-graphs that it uses, and what became of each part.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/importers/importer.h"
#include "compiler/importers/shadergraph/read/shader_graph.h"
#include "compiler/importers/shadergraph/values/types.h"
#include "compiler/importers/terms.h"
#include "compiler/importers/unity/assets.h"
#include "compiler/importers/unity/pictures.h"
#include "patina/patina.h"

namespace patina::importers::shadergraph {

// A sub-graph as those who use it see it.
struct SubgraphPorts {
    std::string file{};    // "./noise.subgraph.json"; empty: it cannot be used, and
    std::string error{};   // why
    std::string remark{};  // what is uncertain about it
    struct Input {
        std::string name{}, guid{}, reference{};
        Type type = Type::None;
        std::vector<double> numbers{};  // its default, if that is a number, a vector or an entry
        bool is_dropdown = false;
        bool is_perceptual = false;          // a gradient whose colours are blended in OkLab
        bool is_normal_map = false;          // it is sampled as one
        std::vector<std::string> entries{};  // of a dropdown
        std::string connected{};  // the further input that says whether this one is connected; empty: nothing asks
    };
    struct Output {
        int slot = 0;
        std::string name{};
        Type type = Type::None;
        std::string passes{};  // the input whose texture it passes on
    };
    std::vector<Input> inputs{};
    std::vector<Output> outputs{};
};

// The library, of which graphs name nodes.
const Compiler& library();

class Project {
public:
    Project(const std::string& source, std::vector<std::string> folders, std::string output_folder)
        : assets(source, std::move(folders)), folder(std::move(output_folder)) {}

    // The graph file becomes a file of the import; empty, or why it does not.
    std::string add_graph(const std::string& path, const std::string& name);
    // The sub-graph, imported when it is first asked for.
    const SubgraphPorts& subgraph(std::string_view guid, std::string_view name);

    Assets assets;
    std::string folder;  // that will be written to
    Pictures pictures{assets, folder};
    Names file_names{};
    std::vector<TextFile> files{};
    std::vector<Remark> remarks{};
    bool has_refused = false;

private:
    SubgraphPorts read_graph(const std::string& path, const std::string& name);

    std::map<std::string, SubgraphPorts> subgraphs_{};  // by path, or by the GUID of one that is missing
    std::vector<std::string> open_{};                   // paths that are being imported, the outer one first
};

}  // namespace patina::importers::shadergraph

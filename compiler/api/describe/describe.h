// Makes the public descriptions of nodes, semantics and models from the library's declarations. `patina nodes`, the
// node reference and the JSON Schema are made from them.
#pragma once

#include "compiler/api/evaluate.h"
#include "patina/patina.h"

namespace patina {

// A doc comment in parts: its text without slashes, and the lines that begin with a keyword.
struct Doc {
    std::string text;
    std::string formula, source, use;
    std::string unit, space;  // of a value of the engine
    std::string block;        // the description of its block, from a value of the block
    struct TestLine {
        std::string_view text;     // the text after "test:"; points into the comment
        std::uint32_t offset = 0;  // of its first byte in the comment
    };
    std::vector<TestLine> tests;
};
Doc read_doc(std::string_view comment);

NodeInfo describe_node(const nodelang::FunctionDecl& function, const EvaluationContext& context);
std::vector<SemanticInfo> describe_semantics(const resolve::Library& library);
std::vector<PathInfo> describe_paths(const resolve::Library& library);
std::vector<EngineInfo> describe_engines(const resolve::Library& library);
ModelInfo describe_model(const format::Graph& graph, const std::string& name, const SourceMap& sources);

}  // namespace patina

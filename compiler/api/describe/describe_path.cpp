// Makes the public description of a rendering path from its pass file, whose opening comment is the documentation.
#include <algorithm>

#include "compiler/api/describe/describe.h"

namespace patina {
namespace {

// The comment lines at the start of the file.
std::string_view opening_comment(std::string_view text) {
    std::size_t end = 0;
    while (text.substr(end).starts_with("//") && !text.substr(end).starts_with("///")) {
        const std::size_t line = text.find('\n', end);
        if (line == text.npos) return text;
        end = line + 1;
    }
    return text.substr(0, end);
}

PassInfo describe_pass(const paths::PassDecl& declaration) {
    PassInfo pass{.state = declaration.state, .blends = {}, .is_optional = declaration.is_optional};
    for (const paths::BlendRow& row : declaration.blends) {
        pass.blends.push_back({.surface = row.surface, .blend = row.blend});
    }
    return pass;
}

}  // namespace

std::vector<PathInfo> describe_paths(const resolve::Library& library) {
    std::vector<PathInfo> paths;
    for (const std::string_view name : library.paths.names()) {
        PathInfo path{.name = std::string(name), .doc = {}, .source = {}, .file = {}, .passes = {}};
        for (const paths::PassDecl* pass : library.paths.passes_of(name)) {
            if (path.passes.empty()) {
                Doc doc = read_doc(opening_comment(library.sources.text_before(pass->fragment->span.begin)));
                path.doc = std::move(doc.text);
                path.source = std::move(doc.source);
                path.file = library.sources.file(pass->fragment->span.begin);
            }
            path.passes.push_back(describe_pass(*pass));
        }
        if (!path.passes.empty()) paths.push_back(std::move(path));
    }
    std::sort(paths.begin(), paths.end(), [](const PathInfo& a, const PathInfo& b) { return a.name < b.name; });
    return paths;
}

std::vector<EngineInfo> describe_engines(const resolve::Library& library) {
    std::vector<EngineInfo> made;
    for (const auto& [name, each] : library.engines) {
        const engines::Engine& engine = each.get();
        made.push_back({.name = engine.name,
                        .title = engine.title,
                        .doc = engine.help,
                        .file = engine.is_one_file() ? engine.file : "stages",
                        .languages = engine.languages,
                        .is_default = name == library.default_engine,
                        .has_own_passes = engine.has_own_passes(),
                        .paths = engine.paths,
                        .is_one_file = engine.is_one_file(),
                        .folder = "nodes/engines/" + engine.name});
    }
    std::stable_partition(made.begin(), made.end(), [](const EngineInfo& engine) { return engine.is_default; });
    return made;
}

}  // namespace patina

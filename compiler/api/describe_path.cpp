// A pass file -> the public description of its rendering path. The comment that opens the file is its documentation.
#include <algorithm>

#include "compiler/api/describe.h"

namespace patina {
namespace {

// The lines of comment before anything else.
std::string_view opening_comment(std::string_view text) {
    std::size_t end = 0;
    while (text.substr(end).starts_with("//") && !text.substr(end).starts_with("///")) {
        const std::size_t line = text.find('\n', end);
        if (line == text.npos) return text;
        end = line + 1;
    }
    return text.substr(0, end);
}

PassInfo describe_pass(const graph::PassDecl& declaration) {
    PassInfo pass{.state = declaration.state, .blends = {}, .is_optional = declaration.is_optional};
    for (const graph::BlendRow& row : declaration.blends) {
        pass.blends.push_back({.surface = row.surface, .blend = row.blend});
    }
    return pass;
}

}  // namespace

std::vector<PathInfo> describe_paths(const graph::Library& library) {
    std::vector<PathInfo> paths;
    for (const std::string_view name : library.stages.paths()) {
        PathInfo path{.name = std::string(name), .doc = {}, .source = {}, .file = {}, .passes = {}};
        for (const graph::PassDecl* pass : library.stages.passes_of(name)) {
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

}  // namespace patina

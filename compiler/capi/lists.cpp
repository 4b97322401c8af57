// The functions of patina/patina_c.h that list what the library has.
#include <memory>

#include "compiler/api/describe/list_json.h"
#include "compiler/capi/handles.h"

namespace patina::capi {
namespace {

// Gives the list, which is made at the first request. `entry_of` makes an entry of an info and its JSON, which stays
// where it is.
template <class Entry, class Info, class EntryOf>
patina_status give(const MadeOnce<List<Entry>>& made, const std::vector<Info>& (Compiler::*infos)() const,
                   const patina_compiler* compiler, const EntryOf& entry_of, const Entry** entries,
                   std::size_t* count) {
    return guarded([&] {
        const List<Entry>& list = made.get([&] {
            auto all = std::make_unique<List<Entry>>();
            const std::vector<Info>& known = (compiler->compiler.*infos)();
            all->texts.reserve(known.size());
            all->entries.reserve(known.size());
            for (const Info& info : known) {
                JsonWriter json;
                write_json(json, info);
                all->texts.push_back(json.take());
                all->entries.push_back(entry_of(info, all->texts.back().c_str()));
            }
            return all;
        });
        *entries = list.entries.data();
        *count = list.entries.size();
        return PATINA_OK;
    });
}

template <class Entry>
bool is_complete(const patina_compiler* compiler, const Entry** entries, std::size_t* count) {
    if (entries) *entries = nullptr;
    if (count) *count = 0;
    return compiler && entries && count;
}

}  // namespace
}  // namespace patina::capi

using namespace patina::capi;

extern "C" {

patina_status patina_nodes(const patina_compiler* compiler, const patina_node** nodes, size_t* count) {
    if (!is_complete(compiler, nodes, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::NodeInfo& node, const char* json) {
        return patina_node{.name = node.name.c_str(),
                           .category = node.category.c_str(),
                           .doc = node.doc.c_str(),
                           .file = node.file.c_str(),
                           .json = json};
    };
    return give(compiler->nodes, &patina::Compiler::nodes, compiler, entry, nodes, count);
}

patina_status patina_paths(const patina_compiler* compiler, const patina_path** paths, size_t* count) {
    if (!is_complete(compiler, paths, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::PathInfo& path, const char* json) {
        return patina_path{.name = path.name.c_str(), .doc = path.doc.c_str(), .file = path.file.c_str(), .json = json};
    };
    return give(compiler->paths, &patina::Compiler::paths, compiler, entry, paths, count);
}

patina_status patina_engines(const patina_compiler* compiler, const patina_engine** engines, size_t* count) {
    if (!is_complete(compiler, engines, count)) return PATINA_BAD_ARGUMENT;
    const auto entry = [](const patina::EngineInfo& engine, const char* json) {
        return patina_engine{
            .name = engine.name.c_str(), .title = engine.title.c_str(), .doc = engine.doc.c_str(), .json = json};
    };
    return give(compiler->engines, &patina::Compiler::engines, compiler, entry, engines, count);
}

}  // extern "C"

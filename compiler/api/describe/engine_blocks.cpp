// engine_blocks(): the [extern] variables of the library, with what their comments say.
#include <algorithm>

#include "compiler/api/compiler_impl.h"
#include "compiler/api/describe/describe.h"
#include "patina/engine_values.h"

namespace patina {
namespace {

std::string type_of(const nodelang::TypeName& type, const SourceMap& sources) {
    std::string text(type.name);
    if (type.array_size) text += "[" + std::string(sources.text(type.array_size->span)) + "]";
    return text;
}

// Adds the block if no value has requested it before.
EngineBlockInfo& block_named(std::vector<EngineBlockInfo>& blocks, std::string_view name) {
    for (EngineBlockInfo& block : blocks) {
        if (block.name == name) return block;
    }
    return blocks.emplace_back(EngineBlockInfo{.name = std::string(name), .doc = {}, .values = {}});
}

// The paragraphs of a comment as one line.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

std::vector<EngineBlockInfo> engine_blocks(const Compiler& compiler) {
    const resolve::Library& library = CompilerAccess::library(compiler);
    std::vector<const paths::ExternDecl*> externs;
    for (const paths::ExternDecl& each : library.paths.externs) {
        if (!each.is_target()) externs.push_back(&each);
    }
    std::stable_partition(externs.begin(), externs.end(), [](const auto* each) { return each->with.empty(); });

    std::vector<EngineBlockInfo> blocks;
    EngineBlockInfo textures;
    for (const paths::ExternDecl* each : externs) {
        EngineBlockInfo* block = each->block.empty() ? &textures : &block_named(blocks, each->block);
        Doc doc = read_doc(each->variable->doc);
        if (!doc.block.empty()) block->doc = one_line(std::move(doc.block));
        block->values.push_back({.name = std::string(each->variable->name),
                                 .type = type_of(each->variable->type, library.sources),
                                 .doc = one_line(std::move(doc.text)),
                                 .unit = std::move(doc.unit),
                                 .space = std::move(doc.space),
                                 .with = {each->with.begin(), each->with.end()},
                                 .is_of_object = each->is_per_object});
    }
    if (!textures.values.empty()) blocks.push_back(std::move(textures));
    return blocks;
}

}  // namespace patina

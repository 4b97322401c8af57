#include "compiler/engines/engine.h"

#include <algorithm>

namespace patina::engines {
namespace {

bool is_in(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string_view Engine::own_path(std::string_view wanted) const {
    const bool has_it = std::find(paths.begin(), paths.end(), wanted) != paths.end();
    return has_it || paths.empty() ? wanted : std::string_view(paths.front());
}

std::string_view Engine::block_name(std::string_view block) const {
    const auto found = blocks.find(block);
    return found == blocks.end() ? block : std::string_view(found->second);
}

const VertexInput* Engine::vertex_input(std::string_view semantic) const {
    const auto found = std::find_if(vertex_inputs.begin(), vertex_inputs.end(),
                                    [&](const VertexInput& input) { return input.semantic == semantic; });
    return found == vertex_inputs.end() ? nullptr : &*found;
}

std::string_view Engine::stored_as(std::string_view type) const {
    const auto found = storage.find(type);
    return found == storage.end() ? std::string_view() : std::string_view(found->second);
}

std::string_view Engine::function_name(std::string_view function) const {
    const auto found = names.instead.find(function);
    return found == names.instead.end() ? function : std::string_view(found->second);
}

std::string_view Engine::declarer_of(std::string_view name) const {
    if (is_in(names.own, name) || is_in(names.own_near_properties, name)) return "the file itself";
    const bool has_prefix = std::any_of(names.prefixes.begin(), names.prefixes.end(),
                                        [&](const std::string& prefix) { return name.starts_with(prefix); });
    return has_prefix || is_in(names.taken, name) ? std::string_view(names.owner) : std::string_view();
}

}  // namespace patina::engines

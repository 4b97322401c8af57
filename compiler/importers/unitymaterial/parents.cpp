#include "compiler/importers/unitymaterial/parents.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace patina::importers::unitymaterial {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDeepest = 32;
constexpr int kOwnQueue = 16;  // of m_ModifiedSerializedProperties

template <class Saved>
void inherit(std::map<std::string, Saved>& own, const std::map<std::string, Saved>& from, const std::string& file,
             std::map<std::string, std::string>& origins) {
    for (const auto& [name, saved] : from) {
        const auto [made, is_new] = own.try_emplace(name, saved);
        if (!is_new) continue;
        made->second.place = {};
        origins[name] = file;
    }
}

bool has_own_queue(const MaterialFile& material) {
    const Setting* modified = material.setting("m_ModifiedSerializedProperties");
    int flags = 0;
    if (modified) std::from_chars(modified->text.data(), modified->text.data() + modified->text.size(), flags);
    return material.parent.is_none() || (flags & kOwnQueue) != 0;
}

void inherit(MaterialFile& own, const MaterialFile& from, const std::string& file, bool takes_queue) {
    if (own.shader.is_none()) own.shader = from.shader;
    inherit(own.numbers, from.numbers, file, own.origins);
    inherit(own.colors, from.colors, file, own.origins);
    inherit(own.textures, from.textures, file, own.origins);
    if (own.keywords.empty() && own.invalid_keywords.empty()) {
        own.keywords = from.keywords;
        for (SavedKeyword& each : own.keywords) each.place = {};
    }
    const Setting* queue = from.setting("m_CustomRenderQueue");
    const auto own_queue = std::ranges::find(own.settings, "m_CustomRenderQueue", &Setting::key);
    if (takes_queue && queue && own_queue != own.settings.end()) own_queue->text = queue->text;
    for (Problem each : from.problems) {
        each.file = file;
        own.problems.push_back(std::move(each));
    }
}

}  // namespace

MaterialFile read_with_parents(const std::string& path, Assets& assets) {
    MaterialFile made = read_material(path);
    std::vector<std::string> chain = {path};
    bool takes_queue = made.error.empty() && !has_own_queue(made);
    while (made.error.empty() && !made.parent.is_none()) {
        const auto located = [&](std::string_view text) {
            made.error = fmt::format("{}:{}:{}: {}", path, made.parent_place.line, made.parent_place.column, text);
        };
        const auto found = assets.find(made.parent.guid, "", kMaterials);
        if (!found) return made;
        const auto is_same = [&](const std::string& each) {
            std::error_code wrong;
            return fs::equivalent(each, found->path, wrong);
        };
        if (std::ranges::any_of(chain, is_same)) {
            located(fmt::format("m_Parent: the material is a variant of itself, by '{}'", chain.back()));
        } else if (chain.size() > kDeepest) {
            located(fmt::format("m_Parent: more than {} materials are variants of one another", kDeepest));
        } else {
            const MaterialFile parent = read_material(found->path, false);
            const std::string file = fs::path(found->path).filename().string();
            if (!parent.error.empty()) {
                made.error = parent.error;
                break;
            }
            if (!found->other.empty())
                made.problems.push_back(
                    {.part = fmt::format("parent '{}'", file),
                     .text = fmt::format("'{}' has the same GUID as '{}', which is taken", found->other, found->path),
                     .place = made.parent_place});
            chain.push_back(found->path);
            made.parents.push_back(file);
            inherit(made, parent, file, takes_queue);
            takes_queue = takes_queue && !has_own_queue(parent);
            made.parent = parent.parent;
        }
    }
    return made;
}

}  // namespace patina::importers::unitymaterial

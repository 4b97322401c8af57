#include "compiler/edit/blame.h"

#include <algorithm>
#include <map>

#include "compiler/base/letters.h"

namespace patina::edit {
namespace {

using nodelang::Expr;
using Names = std::set<std::string, std::less<>>;

constexpr std::size_t kMostDistances = 64;

bool is_word(char c) {
    return is_word_letter(c) || c == '-';
}

void add_words(std::string_view text, Names& words) {
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_word(text[end])) ++end;
        if (end > i) words.emplace(text.substr(i, end - i));
        i = std::max(end, i + 1);
    }
}

void add_names(const Expr& expr, Names& names) {
    if (expr.kind == Expr::Kind::Name || expr.kind == Expr::Kind::Property) names.emplace(expr.text);
    for (const Expr* argument : expr.args) add_names(*argument, names);
}

std::uint32_t offset_of(const GraphText& text, int line, int column) {
    std::string_view all = text.all();
    std::size_t at = 0;
    for (int i = 1; i < line && at != all.npos; ++i) at = all.find('\n', at) + 1;
    return text.base + static_cast<std::uint32_t>(at) + static_cast<std::uint32_t>(column - 1);
}

// The name of the thing that a place belongs to: the node, the property, the port.
std::string_view thing_of(const Path& path) {
    return path.size() < 2 ? std::string_view() : std::string_view(path[1]);
}

bool is_text(const TreeValue& value, const Names& words) {
    return value && value.json->kind == json::Json::Kind::String && words.count(value.json->string) != 0;
}

bool has_child(const TreeValue& value, const Names& names) {
    if (!value) return false;
    const std::vector<TreeChild> children = children_of(value);
    return std::any_of(children.begin(), children.end(),
                       [&](const TreeChild& child) { return names.count(child.name) != 0; });
}

bool is_about(const TreeChange& change, const Names& names) {
    if (names.count(thing_of(change.path))) return true;
    if (change.path.size() == 1 && (has_child(change.before, names) || has_child(change.after, names))) return true;
    return is_text(change.before, names) || is_text(change.after, names);
}

// What each thing of the graphs reads.
std::map<std::string, Names, std::less<>> reads_of(const MergeError& where) {
    std::map<std::string, Names, std::less<>> reads;
    const auto add = [&](const GraphText& text) {
        if (!text.graph) return;
        for (const PlacedExpr& placed : expressions_of(*text.graph))
            add_names(*placed.expr, reads[std::string(thing_of(placed.path))]);
    };
    add(where.merged);
    for (const GraphText* other : where.others) {
        if (other) add(*other);
    }
    return reads;
}

class Search {
public:
    explicit Search(std::span<const TreeChange> changes) : changes_(changes), is_found_(changes.size(), false) {}

    template <class Condition>
    void add_distance(const Condition& condition) {
        std::vector<std::size_t> found;
        for (std::size_t i = 0; i < changes_.size(); ++i) {
            if (is_found_[i] || !condition(changes_[i])) continue;
            is_found_[i] = true;
            found.push_back(i);
        }
        if (!found.empty()) suspects.push_back(std::move(found));
    }

    Suspects suspects{};

private:
    std::span<const TreeChange> changes_;
    std::vector<bool> is_found_;
};

}  // namespace

Suspects find_suspects(const MergeError& where, std::span<const TreeChange> changes) {
    const Diagnostic& error = where.error;
    Path place;
    Names names;
    if (error.line > 0 && error.file == where.merged.sources.file(where.merged.base)) {
        place = path_at(where.merged, offset_of(where.merged, error.line, error.column));
    } else if (!error.node.empty()) {
        place = {"nodes", error.node.substr(0, error.node.find('/'))};  // of an error inside a sub-graph: its node
    }
    add_words(error.message, names);
    for (const Diagnostic& note : error.notes) add_words(note.message, names);

    Search search(changes);
    if (!place.empty()) {
        search.add_distance([&](const TreeChange& change) {
            return !change.is_order && (starts_with(place, change.path) || starts_with(change.path, place));
        });
    }
    const auto reads = reads_of(where);
    Names seen;
    for (std::size_t distance = 0; distance < kMostDistances && !names.empty(); ++distance) {
        search.add_distance([&](const TreeChange& change) { return !change.is_order && is_about(change, names); });
        Names next;
        if (distance == 0) next.emplace(thing_of(place));
        for (const std::string& name : names) {
            if (!seen.insert(name).second) continue;
            const auto found = reads.find(name);
            if (found != reads.end()) next.insert(found->second.begin(), found->second.end());
        }
        if (distance == 0) {
            const auto found = reads.find(thing_of(place));
            if (found != reads.end()) next.insert(found->second.begin(), found->second.end());
        }
        names = std::move(next);
    }
    search.add_distance([](const TreeChange& change) { return !change.is_order; });
    search.add_distance([](const TreeChange&) { return true; });
    return std::move(search.suspects);
}

}  // namespace patina::edit

#include "compiler/edit/merge_comments.h"

#include <algorithm>

#include "compiler/edit/text_edits.h"

namespace patina::edit {
namespace {

template <class Visit>
void for_each_comment(const json::Json& json, const Visit& visit) {
    if (json.comments) {
        for (const std::string& comment : json.comments->before) visit(comment, json);
        visit(json.comments->trailing, json);
        for (const std::string& comment : json.comments->end) visit(comment, json);
    }
    for (const json::Json& element : json.elements) for_each_comment(element, visit);
    for (const json::JsonMember& member : json.members) for_each_comment(member.value, visit);
}

// Without blank lines above and below.
std::vector<std::string> before(const TreeValue& value) {
    if (!value.json->comments) return {};
    std::vector<std::string> lines = value.json->comments->before;
    const auto is_text = [](const std::string& line) { return !line.empty(); };
    lines.erase(lines.begin(), std::find_if(lines.begin(), lines.end(), is_text));
    lines.erase(std::find_if(lines.rbegin(), lines.rend(), is_text).base(), lines.end());
    return lines;
}

std::string trailing(const TreeValue& value) {
    return value.json->comments ? value.json->comments->trailing : std::string();
}

// One value in the merged text and in the three input texts; the base may lack it.
struct Four {
    TreeValue merged{}, base{}, ours{}, theirs{};

    // True if the merge has the comments of OURS, and those of THEIRS are newer. `of`: some of a value's comments.
    template <class Of>
    bool takes_theirs(const Of& of) const {
        if (of(merged) != of(ours) || of(theirs) == of(ours)) return false;
        return base ? of(base) == of(ours) : is_same(merged, theirs) && !is_same(merged, ours);
    }
};

class Comments {
public:
    Comments(const SourceMap& sources, std::vector<TextEdit>& edits) : sources_(sources), edits_(edits) {}

    void take_in(const Four& parents) {
        if (shape_of(parents.merged) == Shape::Whole) return;
        std::unordered_map<std::string, Four> by_name;
        add(parents.base, by_name, &Four::base);
        add(parents.ours, by_name, &Four::ours);
        add(parents.theirs, by_name, &Four::theirs);
        std::vector<ChildComments> taken;
        const std::vector<TreeChild> children = children_of(parents.merged);
        for (std::size_t i = 0; i < children.size(); ++i) {
            Four child = by_name[children[i].name];
            child.merged = children[i].value;
            if (!child.ours || !child.theirs) continue;
            ChildComments comments{.child = i};
            if (child.takes_theirs(before)) comments.before = before(child.theirs);
            if (child.takes_theirs(trailing)) comments.trailing = trailing(child.theirs);
            if (comments.before || comments.trailing) taken.push_back(std::move(comments));
            take_in(child);
        }
        if (!taken.empty()) replace_comments(sources_, *parents.merged.json, taken, edits_);
    }

private:
    static void add(const TreeValue& parent, std::unordered_map<std::string, Four>& by_name, TreeValue Four::*member) {
        if (!parent) return;
        for (TreeChild& child : children_of(parent)) by_name[std::move(child.name)].*member = child.value;
    }

    const SourceMap& sources_;
    std::vector<TextEdit>& edits_;
};

}  // namespace

std::string with_comments(const SameNames& names, std::string merged) {
    const std::unique_ptr<GraphText> text = read_graph_text("", std::move(merged));
    std::vector<TextEdit> edits;
    const Four roots{text->root(), names.base->root(), names.ours->root(), names.theirs->root()};
    Comments(text->sources, edits).take_in(roots);
    if (roots.takes_theirs(before)) {  // at the beginning of the file
        std::string made;
        for (const std::string& comment : before(roots.theirs)) made += comment + '\n';
        edits.push_back({{text->base, text->json->span.begin}, std::move(made)});
    }
    return apply(text->sources, text->base, std::move(edits));
}

std::vector<std::pair<std::string, Span>> lost_comments(const GraphText& base, const GraphText& theirs,
                                                        const std::string& merged) {
    std::set<std::string> known;
    const auto add = [&](const GraphText& text) {
        if (text.json)
            for_each_comment(*text.json, [&](const std::string& comment, const json::Json&) { known.insert(comment); });
    };
    add(base);
    std::vector<std::pair<std::string, Span>> lost;
    const auto find_lost = [&] {
        lost.clear();
        for_each_comment(*theirs.json, [&](const std::string& comment, const json::Json& owner) {
            if (!comment.empty() && !known.count(comment)) lost.emplace_back(comment, owner.span);
        });
    };
    find_lost();
    if (lost.empty()) return lost;
    add(*read_graph_text("", merged));
    find_lost();
    return lost;
}

}  // namespace patina::edit

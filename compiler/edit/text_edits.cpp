#include "compiler/edit/text_edits.h"

#include <algorithm>
#include <cassert>

#include "compiler/format/canonical_form.h"
#include "compiler/json/json_text.h"

namespace patina::edit {
namespace {

constexpr std::size_t kIndent = 2;

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

std::size_t count_of(const json::Json& container) {
    return container.kind == json::Json::Kind::Object ? container.members.size() : container.elements.size();
}

const json::Json& child_of(const json::Json& container, std::size_t i) {
    return container.kind == json::Json::Kind::Object ? container.members[i].value : container.elements[i];
}

// Where the parts of a child are.
struct Child {
    std::uint32_t begin = 0;      // its first comment, or its key, or its value
    std::uint32_t core = 0;       // its key, or its value
    std::uint32_t value_end = 0;  // behind the value
    std::uint32_t comma = 0;      // the comma behind it; 0: there is none
    std::uint32_t end = 0;        // behind the comma and the comments that trail
};

// The text of one file, read a second time between two values: the tree has comments, but not their places.
class Text {
public:
    Text(const SourceMap& sources, const json::Json& container)
        : base_(container.span.begin), text_(sources.text(container.span)), before_(sources.text_before(base_)) {
        const std::size_t count = count_of(container);
        std::uint32_t from = container.span.begin + 1;
        for (std::size_t i = 0; i <= count; ++i) {
            const bool is_last = i == count;
            const std::uint32_t to = is_last ? container.span.end - 1
                                     : container.kind == json::Json::Kind::Object
                                         ? container.members[i].key_span.begin - 1
                                         : container.elements[i].span.begin;
            const json::JsonComments* comments =
                is_last ? container.comments.get() : child_of(container, i).comments.get();
            std::size_t own = 0;
            if (comments) {
                const std::vector<std::string>& list = is_last ? comments->end : comments->before;
                own = static_cast<std::size_t>(
                    std::count_if(list.begin(), list.end(), [](const std::string& c) { return !c.empty(); }));
            }
            read_gap(from, to, own, is_last);
            if (!is_last) from = children_.back().value_end = child_of(container, i).span.end;
        }
    }

    const std::vector<Child>& children() const { return children_; }
    std::uint32_t inside_end() const { return inside_end_; }  // behind the last comment before the closing bracket
    bool has_comments_at_end() const { return comments_at_end_; }

    char at(std::uint32_t offset) const { return text_[offset - base_]; }
    std::string_view text(std::uint32_t begin, std::uint32_t end) const {
        return text_.substr(begin - base_, end - begin);
    }
    std::uint32_t begin() const { return base_; }
    std::uint32_t end() const { return base_ + static_cast<std::uint32_t>(text_.size()); }

    // If only white space is before it on its line: where the line begins. Else 0.
    std::uint32_t line_start(std::uint32_t offset) const {
        while (offset > base_ && is_blank(at(offset - 1))) --offset;
        return offset > base_ && at(offset - 1) == '\n' ? offset : 0;
    }
    // If only white space follows on its line: where the next line begins. Else 0.
    std::uint32_t next_line(std::uint32_t offset) const {
        while (offset < end() && is_blank(at(offset))) ++offset;
        return offset < end() && at(offset) == '\n' ? offset + 1 : 0;
    }
    // The white space that the line of a place begins with.
    std::string indent_at(std::uint32_t offset) const {
        const std::string_view file(before_.data(), before_.size() + text_.size());
        const std::size_t place = before_.size() + (offset - base_);
        const std::size_t line = place == 0 ? 0 : file.rfind('\n', place - 1) + 1;
        std::size_t end = line;
        while (end < file.size() && is_blank(file[end])) ++end;
        return std::string(file.substr(line, end - line));
    }

private:
    // Comments and the comma from a value's end to the next child. Of the comments, the last `own` belong to that
    // child.
    void read_gap(std::uint32_t from, std::uint32_t to, std::size_t own, bool is_last) {
        std::vector<Span> comments;
        std::uint32_t comma = 0;
        for (std::uint32_t i = from; i < to;) {
            if (at(i) == '/') {
                const std::string_view rest = text(i, to);
                const std::size_t length =
                    rest[1] == '/' ? std::min(rest.find('\n'), rest.size()) : rest.find("*/", 2) + 2;
                comments.push_back({i, i + static_cast<std::uint32_t>(length)});
                i = comments.back().end;
                continue;
            }
            if (at(i) == ',') comma = i;
            ++i;
        }
        own = std::min(own, comments.size());
        const std::size_t trailing = children_.empty() ? 0 : comments.size() - own;
        if (!children_.empty()) {
            Child& before = children_.back();
            before.comma = comma;
            before.end = comma ? comma + 1 : before.value_end;
            if (trailing > 0) before.end = std::max(before.end, trimmed_end(comments[trailing - 1]));
        }
        if (!is_last) {
            children_.push_back({.begin = comments.size() > trailing ? comments[trailing].begin : to, .core = to});
            return;
        }
        comments_at_end_ = comments.size() > trailing;
        inside_end_ = comments_at_end_ ? trimmed_end(comments.back()) : children_.empty() ? from : children_.back().end;
    }

    // A line comment may end with a carriage return.
    std::uint32_t trimmed_end(Span comment) const {
        while (is_blank(at(comment.end - 1))) --comment.end;
        return comment.end;
    }

    std::uint32_t base_;
    std::string_view text_, before_;
    std::vector<Child> children_{};
    std::uint32_t inside_end_ = 0;
    bool comments_at_end_ = false;
};

// A layout for the children of a container: each on a line of its own, or all on one line.
struct Style {
    bool lines = false;
    std::string indent{};   // of the children
    std::string closing{};  // of the line of the closing bracket
};

Style style_of(const Text& text, bool is_object) {
    Style style;
    style.closing = text.indent_at(text.begin());
    style.indent = style.closing + std::string(kIndent, ' ');
    const std::vector<Child>& children = text.children();
    if (children.empty()) {
        style.lines = !is_object || text.has_comments_at_end();
    } else if (text.line_start(children.front().core)) {
        style.lines = true;
        style.indent = text.indent_at(children.front().core);
    }
    return style;
}

struct ChildText {
    std::string before{}, value{},
        trailing{};  // comments above it, one a line; the key and the value; a comment behind
    bool needs_lines() const { return !before.empty() || !trailing.empty() || value.find('\n') != std::string::npos; }
};

ChildText text_of(const NewChild& child, bool is_object, const std::string& indent) {
    ChildText made;
    if (child.value.json.comments) {
        for (const std::string& comment : child.value.json.comments->before) {
            if (!comment.empty()) made.before += comment + "\n" + indent;
        }
        made.trailing = child.value.json.comments->trailing;
    }
    if (is_object) {
        json::append_quoted(made.value, child.key);
        made.value += ": ";
    }
    made.value +=
        format::layout_value(child.value.json, child.value.sources, indent.size(), indent.size() + made.value.size());
    return made;
}

// What a removed child takes with it.
Span removed_span(const Text& text, const std::vector<bool>& stays, std::size_t i) {
    const std::vector<Child>& children = text.children();
    const Child& child = children[i];
    const bool is_last = i + 1 == children.size();
    const std::uint32_t line = text.line_start(child.begin), next = text.next_line(child.end);
    if (line && next) {
        // Of two blank lines around it, one goes; and one before the closing bracket.
        const std::uint32_t blank_line = text.line_start(line - 1);
        const bool joins = is_last ? !text.has_comments_at_end() : text.next_line(next) != 0;
        return {blank_line && joins ? blank_line : line, next};
    }
    const auto rest = stays.begin() + static_cast<std::ptrdiff_t>(i);
    const bool is_followed = std::find(rest, stays.end(), true) != stays.end();
    if (is_followed && !text.line_start(children[i + 1].begin)) return {child.begin, children[i + 1].begin};
    std::size_t kept = i;
    while (kept > 0 && !stays[kept - 1]) --kept;
    return {kept == 0 ? text.begin() + 1 : children[kept - 1].end, child.end};
}

}  // namespace

std::string apply(const SourceMap& sources, std::uint32_t base, std::vector<TextEdit> edits) {
    std::stable_sort(edits.begin(), edits.end(),
                     [](const TextEdit& a, const TextEdit& b) { return a.span.begin < b.span.begin; });
    const std::string_view text = sources.file_text(base);
    std::string out;
    std::uint32_t at = base;
    for (const TextEdit& edit : edits) {
        assert(edit.span.begin >= at && edit.span.end >= edit.span.begin);
        out += text.substr(at - base, edit.span.begin - at);
        out += edit.text;
        at = edit.span.end;
    }
    return out += text.substr(at - base);
}

void replace_value(const SourceMap& sources, const json::Json& old_value, const ValueText& new_value,
                   std::vector<TextEdit>& edits) {
    const std::string_view before = sources.text_before(old_value.span.begin);
    const std::string_view line = before.substr(before.rfind('\n') + 1);
    std::size_t indent = 0;
    while (indent < line.size() && is_blank(line[indent])) ++indent;
    edits.push_back({old_value.span, format::layout_value(new_value.json, new_value.sources, indent, line.size())});
}

void edit_children(const SourceMap& sources, const json::Json& container, const ChildEdits& changes,
                   std::vector<TextEdit>& edits) {
    const Text text(sources, container);
    const bool is_object = container.kind == json::Json::Kind::Object;
    const std::vector<Child>& children = text.children();
    const Style style = style_of(text, is_object);
    std::vector<bool> stays(children.size(), true);
    for (const std::size_t i : changes.removed) stays[i] = false;

    // New children follow one that stays.
    std::vector<std::vector<const NewChild*>> added(children.size() + 1);  // [0]: first
    for (std::size_t i = 0; i <= children.size(); ++i) {
        std::size_t place = i;
        while (place > 0 && !stays[place - 1]) --place;
        for (const NewChild& child : changes.added) {
            if (child.after + 1 == i) added[place].push_back(&child);
        }
    }
    std::size_t left = changes.added.size() + static_cast<std::size_t>(std::count(stays.begin(), stays.end(), true));
    if (left == 0 && !text.has_comments_at_end()) {
        edits.push_back({{text.begin() + 1, text.end() - 1}, ""});
        return;
    }
    const bool comma_at_end = !children.empty() && children.back().comma != 0;
    const auto needs_comma = [&] { return --left > 0 || comma_at_end; };

    const auto add_all = [&](std::size_t place, std::uint32_t offset) {
        std::string made;
        for (const NewChild* child : added[place]) {
            const ChildText of_child = text_of(*child, is_object, style.indent);
            const bool ends_line = text.next_line(offset) != 0;
            const bool lines = style.lines || of_child.needs_lines() || ends_line;
            made += lines ? "\n" + style.indent + of_child.before : " ";
            made += of_child.value;
            if (needs_comma()) made += ',';
            if (!of_child.trailing.empty()) made += ' ' + of_child.trailing;
            if (lines && !style.lines && !ends_line) made += "\n" + style.closing;
        }
        if (made.empty()) return;
        if (children.empty()) {  // `{}` has no white space before its closing bracket
            const bool ends_line = text.next_line(offset) != 0;
            if (!ends_line) made += style.lines ? "\n" + style.closing : " ";
            const std::uint32_t end = text.has_comments_at_end() || ends_line ? offset : text.end() - 1;
            edits.push_back({{offset, end}, std::move(made)});
            return;
        }
        if (place == 0 && children.front().begin == offset && made.back() != '\n') made += ' ';  // `{"a": 1}`
        edits.push_back({{offset, offset}, std::move(made)});
    };

    add_all(0, children.empty() ? text.inside_end() : text.begin() + 1);
    std::uint32_t removed_end = 0;
    for (std::size_t i = 0; i < children.size(); ++i) {
        const Child& child = children[i];
        if (!stays[i]) {
            Span span = removed_span(text, stays, i);
            span.begin = std::max(span.begin, removed_end);
            removed_end = span.end;
            edits.push_back({span, ""});
            continue;
        }
        const bool needs = needs_comma();
        if (needs && !child.comma) edits.push_back({{child.value_end, child.value_end}, ","});
        if (!needs && child.comma) edits.push_back({{child.comma, child.comma + 1}, ""});
        add_all(i + 1, child.end);
    }
}

void replace_comments(const SourceMap& sources, const json::Json& container, const std::vector<ChildComments>& comments,
                      std::vector<TextEdit>& edits) {
    const Text text(sources, container);
    for (const ChildComments& each : comments) {
        const Child& child = text.children()[each.child];
        if (each.before && text.line_start(child.begin)) {
            const std::string indent = text.indent_at(child.begin);
            std::string made;
            for (const std::string& comment : *each.before) {
                if (!comment.empty()) made += (made.empty() ? "" : indent) + comment;
                if (!made.empty()) made += '\n';
            }
            if (!made.empty()) made += indent;
            edits.push_back({{child.begin, child.core}, std::move(made)});
        }
        if (each.trailing && text.next_line(child.end)) {
            const std::string comma = child.comma ? "," : "";
            edits.push_back(
                {{child.value_end, child.end}, each.trailing->empty() ? comma : comma + ' ' + *each.trailing});
        }
    }
}

void reorder_children(const SourceMap& sources, const json::Json& container, const std::vector<std::size_t>& order,
                      std::vector<TextEdit>& edits) {
    const Text text(sources, container);
    const std::vector<Child>& children = text.children();
    assert(order.size() == children.size());
    const auto behind = [](const Child& child) { return child.comma ? child.comma + 1 : child.value_end; };
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (order[i] == i) continue;
        const Child &to = children[i], &from = children[order[i]];
        edits.push_back({{to.begin, to.value_end}, std::string(text.text(from.begin, from.value_end))});
        edits.push_back({{behind(to), to.end}, std::string(text.text(behind(from), from.end))});
    }
}

}  // namespace patina::edit

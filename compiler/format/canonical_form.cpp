#include "compiler/format/canonical_form.h"

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/format/keys.h"
#include "compiler/json/json_text.h"

namespace patina::format {
namespace {

constexpr std::size_t kWidth = 110;
constexpr std::size_t kIndent = 2;

// --- key order

std::size_t rank(std::span<const KeyInfo> keys, std::string_view name) {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const KeyInfo& key) { return key.name == name; });
    return static_cast<std::size_t>(found - keys.begin());  // unknown keys go last, in their own order
}

void sort_keys(json::Json& json, ObjectKind kind) {
    for (json::Json& element : json.elements) sort_keys(element, kind);
    const std::span<const KeyInfo> keys = keys_of(kind);
    std::stable_sort(
        json.members.begin(), json.members.end(),
        [&](const json::JsonMember& a, const json::JsonMember& b) { return rank(keys, a.key) < rank(keys, b.key); });
    for (json::JsonMember& member : json.members) {
        const KeyInfo* key = find_key(kind, member.key);
        sort_keys(member.value, key ? value_kind(*key, member.value) : ObjectKind::Free);
    }
}

// --- layout

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

const json::JsonComments& comments_of(const json::Json& json) {
    static const json::JsonComments kNone;
    return json.comments ? *json.comments : kNone;
}

bool has_text(const std::vector<std::string>& comments) {
    return std::any_of(comments.begin(), comments.end(), [](const std::string& comment) { return !comment.empty(); });
}

// Version control merges by line, so each property, node and input has a line of its own.
bool is_list_of_objects(const json::Json& json) {
    return std::any_of(json.elements.begin(), json.elements.end(),
                       [](const json::Json& element) { return element.kind == json::Json::Kind::Object; });
}

// A value that holds comments cannot be written on one line.
bool must_break(const json::Json& json) {
    const auto breaks = [](const json::Json& child) {
        return has_text(comments_of(child).before) || !comments_of(child).trailing.empty() || must_break(child);
    };
    return is_list_of_objects(json) || has_text(comments_of(json).end) ||
           std::any_of(json.elements.begin(), json.elements.end(), breaks) ||
           std::any_of(json.members.begin(), json.members.end(),
                       [&](const json::JsonMember& member) { return breaks(member.value); });
}

class Layout {
public:
    explicit Layout(const SourceMap& sources) : sources_(sources) {}

    std::string write_file(const json::Json& root) {
        for (const std::string& comment : comments_of(root).before) {
            if (!comment.empty() || !out_.empty()) out_ += comment + '\n';
        }
        const bool is_container = !root.members.empty() || !root.elements.empty() || has_text(comments_of(root).end);
        if (is_container) {
            write_broken(root, 0);
        } else {
            json::append_one_line(out_, root, sources_);
        }
        out_ += '\n';
        if (const std::string& after = comments_of(root).trailing; !after.empty()) out_ += after + '\n';
        return std::move(out_);
    }

    std::string write_part(const json::Json& value, std::size_t indent, std::size_t column) {
        out_.assign(column, ' ');
        write_value(value, indent);
        return out_.substr(column);
    }

private:
    // The value starts at the end of `out_`, on a line that is indented by `indent`.
    void write_value(const json::Json& json, std::size_t indent) {
        Cancellation::step();
        if (!write_on_one_line(json)) write_broken(json, indent);
    }

    bool write_on_one_line(const json::Json& json) {
        const bool is_container = json.kind == json::Json::Kind::Array || json.kind == json::Json::Kind::Object;
        const std::size_t line_start = out_.rfind('\n') + 1;
        const std::size_t before = out_.size();
        const std::size_t limit = is_container ? line_start + 4 * kWidth : std::string::npos;  // UTF-8: 4 bytes at most
        const bool written = json::append_one_line(out_, json, sources_, limit);
        if (!is_container) return true;
        constexpr std::size_t kComma = 1;
        const std::size_t width = columns(std::string_view(out_).substr(line_start)) + kComma;
        if (written && width <= kWidth && !must_break(json)) return true;
        out_.resize(before);
        return false;
    }

    void new_line(std::size_t indent) {
        out_ += '\n';
        out_.append(indent, ' ');
    }

    void write_comments(const std::vector<std::string>& comments, std::size_t indent, bool first) {
        for (const std::string& comment : comments) {
            if (comment.empty()) {
                if (!first) out_ += '\n';
                continue;
            }
            new_line(indent);
            out_ += comment;
            first = false;
        }
    }

    void write_broken(const json::Json& json, std::size_t indent) {
        const bool is_object = json.kind == json::Json::Kind::Object;
        const std::size_t count = is_object ? json.members.size() : json.elements.size();
        const std::size_t inner = indent + kIndent;
        out_ += is_object ? '{' : '[';
        for (std::size_t i = 0; i < count; ++i) {
            const json::Json& value = is_object ? json.members[i].value : json.elements[i];
            write_comments(comments_of(value).before, inner, i == 0);
            new_line(inner);
            if (is_object) {
                json::append_quoted(out_, json.members[i].key);
                out_ += ": ";
            }
            write_value(value, inner);
            if (i + 1 < count) out_ += ',';
            const std::string& trailing = comments_of(value).trailing;
            if (!trailing.empty()) out_ += ' ' + trailing;
        }
        write_comments(comments_of(json).end, inner, count == 0);
        new_line(indent);
        out_ += is_object ? '}' : ']';
    }

    const SourceMap& sources_;
    std::string out_;
};

}  // namespace

FormattedText format_graph(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    const std::unique_ptr<json::Json> root = json::parse_json(sources, base, diagnostics);
    if (!root || diagnostics.error_count() > errors_before) return {};
    sort_keys(*root, top_level_kind(*root));
    return {.ok = true, .text = layout_json(*root, sources)};
}

std::string layout_json(const json::Json& root, const SourceMap& sources) {
    return Layout(sources).write_file(root);
}

std::string layout_value(const json::Json& value, const SourceMap& sources, std::size_t indent, std::size_t column) {
    return Layout(sources).write_part(value, indent, column);
}

}  // namespace patina::format

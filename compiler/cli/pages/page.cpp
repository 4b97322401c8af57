#include "compiler/cli/pages/page.h"

#include <fmt/format.h>

#include <algorithm>

namespace patina::cli {
namespace {

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    }
    return result;
}

std::string indented(std::string_view text, std::string_view indent) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string_view line = text.substr(0, end);
        result += line.empty() ? std::string("\n") : std::string(indent) + std::string(line) + "\n";
        text = end == text.npos ? std::string_view() : text.substr(end + 1);
    }
    return result;
}

std::string joined_lines(std::string_view text) {
    std::string line(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

// --- the terminal

std::string entry_text(const Console& console, const Entry& entry) {
    std::string text = "  " + heading(console, entry.name);
    if (!entry.type.empty()) text += "  " + entry.type;
    if (!entry.facts.empty()) text += "  (" + entry.facts + ")";
    text += "\n" + indented(entry.doc, "      ");
    std::size_t width = 0;
    for (const auto& [name, doc] : entry.choices) width = std::max(width, name.size());
    for (const auto& [name, doc] : entry.choices) text += fmt::format("      {:<{}}  {}\n", name, width, doc);
    return text;
}

// --- Markdown

std::string cell(std::string_view text) {
    return escaped(joined_lines(text));
}

// A bar ends a table's cell, also inside of code.
std::string code_span(std::string_view text) {
    std::string span;
    for (char c : joined_lines(text)) span += c == '|' ? std::string("\\|") : std::string(1, c);
    return span.empty() ? span : "`" + span + "`";
}

// Columns that are empty in every row are left out.
std::string table(const Section& section) {
    std::vector<std::array<std::string, 4>> rows;
    for (const Entry& entry : section.entries) {
        std::string doc = cell(entry.doc);
        for (const auto& [name, what] : entry.choices) {
            doc += (doc.empty() ? "" : "<br>") + code_span(name) + (what.empty() ? "" : ": " + cell(what));
        }
        const std::string type =
            entry.link.empty() ? cell(entry.type) : "[" + cell(entry.type) + "](" + entry.link + ")";
        rows.push_back(
            {code_span(entry.name), type, section.has_code_facts ? code_span(entry.facts) : cell(entry.facts), doc});
    }
    std::string head, rule, body;
    std::array<bool, 4> shown{};
    for (std::size_t c = 0; c < shown.size(); ++c) {
        shown[c] = std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return !row[c].empty(); });
        if (!shown[c]) continue;
        head += "| " + section.columns[c] + " ";
        rule += "|---";
    }
    for (const auto& row : rows) {
        for (std::size_t c = 0; c < shown.size(); ++c) {
            if (shown[c]) body += "| " + row[c] + " ";
        }
        body += "|\n";
    }
    return head + "|\n" + rule + "|\n" + body;
}

// A bar ends a cell of a table; the others are Markdown's own characters.
constexpr std::string_view kMarks = "\\*_<>|";

}  // namespace

std::string to_terminal(const Console& console, const Page& page) {
    std::string text = heading(console, page.title) + (page.place.empty() ? "" : "  " + page.place) + "\n";
    for (const Section& section : page.sections) {
        std::string body = indented(section.text, "  ") + indented(section.code, "  ");
        for (const Entry& entry : section.entries) body += entry_text(console, entry);
        if (body.empty()) continue;
        text += "\n" + heading(console, section.title.empty() ? "DESCRIPTION" : upper(section.title)) + "\n" + body;
    }
    return text;
}

std::string to_markdown(const Page& page, const std::string& index) {
    std::string text = std::string(kWritten) + "# " + page.title + "\n\n";
    if (!index.empty()) text += "[" + (page.place.empty() ? std::string("All") : page.place) + "](" + index + ")\n\n";
    for (const Section& section : page.sections) {
        const bool is_empty = section.text.empty() && section.code.empty() && section.entries.empty();
        if (is_empty && section.pictures.empty()) continue;
        if (!section.title.empty()) text += "## " + section.title + "\n\n";
        const std::string words = escaped(section.text);
        if (!words.empty()) text += (section.link.empty() ? words : "[" + words + "](" + section.link + ")") + "\n\n";
        if (!section.code.empty()) text += "```" + section.language + "\n" + section.code + "\n```\n\n";
        if (!section.entries.empty()) text += table(section) + "\n";
        for (const Picture& picture : section.pictures) {
            text += "![" + escaped(picture.caption) + "](" + picture.path + ")\n\n";
        }
    }
    text.pop_back();
    return text;
}

std::string escaped(std::string_view text) {
    std::string result;
    bool in_code = false;
    for (char c : text) {
        if (c == '`') in_code = !in_code;
        if (!in_code && kMarks.find(c) != kMarks.npos) result += '\\';
        result += c;
    }
    return result;
}

std::string first_sentence(std::string_view text) {
    std::string sentence = joined_lines(text.substr(0, text.find("\n\n")));
    std::size_t stop = sentence.find(". ");
    // "Rec. 709" does not end a sentence.
    while (stop != sentence.npos && stop + 2 < sentence.size() && sentence[stop + 2] >= '0' &&
           sentence[stop + 2] <= '9') {
        stop = sentence.find(". ", stop + 1);
    }
    sentence = sentence.substr(0, stop);
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

std::string enumerate(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
        text += words[i];
    }
    return text;
}

}  // namespace patina::cli

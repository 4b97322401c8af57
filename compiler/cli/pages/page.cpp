#include "compiler/cli/pages/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/letters.h"

namespace patina::cli {
namespace {

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

}  // namespace

std::string to_terminal(const Console& console, const Page& page) {
    std::string text = heading(console, page.title) + (page.place.empty() ? "" : "  " + page.place) + "\n";
    for (const Section& section : page.sections) {
        std::string body = indented(section.text, "  ") + indented(section.code, "  ");
        for (const Entry& entry : section.entries) body += entry_text(console, entry);
        if (body.empty()) continue;
        text += "\n" + heading(console, section.title.empty() ? "DESCRIPTION" : capital_letters(section.title)) + "\n" +
                body;
    }
    return text;
}

std::string first_sentence(std::string_view text) {
    std::string sentence = joined_lines(text.substr(0, text.find("\n\n")));
    std::size_t stop = sentence.find(". ");
    // "Rec. 709" does not end a sentence.
    while (stop != sentence.npos && stop + 2 < sentence.size() && is_digit(sentence[stop + 2])) {
        stop = sentence.find(". ", stop + 1);
    }
    sentence = sentence.substr(0, stop);
    if (sentence.ends_with('.')) sentence.pop_back();
    return sentence;
}

}  // namespace patina::cli

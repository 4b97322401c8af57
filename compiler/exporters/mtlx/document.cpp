#include "compiler/exporters/mtlx/document.h"

#include <fmt/format.h>

#include "compiler/base/letters.h"

namespace patina::exporters::mtlx {
namespace {

std::string escaped(std::string_view text) {
    std::string made;
    for (const char c : text) {
        switch (c) {
            case '&': made += "&amp;"; break;
            case '<': made += "&lt;"; break;
            case '>': made += "&gt;"; break;
            case '"': made += "&quot;"; break;
            case '\n': made += "&#10;"; break;
            default: made += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return made;
}

void write(const Element& element, std::size_t depth, std::string& out) {
    out.append(2 * depth, ' ');
    out += "<" + element.category;
    for (const auto& [name, value] : element.attributes) out += fmt::format(" {}=\"{}\"", name, escaped(value));
    if (element.children.empty()) {
        out += " />\n";
        return;
    }
    out += ">\n";
    for (const Element& each : element.children) write(each, depth + 1, out);
    out.append(2 * depth, ' ');
    out += fmt::format("</{}>\n", element.category);
}

}  // namespace

std::string write_document(const Element& root) {
    std::string out = "<?xml version=\"1.0\"?>\n";
    write(root, 0, out);
    return out;
}

std::string numbers_text(const std::vector<double>& numbers) {
    std::string made;
    for (const double each : numbers) made += fmt::format("{}{}", made.empty() ? "" : ", ", static_cast<float>(each));
    return made;
}

std::string Names::unique(std::string_view wanted) {
    std::string name;
    for (const char c : wanted) name += is_word_letter(c) ? c : '_';
    if (name.empty() || is_digit(name[0])) name = "_" + name;
    std::string made = name;
    for (int i = 2; !taken_.insert(made).second; ++i)
        made = fmt::format("{}{}{}", name, is_digit(name.back()) ? "_" : "", i);
    return made;
}

}  // namespace patina::exporters::mtlx

#include "runtime/sheet/sheet_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "patina/words.h"
#include "runtime/page/escaped.h"
#include "runtime/page/page.h"
#include "runtime/picture/image.h"

namespace patina::runtime {
namespace {

std::string cell(const std::string& html, bool is_number = false) {
    return fmt::format("<td{}>{}</td>", is_number ? " class=\"number\"" : "", html);
}

std::string table(const std::vector<std::string_view>& columns, const std::string& rows) {
    if (rows.empty()) return {};
    std::string head;
    for (const std::string_view column : columns) head += fmt::format("<th>{}</th>", column);
    return fmt::format("<div class=\"wide\"><table><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>\n", head,
                       rows);
}

// --- properties

int components(PropertyType type) {
    if (type == PropertyType::Float2) return 2;
    if (type == PropertyType::Float3) return 3;
    return type == PropertyType::Float4 || type == PropertyType::Color ? 4 : 1;
}

// A colour as a screen shows it.
std::string swatch(const std::array<double, 4>& linear) {
    const auto byte = [](double value) {
        return int(std::lround(255 * std::clamp(srgb_encode(float(value)), 0.0f, 1.0f)));
    };
    return fmt::format("<span class=\"swatch\" style=\"background: rgb({} {} {})\"></span>", byte(linear[0]),
                       byte(linear[1]), byte(linear[2]));
}

std::string value_of(const Property& property) {
    if (property.type == PropertyType::Bool) return property.value[0] != 0 ? "true" : "false";
    if (property.type == PropertyType::Enum) {
        const std::size_t index = std::size_t(std::max(property.value[0], 0.0));
        return index < property.values.size() ? escaped(property.values[index]) : std::string();
    }
    if (property.type == PropertyType::Sampler) return std::string(name_of(property.sampler));
    if (is_array(property.type)) return std::string(to_string(property.type));
    std::string text = property.type == PropertyType::Color ? swatch(property.value) : std::string();
    for (int i = 0; i < components(property.type); ++i)
        text += fmt::format("{}{:.4g}", i > 0 ? ", " : "", property.value[std::size_t(i)]);
    return text;
}

std::string limits(const Property& property) {
    std::string text;
    if (property.range) text = fmt::format("{:.4g} to {:.4g}", (*property.range)[0], (*property.range)[1]);
    for (const std::string& value : property.values) text += (text.empty() ? "" : ", ") + escaped(value);
    return text;
}

std::string properties(const Reflection& reflection) {
    std::string rows;
    for (const Property& property : reflection.properties) {
        const auto texture = std::ranges::find(reflection.textures, property.name, &Texture::name);
        const bool is_texture = texture != reflection.textures.end();
        const std::string help = property.help.empty() ? property.label : property.help;
        rows += "<tr>" + cell(escaped(property.name)) + cell(std::string(to_string(property.type))) +
                cell(is_texture ? escaped(texture->default_text()) : value_of(property), true) +
                cell(is_texture ? std::string(to_string(texture->usage)) : limits(property)) + cell(escaped(help)) +
                "</tr>\n";
    }
    const std::string made = table({"property", "type", "default", "values", ""}, rows);
    return made.empty() ? made : "<h3>Properties</h3>\n" + made;
}

// --- passes

std::string count(std::uint32_t number) {
    return cell(number > 0 ? std::to_string(number) : "&ndash;", true);
}

std::string counts(const CostCounts& counts) {
    std::string cells;
    for (const CostFigure& figure : kCostFigures) cells += count(counts.*figure.count);
    return cells;
}

// The titles of these cells come between the others.
std::vector<std::string_view> titles(std::vector<std::string_view> before, const std::vector<std::string_view>& after) {
    for (const CostFigure& figure : kCostFigures) before.emplace_back(figure.name);
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

std::string passes(const SheetEntry& entry) {
    std::string rows;
    for (const MeasuredPass& pass : entry.passes) {
        const auto add = [&](std::string_view name, std::string_view each, const CostCounts& cost,
                             const std::string& rest) {
            rows += "<tr>" + cell(escaped(name)) + cell(std::string(each)) + counts(cost) + rest + "</tr>\n";
        };
        const auto add_stage = [&](std::string_view name, std::string_view each, const StageCost& cost,
                                   std::uint32_t bytes) {
            add(name, each, cost.once, count(cost.varyings) + count(cost.registers) + count(bytes));
            if (cost.per_light.instructions > 0) add("", "light", cost.per_light, cell("") + cell("") + cell(""));
        };
        add_stage(pass.name, "vertex", pass.cost.vertex, 0);
        add_stage("", "pixel", pass.cost.fragment, pass.cost.uniform_bytes);
    }
    const std::string made = table(titles({"pass", "for each"}, {"varyings", "registers", "uniform bytes"}), rows);
    if (made.empty()) return made;
    return "<h3>Passes and their cost</h3>\n" + made +
           "<p class=\"note\">Instructions of SPIR-V after <code>spirv-opt -O</code>; each loop counts one "
           "round.</p>\n";
}

std::string part_of(const CostShare& share) {
    switch (share.part) {
        case CostShare::Part::Node: return escaped(share.node);
        case CostShare::Part::Surface: return "<em>surface</em>";
        case CostShare::Part::Lighting: return "<em>lighting</em>";
        case CostShare::Part::Pass: return "<em>pass</em>";
    }
    return {};
}

// Of the first pass, which is the one that draws the surface.
std::string shares(const SheetEntry& entry) {
    std::string rows;
    if (entry.passes.empty()) return rows;
    for (const CostShare& share : entry.passes.front().fragment.shares)
        rows += "<tr>" + cell(part_of(share)) + counts(share.once) + count(share.per_light.instructions) + "</tr>\n";
    const std::string made = table(titles({"node"}, {"instructions for each light"}), rows);
    if (made.empty()) return made;
    return fmt::format("<h3>What each node adds to a pixel of the pass {}</h3>\n{}", escaped(entry.passes.front().name),
                       made);
}

// --- nodes and shaders

// The drawing for a page of HTML: without the text before the drawing, and with names that no other drawing has.
std::string inlined(std::string svg, std::size_t index) {
    svg.erase(0, svg.find("<svg"));
    const std::string name = fmt::format(" id=\"d{}-", index);
    for (std::size_t at = 0; (at = svg.find(" id=\"", at)) != svg.npos; at += name.size()) svg.replace(at, 5, name);
    return svg;
}

std::string drawing(const SheetEntry& entry, std::size_t index) {
    std::string made;
    if (!entry.drawing.empty()) made = fmt::format("<div class=\"drawing\">{}</div>\n", inlined(entry.drawing, index));
    if (!entry.without_nodes.empty()) made += fmt::format("<p class=\"note\">{}</p>\n", escaped(entry.without_nodes));
    if (!entry.ranges.empty())
        made += fmt::format("<p class=\"note\">Not 0 to 1, so numbers are in false colours: {}</p>\n",
                            escaped(entry.ranges));
    if (made.empty()) return made;
    return fmt::format("<details open><summary>Nodes: {}</summary>\n{}</details>\n", entry.nodes.size(), made);
}

std::string shaders(const SheetEntry& entry) {
    std::string texts;
    std::size_t lines = 0;
    for (const Shader& shader : entry.shaders) {
        const std::size_t own = std::size_t(std::ranges::count(shader.text, '\n'));
        lines += own;
        texts += fmt::format("<details><summary>{}: {} lines</summary><pre class=\"shader\">{}</pre></details>\n",
                             escaped(shader.file_name), own, escaped(shader.text));
    }
    if (texts.empty()) return texts;
    return fmt::format("<details><summary>Shaders: {} files, {} lines</summary>\n{}</details>\n", entry.shaders.size(),
                       lines, texts);
}

// --- cards

std::string messages(const SheetEntry& entry) {
    std::string text;
    for (const Diagnostic& diagnostic : entry.diagnostics)
        text += fmt::format("<pre class=\"message\">{}</pre>\n", escaped(to_text(diagnostic)));
    if (!entry.error.empty()) text += fmt::format("<p class=\"message\">{}</p>\n", escaped(entry.error));
    return text;
}

// What a search finds the card by.
std::string words(const SheetEntry& entry) {
    std::string text = entry.name + " " + entry.kind;
    for (const std::string& node : entry.nodes) text += " " + node;
    for (const Property& property : entry.reflection.properties) text += " " + property.name;
    for (const Texture& texture : entry.reflection.textures) text += " " + texture.name;
    return escaped(text);
}

std::string card(const SheetEntry& entry, const std::string& id, std::size_t index) {
    const std::string facts = properties(entry.reflection) + passes(entry) + shares(entry);
    const std::string picture =
        entry.picture.empty()
            ? std::string()
            : fmt::format("<figure><div class=\"picture\">{}</div></figure>\n", picture_tag(entry.picture, entry.name));
    const std::string shown = picture.empty() && facts.empty()
                                  ? std::string()
                                  : fmt::format("<div class=\"shown\">\n{}<div>{}</div>\n</div>\n", picture, facts);
    return fmt::format(
        "<section class=\"card\" data-case=\"{0}\" data-words=\"{1}\" id=\"{2}\">\n<div class=\"head\"><h2>{3}</h2>"
        "<span class=\"kind\">{0}</span>{4}<span class=\"file\">{5}</span></div>\n{6}{7}{8}{9}</section>\n",
        entry.kind, words(entry), escaped(id), escaped(entry.name),
        entry.ok ? "" : "<span class=\"state failed\">wrong</span>", escaped(entry.file), messages(entry), shown,
        drawing(entry, index), shaders(entry));
}

std::string thumbnail(const SheetEntry& entry, const std::string& id) {
    if (entry.thumbnail.empty()) return {};
    return fmt::format(
        "<figure data-case=\"{}\" data-words=\"{}\"><a href=\"#{}\"><div class=\"picture\">{}</div>"
        "<figcaption>{}</figcaption></a></figure>\n",
        entry.kind, words(entry), escaped(id), picture_tag(entry.thumbnail, entry.name), escaped(entry.name));
}

std::string tools(const Sheet& sheet) {
    std::map<std::string_view, std::size_t> kinds;
    for (const SheetEntry& entry : sheet.entries) ++kinds[entry.kind];
    std::string text;
    for (const auto& [kind, number] : kinds) text += kind_button(kind, number, number > 1 ? "s" : "");
    return text + "<input type=\"search\" placeholder=\"name, node or property\" aria-label=\"search\">";
}

}  // namespace

std::string sheet_page(const Sheet& sheet, const std::string& folder) {
    std::string thumbnails, cards;
    std::map<std::string, int> names;
    for (const SheetEntry& entry : sheet.entries) ++names[entry.name];
    for (std::size_t i = 0; i < sheet.entries.size(); ++i) {
        const SheetEntry& entry = sheet.entries[i];
        const std::string id = names[entry.name] > 1 ? entry.name + " (" + entry.kind + ")" : entry.name;
        thumbnails += thumbnail(entry, id);
        cards += card(entry, id, i);
    }
    if (!thumbnails.empty())
        thumbnails = "<section class=\"card\">\n<div class=\"grid\">\n" + thumbnails + "</div>\n</section>\n";
    return make_page(
        {.title = "Graphs of " + folder_name(folder), .tools = tools(sheet), .content = thumbnails + cards});
}

}  // namespace patina::runtime

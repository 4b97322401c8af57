#include "compiler/cli/node_sheet/node_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "compiler/cli/json_text.h"
#include "compiler/cli/node_sheet/drawings.h"
#include "compiler/cli/node_sheet/plot.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/pages/page.h"
#include "runtime/page/escaped.h"
#include "runtime/page/page.h"
#include "runtime/render/render_jobs.h"
#include "runtime/render/render_request.h"

namespace patina::cli {
namespace {

constexpr int kSize = 160;

struct Tile {
    const NodeInfo* node = nullptr;
    std::string picture{};  // HTML
    std::string error{};    // of the machine
};

// All places of the ball have one colour, so the picture says nothing.
bool is_even(const runtime::Image& image) {
    const auto at = [&](int x, int y) { return image.at(image.width * x / 8, image.height * y / 8); };
    for (const auto& [x, y] : {std::pair{2, 4}, {6, 4}, {4, 2}, {4, 6}, {5, 5}})
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(at(x, y)[c] - at(4, 4)[c]) > 1e-4) return false;
    return true;
}

// The picture of the node `shown` of the graph's nodes: as it is, or in the range of its values.
std::string drawn(const Compiler& compiler, runtime::RenderMachine& machine, const std::string& nodes, bool is_flat,
                  std::string_view mesh, bool is_value, Tile& entry) {
    const std::string graph = fmt::format(
        "{{ \"patina\": 1, \"workflow\": \"unlit\", \"nodes\": [{{ \"id\": \"uv\", \"expr\": \"{}\" }}, "
        "{}], \"surface\": {{ \"color\": \"{}\" }} }}",
        is_flat ? "@screenUV" : "@uv0", nodes, is_value ? "= 0" : "= float3(1) * shown");
    runtime::RenderRequest request{.graph = "node.graph.json", .size = kSize, .samples = 2};
    if (is_flat) {
        request.mesh = "plane";
        request.camera = "position=0,0,0.3 target=0,0,0 fov=40";
    } else if (!mesh.empty()) {
        request.mesh = mesh;
    }
    request.background = "none";
    request.options.files = std::make_shared<const runtime::MemoryFiles>(runtime::MemoryFiles{{request.graph, graph}});
    if (is_value) request.options.preview = "shown";
    runtime::RenderOutcome outcome = render(compiler, request, machine);
    if (outcome.missing_machine) entry.error = outcome.error;
    if (!outcome.ok) return {};
    if (is_value) {
        const runtime::DataSummary& values = outcome.values;
        if (values.is_empty || values.not_finite > 0 || is_even(outcome.image)) return {};
        const double most = std::max(std::abs(values.low), std::abs(values.high));
        if (values.low < 0)
            request.range = {.low = -most, .high = most};
        else if (values.high > 1)
            request.range = {.low = 0, .high = values.high};
        if (request.range) outcome = render(compiler, request, machine);
        if (!outcome.ok) return {};
    }
    runtime::Outcome<std::string> png = runtime::encode_png(outcome.image);
    return png ? runtime::picture_tag(png.value, entry.node->name) : std::string();
}

// "\"node\": \"Lerp\"" -> { "id": "shown", "node": "Lerp" }
std::string node_text(std::string_view id, const std::string& content) {
    return fmt::format("{{ \"id\": \"{}\", {} }}", id, content);
}

// The input of a node that changes colours.
const PortInfo* color_input(const NodeInfo& node) {
    const PortInfo& first = node.ports.front();
    const bool is_color = first.name == "color" || first.doc.find("colour") != std::string::npos;
    const bool is_vector = first.type == "float3" || first.type == "floatN";
    return !first.is_output && is_color && is_vector && node.category.starts_with("Color") ? &first : nullptr;
}

// A value of another input with which the node changes colours, if it keeps them with its defaults: the channel blue,
// or another word.
std::optional<std::pair<std::string, std::string>> change_of(const Compiler& compiler, const NodeInfo& node,
                                                             const PortInfo& color) {
    constexpr const char* kColor = "0.8,0.3,0.1";
    const auto keeps = [&](std::vector<std::pair<std::string, std::string>> inputs) {
        inputs.emplace_back(color.name, kColor);
        const EvalResult result = compiler.evaluate(node.name, inputs);
        const std::vector<double> same = {0.8, 0.3, 0.1};
        if (!result.ok || result.outputs.front().values.size() != same.size()) return !result.ok;
        for (std::size_t i = 0; i < same.size(); ++i)
            if (std::abs(result.outputs.front().values[i] - same[i]) > 1e-4) return false;
        return true;
    };
    if (!keeps({})) return std::nullopt;
    for (const PortInfo& each : node.ports) {
        if (each.is_output || &each == &color) continue;
        std::vector<std::string> values;
        for (const auto& word : each.enumerators) values.push_back(word.name);
        if (each.type == "float3" || each.type == "floatN") values.emplace_back("0,0,1");
        for (const std::string& value : values)
            if (!keeps({{each.name, value}})) return std::pair(each.name, value);
    }
    return std::nullopt;
}

// Hues from left to right and values from top to bottom, twice: on the left as they are, on the right as the node
// changes them.
std::string before_and_after(const Compiler& compiler, const NodeInfo& node, const PortInfo& color) {
    std::string inputs = json_text(color.name) + ": \"before\"";
    if (const auto change = change_of(compiler, node, color))
        inputs += ", " + json_text(change->first) + ": " +
                  (change->second == "0,0,1" ? "[0, 0, 1]" : json_text(change->second));
    return node_text("before", "\"expr\": \"HsvToRgb(float3(frac(uv.x * 2), 0.8, 1 - uv.y))\"") + ", " +
           node_text("after", "\"node\": " + json_text(node.name) + ", \"in\": { " + inputs + " }") + ", " +
           node_text("shown", "\"expr\": \"uv.x < 0.5 ? before : float3(1) * after\"");
}

// It needs nothing but what the mesh, the camera and the scene have.
bool is_open(const NodeInfo& node) {
    return std::ranges::none_of(node.ports,
                                [](const PortInfo& each) { return !each.is_output && each.default_value.empty(); });
}

std::string text_picture(const NodeInfo& node) {
    std::string text = !node.formula.empty() ? node.formula : node.tests.empty() ? "" : node.tests.front();
    if (text.empty()) {
        std::string outputs;
        for (const PortInfo& each : node.ports) (each.is_output ? outputs : text) += each.type + " " + each.name + "\n";
        text += "\u2192 " + outputs;
    }
    return "<pre class=\"formula\">" + runtime::escaped(text) + "</pre>";
}

void draw(const Compiler& compiler, runtime::RenderMachine& machine, Tile& entry) {
    const NodeInfo& node = *entry.node;
    const PlotWish* plot = plot_wish(node.name);
    if (const auto panel = panel_wish(node.name))
        entry.picture = drawn(compiler, machine, node_text("shown", "\"expr\": " + json_text(panel->expression)),
                              panel->mesh.empty(), panel->mesh, false, entry);
    if (entry.picture.empty() && plot && plot->is_strip) {
        if (const auto bands = plot_bands(compiler, *plot, kSize, kSize * 2 / 3))
            if (const auto png = runtime::encode_png(*bands); png)
                entry.picture = runtime::picture_tag(png.value, node.name);
    } else if (entry.picture.empty() && plot) {
        entry.picture = plot_svg(compiler, *plot).value_or("");
    }
    if (entry.picture.empty() && entry.error.empty() && is_open(node))
        entry.picture =
            drawn(compiler, machine, node_text("shown", "\"node\": " + json_text(node.name)), false, "", true, entry);
    if (const PortInfo* color = color_input(node); color && entry.picture.empty() && entry.error.empty())
        entry.picture = drawn(compiler, machine, before_and_after(compiler, node, *color), true, "", false, entry);
    if (entry.picture.empty())
        if (const auto usual = usual_plot(compiler, node)) entry.picture = plot_svg(compiler, *usual).value_or("");
    if (entry.picture.empty()) entry.picture = text_picture(node);
}

std::string html_of(const Tile& entry) {
    const NodeInfo& node = *entry.node;
    std::string also;
    for (const std::string& each : node.also) also += (also.empty() ? "" : ", ") + each;
    return fmt::format(
        "<figure data-case=\"{}\" data-words=\"{} {} {}\" id=\"{}\"><div "
        "class=\"picture\">{}</div><figcaption><b>{}</b>{}"
        "{}</figcaption></figure>\n",
        runtime::escaped(node.category), runtime::escaped(node.name), runtime::escaped(also),
        runtime::escaped(node.doc), node.name, entry.picture, runtime::escaped(node.name),
        also.empty() ? "<br>" : "<small>" + runtime::escaped(also) + "</small>",
        runtime::escaped(first_sentence(node.doc)));
}

std::string page(const std::vector<Tile>& entries) {
    std::string content =
        "<style>.nodes { grid-template-columns: repeat(auto-fill, minmax(210px, 1fr)); } .nodes .picture { background: "
        "none; border: 1px solid var(--line); aspect-ratio: 24 / 17; display: grid; place-items: center; } .nodes "
        ".picture img { width: auto; height: 100%; image-rendering: auto; } .nodes svg { width: 100%; } .formula { "
        "margin: 8px; font: "
        "12px/1.4 "
        "var(--mono); white-space: pre-wrap; overflow-wrap: anywhere; } .nodes small { display: block; } "
        "section:not(:has(figure:not([hidden]))) { display: none; }</style>\n";
    for (std::size_t i = 0; i < entries.size();) {
        const std::string& category = entries[i].node->category;
        content +=
            fmt::format("<section class=\"card\"><div class=\"head\"><h2>{}</h2></div>\n<div class=\"grid nodes\">\n",
                        runtime::escaped(category));
        for (; i < entries.size() && entries[i].node->category == category; ++i) content += html_of(entries[i]);
        content += "</div>\n</section>\n";
    }
    return runtime::make_page({.title = fmt::format("{} nodes", entries.size()),
                               .tools = "<input type=\"search\" placeholder=\"name or words\" aria-label=\"search\">",
                               .content = content});
}

}  // namespace

Exit write_node_sheet(const Console& console, const Compiler& compiler, std::span<const NodeInfo* const> nodes,
                      const std::string& output) {
    Outputs outputs(console);
    if (!outputs.is_possible(output)) return Exit::Wrong;
    std::vector<Tile> entries;
    for (const NodeInfo& each : compiler.nodes())
        if (std::ranges::find(nodes, &each) != nodes.end()) entries.push_back({.node = &each});
    runtime::render_jobs(
        entries.size(), 0, [&](std::size_t i, runtime::RenderMachine& machine) { draw(compiler, machine, entries[i]); },
        [&](std::size_t i) {
            if (i + 1 < entries.size()) show_progress(console, i + 1, entries.size(), entries[i].node->name);
        });
    end_progress(console);
    const auto without = std::ranges::find_if(entries, [](const Tile& each) { return !each.error.empty(); });
    if (without != entries.end()) {
        complain(console, Complaint::CannotRender, {without->error});
        return Exit::Machine;
    }
    OutputFiles files;
    files.add(output, page(entries));
    if (!outputs.write("nodes", files)) return Exit::Wrong;
    say(console, files);
    return Exit::Ok;
}

}  // namespace patina::cli

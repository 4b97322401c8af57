#include "runtime/page/drawing.h"

#include <fmt/format.h>
#include <graphviz/gvc.h>

#include <algorithm>
#include <locale>
#include <mutex>
#include <sstream>

#include "runtime/page/escaped.h"
#include "runtime/page/page.h"

namespace patina::runtime {
namespace {

constexpr std::size_t kLongest = 48;  // characters of a value
constexpr int kPictureSize = 72;      // points

// Graphviz wants the pictures of boxes as files. So it gets rectangles in colours that nothing else has, and the
// pictures replace these.
constexpr std::size_t kFirstColor = 0x010000;
std::string color_of(std::size_t box) {
    return fmt::format("#{:06x}", kFirstColor + box);
}

// Graphviz's labels are XML of its own: no control characters, and long values are cut between characters.
std::string label(std::string text) {
    if (text.size() > kLongest) {
        std::size_t end = kLongest;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
        text = text.substr(0, end) + "...";
    }
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return escaped(text);
}

std::string small(const std::string& text) {
    return text.empty() ? std::string()
                        : fmt::format(" <FONT COLOR=\"#6b7280\" POINT-SIZE=\"9\">{}</FONT>", label(text));
}

std::string row(const GraphBox& box, std::size_t i) {
    std::string text = "<TR>";
    if (!box.inputs.empty()) {
        const bool has = i < box.inputs.size();
        const GraphPort port = has ? box.inputs[i] : GraphPort{};
        const std::string value = port.value.empty() ? "" : " = " + port.value;
        text += has ? fmt::format("<TD PORT=\"i{}\" ALIGN=\"LEFT\">{}{}{}</TD>", i, label(port.name), small(port.type),
                                  small(value))
                    : "<TD></TD>";
    }
    if (!box.outputs.empty()) {
        text += i < box.outputs.size() ? fmt::format("<TD PORT=\"o{}\" ALIGN=\"RIGHT\">{}{}</TD>", i,
                                                     label(box.outputs[i].name), small(box.outputs[i].type))
                                       : "<TD></TD>";
    }
    return text + "</TR>";
}

// `picture`: the colour of the place for a picture; empty: there is none.
std::string table(const GraphBox& box, const std::string& picture) {
    const std::size_t rows = std::max(box.inputs.size(), box.outputs.size());
    const int columns = box.inputs.empty() || box.outputs.empty() ? 1 : 2;
    std::string text = fmt::format(
        "<TABLE BORDER=\"0\" CELLBORDER=\"1\" CELLSPACING=\"0\" CELLPADDING=\"3\" COLOR=\"#9ca3af\" "
        "BGCOLOR=\"white\"><TR><TD COLSPAN=\"{}\" BGCOLOR=\"{}\"><B>{}</B>",
        columns, box.is_node ? "#dbeafe" : "#fde68a", label(box.id));
    if (!box.title.empty()) text += "<BR/>" + label(box.title);
    text += "</TD></TR>";
    if (!picture.empty())
        text += fmt::format(
            "<TR><TD COLSPAN=\"{0}\"><TABLE BORDER=\"0\" CELLBORDER=\"0\" CELLSPACING=\"0\" CELLPADDING=\"0\"><TR>"
            "<TD FIXEDSIZE=\"TRUE\" WIDTH=\"{1}\" HEIGHT=\"{1}\" BGCOLOR=\"{2}\"></TD></TR></TABLE></TD></TR>",
            columns, kPictureSize, picture);
    for (std::size_t i = 0; i < rows; ++i) text += row(box, i);
    return text + "</TABLE>";
}

std::string dot_with_places(const GraphView& view, const BoxPictures& pictures) {
    std::string text =
        "digraph patina {\n  graph [rankdir=LR, ranksep=0.6, nodesep=0.25, bgcolor=white]\n"
        "  node [shape=plain, fontname=\"DejaVu Sans,Helvetica,sans-serif\", fontsize=11]\n"
        "  edge [color=\"#4b5563\", arrowsize=0.6]\n";
    for (std::size_t i = 0; i < view.boxes.size(); ++i)
        text += fmt::format("  n{} [label=<{}>]\n", i, table(view.boxes[i], pictures.contains(i) ? color_of(i) : ""));
    for (const GraphEdge& edge : view.edges)
        text += fmt::format("  n{}:o{}:e -> n{}:i{}:w\n", edge.from, edge.from_port, edge.to, edge.to_port);
    return text + "}\n";
}

Drawing run_graphviz(const std::string& dot) {
    static std::mutex graphviz;  // it has global variables
    const std::scoped_lock lock(graphviz);
    const auto silent = [](char*) { return 0; };
    agseterrf(silent);
    // Never freed: Graphviz's Pango plugin keeps a pointer to a font of the last context that it has seen.
    static GVC_t* const context = gvContext();
    if (!context) return {.error = "Graphviz cannot be started"};
    Drawing made;
    Agraph_t* graph = agmemread(dot.c_str());
    char* bytes = nullptr;
    unsigned int size = 0;
    if (graph && gvLayout(context, graph, "dot") == 0) {
        if (gvRenderData(context, graph, "svg", &bytes, &size) == 0 && bytes) made.svg.assign(bytes, size);
        gvFreeRenderData(bytes);
        gvFreeLayout(context, graph);
    }
    if (graph) agclose(graph);
    if (made.svg.empty()) {
        const char* reason = aglasterr();
        made.error = fmt::format("Graphviz cannot draw it{}{}", reason ? ": " : "", reason ? reason : "");
    }
    return made;
}

// The value of an attribute of the tag that begins at `tag`.
std::string attribute(std::string_view svg, std::size_t tag, std::string_view name) {
    const std::size_t begin = svg.find(name, tag) + name.size();
    return std::string(svg.substr(begin, svg.find('"', begin) - begin));
}

// Puts the pictures where their places are.
void put(const BoxPictures& pictures, std::string& svg) {
    for (const auto& [box, png] : pictures) {
        const std::size_t begin = svg.find(fmt::format("<polygon fill=\"{}\"", color_of(box)));
        if (begin == svg.npos) continue;
        std::istringstream points(attribute(svg, begin, "points=\""));
        points.imbue(std::locale::classic());
        double left = 0, top = 0, right = 0, bottom = 0;
        for (int i = 0; i < 4; ++i) {
            double x = 0, y = 0;
            char comma = 0;
            points >> x >> comma >> y;
            left = i == 0 ? x : std::min(left, x), right = i == 0 ? x : std::max(right, x);
            top = i == 0 ? y : std::min(top, y), bottom = i == 0 ? y : std::max(bottom, y);
        }
        svg.replace(begin, svg.find("/>", begin) + 2 - begin,
                    fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                                "xlink:href=\"data:image/png;base64,{}\"/>",
                                left, top, right - left, bottom - top, base64(png)));
    }
}

}  // namespace

std::string dot_of(const GraphView& view) {
    return dot_with_places(view, {});
}

Drawing draw(const GraphView& view, const BoxPictures& pictures) {
    if (view.boxes.size() > kMostBoxes)
        return {.error = fmt::format("it has {} nodes, and a drawing has at most {}", view.boxes.size(), kMostBoxes)};
    Drawing drawing = run_graphviz(dot_with_places(view, pictures));
    put(pictures, drawing.svg);
    return drawing;
}

}  // namespace patina::runtime

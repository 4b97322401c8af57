#include "runtime/snapshot/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/page/escaped.h"
#include "runtime/page/page.h"

namespace patina::runtime {
namespace {

std::string figure(const std::string& png, const std::string& caption) {
    if (png.empty()) return {};
    return fmt::format("<figure><div class=\"picture\">{}</div><figcaption>{}</figcaption></figure>\n",
                       picture_tag(png, caption), escaped(caption));
}

// The reference left of the bar, what was received right of it.
std::string slider(const SnapshotCase& each) {
    if (each.reference_png.empty() || each.received_png.empty() || each.gates.empty()) return {};
    return fmt::format(
        "<figure><div class=\"picture slider\">{}{}<div class=\"bar\"></div><input type=\"range\" min=\"0\" "
        "max=\"100\" "
        "step=\"0.1\" value=\"50\" aria-label=\"from the reference to what was received\"></div>"
        "<figcaption class=\"ends\"><span>Reference</span><span>move the bar</span><span>Received</span></figcaption>"
        "</figure>\n",
        picture_tag(each.reference_png, "reference"), picture_tag(each.received_png, "received", "over"));
}

// --- figures

std::string_view meaning(std::string_view gate) {
    if (gate == "share") return "pixels that differ";
    if (gate == "average") return "mean difference of a channel";
    if (gate == "tile") return "the same of the worst 16 &times; 16 tile";
    return "FLIP: the difference that a person sees";
}

std::string number(const Gate& gate, double value) {
    return gate.name == "share" ? fmt::format("{:.3g} %", 100 * value) : fmt::format("{:.3g}", value);
}

// From a hundredth of the limit to a hundred times it, so that the limit is in the middle.
double length(const Gate& gate) {
    if (!(gate.value > 0)) return 0;
    if (!(gate.limit > 0)) return 1;
    return std::clamp(0.5 + std::log10(gate.value / gate.limit) / 4, 0.0, 1.0);
}

std::string row(const Gate& gate) {
    return fmt::format(
        "<tr{}><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td><div "
        "class=\"meter\"><i style=\"width: {:.0f}%\"></i></div></td><td class=\"note\">{}</td></tr>\n",
        gate.passes() ? "" : " class=\"over\"", gate.name, number(gate, gate.value), number(gate, gate.limit),
        gate.limit > 0 ? fmt::format("{:.2g}", gate.value / gate.limit) : "", 100 * length(gate), meaning(gate.name));
}

std::string table(const std::vector<Gate>& gates) {
    if (gates.empty()) return {};
    std::string rows;
    for (const Gate& gate : gates) rows += row(gate);
    return "<h3>Figures</h3>\n<table><thead><tr><th></th><th>value</th><th>limit</th><th>value / limit</th>"
           "<th>1/100 to 100</th><th></th></tr></thead>"
           "<tbody>\n" +
           rows + "</tbody></table>\n";
}

// "12 340", with thin spaces.
std::string with_spaces(std::size_t count) {
    std::string text = std::to_string(count);
    for (int at = int(text.size()) - 3; at > 0; at -= 3) text.insert(std::size_t(at), "&#8239;");
    return text;
}

std::string cost(const SnapshotCase& each) {
    const std::size_t now = each.now.spirv_bytes, then = each.then.spirv_bytes;
    if (now == 0) return {};
    if (then == 0 || then == now)
        return fmt::format("<p class=\"note\">Cost: <b>{} bytes</b> of SPIR-V{}</p>\n", with_spaces(now),
                           then == now ? ", as before" : "");
    return fmt::format("<p class=\"note\">Cost: {} &rarr; <b>{} bytes</b> of SPIR-V ({:+.1f} %)</p>\n",
                       with_spaces(then), with_spaces(now), 100 * (double(now) / double(then) - 1));
}

std::string device(const SnapshotCase& each) {
    if (each.now.device.empty()) return {};
    const auto words = [](const PictureRecord& record) {
        return escaped(record.device + (record.driver.empty() ? "" : ", " + record.driver));
    };
    std::string text = fmt::format("<p class=\"note\">Drawn by {}", words(each.now));
    if (each.other_driver)
        text += fmt::format("; the reference by <b>{}</b>, so that the limits are wider", words(each.then));
    return text + "</p>\n";
}

// --- texts

std::string text_difference(const std::vector<DiffLine>& diff) {
    if (diff.empty()) return {};
    std::string lines;
    const auto line_number = [](int number) { return number > 0 ? std::to_string(number) : std::string(); };
    for (const DiffLine& line : diff) {
        if (line.kind == DiffLine::Kind::Gap) {
            lines += "<div class=\"gap\">&middot;&middot;&middot;</div>";
            continue;
        }
        const char* css = line.kind == DiffLine::Kind::Added     ? " class=\"added\""
                          : line.kind == DiffLine::Kind::Removed ? " class=\"removed\""
                                                                 : "";
        const char* sign = line.kind == DiffLine::Kind::Added ? "+" : line.kind == DiffLine::Kind::Removed ? "-" : " ";
        lines += fmt::format("<div{}><span>{}</span><span>{}</span><code>{} {}</code></div>", css,
                             line_number(line.old_line), line_number(line.new_line), sign, escaped(line.text));
    }
    return fmt::format("<h3>Shaders: {} changed lines</h3>\n<div class=\"code\">{}</div>\n", changed_lines(diff),
                       lines);
}

// --- cases

std::string message(const SnapshotCase& each) {
    std::string text = each.message.empty() ? "" : fmt::format("<p class=\"message\">{}</p>\n", escaped(each.message));
    for (const Diagnostic& diagnostic : each.diagnostics)
        text += fmt::format("<pre class=\"message\">{}</pre>\n", escaped(to_text(diagnostic)));
    return text;
}

std::string card(const SnapshotCase& each) {
    const std::string pictures = slider(each) + figure(each.reference_png, "Reference") +
                                 figure(each.received_png, "Received") +
                                 figure(each.difference_png, "Difference, 8 times as bright");
    return fmt::format(
        "<section class=\"card\" data-case=\"{0}\" id=\"{1}\">\n<div class=\"head\"><span class=\"state "
        "{0}\">{0}</span>"
        "<h2>{1}</h2><span class=\"file\">{2}</span></div>\n{3}<div class=\"pictures\">\n{4}</div>\n{5}{6}{7}{8}"
        "</section>\n",
        to_string(each.state), escaped(each.name), escaped(each.file), message(each), pictures, table(each.gates),
        cost(each), device(each), text_difference(each.text_diff));
}

std::string thumbnail(const SnapshotCase& each) {
    const auto perceptual = std::ranges::find(each.gates, "perceptual", &Gate::name);
    const std::string figure =
        perceptual == each.gates.end() ? "" : fmt::format("<br><small>FLIP {:.2g}</small>", perceptual->value);
    return fmt::format(
        "<figure data-case=\"{}\"><div class=\"picture\">{}</div><figcaption>{}{}</figcaption></figure>\n",
        to_string(each.state), picture_tag(each.received_png, each.name), escaped(each.name), figure);
}

std::string summary(const SnapshotReport& report) {
    std::string text;
    for (const SnapshotState state :
         {SnapshotState::Failed, SnapshotState::Missing, SnapshotState::Updated, SnapshotState::Passed}) {
        const std::size_t count = report.count(state);
        if (count == 0) continue;
        text += kind_button(to_string(state), count);
    }
    return text.empty() ? "no case" : text;
}

std::string all_cases(const SnapshotReport& report) {
    std::string cards, thumbnails;
    for (const SnapshotCase& each : report.cases) {
        if (each.ok())
            thumbnails += thumbnail(each);
        else
            cards += card(each);
    }
    if (thumbnails.empty()) return cards;
    return cards +
           "<section class=\"card\">\n<div class=\"head\"><h2>As they should be</h2></div>\n<div class=\"grid\" "
           "style=\"margin-top: 16px\">\n" +
           thumbnails + "</div>\n</section>\n";
}

}  // namespace

std::string report_page(const SnapshotReport& report, const std::string& folder) {
    return make_page(
        {.title = "Snapshots of " + folder_name(folder), .tools = summary(report), .content = all_cases(report)});
}

}  // namespace patina::runtime

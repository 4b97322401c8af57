#include "compiler/api/report.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "compiler/api/messages/source_line.h"
#include "compiler/base/broken_text.h"
#include "compiler/base/disk/near_file.h"
#include "compiler/base/text.h"
#include "compiler/json/json_writer.h"

namespace patina {
namespace {

void place(Diagnostic& diagnostic, Span span, const SourceMap& sources) {
    if (!span) return;
    const Position begin = sources.resolve(span.begin);
    const Position end = sources.resolve(std::max(span.begin, span.end));
    diagnostic.file = begin.file;
    diagnostic.line = begin.line;
    diagnostic.column = begin.column;
    diagnostic.end_line = end.line;
    diagnostic.end_column = end.column;
    // A whole graph may be one line, which is too long to copy into each diagnostic.
    constexpr std::size_t kMaxLine = 1u << 16;
    if (begin.line_text.size() > kMaxLine) return;
    // A binary file has no lines to show; a text may have a control character or two.
    constexpr std::ptrdiff_t kMostControls = 4;
    const bool is_binary = std::count_if(begin.line_text.begin(), begin.line_text.end(), [](char c) {
                               return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\r';
                           }) > kMostControls;
    if (!is_binary) diagnostic.source_line = begin.line_text;
}

std::string_view word(Severity severity) {
    switch (severity) {
        case Severity::Error: return "error";
        case Severity::Warning: return "warning";
        case Severity::Note: return "note";
    }
    return {};
}

void write_text(std::string& text, const Diagnostic& d, bool colors) {
    const auto paint = [&](const char* code) { return colors ? code : ""; };
    const char* color = d.severity == Severity::Error     ? "\x1b[1;31m"
                        : d.severity == Severity::Warning ? "\x1b[1;35m"
                                                          : "\x1b[1;36m";
    const std::string place =
        d.line > 0 ? fmt::format("{}:{}:{}", printable(d.file), d.line, d.column) : printable(d.file);
    if (!d.file.empty()) text += fmt::format("{}{}:{} ", paint("\x1b[1m"), place, paint("\x1b[0m"));
    text += fmt::format("{}{}:{} {}", paint(color), word(d.severity), paint("\x1b[0m"), printable(d.message));
    // To a reader, these are not nodes.
    constexpr std::string_view kParts[] = {"surface", "vertex", "outputs", "properties", "inputs"};
    const bool is_part = std::find(std::begin(kParts), std::end(kParts), d.node) != std::end(kParts);
    const std::string node = is_part ? d.node : d.node.empty() ? "" : fmt::format("node '{}'", printable(d.node));
    if (!node.empty()) {
        text += d.port.empty() ? fmt::format(" ({})", node)
                               : fmt::format(" ({}{} '{}')", node, is_part ? "" : ", port", printable(d.port));
    }
    if (!d.code.empty()) text += fmt::format(" [{}]", printable(d.code));
    text += "\n";
    show_source(text, d, colors);
    for (const Diagnostic& note : d.notes) write_text(text, note, colors);
}

void write_json(JsonWriter& json, const Diagnostic& d) {
    json.begin('{');
    json.write("severity", word(d.severity));
    json.if_any("code", d.code);
    json.write("message", d.message);
    json.if_any("file", d.file);
    if (d.line > 0) {
        json.write("line", d.line);
        json.write("column", d.column);
        json.write("endLine", d.end_line);
        json.write("endColumn", d.end_column);
    }
    json.if_any("node", d.node);
    json.if_any("port", d.port);
    if (!d.notes.empty()) {
        json.begin("notes", '[');
        for (const Diagnostic& note : d.notes) write_json(json, note);
        json.end();
    }
    json.end();
}

}  // namespace

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources) {
    return to_public(diagnostics, sources, sources, {});
}

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources, const SourceMap& library,
                                  std::string_view graph) {
    std::vector<Diagnostic> out;
    // A material's passes share its nodes, so an error in a node is found for each pass, but reported once.
    std::set<std::tuple<Code, std::uint32_t, std::uint32_t, std::string_view>> said;
    for (const DiagnosticRecord& record : diagnostics.records()) {
        if (!said.emplace(record.code, record.span.begin, record.span.end, record.message).second) continue;
        Diagnostic& d = out.emplace_back();
        d.severity = record.severity == Level::Error ? Severity::Error : Severity::Warning;
        d.code = info(record.code).name;
        d.message = record.message;
        d.node = record.node;
        d.port = record.port;
        place(d, record.span, sources);
        for (const DiagnosticNote& note : record.notes) {
            if (note.message.empty()) continue;
            Diagnostic& n = d.notes.emplace_back();
            n.severity = Severity::Note;
            n.message = note.message;
            place(n, note.span, sources);
        }
        if (!graph.empty() && record.span && !library.file(record.span.begin).empty()) {
            Diagnostic& n = d.notes.emplace_back();
            n.severity = Severity::Note;
            n.message = fmt::format("the graph is '{}'", graph);
        }
    }
    // In the order of the text; files in the order of their first diagnostic.
    std::vector<std::string> files;
    for (const Diagnostic& d : out) {
        if (std::find(files.begin(), files.end(), d.file) == files.end()) files.push_back(d.file);
    }
    const auto rank = [&](const Diagnostic& d) {
        return std::tuple(std::find(files.begin(), files.end(), d.file) - files.begin(), d.line, d.column);
    };
    std::stable_sort(out.begin(), out.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return rank(a) < rank(b); });
    return out;
}

std::string to_text(const Diagnostic& diagnostic, bool colors) {
    std::string text;
    write_text(text, diagnostic, colors);
    if (!text.empty()) text.pop_back();
    return text;
}

Diagnostic diagnostic_at(const FileLocation& place, std::string code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.file = place.file;
    diagnostic.line = place.line;
    diagnostic.column = place.column;
    diagnostic.end_line = place.end_line;
    diagnostic.end_column = place.end_column;
    diagnostic.source_line = place.source_line;
    return diagnostic;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
    const std::vector<std::string_view> views(known.begin(), known.end());
    return Diagnostics::suggestion(word, views);
}

std::string file_suggestion(const std::string& path) {
    return near_file(path);
}

std::string to_json(const Diagnostic& diagnostic) {
    JsonWriter json;
    write_json(json, diagnostic);
    return json.take();
}

}  // namespace patina

#include "compiler/report.h"

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <algorithm>
#include <tuple>

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
    diagnostic.source_line = begin.line_text;
}

std::string_view word(Severity severity) {
    switch (severity) {
        case Severity::Error: return "error";
        case Severity::Warning: return "warning";
        case Severity::Note: return "note";
    }
    return {};
}

// Long lines (a whole graph on one) are shown around the place only.
constexpr int kShown = 110;

void show_source(std::string& text, const Diagnostic& d, bool colors) {
    if (d.source_line.empty() || d.column < 1) return;
    const auto length = static_cast<int>(d.source_line.size());
    int first = d.column - 1 > kShown * 3 / 4 ? d.column - 1 - kShown / 2 : 0;
    first = std::min(first, std::max(0, length - kShown));
    std::string line = d.source_line.substr(static_cast<std::size_t>(first), kShown);
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    const int last = d.end_line > d.line ? length + 1 : std::max(d.end_column, d.column + 1);
    const int width = std::clamp(last - d.column, 1, std::max(1, kShown - (d.column - 1 - first)));
    const std::string gutter = fmt::format("{:>5} | ", d.line);
    text += gutter + line + "\n";
    text += fmt::format("{:>5} | {:>{}}", "", "", d.column - 1 - first);
    if (colors) text += "\x1b[1;32m";
    text += "^" + std::string(static_cast<std::size_t>(width - 1), '~');
    if (colors) text += "\x1b[0m";
    text += "\n";
}

void write_text(std::string& text, const Diagnostic& d, bool colors) {
    const auto paint = [&](const char* code) { return colors ? code : ""; };
    const char* color = d.severity == Severity::Error     ? "\x1b[1;31m"
                        : d.severity == Severity::Warning ? "\x1b[1;35m"
                                                          : "\x1b[1;36m";
    if (!d.file.empty())
        text += fmt::format("{}{}:{}:{}:{} ", paint("\x1b[1m"), d.file, d.line, d.column, paint("\x1b[0m"));
    text += fmt::format("{}{}:{} {}", paint(color), word(d.severity), paint("\x1b[0m"), d.message);
    if (!d.node.empty())
        text += d.port.empty() ? fmt::format(" (node '{}')", d.node)
                               : fmt::format(" (node '{}', port '{}')", d.node, d.port);
    if (!d.code.empty()) text += fmt::format(" [{}]", d.code);
    text += "\n";
    show_source(text, d, colors);
    for (const Diagnostic& note : d.notes) write_text(text, note, colors);
}

using Writer = rapidjson::Writer<rapidjson::StringBuffer>;

void write_json(Writer& writer, const Diagnostic& d) {
    const auto string = [&](const char* key, std::string_view value) {
        writer.Key(key);
        writer.String(value.data(), static_cast<rapidjson::SizeType>(value.size()));
    };
    const auto number = [&](const char* key, int value) {
        writer.Key(key);
        writer.Int(value);
    };
    writer.StartObject();
    string("severity", word(d.severity));
    if (!d.code.empty()) string("code", d.code);
    string("message", d.message);
    if (!d.file.empty()) {
        string("file", d.file);
        number("line", d.line);
        number("column", d.column);
        number("endLine", d.end_line);
        number("endColumn", d.end_column);
    }
    if (!d.node.empty()) string("node", d.node);
    if (!d.port.empty()) string("port", d.port);
    if (!d.notes.empty()) {
        writer.Key("notes");
        writer.StartArray();
        for (const Diagnostic& note : d.notes) write_json(writer, note);
        writer.EndArray();
    }
    writer.EndObject();
}

}  // namespace

std::vector<Diagnostic> to_public(const Diagnostics& diagnostics, const SourceMap& sources) {
    std::vector<Diagnostic> out;
    for (const DiagnosticRecord& record : diagnostics.records()) {
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
    }
    // In the order of the text; files in the order of their first complaint.
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

std::string to_json(const Diagnostic& diagnostic) {
    rapidjson::StringBuffer buffer;
    Writer writer(buffer);
    write_json(writer, diagnostic);
    return {buffer.GetString(), buffer.GetSize()};
}

}  // namespace patina

#include "runtime/snapshot/report_data.h"

#include <fmt/format.h>

#include <cmath>

#include "compiler/json/memory/json_memory.h"
#include "runtime/page/escaped.h"

namespace patina::runtime {
namespace {

void write_text(JsonPages& writer, const char* key, const std::string& text) {
    if (text.empty()) return;
    writer.Key(key);
    writer.String(text.c_str());
}

void write_count(JsonPages& writer, const char* key, std::size_t count) {
    if (count == 0) return;
    writer.Key(key);
    writer.Uint64(count);
}

// JSON has no infinity.
void write_number(JsonPages& writer, const char* key, double value) {
    writer.Key(key);
    std::isfinite(value) ? writer.Double(value) : writer.String("infinity");
}

void write_gates(JsonPages& writer, const std::vector<Gate>& gates) {
    if (gates.empty()) return;
    writer.Key("gates");
    writer.StartObject();
    for (const Gate& gate : gates) {
        writer.Key(std::string(gate.name).c_str());
        writer.StartObject();
        write_number(writer, "value", gate.value);
        write_number(writer, "limit", gate.limit);
        writer.Key("ok");
        writer.Bool(gate.passes());
        writer.EndObject();
    }
    writer.EndObject();
}

// Why a case is not right, with the compiler's own words if it has some.
std::string reason(const SnapshotCase& each) {
    std::string text = each.message;
    for (const Diagnostic& diagnostic : each.diagnostics)
        if (diagnostic.severity == Severity::Error) text += (text.empty() ? "" : "\n") + to_text(diagnostic);
    return text;
}

void write_case(JsonPages& writer, const SnapshotCase& each) {
    writer.StartObject();
    write_text(writer, "name", each.name);
    write_text(writer, "file", each.file);
    write_text(writer, "state", std::string(to_string(each.state)));
    if (!each.ok()) write_text(writer, "message", reason(each));
    write_text(writer, "reference", each.reference);
    write_text(writer, "received", each.received);
    write_text(writer, "difference", each.difference);
    write_gates(writer, each.gates);
    write_text(writer, "device", each.now.device);
    write_text(writer, "driver", each.now.driver);
    write_text(writer, "referenceDevice", each.then.device);
    write_text(writer, "referenceDriver", each.then.driver);
    writer.Key("otherDriver");
    writer.Bool(each.other_driver);
    write_count(writer, "spirvBytes", each.now.spirv_bytes);
    write_count(writer, "referenceSpirvBytes", each.then.spirv_bytes);
    write_count(writer, "changedLines", changed_lines(each.text_diff));
    writer.EndObject();
}

bool is_drawn(const SnapshotCase& each) {
    return !each.now.device.empty();
}

}  // namespace

std::string report_json(const SnapshotReport& report) {
    JsonBuffer buffer;
    JsonPages writer(buffer);
    writer.SetIndent(' ', 2);
    writer.StartObject();
    writer.Key("ok");
    writer.Bool(report.ok());
    for (const SnapshotState state :
         {SnapshotState::Passed, SnapshotState::Failed, SnapshotState::Missing, SnapshotState::Updated}) {
        writer.Key(std::string(to_string(state)).c_str());
        writer.Uint64(report.count(state));
    }
    writer.Key("cases");
    writer.StartArray();
    for (const SnapshotCase& each : report.cases) write_case(writer, each);
    writer.EndArray();
    writer.EndObject();
    return std::string(buffer.GetString()) + "\n";
}

std::string report_junit(const SnapshotReport& report, const std::string& suite) {
    std::size_t failures = 0, errors = 0;
    double seconds = 0;
    std::string cases;
    for (const SnapshotCase& each : report.cases) {
        seconds += each.seconds;
        cases += fmt::format("    <testcase name=\"{}\" classname=\"{}\" file=\"{}\" time=\"{:.3f}\"",
                             escaped(each.name), escaped(suite), escaped(each.file), each.seconds);
        if (each.ok()) {
            cases += "/>\n";
            continue;
        }
        const char* kind = is_drawn(each) ? "failure" : "error";
        (is_drawn(each) ? failures : errors)++;
        std::string text = reason(each);
        for (const std::string& file : {each.reference, each.received, each.difference})
            if (!file.empty()) text += "\n" + file;
        cases += fmt::format(">\n      <{} message=\"{}\" type=\"{}\">{}</{}>\n    </testcase>\n", kind,
                             escaped(reason(each)), to_string(each.state), escaped(text), kind);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"{}\" tests=\"{}\" "
        "failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n{}  </testsuite>\n</testsuites>\n",
        escaped(suite), report.cases.size(), failures, errors, seconds, cases);
}

}  // namespace patina::runtime

#include "runtime/snapshot/report_data.h"

#include <fmt/format.h>

#include "compiler/json/json_writer.h"
#include "runtime/page/escaped.h"

namespace patina::runtime {
namespace {

void write_count(JsonWriter& json, std::string_view key, std::size_t count) {
    if (count > 0) json.write(key, count);
}

void write_gates(JsonWriter& json, const std::vector<Gate>& gates) {
    if (gates.empty()) return;
    json.begin("gates", '{');
    for (const Gate& gate : gates) {
        json.begin(gate.name, '{');
        json.write("value", gate.value);
        json.write("limit", gate.limit);
        json.write("ok", gate.passes());
        json.end();
    }
    json.end();
}

// Why a case is not right, with the compiler's own words if it has some.
std::string reason(const SnapshotCase& each) {
    std::string text = each.message;
    for (const Diagnostic& diagnostic : each.diagnostics)
        if (diagnostic.severity == Severity::Error) text += (text.empty() ? "" : "\n") + to_text(diagnostic);
    return text;
}

void write_case(JsonWriter& json, const SnapshotCase& each) {
    json.begin('{');
    json.if_any("name", each.name);
    json.if_any("file", each.file);
    json.write("state", each.state);
    if (!each.ok()) json.if_any("message", reason(each));
    json.if_any("reference", each.reference);
    json.if_any("received", each.received);
    json.if_any("difference", each.difference);
    write_gates(json, each.gates);
    json.if_any("device", each.now.device);
    json.if_any("driver", each.now.driver);
    json.if_any("referenceDevice", each.then.device);
    json.if_any("referenceDriver", each.then.driver);
    json.write("otherDriver", each.other_driver);
    write_count(json, "spirvBytes", each.now.spirv_bytes);
    write_count(json, "referenceSpirvBytes", each.then.spirv_bytes);
    write_count(json, "changedLines", changed_lines(each.text_diff));
    json.end();
}

bool is_drawn(const SnapshotCase& each) {
    return !each.now.device.empty();
}

}  // namespace

std::string report_json(const SnapshotReport& report) {
    JsonWriter json(JsonWriter::Layout::Pages);
    json.begin('{');
    json.write("ok", report.ok());
    for (const SnapshotState state :
         {SnapshotState::Passed, SnapshotState::Failed, SnapshotState::Missing, SnapshotState::Updated}) {
        json.write(to_string(state), report.count(state));
    }
    json.begin("cases", '[');
    for (const SnapshotCase& each : report.cases) write_case(json, each);
    json.end();
    json.end();
    return json.take() + "\n";
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

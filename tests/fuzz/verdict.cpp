#include <fmt/format.h>

#include "tests/fuzz/fuzz.h"

namespace patina::fuzz {
namespace {

std::string wrong_with_one(const Diagnostic& d, bool must_have_line) {
    const std::string text = to_text(d), colored = to_text(d, true), json = to_json(d);
    if (d.message.empty()) return "a diagnostic without a message: " + json;
    if (d.code == "internal") return text;
    if (must_have_line && d.severity == Severity::Error && d.line < 1) return "no place: " + text;
    if (d.line > 0 && (d.file.empty() || d.column < 1)) return "half a place: " + text;
    if (colored.size() < text.size() || json.find('\n') != json.npos) return "printed badly: " + text;
    for (const Diagnostic& note : d.notes)
        if (std::string wrong = wrong_with_one(note, false); !wrong.empty()) return wrong;
    return {};
}

}  // namespace

std::string wrong_with(std::span<const Diagnostic> diagnostics, bool is_ok, bool must_have_line) {
    bool has_errors = false;
    for (const Diagnostic& each : diagnostics) {
        has_errors = has_errors || each.severity == Severity::Error;
        if (std::string wrong = wrong_with_one(each, must_have_line); !wrong.empty()) return wrong;
    }
    if (is_ok != has_errors) return {};
    return is_ok ? "it is ok, and has errors: " + to_text(diagnostics[0]) : "neither ok nor an error";
}

std::string first_error(std::span<const Diagnostic> diagnostics) {
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::Error) return to_text(each);
    return {};
}

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

}  // namespace patina::fuzz

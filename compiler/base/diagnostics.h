// The room `base` holds what all other rooms use: places in sources, diagnostics, text and identifiers. It knows no
// graph, no IR and no language.
//
// The list of errors and warnings that a compilation reports. Each has a code from diagnostics.def, the narrowest wrong
// range of the source, and notes that say what to do. Reporting never throws and never stops a stage: a stage that
// cannot go on returns early, and its caller asks `has_errors()`.
//
//   diagnostics.report(Code::UnknownNode, span, "Lrep").note(other_span, "did you mean 'Lerp'?");
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/source.h"

namespace patina {

enum class Level { Error, Warning };

enum class Code {
#define DIAGNOSTIC(name, code, severity, message) name,
#include "compiler/base/diagnostics.def"
#undef DIAGNOSTIC
};

struct CodeInfo {
    std::string_view name;  // "unknown-node"
    Level severity;
    std::string_view message;  // fmt pattern
};
const CodeInfo& info(Code code);
// All codes, in the table's order.
std::span<const CodeInfo> all_codes();

struct DiagnosticNote {
    Span span;  // nowhere if the note is about the place of the diagnostic itself
    std::string message;
};

struct DiagnosticRecord {
    Code code;
    Level severity;
    Span span;
    std::string message;
    std::string node;  // graph node id, when known
    std::string port;  // port of that node, when known
    std::vector<DiagnosticNote> notes;

    DiagnosticRecord& note(Span where, std::string text) {
        notes.push_back({where, std::move(text)});
        return *this;
    }
    DiagnosticRecord& note(std::string text) { return note({}, std::move(text)); }
    DiagnosticRecord& at(std::string_view node_id, std::string_view port_name = {}) {
        node = node_id;
        port = port_name;
        return *this;
    }
};

class Diagnostics {
public:
    template <class... Args>
    DiagnosticRecord& report(Code code, Span span, const Args&... args) {
        return add(code, span, fmt::format(fmt::runtime(info(code).message), args...));
    }
    // "did you mean 'x'?", or the whole list when it is short, or nothing.
    static std::string suggestion(std::string_view word, std::span<const std::string_view> candidates);

    bool has_errors() const { return errors_ > 0; }
    // True if so many have been reported that further ones are only counted. Then notes are not needed.
    bool is_full() const;
    std::size_t error_count() const { return errors_; }
    const std::vector<DiagnosticRecord>& records() const { return records_; }

    // While a context is set, a new record gets its node and port, unless it names its own.
    void set_context(std::string_view node, std::string_view port) {
        node_ = node;
        port_ = port;
    }
    std::string_view context_node() const { return node_; }
    std::string_view context_port() const { return port_; }

private:
    DiagnosticRecord& add(Code code, Span span, std::string message);

    std::vector<DiagnosticRecord> records_;
    DiagnosticRecord overflow_{};
    std::size_t errors_ = 0;
    std::string node_, port_;
};

}  // namespace patina

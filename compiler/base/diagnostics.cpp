#include "compiler/base/diagnostics.h"

#include <array>

#include "compiler/base/cancellation.h"
#include "compiler/base/text.h"

namespace patina {
namespace {

constexpr std::array kInfos = {
#define DIAGNOSTIC(name, code, severity, message) CodeInfo{code, Level::severity, message},
#include "compiler/base/diagnostics.def"
#undef DIAGNOSTIC
};

// A graph that is wrong everywhere should not bury its reader.
constexpr std::size_t kMaxRecords = 200;

constexpr std::size_t kMostListed = 24, kMostLetters = 2000;

}  // namespace

const CodeInfo& info(Code code) {
    return kInfos[static_cast<std::size_t>(code)];
}

std::span<const CodeInfo> all_codes() {
    return kInfos;
}

bool Diagnostics::is_full() const {
    return records_.size() >= kMaxRecords;
}

DiagnosticRecord& Diagnostics::add(Code code, Span span, std::string message) {
    const Level severity = info(code).severity;
    if (severity == Level::Error) ++errors_;
    Cancellation::step(1 + records_.size() / 8);
    // The same words at the same place add nothing (a node that is lowered for two stages, say).
    for (DiagnosticRecord& record : records_) {
        if (record.code == code && record.span == span && record.message == message) return overflow_ = record;
    }
    DiagnosticRecord record{.code = code,
                            .severity = severity,
                            .span = span,
                            .message = std::move(message),
                            .node = node_,
                            .port = port_,
                            .notes = {}};
    if (records_.size() >= kMaxRecords) return overflow_ = std::move(record);
    records_.push_back(std::move(record));
    return records_.back();
}

std::string Diagnostics::suggestion(std::string_view word, std::span<const std::string_view> candidates) {
    if (const std::string_view best = nearest(word, candidates); !best.empty()) {
        return fmt::format("did you mean '{}'?", best);
    }
    // A list that is too long to read is no help.
    std::size_t letters = 0;
    for (const std::string_view candidate : candidates) letters += candidate.size();
    if (candidates.empty() || candidates.size() > kMostListed || letters > kMostLetters) return {};
    if (candidates.size() == 1) return fmt::format("there is only '{}'", candidates[0]);
    return fmt::format("these exist: {}", enumerate(candidates));
}

}  // namespace patina

#include "runtime/render/not_finite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace patina::runtime {
namespace {

std::optional<TracedValue> first_not_finite(const PixelTrace& trace) {
    const auto search = [](const std::vector<TracedValue>& values) -> std::optional<TracedValue> {
        for (const TracedValue& value : values) {
            if (!std::ranges::all_of(value.values, [](double number) { return std::isfinite(number); })) return value;
        }
        return std::nullopt;
    };
    for (const std::vector<TracedValue>& corner : trace.corners) {
        if (auto found = search(corner)) return found;
    }
    return search(trace.values);
}

}  // namespace

std::optional<Cause> cause_at(const Compiler& compiler, const World& world, const RenderOptions& options,
                              TraceWish wish) {
    const TraceOutcome front = trace_world(compiler, world, options, wish);
    if (!front.ok) return std::nullopt;
    if (auto value = first_not_finite(front.trace)) return Cause{*std::move(value), front.object, true};
    for (std::size_t object : front.trace.seen) {
        if (object == front.trace.object) continue;
        wish.object = object;
        const TraceOutcome other = trace_world(compiler, world, options, wish);
        if (auto value = first_not_finite(other.trace)) return Cause{*std::move(value), other.object, false};
    }
    return std::nullopt;
}

std::string words_of(const Cause& cause) {
    const std::string object = cause.object.empty() ? "" : fmt::format(" of the object '{}'", cause.object);
    return fmt::format(": '{}.{}'{} is {:.6g} there", cause.value.node, cause.value.port, object,
                       fmt::join(cause.value.values, ", "));
}

void blame(Diagnostic& warning, const Cause& cause) {
    warning.node = cause.value.node;
    warning.port = cause.value.port;
    if (cause.value.file.empty()) return;
    warning.file = cause.value.file;
    warning.line = cause.value.line;
    warning.column = cause.value.column;
}

}  // namespace patina::runtime

#include "compiler/exporters/mtlx/smoothing.h"

#include <algorithm>

namespace patina::exporters::mtlx {
namespace {

constexpr double kLeast = 1e-6;
constexpr int kDeepest = 10;

bool is_derivative(ir::Op op) {
    return op == ir::Op::Ddx || op == ir::Op::Ddy || op == ir::Op::Fwidth;
}

// Operations that make one width of several: "sqrt(x * x + y * y)".
bool joins_widths(ir::Op op) {
    static constexpr ir::Op kOps[] = {ir::Op::Add, ir::Op::Mul, ir::Op::Sqrt,      ir::Op::Abs,     ir::Op::Length,
                                      ir::Op::Dot, ir::Op::Max, ir::Op::Construct, ir::Op::Extract, ir::Op::Swizzle};
    return std::find(std::begin(kOps), std::end(kOps), op) != std::end(kOps);
}

// Made of derivatives, and of numbers that scale them.
bool is_width(const NodeWriter& writer, ir::Value value, int depth = 0) {
    if (is_derivative(writer[value].op)) return true;
    if (depth > kDeepest || !joins_widths(writer[value].op)) return false;
    bool is_any = false;
    for (const ir::Value each : writer.function().args(value)) {
        if (writer.constant(each)) continue;
        if (!is_width(writer, each, depth + 1)) return false;
        is_any = true;
    }
    return is_any;
}

std::optional<Ref> least_width(NodeWriter& writer, ir::Value value) {
    const auto args = writer.function().args(value);
    const std::size_t width = is_width(writer, args[0]) ? 0 : 1;
    const ir::Value other = args[1 - width];
    if (!is_width(writer, args[width]) || is_width(writer, other)) return std::nullopt;
    const Ref ref = writer.value(other);
    const bool is_positive =
        ref.is_number() && std::all_of(ref.numbers.begin(), ref.numbers.end(), [](double each) { return each > 0; });
    return is_positive ? ref : writer.combine("max", ref, {.numbers = {kLeast}});
}

// Of "c - width" or "c + width", by the operation: c. Else the value itself.
ir::Value without_width(const NodeWriter& writer, ir::Value value, ir::Op operation) {
    if (writer[value].op != operation) return value;
    const auto args = writer.function().args(value);
    if (is_width(writer, args[1])) return args[0];
    return operation == ir::Op::Add && is_width(writer, args[0]) ? args[1] : value;
}

std::optional<Ref> sharp_step(NodeWriter& writer, ir::Value value) {
    const auto args = writer.function().args(value);
    if (!writer[value].type.is_scalar()) return std::nullopt;
    const ir::Value low = without_width(writer, args[0], ir::Op::Sub),
                    high = without_width(writer, args[1], ir::Op::Add);
    const bool has_width = low.index != args[0].index || high.index != args[1].index;
    const auto number = writer.constant(low);
    if (!has_width || (low.index != high.index && (!number || number != writer.constant(high)))) return std::nullopt;
    const Ref edge = writer.value(low), in = writer.value(args[2]);
    return writer.node("ifgreatereq", "float",
                       {{.name = "value1", .value = in, .type = "float"},
                        {.name = "value2", .value = edge, .type = "float"},
                        {.name = "in1", .value = {.numbers = {1}}, .type = "float"},
                        {.name = "in2", .value = {.numbers = {0}}, .type = "float"}});
}

}  // namespace

std::optional<Ref> sharp_edge(NodeWriter& writer, ir::Value value) {
    std::optional<Ref> made;
    if (writer[value].op == ir::Op::Max) made = least_width(writer, value);
    if (writer[value].op == ir::Op::Smoothstep) made = sharp_step(writer, value);
    if (made) writer.differs(writer.span_of(value), "an edge is not smoothed over a pixel");
    return made;
}

}  // namespace patina::exporters::mtlx

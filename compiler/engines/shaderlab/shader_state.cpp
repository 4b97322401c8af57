// Writes the state of a pass in ShaderLab's words.
#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

#include "compiler/base/text.h"
#include "compiler/engines/shaderlab/shader_file.h"

namespace patina::engines::shaderlab {
namespace {

struct QueueRow {
    std::string_view name;
    int queue;
};
constexpr QueueRow kQueues[] = {
    {"Background", 1000}, {"Geometry", 2000}, {"AlphaTest", 2450}, {"Transparent", 3000}, {"Overlay", 4000}};

}  // namespace

std::string queue_word(int queue) {
    const QueueRow* nearest = &kQueues[0];
    for (const QueueRow& row : kQueues) {
        if (std::abs(row.queue - queue) < std::abs(nearest->queue - queue)) nearest = &row;
    }
    return queue == nearest->queue ? std::string(nearest->name)
                                   : fmt::format("{}{:+}", nearest->name, queue - nearest->queue);
}

namespace {

// "oneMinusSrcAlpha" -> "OneMinusSrcAlpha", "notEqual" -> "NotEqual"
std::string in_capitals(std::string_view word) {
    std::string made;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] == '_') continue;
        const bool begins = i == 0 || word[i - 1] == '_';
        made += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(word[i]))) : word[i];
    }
    return made;
}

std::string compare_word(Compare compare) {
    if (compare == Compare::LessEqual) return "LEqual";
    return compare == Compare::GreaterEqual ? "GEqual" : in_capitals(to_string(compare));
}

// Unity's IncrSat stops at 255, IncrWrap goes on at 0.
std::string operation_word(StencilOp operation) {
    switch (operation) {
        case StencilOp::Increment: return "IncrSat";
        case StencilOp::Decrement: return "DecrSat";
        case StencilOp::IncrementWrap: return "IncrWrap";
        case StencilOp::DecrementWrap: return "DecrWrap";
        case StencilOp::Keep:
        case StencilOp::Zero:
        case StencilOp::Replace:
        case StencilOp::Invert: break;
    }
    return in_capitals(to_string(operation));
}

std::string factor_word(BlendFactor factor) {
    return in_capitals(to_string(factor));
}

std::string stencil_line(const Stencil& stencil) {
    std::string made = fmt::format("Ref {} Comp {}", stencil.value, compare_word(stencil.test));
    if (stencil.read_mask != 255) made += fmt::format(" ReadMask {}", stencil.read_mask);
    if (stencil.write_mask != 255) made += fmt::format(" WriteMask {}", stencil.write_mask);
    for (const auto& [word, operation] :
         {std::pair("Pass", stencil.pass), std::pair("Fail", stencil.fail), std::pair("ZFail", stencil.depth_fail)}) {
        if (operation != StencilOp::Keep) made += fmt::format(" {} {}", word, operation_word(operation));
    }
    return fmt::format("Stencil {{ {} }}", made);
}

std::string blend_line(const Blend& blend) {
    std::string factors = fmt::format("{} {}", factor_word(blend.source), factor_word(blend.destination));
    if (blend.source_alpha != blend.source || blend.destination_alpha != blend.destination)
        factors += fmt::format(", {} {}", factor_word(blend.source_alpha), factor_word(blend.destination_alpha));
    return "Blend " + factors;
}

}  // namespace

std::vector<std::string> shader_state(const Pass& pass) {
    std::vector<std::string> lines;
    if (pass.cull != Cull::Back) lines.push_back(fmt::format("Cull {}", in_capitals(to_string(pass.cull))));
    if (!pass.depth_write) lines.emplace_back("ZWrite Off");
    if (pass.depth_test != Compare::LessEqual) lines.push_back(fmt::format("ZTest {}", compare_word(pass.depth_test)));
    if (pass.depth_bias != 0 || pass.depth_slope_bias != 0)
        lines.push_back(fmt::format("Offset {}, {}", shortest(pass.depth_slope_bias), shortest(pass.depth_bias)));
    if (pass.stencil.is_used()) lines.push_back(stencil_line(pass.stencil));
    const Blend blend = pass.targets.empty() ? Blend{} : pass.targets.front().blend;
    if (blend.is_on()) lines.push_back(blend_line(blend));
    return lines;
}

}  // namespace patina::engines::shaderlab

// The state of a pass in ShaderLab's words.
#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

#include "compiler/base/text.h"
#include "compiler/engines/shaderlab/shader_file.h"

namespace patina::assemble {
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

// "oneMinusSrcAlpha" -> "OneMinusSrcAlpha", "lessEqual" -> "LessEqual"
std::string in_capitals(std::string_view word) {
    std::string made;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] == '_') continue;
        const bool begins = i == 0 || word[i - 1] == '_';
        made += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(word[i]))) : word[i];
    }
    return made;
}

std::string compare_word(std::string_view word) {
    const std::string made = in_capitals(word);
    if (made == "LessEqual") return "LEqual";
    return made == "GreaterEqual" ? "GEqual" : made;
}

// Unity's IncrSat stops at 255, IncrWrap goes on at 0.
std::string operation_word(std::string_view word) {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {{"increment", "IncrSat"},
                                                                        {"decrement", "DecrSat"},
                                                                        {"incrementWrap", "IncrWrap"},
                                                                        {"decrementWrap", "DecrWrap"}};
    for (const auto& [ours, unitys] : kWords) {
        if (word == ours) return std::string(unitys);
    }
    return in_capitals(word);
}

std::string stencil_line(const Stencil& stencil) {
    std::string made = fmt::format("Ref {} Comp {}", stencil.value, compare_word(stencil.test));
    if (stencil.read_mask != 255) made += fmt::format(" ReadMask {}", stencil.read_mask);
    if (stencil.write_mask != 255) made += fmt::format(" WriteMask {}", stencil.write_mask);
    for (const auto& [word, operation] :
         {std::pair("Pass", stencil.pass), std::pair("Fail", stencil.fail), std::pair("ZFail", stencil.depth_fail)}) {
        if (operation != "keep") made += fmt::format(" {} {}", word, operation_word(operation));
    }
    return fmt::format("Stencil {{ {} }}", made);
}

std::string blend_line(const Blend& blend) {
    std::string factors = fmt::format("{} {}", in_capitals(blend.source), in_capitals(blend.destination));
    if (blend.source_alpha != blend.source || blend.destination_alpha != blend.destination)
        factors += fmt::format(", {} {}", in_capitals(blend.source_alpha), in_capitals(blend.destination_alpha));
    return "Blend " + factors;
}

}  // namespace

std::vector<std::string> shader_state(const Pass& pass) {
    std::vector<std::string> lines;
    if (pass.cull != "back") lines.push_back(fmt::format("Cull {}", in_capitals(pass.cull)));
    if (!pass.depth_write) lines.emplace_back("ZWrite Off");
    if (pass.depth_test != "lessEqual") lines.push_back(fmt::format("ZTest {}", compare_word(pass.depth_test)));
    if (pass.depth_bias != 0 || pass.depth_slope_bias != 0)
        lines.push_back(fmt::format("Offset {}, {}", shortest(pass.depth_slope_bias), shortest(pass.depth_bias)));
    if (pass.stencil.is_used()) lines.push_back(stencil_line(pass.stencil));
    const Blend blend = pass.targets.empty() ? Blend{} : pass.targets.front().blend;
    if (blend != Blend{}) lines.push_back(blend_line(blend));
    return lines;
}

}  // namespace patina::assemble

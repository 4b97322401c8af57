// Writes the state of a pass in ShaderLab's words.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/writers/shaderlab/shader_file.h"

namespace patina::writers::shaderlab {
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
        made += begins ? to_upper(word[i]) : word[i];
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

// --- state that a material can change

// Unity's numbers, in the order of Patina's words. UnityEngine.Rendering.CompareFunction has 1 for the first of them.
constexpr int kFactorNumbers[] = {1, 0, 5, 10, 7, 8, 3, 2, 6, 4};  // UnityEngine.Rendering.BlendMode
constexpr int kCullNumbers[] = {2, 1, 0};                          // UnityEngine.Rendering.CullMode

template <class E>
std::size_t index_of(E value) {
    return static_cast<std::size_t>(value);
}

struct FactorRow {
    BlendFactor Blend::*factor;
    std::string_view property, label;
};
constexpr FactorRow kFactors[] = {{&Blend::source, "_SrcBlend", "Source Factor"},
                                  {&Blend::destination, "_DstBlend", "Destination Factor"},
                                  {&Blend::source_alpha, "_SrcBlendAlpha", "Source Factor of Alpha"},
                                  {&Blend::destination_alpha, "_DstBlendAlpha", "Destination Factor of Alpha"}};
constexpr std::string_view kWrite = "_ZWrite", kTest = "_ZTest", kCull = "_Cull";

bool is_overridable(const LinkedPass& pass) {
    return pass.material->graph->graph->render.is_overridable;
}

// True if the kinds of surfaces that the pass draws differ in the factor.
bool depends_on_kind(const paths::PassDecl& pass, BlendFactor Blend::*factor) {
    return std::any_of(pass.blends.begin(), pass.blends.end(), [&](const paths::BlendRow& row) {
        return row.blend.*factor != pass.blends.front().blend.*factor;
    });
}

// True if the pass has all state that a material can change: the one that draws the object first.
bool has_all_state(const paths::PassDecl& pass) {
    return !pass.has_depth && !pass.has_cull && std::all_of(std::begin(kFactors), std::end(kFactors), [&](auto& row) {
        return depends_on_kind(pass, row.factor);
    });
}

// "Blend [_SrcBlend] One, Zero One". Empty if all kinds of surfaces that the pass draws are blended alike.
std::string chosen_blend_line(const paths::PassDecl& pass) {
    std::string made = "Blend";
    bool is_chosen = false;
    for (const FactorRow& row : kFactors) {
        const bool depends = depends_on_kind(pass, row.factor);
        is_chosen = is_chosen || depends;
        if (&row == &kFactors[2]) made += ',';
        made += depends ? fmt::format(" [{}]", row.property) : " " + factor_word(pass.blends.front().blend.*row.factor);
    }
    return is_chosen ? made : std::string();
}

// A pass that draws the object again and has its own test, for example the light's, keeps it.
void add_chosen_state(const Pass& pass, const LinkedPass& linked, std::vector<std::string>& lines) {
    const paths::PassDecl& declared = *linked.pass->declaration;
    const Compare own = linked.material->graph->graph->render.depth_test.value_or(Compare::LessEqual);
    if (!declared.has_cull) lines.push_back(fmt::format("Cull [{}]", kCull));
    if (!declared.has_depth) lines.push_back(fmt::format("ZWrite [{}]", kWrite));
    if (declared.has_depth && !pass.depth_write) lines.emplace_back("ZWrite Off");
    if (!declared.has_depth || (!pass.depth_write && pass.depth_test == own))
        lines.push_back(fmt::format("ZTest [{}]", kTest));
    else if (pass.depth_test != Compare::LessEqual)
        lines.push_back(fmt::format("ZTest {}", compare_word(pass.depth_test)));
}

void add_fixed_state(const Pass& pass, std::vector<std::string>& lines) {
    if (pass.cull != Cull::Back) lines.push_back(fmt::format("Cull {}", in_capitals(to_string(pass.cull))));
    if (!pass.depth_write) lines.emplace_back("ZWrite Off");
    if (pass.depth_test != Compare::LessEqual) lines.push_back(fmt::format("ZTest {}", compare_word(pass.depth_test)));
}

}  // namespace

bool is_state_property(std::string_view name) {
    return name == kWrite || name == kTest || name == kCull ||
           std::any_of(std::begin(kFactors), std::end(kFactors), [&](auto& row) { return row.property == name; });
}

std::vector<std::string> state_properties(const Reflection& reflection, std::span<const LinkedPass> passes) {
    const auto first = std::find_if(passes.begin(), passes.end(), [](const LinkedPass& each) {
        return is_overridable(each) && has_all_state(*each.pass->declaration);
    });
    if (first == passes.end()) return {};
    const Pass& pass = reflection.passes[static_cast<std::size_t>(first - passes.begin())];
    std::vector<std::string> lines = {"", "[Header(Render State)]"};
    const auto add = [&](std::string_view list, std::string_view name, std::string_view label, int value) {
        lines.push_back(fmt::format("[Enum({})] {} (\"{}\", Float) = {}", list, name, label, value));
    };
    const Blend blend = pass.targets.front().blend;
    for (const FactorRow& row : kFactors)
        add("UnityEngine.Rendering.BlendMode", row.property, row.label, kFactorNumbers[index_of(blend.*row.factor)]);
    add("Off, 0, On, 1", kWrite, "Depth Write", pass.depth_write ? 1 : 0);
    add("UnityEngine.Rendering.CompareFunction", kTest, "Depth Test", static_cast<int>(index_of(pass.depth_test)) + 1);
    add("UnityEngine.Rendering.CullMode", kCull, "Culled Faces", kCullNumbers[index_of(pass.cull)]);
    return lines;
}

std::vector<std::string> shader_state(const Pass& pass, const LinkedPass& linked) {
    std::vector<std::string> lines;
    if (is_overridable(linked))
        add_chosen_state(pass, linked, lines);
    else
        add_fixed_state(pass, lines);
    if (pass.depth_bias != 0 || pass.depth_slope_bias != 0)
        lines.push_back(fmt::format("Offset {}, {}", shortest(pass.depth_slope_bias), shortest(pass.depth_bias)));
    if (pass.stencil.is_used()) lines.push_back(stencil_line(pass.stencil));
    const std::string chosen =
        is_overridable(linked) && !pass.targets.empty() && !linked.pass->declaration->blends.empty()
            ? chosen_blend_line(*linked.pass->declaration)
            : std::string();
    const Blend blend = pass.targets.empty() ? Blend{} : pass.targets.front().blend;
    if (!chosen.empty())
        lines.push_back(chosen);
    else if (blend.is_on())
        lines.push_back(blend_line(blend));
    return lines;
}

}  // namespace patina::writers::shaderlab

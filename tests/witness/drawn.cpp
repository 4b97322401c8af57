#include "witness/drawn.h"

#include <gtest/gtest.h>

#include "patina/validate.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/gpu/renderer.h"

namespace patina::witness {

using runtime::Image;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

CompileOptions options_for(const std::map<std::string, std::string>& files) {
    CompileOptions options;
    options.files.read = [files](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path.substr(path.find_last_of('/') + 1));
        return found == files.end() ? std::nullopt : std::optional(found->second);
    };
    return options;
}

std::string text_of(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) text += to_text(diagnostic);
    return text;
}

runtime::Renderer& renderer() {
    static const auto kOpened = runtime::Renderer::open({.validation = true});
    EXPECT_TRUE(kOpened) << kOpened.error;
    return *kOpened.value;
}

std::vector<std::uint32_t> spirv_of(const Result& result, Stage stage, Target target) {
    for (const Shader& shader : result.shaders) {
        if (shader.stage != stage || shader.target != target) continue;
        Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log << shader.text;
        return validated.spirv;
    }
    ADD_FAILURE() << "there is no such stage";
    return {};
}

// A quad that fills the picture. Null target: the CPU.
Image drawn(const Result& result, std::optional<Target> target, const std::map<std::string, std::string>& words) {
    runtime::Scene scene = runtime::fullscreen_scene(8, 8);
    const auto values = runtime::material_values(result.reflection, words);
    EXPECT_TRUE(values) << values.error;
    const auto blocks = runtime::fill_blocks(result.reflection, values.value, scene);
    runtime::Draw draw{.reflection = &result.reflection,
                       .scene = &scene,
                       .blocks = blocks,
                       .constants = runtime::constants_of(result.reflection, values.value),
                       .program = result.program.get()};
    if (!target) {
        auto image = runtime::cpu_draw(draw, Precision::Double);
        EXPECT_TRUE(image) << image.error;
        return std::move(image.value);
    }
    const auto vertex = spirv_of(result, Stage::Vertex, *target), fragment = spirv_of(result, Stage::Fragment, *target);
    draw.vertex_spirv = vertex;
    draw.fragment_spirv = fragment;
    auto image = renderer().draw(draw);
    EXPECT_TRUE(image) << image.error;
    return std::move(image.value);
}

}  // namespace patina::witness

// What is refused before a device is asked for more than it says it has: each limit lowered by one below a small draw's
// need, and what lavapipe cannot take as it is.
#include "runtime/gpu/limits.h"

#include <gtest/gtest.h>

#include "patina/validate.h"

namespace patina::runtime {
namespace {

std::vector<std::uint32_t> compiled(Stage stage, const std::string& text) {
    Shader shader;
    shader.stage = stage;
    shader.text = text;
    Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << validated.log;
    return validated.spirv;
}

// Three blocks, of which the renderer binds one twice, in sets 0 and 1; two textures; three vertex inputs; two values
// between the stages; 10 x 20 pixels of 2 x 2 samples.
class Limits : public testing::Test {
protected:
    Limits() {
        for (std::uint32_t i = 0; i < 3; i++) {
            Block& block = reflection.blocks.emplace_back();
            block.name = "Block" + std::to_string(i);
            block.set = i / 2;
            block.size = 64;
        }
        TextureData data{.levels = mip_chain(make_image(8, 30)), .sampler = {}};
        for (const char* name : {"_A", "_B"}) {
            Texture& texture = reflection.textures.emplace_back();
            texture.name = name;
            texture.sampler_binding = 10 + static_cast<std::uint32_t>(reflection.textures.size());
            textures.push_back({.name = name, .data = std::make_shared<const TextureData>(data)});
        }
        Pass& pass = reflection.passes.emplace_back();
        pass.name = "forward";
        for (std::uint32_t i = 0; i < 3; i++) pass.vertex_inputs.push_back({"input", ValueType::Float4, i, ""});
        scene.samples = 2;

        for (std::uint32_t* limit :
             {&limits.maxImageDimension2D, &limits.maxFramebufferWidth, &limits.maxFramebufferHeight,
              &limits.maxPerStageDescriptorSamplers, &limits.maxPerStageDescriptorSampledImages,
              &limits.maxPerStageDescriptorUniformBuffers, &limits.maxPerStageResources, &limits.maxBoundDescriptorSets,
              &limits.maxUniformBufferRange, &limits.maxVertexInputAttributes, &limits.maxVertexOutputComponents,
              &limits.maxFragmentInputComponents})
            *limit = 1000;
    }
    std::string error() const {
        return beyond_limits(limits, "gpu",
                             {.reflection = &reflection,
                              .scene = &scene,
                              .textures = textures,
                              .vertex_spirv = vertex,
                              .fragment_spirv = fragment});
    }

    Reflection reflection;
    std::vector<LoadedTexture> textures;
    Scene scene = fullscreen_scene(10, 20);
    std::vector<std::uint32_t> vertex = compiled(Stage::Vertex, R"(#version 450
        layout(location = 0) out float a;
        layout(location = 1) out vec2 b;
        void main() { a = 0; b = vec2(0); gl_Position = vec4(0); })");
    std::vector<std::uint32_t> fragment = compiled(Stage::Fragment, R"(#version 450
        layout(location = 0) in float a;
        layout(location = 1) in vec2 b;
        layout(location = 0) out vec4 result;
        void main() { result = vec4(a, b, 0); })");
    VkPhysicalDeviceLimits limits{};
};

TEST_F(Limits, EachIsKept) {
    struct Case {
        std::uint32_t VkPhysicalDeviceLimits::*limit;
        std::uint32_t need;
        const char* expected;
    };
    for (Case each : {
             Case{&VkPhysicalDeviceLimits::maxImageDimension2D, 40, "(maxImageDimension2D)"},
             Case{&VkPhysicalDeviceLimits::maxFramebufferWidth, 40, "(maxFramebufferWidth)"},
             Case{&VkPhysicalDeviceLimits::maxFramebufferHeight, 40, "(maxFramebufferHeight)"},
             Case{&VkPhysicalDeviceLimits::maxPerStageDescriptorSamplers, 2, "(maxPerStageDescriptorSamplers)"},
             Case{&VkPhysicalDeviceLimits::maxPerStageDescriptorSampledImages, 2,
                  "(maxPerStageDescriptorSampledImages)"},
             Case{&VkPhysicalDeviceLimits::maxPerStageDescriptorUniformBuffers, 4,
                  "4 uniform buffers: its limit is 3 (maxPerStageDescriptorUniformBuffers)"},
             Case{&VkPhysicalDeviceLimits::maxPerStageResources, 7, "(maxPerStageResources)"},
             Case{&VkPhysicalDeviceLimits::maxBoundDescriptorSets, 2, "(maxBoundDescriptorSets)"},
             Case{&VkPhysicalDeviceLimits::maxUniformBufferRange, 64, "the block 'Block0' of 64 bytes"},
             Case{&VkPhysicalDeviceLimits::maxVertexInputAttributes, 3, "(maxVertexInputAttributes)"},
             Case{&VkPhysicalDeviceLimits::maxVertexOutputComponents, 15, "(maxVertexOutputComponents)"},
             Case{&VkPhysicalDeviceLimits::maxFragmentInputComponents, 8, "(maxFragmentInputComponents)"},
         }) {
        limits.*each.limit = each.need;
        EXPECT_EQ(error(), "");
        limits.*each.limit = each.need - 1;
        EXPECT_NE(error().find(each.expected), std::string::npos) << each.expected << ": " << error();
        EXPECT_TRUE(error().starts_with("'gpu' cannot take ")) << error();
        limits.*each.limit = 1000;
    }
}

TEST_F(Limits, TexturesThatShareASamplerNeedOne) {
    limits.maxPerStageDescriptorSamplers = 1;
    EXPECT_EQ(error(), "'gpu' cannot take the material's 2 samplers: its limit is 1 (maxPerStageDescriptorSamplers)");
    reflection.textures[1].sampler_binding = reflection.textures[0].sampler_binding;
    EXPECT_EQ(error(), "");
}

TEST_F(Limits, ATextureThatIsTooLargeIsNamed) {
    scene.samples = 1;
    limits.maxImageDimension2D = 29;
    EXPECT_EQ(error(), "'gpu' cannot take the texture '_A' of 8 x 30 texels: its limit is 29 (maxImageDimension2D)");
}

// Every device takes four targets, so more than that are counted.
TEST_F(Limits, TooManyTargetsOfAStepAreRefused) {
    Reflection reflection;
    Pass pass;
    pass.name = "gbuffer";
    const Mesh mesh;
    Frame frame{.targets = std::vector<FrameTarget>(7, FrameTarget{.width = 8, .height = 8})};
    frame.steps = {
        FrameStep{.reflection = &reflection, .pass = &pass, .mesh = &mesh, .targets = {0, 1, 2, 3, 4, 5, 6}}};
    for (std::uint32_t* limit : {&limits.maxColorAttachments, &limits.maxFragmentOutputAttachments}) *limit = 7;
    EXPECT_EQ(beyond_limits(limits, "gpu", frame), "");
    limits.maxFragmentOutputAttachments = 6;
    EXPECT_EQ(beyond_limits(limits, "gpu", frame),
              "'gpu' cannot take the 7 targets of the pass 'gbuffer': its limit is 6 "
              "(maxFragmentOutputAttachments)");
    limits.maxColorAttachments = 6;
    EXPECT_TRUE(beyond_limits(limits, "gpu", frame).ends_with("6 (maxColorAttachments)"));
}

// In tiles, the images are smaller than the picture.
TEST_F(Limits, AnImageThatIsTooLargeIsRefused) {
    Frame frame{.targets = {{.name = "color", .width = 600, .height = 400, .is_of_picture = true}}};
    constexpr std::uint64_t kBytes = 600 * 400 * 16;
    EXPECT_EQ(beyond_limits(limits, "gpu", frame, kBytes), "");
    EXPECT_EQ(beyond_limits(limits, "gpu", frame, kBytes - 1),
              "'gpu' cannot take a picture of 600 x 400 samples, which is an image of 3840000 bytes: its limit is "
              "3839999 (maxMemoryAllocationSize)");
    limits.maxImageDimension2D = 100;
    EXPECT_NE(beyond_limits(limits, "gpu", frame), "");
    frame.tile = 100;
    EXPECT_EQ(beyond_limits(limits, "gpu", frame, 100 * 100 * 16), "");
}

}  // namespace
}  // namespace patina::runtime

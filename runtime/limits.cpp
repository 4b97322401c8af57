#include "runtime/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "runtime/pipeline.h"

namespace patina::runtime {
namespace {

// How many locations a stage's variables of one storage class take: the highest and those below. Each variable of a
// generated shader is a number or a vector, which takes one.
std::uint32_t location_count(std::span<const std::uint32_t> spirv, std::uint32_t storage_class) {
    constexpr std::size_t kHeader = 5;
    constexpr std::uint32_t kOpVariable = 59, kOpDecorate = 71, kLocation = 30;
    std::map<std::uint32_t, std::uint32_t> locations;  // of a variable
    std::uint32_t count = 0;
    for (std::size_t at = kHeader; at < spirv.size();) {
        const std::uint32_t operation = spirv[at] & 0xffffu, length = spirv[at] >> 16;
        if (length == 0 || at + length > spirv.size()) break;
        std::span<const std::uint32_t> operands = spirv.subspan(at + 1, length - 1);
        if (operation == kOpDecorate && operands.size() == 3 && operands[1] == kLocation)
            locations[operands[0]] = operands[2];
        // Decorations come before variables.
        if (operation == kOpVariable && operands[2] == storage_class)
            if (auto found = locations.find(operands[1]); found != locations.end())
                count = std::max(count, found->second + 1);
        at += length;
    }
    return count;
}

struct Need {
    std::string what;  // "the material's 33 textures"
    std::uint64_t amount = 0;
    std::uint64_t limit = 0;
    const char* name = "";  // Vulkan's
};

std::vector<Need> needs_of(const VkPhysicalDeviceLimits& limits, const Draw& draw) {
    const Reflection& reflection = *draw.reflection;
    std::vector<Need> needs;
    const auto add = [&](std::string what, std::uint64_t amount, std::uint64_t limit, const char* name) {
        needs.push_back({.what = std::move(what), .amount = amount, .limit = limit, .name = name});
    };

    const Scene& scene = *draw.scene;
    const std::uint64_t side = std::uint64_t(std::max(scene.width, scene.height)) * scene.samples;
    std::string picture = fmt::format("a picture that is {} samples on a side", side);
    add(picture, side, limits.maxImageDimension2D, "maxImageDimension2D");
    add(picture, side, limits.maxFramebufferWidth, "maxFramebufferWidth");
    add(picture, side, limits.maxFramebufferHeight, "maxFramebufferHeight");
    for (const LoadedTexture& texture : draw.textures) {
        const TextureLevel& level = texture.data->levels.front();
        add(fmt::format("the texture '{}' of {} x {} texels", texture.name, level.width, level.height),
            std::uint64_t(std::max(level.width, level.height)), limits.maxImageDimension2D, "maxImageDimension2D");
    }

    // Both stages see everything that the reflection has.
    const std::size_t textures = draw.textures.size(), buffers = uniform_buffer_count(reflection);
    std::uint32_t sets = 0;
    for (const Block& block : reflection.blocks) sets = std::max(sets, block.set + 1);
    for (const Texture& texture : reflection.textures) sets = std::max(sets, texture.set + 1);
    const std::string all_textures = fmt::format("the material's {} textures", textures);
    add(all_textures, textures, limits.maxPerStageDescriptorSamplers, "maxPerStageDescriptorSamplers");
    add(all_textures, textures, limits.maxPerStageDescriptorSampledImages, "maxPerStageDescriptorSampledImages");
    add(fmt::format("the material's {} uniform buffers", buffers), buffers, limits.maxPerStageDescriptorUniformBuffers,
        "maxPerStageDescriptorUniformBuffers");
    const std::size_t resources = textures + buffers + 1;
    add(fmt::format("the material's {} textures, buffers and targets", resources), resources,
        limits.maxPerStageResources, "maxPerStageResources");
    add(fmt::format("the material's {} descriptor sets", sets), sets, limits.maxBoundDescriptorSets,
        "maxBoundDescriptorSets");
    for (const Block& block : reflection.blocks)
        add(fmt::format("the block '{}' of {} bytes", block.name, block.size), block.size, limits.maxUniformBufferRange,
            "maxUniformBufferRange");

    for (const Pass& pass : reflection.passes) {
        if (pass.name != draw.pass) continue;
        std::uint32_t inputs = 0;
        for (const VertexInput& input : pass.vertex_inputs) inputs = std::max(inputs, input.location + 1);
        add(fmt::format("the material's {} vertex inputs", inputs), inputs, limits.maxVertexInputAttributes,
            "maxVertexInputAttributes");
    }
    // A location counts as four numbers, however many are used. GLSL's gl_PerVertex counts too: a position, a point
    // size, a clip and a cull distance.
    constexpr std::uint32_t kInput = 1, kOutput = 3;
    constexpr std::uint64_t kPerVertex = 7;
    const std::uint64_t outputs = 4 * std::uint64_t(location_count(draw.vertex_spirv, kOutput)) + kPerVertex;
    const std::uint64_t inputs = 4 * std::uint64_t(location_count(draw.fragment_spirv, kInput));
    add(fmt::format("the {} numbers that the vertex stage hands on, its position among them", outputs), outputs,
        limits.maxVertexOutputComponents, "maxVertexOutputComponents");
    add(fmt::format("the {} numbers that the fragment stage takes, four for each value", inputs), inputs,
        limits.maxFragmentInputComponents, "maxFragmentInputComponents");
    return needs;
}

}  // namespace

std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Draw& draw) {
    for (const Need& need : needs_of(limits, draw)) {
        if (need.amount <= need.limit) continue;
        return fmt::format("'{}' cannot take {}: its limit is {} ({})", device, need.what, need.limit, need.name);
    }
    return "";
}

}  // namespace patina::runtime

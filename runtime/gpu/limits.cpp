#include "runtime/gpu/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "runtime/frame/pixel_format.h"
#include "runtime/frame/tiles.h"
#include "runtime/gpu/bindings.h"

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

// Textures may share samplers.
std::size_t sampler_count(const FrameStep& step) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    const auto add = [&](const std::string& name) {
        for (const Texture& texture : step.reflection->textures)
            if (texture.name == name) places.insert({texture.set, texture.sampler_binding});
    };
    for (const LoadedTexture& texture : step.textures) add(texture.name);
    for (const FrameRead& read : step.reads) add(read.texture);
    for (const BoundSampler& sampler : step.reflection->samplers) places.insert({sampler.set, sampler.binding});
    return places.size();
}

class Needs {
public:
    Needs(const VkPhysicalDeviceLimits& limits, std::uint64_t most_allocation)
        : limits_(limits), most_allocation_(most_allocation) {}

    // As large as its image is: in tiles, smaller than the picture.
    void add_target(glm::ivec2 size, const PixelFormat& format);
    void add_step(const FrameStep& step);
    // The first number that exceeds its limit; null: there is none.
    const Need* unmet() const {
        auto found =
            std::find_if(needs_.begin(), needs_.end(), [](const Need& need) { return need.amount > need.limit; });
        return found == needs_.end() ? nullptr : &*found;
    }

private:
    void add(std::string what, std::uint64_t amount, std::uint64_t limit, const char* name) {
        needs_.push_back({.what = std::move(what), .amount = amount, .limit = limit, .name = name});
    }
    void add_bindings(const FrameStep& step);
    void add_stages(const FrameStep& step);

    const VkPhysicalDeviceLimits& limits_;
    std::uint64_t most_allocation_;
    std::vector<Need> needs_;
};

void Needs::add_target(glm::ivec2 size, const PixelFormat& format) {
    const auto side = std::uint64_t(std::max(size.x, size.y));
    const std::string picture = fmt::format("a picture that is {} samples on a side", side);
    add(picture, side, limits_.maxImageDimension2D, "maxImageDimension2D");
    add(picture, side, limits_.maxFramebufferWidth, "maxFramebufferWidth");
    add(picture, side, limits_.maxFramebufferHeight, "maxFramebufferHeight");
    const std::uint64_t bytes = std::uint64_t(size.x) * std::uint64_t(size.y) * format.bytes;
    add(fmt::format("a picture of {} x {} samples, which is an image of {} bytes", size.x, size.y, bytes), bytes,
        most_allocation_, "maxMemoryAllocationSize");
}

void Needs::add_step(const FrameStep& step) {
    for (const LoadedTexture& texture : step.textures) {
        const TextureLevel& level = texture.data->levels.front();
        add(fmt::format("the texture '{}' of {} x {} texels", texture.name, level.width, level.height),
            std::uint64_t(std::max(level.width, level.height)), limits_.maxImageDimension2D, "maxImageDimension2D");
    }
    // Every device takes four.
    if (const std::size_t targets = step.targets.size(); targets > 4) {
        const std::string too_many = fmt::format("the {} targets of the pass '{}'", targets, step.pass->name);
        add(too_many, targets, limits_.maxColorAttachments, "maxColorAttachments");
        add(too_many, targets, limits_.maxFragmentOutputAttachments, "maxFragmentOutputAttachments");
    }
    add_bindings(step);
    add_stages(step);
}

// Both stages see everything that the reflection has.
void Needs::add_bindings(const FrameStep& step) {
    const Reflection& reflection = *step.reflection;
    const std::size_t textures = step.textures.size() + step.reads.size(), buffers = uniform_buffer_count(reflection);
    std::uint32_t sets = 0;
    for (const Block& block : reflection.blocks) sets = std::max(sets, block.set + 1);
    for (const Texture& texture : reflection.textures) sets = std::max(sets, texture.set + 1);
    const std::string all_textures = fmt::format("the material's {} textures", textures);
    const std::size_t samplers = sampler_count(step);
    add(fmt::format("the material's {} samplers", samplers), samplers, limits_.maxPerStageDescriptorSamplers,
        "maxPerStageDescriptorSamplers");
    add(all_textures, textures, limits_.maxPerStageDescriptorSampledImages, "maxPerStageDescriptorSampledImages");
    add(fmt::format("the material's {} uniform buffers", buffers), buffers, limits_.maxPerStageDescriptorUniformBuffers,
        "maxPerStageDescriptorUniformBuffers");
    const std::size_t resources = textures + buffers + step.targets.size();
    add(fmt::format("the material's {} textures, buffers and targets", resources), resources,
        limits_.maxPerStageResources, "maxPerStageResources");
    add(fmt::format("the material's {} descriptor sets", sets), sets, limits_.maxBoundDescriptorSets,
        "maxBoundDescriptorSets");
    for (const Block& block : reflection.blocks)
        add(fmt::format("the block '{}' of {} bytes", block.name, block.size), block.size,
            limits_.maxUniformBufferRange, "maxUniformBufferRange");
}

void Needs::add_stages(const FrameStep& step) {
    std::uint32_t vertex_inputs = 0;
    for (const VertexInput& input : step.pass->vertex_inputs)
        vertex_inputs = std::max(vertex_inputs, input.location + 1);
    add(fmt::format("the material's {} vertex inputs", vertex_inputs), vertex_inputs, limits_.maxVertexInputAttributes,
        "maxVertexInputAttributes");
    // A location counts as four numbers, however many are used. GLSL's gl_PerVertex counts too: a position, a point
    // size, a clip and a cull distance.
    constexpr std::uint32_t kInput = 1, kOutput = 3;
    constexpr std::uint64_t kPerVertex = 7;
    const std::uint64_t outputs = 4 * std::uint64_t(location_count(step.stages.vertex_spirv, kOutput)) + kPerVertex;
    const std::uint64_t inputs = 4 * std::uint64_t(location_count(step.stages.fragment_spirv, kInput));
    add(fmt::format("the {} numbers that the vertex stage outputs, including its position", outputs), outputs,
        limits_.maxVertexOutputComponents, "maxVertexOutputComponents");
    add(fmt::format("the {} numbers that the fragment stage reads, four for each value", inputs), inputs,
        limits_.maxFragmentInputComponents, "maxFragmentInputComponents");
}

}  // namespace

std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Frame& frame,
                          std::uint64_t most_allocation) {
    Needs needs(limits, most_allocation);
    for (const FrameTarget& target : frame.targets)
        needs.add_target(image_size(frame, target), pixel_format(target.format));
    for (const FrameStep& step : frame.steps) needs.add_step(step);
    const Need* need = needs.unmet();
    if (!need) return "";
    return fmt::format("'{}' cannot take {}: its limit is {} ({})", device, need->what, need->limit, need->name);
}

std::string beyond_limits(const VkPhysicalDeviceLimits& limits, const std::string& device, const Draw& draw,
                          std::uint64_t most_allocation) {
    for (const Pass& pass : draw.reflection->passes)
        if (pass.name == draw.pass) return beyond_limits(limits, device, frame_of(draw, pass), most_allocation);
    return "";
}

}  // namespace patina::runtime

#include "runtime/gpu/gpu_frame.h"

#include <algorithm>
#include <cstring>

#include "runtime/frame/frame_check.h"
#include "runtime/frame/tiles.h"
#include "runtime/gpu/vulkan_words.h"

namespace patina::runtime {
namespace {

bool draws_into(const FrameStep& step, std::size_t target) {
    const std::vector<std::size_t> attached = attachments(step);
    return std::find(attached.begin(), attached.end(), target) != attached.end();
}

// --- making ready

Outcome<std::vector<BoundTexture>> bind_textures(Gpu& gpu, const FrameStep& step, const ReadyFrame& ready,
                                                 std::vector<GpuTarget>& targets, TextureCache& textures) {
    std::vector<BoundTexture> bound;
    for (const FrameRead& read : step.reads) {  // before the loaded ones: the first of a name counts
        GpuTarget& target = targets[read.target];
        const bool reads_copy = draws_into(step, read.target);
        if (reads_copy)
            if (auto made = need_copy(gpu, target); !made) return Failure{made.error};
        bound.push_back({.name = read.texture,
                         .view = (reads_copy ? target.copy : target.drawn).read_view(),
                         .sampler = ready.read_sampler.get()});
    }
    for (const LoadedTexture& texture : step.textures) {
        Outcome<BoundTexture> loaded = textures.bind(gpu, texture);
        if (!loaded) return Failure{loaded.error};
        bound.push_back(std::move(loaded.value));
    }
    return bound;
}

std::vector<VkSampler> bind_samplers(Gpu& gpu, const FrameStep& step, ReadyFrame& ready) {
    std::vector<VkSampler> bound;
    for (const BoundSampler& sampler : step.reflection->samplers) {
        const Sampler& state = step.state_of(sampler);
        SamplerHandle& made = ready.samplers[{state.wrap, state.filter, state.anisotropy}];
        if (!made) made = make_sampler(gpu, state);
        bound.push_back(made.get());
    }
    return bound;
}

Outcome<VkPipeline> find_pipeline(Gpu& gpu, ReadyFrame& ready, const FrameStep& step, VkPipelineLayout layout,
                                  const std::vector<GpuTarget>& targets) {
    PipelineInfo info{.pass = step.pass,
                      .clip_depth = step.clip_depth(),
                      .layout = layout,
                      .vertex_spirv = step.stages.vertex_spirv,
                      .fragment_spirv = step.stages.fragment_spirv,
                      .constants = step.constants};
    for (std::size_t target : step.targets) info.color_formats.push_back(vulkan_format(targets[target].format->word));
    if (step.depth >= 0) info.depth_format = vulkan_format(targets[std::size_t(step.depth)].format->word);
    ReadyFrame::PipelineKey key{step.pass,     info.vertex_spirv.data(), info.fragment_spirv.data(),
                                layout,        info.color_formats,       info.depth_format,
                                step.constants};
    auto found = ready.pipelines.find(key);
    if (found == ready.pipelines.end()) {
        Outcome<PipelineHandle> made = make_pipeline(gpu, info);
        if (!made) return Failure{made.error};
        found = ready.pipelines.emplace(std::move(key), std::move(made.value)).first;
    }
    return found->second.get();
}

Outcome<ReadyStep> make_step_ready(Gpu& gpu, const Frame& frame, std::size_t index, ReadyFrame& ready,
                                   std::vector<GpuTarget>& targets, TextureCache& textures) {
    const FrameStep& step = frame.steps[index];
    auto bound = bind_textures(gpu, step, ready, targets, textures);
    if (!bound) return Failure{bound.error};
    const Slots slots = find_slots(*step.reflection, ready.data.buffer.handle.get(), ready.data.blocks[index],
                                   bound.value, bind_samplers(gpu, step, ready));
    auto [layout, is_new] = ready.layouts.try_emplace(shape_of(slots));
    if (is_new) layout->second = make_layout(gpu, slots);
    if (!gpu.error.empty()) return Failure{gpu.error};

    ReadyStep made{.layout = layout->second.layout.get(), .bound = make_sets(gpu, layout->second, slots)};
    if (!gpu.error.empty()) return Failure{gpu.error};
    Outcome<VkPipeline> pipeline = find_pipeline(gpu, ready, step, made.layout, targets);
    if (!pipeline) return Failure{pipeline.error};
    made.pipeline = pipeline.value;
    return made;
}

// --- recording

VkRenderingAttachmentInfo attachment(const GpuImage& image) {
    VkRenderingAttachmentInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    info.imageView = image.view.get();
    info.imageLayout = image.layout;
    info.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    return info;
}

// Records step after step. One rendering continues while the steps draw into the same images and everything that they
// read is ready: only draws can be recorded inside it.
class Recorder {
public:
    Recorder(VkCommandBuffer commands, const Frame& frame, const ReadyFrame& ready, std::vector<GpuTarget>& targets)
        : commands_(commands), frame_(frame), ready_(ready), targets_(targets) {}

    void record(std::size_t index) {
        const FrameStep& step = frame_.steps[index];
        if (open_ && (attachments(*open_) != attachments(step) || !can_read(step) || step.clears_stencil)) end();
        if (!open_) begin(step);
        draw(step, ready_.steps[index]);
        for (std::size_t target : step.targets) targets_[target].version++;
        if (step.depth >= 0 && step.pass->depth_write) targets_[std::size_t(step.depth)].version++;
    }
    void end() {
        if (open_) vkCmdEndRendering(commands_);
        open_ = nullptr;
    }

private:
    bool is_ready(const FrameStep& step, const FrameRead& read) const {
        const GpuTarget& target = targets_[read.target];
        return draws_into(step, read.target) ? target.copied_version == target.version
                                             : target.drawn.image.layout == VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    }
    bool can_read(const FrameStep& step) const {
        return std::all_of(step.reads.begin(), step.reads.end(),
                           [&](const FrameRead& read) { return is_ready(step, read); });
    }
    void begin(const FrameStep& step);
    void draw(const FrameStep& step, const ReadyStep& ready);

    VkCommandBuffer commands_;
    const Frame& frame_;
    const ReadyFrame& ready_;
    std::vector<GpuTarget>& targets_;
    const FrameStep* open_ = nullptr;  // the first step of the rendering that goes on
};

void Recorder::begin(const FrameStep& step) {
    for (const FrameRead& read : step.reads) {
        if (is_ready(step, read)) continue;
        if (draws_into(step, read.target))
            copy_target(commands_, targets_[read.target]);
        else
            transition(commands_, targets_[read.target].drawn.image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    }
    std::vector<VkRenderingAttachmentInfo> colors;
    for (std::size_t target : step.targets) {
        GpuImage& image = targets_[target].drawn.image;
        transition(commands_, image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
        colors.push_back(attachment(image));
    }
    VkRenderingAttachmentInfo depth{};
    if (step.depth >= 0) {
        GpuImage& image = targets_[std::size_t(step.depth)].drawn.image;
        transition(commands_, image, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL);
        depth = attachment(image);
    }
    const GpuImage& first = targets_[attachments(step).front()].drawn.image;
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea = {{0, 0}, {first.width, first.height}};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = std::uint32_t(colors.size());
    rendering.pColorAttachments = colors.data();
    VkRenderingAttachmentInfo stencil = depth;
    if (step.clears_stencil) stencil.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    if (step.depth >= 0) {
        rendering.pDepthAttachment = &depth;
        rendering.pStencilAttachment = &stencil;
    }
    vkCmdBeginRendering(commands_, &rendering);
    open_ = &step;
}

void Recorder::draw(const FrameStep& step, const ReadyStep& ready) {
    const bool is_tile = frame_.tile != 0 && is_of_picture(frame_, step);
    const PixelArea view = is_tile ? ready_.viewport : full_area(step, frame_);
    const PixelArea area =
        is_tile ? PixelArea{.width = ready_.tile.width, .height = ready_.tile.height} : full_area(step, frame_);
    // The negative height makes clip space y-up, as graphs and meshes are.
    const VkViewport viewport{float(view.x), float(view.y + view.height), float(view.width), -float(view.height), 0, 1};
    const VkRect2D scissor{{area.x, area.y}, {std::uint32_t(area.width), std::uint32_t(area.height)}};
    vkCmdSetViewport(commands_, 0, 1, &viewport);
    vkCmdSetScissor(commands_, 0, 1, &scissor);
    vkCmdSetStencilReference(commands_, VK_STENCIL_FACE_FRONT_AND_BACK, step.stencil_reference);
    vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, ready.pipeline);
    if (!ready.bound.sets.empty())
        vkCmdBindDescriptorSets(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, ready.layout, 0,
                                std::uint32_t(ready.bound.sets.size()), ready.bound.sets.data(), 0, nullptr);
    const VkBuffer buffer = ready_.data.buffer.handle.get();
    const FrameData::MeshPlace& mesh = ready_.data.meshes.at(step.mesh);
    vkCmdBindVertexBuffers(commands_, 0, 1, &buffer, &mesh.vertices);
    vkCmdBindIndexBuffer(commands_, buffer, mesh.indices, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands_, std::uint32_t(step.mesh->indices.size()), step.instances, 0, 0, 0);
}

// Whether the device draws through a viewport of this place and size.
bool takes_viewport(const VkPhysicalDeviceLimits& limits, const Frame& frame, const PixelArea& viewport) {
    const auto takes = [&](int begin, int length, std::uint32_t longest) {
        return std::uint32_t(length) <= longest && (frame.largest_viewport == 0 || length <= frame.largest_viewport) &&
               float(begin) >= limits.viewportBoundsRange[0] && float(begin + length) <= limits.viewportBoundsRange[1];
    };
    return takes(viewport.x, viewport.width, limits.maxViewportDimensions[0]) &&
           takes(viewport.y, viewport.height, limits.maxViewportDimensions[1]);
}

}  // namespace

Outcome<ReadyFrame> make_ready(Gpu& gpu, const Frame& frame, std::vector<GpuTarget>& targets, TextureCache& textures) {
    ReadyFrame ready;
    ready.data = make_frame_data(gpu, frame);
    ready.read_sampler = make_sampler(gpu, {.wrap = Wrap::Clamp, .filter = Filter::Nearest});
    if (!gpu.error.empty()) return Failure{gpu.error};
    for (std::size_t i = 0; i < frame.steps.size(); i++) {
        Outcome<ReadyStep> step = make_step_ready(gpu, frame, i, ready, targets, textures);
        if (!step) return Failure{step.error};
        ready.steps.push_back(std::move(step.value));
    }
    return ready;
}

void move_to(ReadyFrame& ready, const Frame& frame, const VkPhysicalDeviceLimits& limits, const PixelArea& tile) {
    ready.is_first = tile.x == 0 && tile.y == 0;
    ready.tile = tile;
    if (frame.tile == 0) return;
    const FrameTarget& picture = frame.targets[frame.shown];
    const glm::ivec2 size = image_size(frame, picture);
    TilePlace place{.x = tile.x, .y = tile.y, .width = size.x, .height = size.y};
    ready.viewport = {.x = -tile.x, .y = -tile.y, .width = picture.width, .height = picture.height};
    if (!takes_viewport(limits, frame, ready.viewport)) {
        ready.viewport = {.width = size.x, .height = size.y};
        const glm::vec2 whole(picture.width, picture.height), part(size);
        place.scale = whole / part;
        place.offset = (whole - 2.0f * glm::vec2(tile.x, tile.y) - part) / part * glm::vec2(1, -1);
    }
    for (std::size_t i = 0; i < frame.steps.size(); i++) {
        if (!is_of_picture(frame, frame.steps[i])) continue;
        const std::vector<BlockBytes> blocks = blocks_at(frame.steps[i], place);
        for (std::size_t k = 0; k < blocks.size(); k++)
            std::memcpy(ready.data.buffer.data + ready.data.blocks[i][k].offset, blocks[k].bytes.data(),
                        blocks[k].bytes.size());
    }
}

void record_frame(VkCommandBuffer commands, const Frame& frame, const ReadyFrame& ready,
                  std::vector<GpuTarget>& targets) {
    for (std::size_t i = 0; i < targets.size(); i++)
        if (ready.is_first || frame.targets[i].is_of_picture)
            clear_target(commands, targets[i], frame.targets[i].clear);
    Recorder recorder(commands, frame, ready, targets);
    for (std::size_t i = 0; i < frame.steps.size(); i++)
        if (ready.is_first || is_of_picture(frame, frame.steps[i])) recorder.record(i);
    recorder.end();
}

}  // namespace patina::runtime

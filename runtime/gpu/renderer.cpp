#include "runtime/gpu/renderer.h"

#include <span>

#include "runtime/frame/frame_check.h"
#include "runtime/frame/tiles.h"
#include "runtime/gpu/gpu_frame.h"
#include "runtime/gpu/limits.h"

namespace patina::runtime {

struct Renderer::Impl {
    std::unique_ptr<Device> device;  // first, so that it goes last
    std::vector<GpuTarget> targets;
    std::vector<Buffer> readbacks;  // of the targets that are shown
    TextureCache textures;

    bool fit_readbacks(Gpu& gpu, std::span<const FrameTarget> shown);
    Outcome<std::vector<Image>> draw(Gpu& gpu, const Frame& frame);
};

bool Renderer::Impl::fit_readbacks(Gpu& gpu, std::span<const FrameTarget> shown) {
    readbacks.resize(shown.size());
    for (std::size_t i = 0; i < shown.size(); i++) {
        const std::size_t pixels = std::size_t(shown[i].width) * std::size_t(shown[i].height);
        const std::size_t size = pixel_format(shown[i].format).bytes * pixels;
        if (readbacks[i].size != size) readbacks[i] = make_buffer(gpu, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    }
    return gpu.error.empty();
}

// Draws tile after tile, and averages each into the picture.
Outcome<std::vector<Image>> Renderer::Impl::draw(Gpu& gpu, const Frame& frame) {
    textures.trim();
    std::vector<FrameTarget> wanted = frame.targets;
    for (FrameTarget& target : wanted) {
        const glm::ivec2 size = image_size(frame, target);
        target.width = size.x;
        target.height = size.y;
    }
    if (auto fitted = fit_targets(gpu, targets, wanted); !fitted) return Failure{fitted.error};
    std::vector<std::size_t> shown = {frame.shown};
    shown.insert(shown.end(), frame.also_shown.begin(), frame.also_shown.end());
    std::vector<FrameTarget> images;
    for (const std::size_t target : shown) images.push_back(wanted[target]);
    if (!fit_readbacks(gpu, images)) return Failure{gpu.error};

    Outcome<ReadyFrame> ready = make_ready(gpu, frame, targets, textures);
    if (!ready) return Failure{ready.error};
    const std::vector<PixelArea> tiles = tiles_of(frame);
    const int samples = frame.samples;
    const FrameTarget& whole = frame.targets[frame.shown];
    std::vector<Image> pictures;
    for (std::size_t k = 0; k < shown.size(); k++)
        if (tiles.size() > 1) pictures.push_back(make_image(whole.width / samples, whole.height / samples));
    for (std::size_t i = 0; i < tiles.size(); i++) {
        if (tiles.size() > 1 && frame.progress) frame.progress(double(i) / double(tiles.size()));
        move_to(ready.value, frame, device->limits, tiles[i]);
        run_commands(gpu, [&](VkCommandBuffer commands) {
            record_frame(commands, frame, ready.value, targets);
            for (std::size_t k = 0; k < shown.size(); k++) read_target(commands, targets[shown[k]], readbacks[k]);
        });
        if (!gpu.error.empty()) return Failure{gpu.error};
        for (std::size_t k = 0; k < shown.size(); k++) {
            const PixelFormat& format = *targets[shown[k]].format;
            Image part = box_filtered(image_of(format, images[k].width, images[k].height, readbacks[k].data), samples);
            if (tiles.size() == 1)
                pictures.push_back(std::move(part));
            else
                put_tile(part, tiles[i].x / samples, tiles[i].y / samples, pictures[k]);
        }
    }
    return pictures;
}

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

Outcome<std::unique_ptr<Renderer>> Renderer::open(const DeviceOptions& options) {
    Outcome<std::unique_ptr<Device>> device = open_device(options);
    if (!device) return Failure{device.error};
    std::unique_ptr<Renderer> renderer(new Renderer);
    renderer->impl_->device = std::move(device.value);
    return renderer;
}

Outcome<Image> Renderer::draw(const Frame& frame) {
    Outcome<std::vector<Image>> drawn = draw_all(frame);
    if (!drawn) return Failure{drawn.error};
    return std::move(drawn.value.front());
}

Outcome<std::vector<Image>> Renderer::draw_all(const Frame& frame) {
    if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
    if (std::string error = beyond_limits(frame); !error.empty()) return Failure{error};
    Gpu gpu{.device = *impl_->device, .error = {}};
    Outcome<std::vector<Image>> drawn = impl_->draw(gpu, frame);
    if (!drawn) impl_->targets.clear();  // their layouts may not be what was recorded
    return drawn;
}

Outcome<Image> Renderer::draw(const Draw& draw) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    return this->draw(frame_of(draw, *pass.value));
}

std::string Renderer::beyond_limits(const Frame& frame) const {
    return runtime::beyond_limits(impl_->device->limits, impl_->device->name, frame, impl_->device->most_allocation);
}
std::string Renderer::beyond_limits(const Draw& draw) const {
    return runtime::beyond_limits(impl_->device->limits, impl_->device->name, draw, impl_->device->most_allocation);
}

const std::string& Renderer::device_name() const {
    return impl_->device->name;
}
const std::string& Renderer::driver() const {
    return impl_->device->driver;
}
const std::vector<std::string>& Renderer::messages() const {
    return impl_->device->messages;
}

}  // namespace patina::runtime

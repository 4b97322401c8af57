#include "runtime/gpu/renderer.h"

#include "runtime/frame/frame_check.h"
#include "runtime/frame/tiles.h"
#include "runtime/gpu/gpu_frame.h"
#include "runtime/gpu/limits.h"

namespace patina::runtime {

struct Renderer::Impl {
    std::unique_ptr<Device> device;  // first, so that it goes last
    std::vector<GpuTarget> targets;
    Buffer readback;
    TextureCache textures;

    Outcome<Image> draw(Gpu& gpu, const Frame& frame);
};

// Draws tile after tile, and averages each into the picture.
Outcome<Image> Renderer::Impl::draw(Gpu& gpu, const Frame& frame) {
    textures.trim();
    std::vector<FrameTarget> wanted = frame.targets;
    for (FrameTarget& target : wanted) {
        const glm::ivec2 size = image_size(frame, target);
        target.width = size.x;
        target.height = size.y;
    }
    if (auto fitted = fit_targets(gpu, targets, wanted); !fitted) return Failure{fitted.error};
    GpuTarget& shown = targets[frame.shown];
    const FrameTarget& image = wanted[frame.shown];
    const std::size_t size = shown.format->bytes * std::size_t(image.width) * std::size_t(image.height);
    if (readback.size != size) readback = make_buffer(gpu, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    if (!gpu.error.empty()) return Failure{gpu.error};

    Outcome<ReadyFrame> ready = make_ready(gpu, frame, targets, textures);
    if (!ready) return Failure{ready.error};
    const std::vector<PixelArea> tiles = tiles_of(frame);
    const int samples = frame.samples;
    const FrameTarget& whole = frame.targets[frame.shown];
    Image picture;
    if (tiles.size() > 1) picture = make_image(whole.width / samples, whole.height / samples);
    for (std::size_t i = 0; i < tiles.size(); i++) {
        if (tiles.size() > 1 && frame.progress) frame.progress(double(i) / double(tiles.size()));
        move_to(ready.value, frame, device->limits, tiles[i]);
        run_commands(gpu, [&](VkCommandBuffer commands) {
            record_frame(commands, frame, ready.value, targets);
            read_target(commands, shown, readback);
        });
        if (!gpu.error.empty()) return Failure{gpu.error};
        Image part = box_filtered(image_of(*shown.format, image.width, image.height, readback.data), samples);
        if (tiles.size() == 1) return part;
        put_tile(part, tiles[i].x / samples, tiles[i].y / samples, picture);
    }
    return picture;
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
    if (std::string error = frame_error(frame); !error.empty()) return Failure{error};
    if (std::string error = beyond_limits(frame); !error.empty()) return Failure{error};
    Gpu gpu{.device = *impl_->device, .error = {}};
    Outcome<Image> drawn = impl_->draw(gpu, frame);
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

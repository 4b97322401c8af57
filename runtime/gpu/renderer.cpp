#include "runtime/gpu/renderer.h"

#include "runtime/frame/frame_check.h"
#include "runtime/gpu/gpu_frame.h"
#include "runtime/gpu/limits.h"

namespace patina::runtime {

struct Renderer::Impl {
    std::unique_ptr<Device> device;  // first, so that it goes last
    std::vector<GpuTarget> targets;
    Buffer readback;
    TextureCache textures;

    Outcome<bool> draw(Gpu& gpu, const Frame& frame);
};

// Leaves the shown target's pixels in `readback`.
Outcome<bool> Renderer::Impl::draw(Gpu& gpu, const Frame& frame) {
    textures.trim();
    if (auto fitted = fit_targets(gpu, targets, frame.targets); !fitted) return Failure{fitted.error};
    GpuTarget& shown = targets[frame.shown];
    const std::size_t size = shown.format->bytes * shown.drawn.image.width * shown.drawn.image.height;
    if (readback.size != size) readback = make_buffer(gpu, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    if (!gpu.error.empty()) return Failure{gpu.error};

    Outcome<ReadyFrame> ready = make_ready(gpu, frame, targets, textures);
    if (!ready) return Failure{ready.error};
    run_commands(gpu, [&](VkCommandBuffer commands) {
        record_frame(commands, frame, ready.value, targets);
        read_target(commands, shown, readback);
    });
    if (!gpu.error.empty()) return Failure{gpu.error};
    return true;
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
    if (auto drawn = impl_->draw(gpu, frame); !drawn) {
        impl_->targets.clear();  // their layouts may not be what was recorded
        return Failure{drawn.error};
    }
    const FrameTarget& shown = frame.targets[frame.shown];
    return box_filtered(image_of(pixel_format(shown.format), shown.width, shown.height, impl_->readback.data),
                        frame.samples);
}

Outcome<Image> Renderer::draw(const Draw& draw) {
    Outcome<const Pass*> pass = drawable_pass(draw);
    if (!pass) return Failure{pass.error};
    return this->draw(frame_of(draw, *pass.value));
}

std::string Renderer::beyond_limits(const Frame& frame) const {
    return runtime::beyond_limits(impl_->device->limits, impl_->device->name, frame);
}
std::string Renderer::beyond_limits(const Draw& draw) const {
    return runtime::beyond_limits(impl_->device->limits, impl_->device->name, draw);
}

const std::string& Renderer::device_name() const {
    return impl_->device->name;
}
const std::vector<std::string>& Renderer::messages() const {
    return impl_->device->messages;
}

}  // namespace patina::runtime

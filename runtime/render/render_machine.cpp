#include "runtime/render/render_machine.h"

namespace patina::runtime {

std::string open_machine(const std::string& device, bool validation, RenderMachine& machine) {
    DeviceOptions wanted{.validation = validation, .device = device};
    if (machine.renderer && machine.options == wanted) return "";
    machine.renderer.reset();
    Outcome<std::unique_ptr<Renderer>> opened = Renderer::open(wanted);
    if (!opened) return opened.error;
    machine.renderer = std::move(opened.value);
    machine.options = wanted;
    return "";
}

}  // namespace patina::runtime

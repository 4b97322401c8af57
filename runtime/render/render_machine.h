// The GPU of a program that renders. It is opened when it is first needed, and stays open for later renders.
//
//   RenderMachine machine;
//   if (std::string error = open_machine("", false, machine); error.empty()) machine.renderer->draw(frame);
#pragma once

#include <memory>
#include <string>

#include "runtime/gpu/renderer.h"

namespace patina::runtime {

// The GPU that renders share. Reopened when a request asks for another device.
struct RenderMachine {
    std::unique_ptr<Renderer> renderer;
    DeviceOptions options;
};

// Opens the device that is wanted, unless it is open already. Empty: done; else what is wrong.
std::string open_machine(const std::string& device, bool validation, RenderMachine& machine);

}  // namespace patina::runtime

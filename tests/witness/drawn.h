// What tests of whole graphs share: one compiler, files from memory, and the picture of a compiled graph.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/gpu/renderer.h"
#include "runtime/picture/image.h"

namespace patina::witness {

const Compiler& compiler();
// Files are found by their names, without folders.
CompileOptions options_for(const std::map<std::string, std::string>& files);
std::string text_of(const std::vector<Diagnostic>& diagnostics);

runtime::Renderer& renderer();
std::vector<std::uint32_t> spirv_of(const Result& result, Stage stage, Target target);
// A quad that fills the picture. Null target: the CPU. `words`: values of properties.
runtime::Image drawn(const Result& result, std::optional<Target> target,
                     const std::map<std::string, std::string>& words = {});

}  // namespace patina::witness

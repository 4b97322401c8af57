// The room `validate` compiles and checks emitted texts with other compilers. It knows texts and their line maps only.
//
// Checks emitted GLSL or HLSL with another compiler: glslang turns it into SPIR-V, and spirv-val validates that.
// Messages become diagnostics at the graph's own lines. Links glslang and SPIRV-Tools; the core library does not.
#pragma once

#include <cstdint>
#include <vector>

#include "patina/patina.h"

namespace patina {

struct Validated {
    bool ok = false;
    std::vector<std::uint32_t> spirv;  // for Vulkan 1.3; entry point "main"
    std::vector<Diagnostic> diagnostics;
    std::string log;  // the output of glslang and spirv-val
};

// How the HLSL reads textures: with separate samplers, or through DirectX 9's sampler2D, which joins a texture and its
// sampler. In that case glslang chooses the bindings that the text leaves open.
enum class HlslSamplers { Separate, Combined };

// Thread-safe. With lines, OpLine says where in the text each instruction stands.
Validated validate(const Shader& shader, HlslSamplers samplers = HlslSamplers::Separate, bool with_lines = false);

// The line's place in the sources; null if it has none, as a line of a rendering path.
const LineOrigin* origin_of(const Shader& shader, int line);

// The output of `spirv-opt -O`; empty if the input is not valid.
std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv);

// Readable SPIR-V.
std::string disassemble(const std::vector<std::uint32_t>& spirv);

}  // namespace patina

// The room `validate` compiles and checks emitted texts with other compilers. It knows texts and their line maps only.
//
// Checks emitted GLSL or HLSL with another compiler: glslang turns it into SPIR-V, and spirv-val validates that.
// Messages become diagnostics at the graph's own lines. Links glslang and SPIRV-Tools; the core library does not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "patina/patina.h"

namespace patina {

// What another compiler makes of a shader.
struct Validated {
    bool ok = false;                      // glslang and spirv-val accept it
    std::vector<std::uint32_t> spirv;     // for Vulkan 1.3; entry point "main"
    std::vector<Diagnostic> diagnostics;  // at the graph's own lines, where they are known
    std::string log;                      // the output of glslang and spirv-val
};

// How the HLSL reads textures: with separate samplers, or through DirectX 9's sampler2D, which joins a texture and its
// sampler. In that case glslang chooses the bindings that the text leaves open.
enum class HlslSamplers { Separate, Combined };

// Checks a stage of a pass, or functions, which are put into the smallest shader. A language that glslang does not read
// is not ok, and neither is a function with more than 8,192 branches, for which spirv-val takes minutes: the error
// `over-budget`. Any thread may call it.
Validated validate(const Shader& shader, HlslSamplers samplers = HlslSamplers::Separate);

// Why a stage is too large for drivers and for spirv-opt, which replace each call by what it calls and cannot be
// interrupted: the error `over-budget`, where it has more than 200,000 instructions or 4,096 blocks then. Materials
// have some hundreds or thousands of instructions. Nothing if it is not too large. `spirv` is the shader's.
std::optional<Diagnostic> too_large(const Shader& shader, const std::vector<std::uint32_t>& spirv);

// The output of `spirv-opt -O`; empty if the input is not valid.
std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv);

// SPIR-V as text, with the names of the shader; empty if the input is not valid.
std::string disassemble(const std::vector<std::uint32_t>& spirv);

}  // namespace patina

// The room `validate` compiles and checks emitted texts with other compilers. It reads only texts and their line maps.
//
// Checks emitted GLSL or HLSL with another compiler: glslang turns it into SPIR-V, and spirv-val validates that.
// Messages become diagnostics at the graph's own lines. Links glslang and SPIRV-Tools; the core library does not.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "patina/patina.h"

namespace patina {

// The result of another compiler for a shader.
struct Validated {
    bool ok = false;                      // glslang and spirv-val accept it
    std::vector<std::uint32_t> spirv;     // for Vulkan 1.3; entry point "main"
    std::vector<Diagnostic> diagnostics;  // at the graph's own lines, where they are known
    std::string log;                      // the output of glslang and spirv-val
};

// How the HLSL reads textures: with separate samplers, or through DirectX 9's sampler2D, which joins a texture and its
// sampler. With Combined, glslang chooses the bindings that the text leaves open.
enum class HlslSamplers { Separate, Combined };

// Checks a stage of a pass, or functions, which are put into the smallest shader. The result is not ok if glslang does
// not read the language. A function with more than 8,192 branches, for which spirv-val needs minutes, is the error
// `over-budget`. Any thread may call validate().
Validated validate(const Shader& shader, HlslSamplers samplers = HlslSamplers::Separate);

// The error `over-budget` if a stage is too large for drivers and for spirv-opt; else nothing. Both write the called
// function in place of each call, and cannot be interrupted. Too large means more than 200,000 instructions or 4,096
// blocks after that; materials have some hundreds or thousands of instructions. `spirv` is the shader's.
std::optional<Diagnostic> too_large(const Shader& shader, const std::vector<std::uint32_t>& spirv);

// The output of `spirv-opt -O`; empty if the input is not valid.
std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv);

// SPIR-V as text, with the names of the shader; empty if the input is not valid.
std::string disassemble(const std::vector<std::uint32_t>& spirv);

}  // namespace patina

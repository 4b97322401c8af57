// Proof by another compiler: glslang turns emitted GLSL or HLSL into SPIR-V and spirv-val checks it. Messages come back
// as diagnostics at the graph's own lines. Links glslang and SPIRV-Tools; the core library does not.
#pragma once

#include <cstdint>
#include <vector>

#include "patina/patina.h"

namespace patina {

struct Validated {
    bool ok = false;
    std::vector<std::uint32_t> spirv;  // for Vulkan 1.3; entry point "main"
    std::vector<Diagnostic> diagnostics;
    std::string log;  // glslang's and spirv-val's own words
};

// How HLSL says `sampler2D`: not at all, or as DirectX 9 did, a texture and its sampler in one. With those the bindings
// that the text leaves open are glslang's choice.
enum class HlslSamplers { Separate, Combined };

// Thread-safe.
Validated validate(const Shader& shader, HlslSamplers samplers = HlslSamplers::Separate);

// What `spirv-opt -O` makes of it; empty if it is not valid.
std::vector<std::uint32_t> optimised(const std::vector<std::uint32_t>& spirv);

// Readable SPIR-V.
std::string disassemble(const std::vector<std::uint32_t>& spirv);

}  // namespace patina

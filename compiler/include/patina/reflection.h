// What a compiled material needs from whoever draws it: blocks and their layout, textures, samplers, vertex inputs and
// render state. Plain data; `to_json` gives the text of NAME.reflect.json.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace patina {

// A member of a uniform block. Types are spelled as in HLSL: "float", "float4", "int", "float4x4" (column-major).
struct BlockMember {
    std::string name;
    std::string type;
    std::uint32_t offset = 0;       // bytes from the start of the block; the same in GLSL std140 and in an HLSL cbuffer
    std::uint32_t size = 0;         // bytes, of the whole array if it is one
    std::uint32_t array_count = 0;  // 0: not an array
    std::uint32_t array_stride = 0;
};

struct Block {
    std::string name;
    bool is_material = false;   // the graph's own properties; other blocks are the engine's
    std::uint32_t set = 0;      // Vulkan descriptor set = HLSL register space
    std::uint32_t binding = 0;  // Vulkan binding, of GLSL and of HLSL after the shifts
    std::string hlsl_register;  // "b0, space1"
    std::uint32_t size = 0;     // bytes, a multiple of 16
    std::vector<BlockMember> members;
};

struct Sampler {
    std::string wrap = "repeat";    // repeat | clamp | mirror
    std::string filter = "linear";  // linear (trilinear) | nearest
    int anisotropy = 1;
};

struct Texture {
    std::string name;              // the property's
    std::string identifier;        // in the shaders: the name, or another where a language or a block has it already
    std::string dimension = "2d";  // 2d | cube
    std::string usage = "color";   // color: sRGB, decoded when sampled | data: linear | normal: tangent-space, 2x - 1
    std::string default_value;     // white | black | gray | bump, or a file: its path from the compiled graph's folder
    bool is_material = true;       // false: the engine's own, which has no default
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    std::string hlsl_register;  // "t0, space1"
    std::string sampler_name;
    std::uint32_t sampler_binding = 0;
    std::string sampler_register;  // "s0, space1"
    std::string tiling;            // member of the material's block: float4 scale and offset; empty: has none
    Sampler sampler;
};

struct Property {
    std::string name;
    std::string identifier;         // in the shaders: the name, or another where a language or a block has it already
    std::string type;               // float | float2 | float3 | float4 | color | int | bool | enum | texture2d
    std::array<double, 4> value{};  // default; colours linear; bool 0 or 1; enum: index
    std::optional<std::array<double, 2>> range;
    bool hard = false;                // the range is a limit, not a hint
    std::vector<std::string> values;  // enumerators
    std::string label, group, help;
    std::string block;         // block that holds it; empty for textures
    std::uint32_t offset = 0;  // in that block
    std::uint32_t size = 0;
};

struct VertexInput {
    std::string name;  // position_os, normal_os, tangent_os (w: handedness of the bitangent), uv0.., vertex_color
    std::string type;
    std::uint32_t location = 0;
    std::string hlsl_semantic;
};

struct RenderTarget {
    std::string name;
    std::uint32_t location = 0;
    std::string blend_source = "one";  // Vulkan's words in lower case: one, zero, src_alpha, one_minus_src_alpha
    std::string blend_destination = "zero";
};

// A pass of the material: two stages and the fixed-function state that goes with them.
struct Pass {
    std::string name;
    std::string draws = "objects";  // objects | fullscreen
    std::string cull = "back";      // back | front | off; front faces are counter-clockwise
    bool depth_write = true;
    std::string depth_test = "lessEqual";  // as in `render`: never, less, equal, lessEqual, greater, ...
    int queue = 2000;
    std::vector<RenderTarget> targets;
    std::vector<VertexInput> vertex_inputs;
    std::vector<std::string> blocks;    // names of the blocks that either stage reads
    std::vector<std::string> textures;  // names of the textures that either stage reads
};

struct Reflection {
    std::string name;
    std::string workflow, lighting;
    std::string surface = "opaque";  // opaque | cutout
    std::vector<Property> properties;
    std::vector<Block> blocks;
    std::vector<Texture> textures;
    std::vector<Pass> passes;
    std::string layout_hash;  // of blocks and bindings: equal hash, equal layout
    // Per set: glslang binding shifts that turn HLSL registers into `binding`. textures: t, samplers: s, buffers: b.
    struct Shifts {
        std::uint32_t set = 0, textures = 0, samplers = 0, buffers = 0;
    };
    std::vector<Shifts> hlsl_shifts;
    std::string meta;  // raw JSON that the graph carries through, or empty

    std::string to_json() const;
};

}  // namespace patina

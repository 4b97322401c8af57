// The engine's values that shaders can read, as the library declares them: the members of the engine's uniform blocks
// and the engine's textures, with their meaning. `patina values` lists these values. A reflection lists the values that
// a material reads, with their offsets.
//
//   for (const patina::EngineBlockInfo& block : patina::engine_blocks(compiler))
//       for (const patina::EngineValueInfo& value : block.values) std::puts(value.name.c_str());
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina {

// A member of a block, or a texture.
struct EngineValueInfo {
    std::string name;   // as in the reflection, unless the engine has a name of its own: "lightPosition"
    std::string type;   // "float4x4", "float4[16]", "TextureCube"
    std::string doc;    // what it is
    std::string unit;   // "m"; empty: it has none
    std::string space;  // the coordinate space, or two of a matrix: "world", "world to view"; empty: no space
    std::vector<std::string> with;  // the value exists if one of these switches or paths is on; empty: always
    bool is_of_object = false;      // each instance of a draw has its own value
};

// A uniform block by its name in the library, or all textures.
struct EngineBlockInfo {
    std::string name;                     // "Camera"; empty: the textures
    std::string doc;                      // what the block holds, and how often the engine fills it
    std::vector<EngineValueInfo> values;  // in the order of the block; those that need a switch or a path come last
};

// All blocks, in the order of the library's files, and the textures.
PATINA_API std::vector<EngineBlockInfo> engine_blocks(const Compiler& compiler);

}  // namespace patina

// The room `values`: the contents of the blocks and textures of a reflection, from a scene and a material. It does
// not depend on passes, their order or a device.
//
// Gives a material's properties their values: the defaults of the reflection, changed by the user's words. It also
// fills the uniform blocks, the material's and the engine's: members are found by name in the reflection and written at
// their offsets. The GPU and the CPU renderer share it, so both see the same bytes.
//
//   Outcome<MaterialValues> values = material_values(reflection, {{"_Roughness", "0.2"}, {"_MainTex", "rust.png"}});
//   std::vector<BlockBytes> blocks = fill_blocks(reflection, values.value, scene);
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "patina/reflection.h"
#include "runtime/outcome.h"
#include "runtime/scene/scene.h"

namespace patina::runtime {

struct EngineScene;  // engine_values.h

struct MaterialValues {
    std::map<std::string, std::array<double, 4>> numbers;  // every property that is one number, vector or choice
    std::map<std::string, std::vector<double>> arrays;     // matrices, gradients and curves that were given a value
    std::map<std::string, std::string> textures;  // those that were named: white | black | gray | bump | a file
    std::map<std::string, Sampler> samplers;      // those that were given a value
    std::map<std::string, std::array<double, 4>> tilings;  // texture -> scale x, y, offset x, y
    std::vector<std::string> warnings;                     // values outside the usual range
};

// How the user writes values. Complaints name the forms of a value in this spelling: "1,0,0" on a command line,
// [1, 0, 0] in JSON.
enum class Spelling { Words, Json };

// Words: "0.2", "1,0,0" (linear), "#ff8800", "true", "Wet" (an enumerator), the JSON of a matrix, a gradient or a
// curve, the name of a sampler, a file name, or "NAME_ST" = "2,2,0,0" for a texture's tiling. A bad one, or one outside
// a hard range, is an error that lists the possible values.
Outcome<MaterialValues> material_values(const Reflection& reflection, const std::map<std::string, std::string>& words,
                                        Spelling spelling = Spelling::Words);
// A variant of the lighting model, or null.
const Property* lighting_option(const Reflection& reflection, const std::string& name);
// Of everything that can be given a value, tilings too.
std::vector<std::string> property_names(const Reflection& reflection);

// The keywords to pass to the compiler as CompileOptions::switches: variants whose values differ from the compiled
// ones, and words from a command line that are no values of their variant or constant. The compiler reports the latter
// at the declaration.
std::vector<std::pair<std::string, std::string>> keywords_of(const Reflection& reflection,
                                                             const std::map<std::string, std::string>& words,
                                                             Spelling spelling = Spelling::Words);

// Of the specialization constant `id`: a bool as 0 or 1, an enum as its index.
struct ConstantValue {
    std::uint32_t id = 0;
    std::uint32_t value = 0;
    std::string name{};  // in the shaders
    friend auto operator<=>(const ConstantValue&, const ConstantValue&) = default;
};
std::vector<ConstantValue> constants_of(const Reflection& reflection, const MaterialValues& values);

struct BlockBytes {
    std::string name;
    std::vector<std::byte> bytes;
};

// One entry for each block of the reflection, in its order. Members that nobody has a value for stay zero.
std::vector<BlockBytes> fill_blocks(const Reflection& reflection, const MaterialValues& values, const Scene& scene);
std::vector<BlockBytes> fill_blocks(const Reflection& reflection, const MaterialValues& values,
                                    const EngineScene& seen);

}  // namespace patina::runtime

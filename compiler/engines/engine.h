// The room `engines` says where values come from and what holds a shader. An engine is a folder of data,
// nodes/engines/NAME/: engine.json (read here), its passes and its include. Everything that data can express is data.
// Only the format of a whole file is C++: engine.json names a writer (compiler/writers). No code in this room or
// another one knows an engine by name, except the writers of formats.
//
//   const Engine* engine = library.engine("vulkan");
//   engine->places_of(ir::Group::Material).set   // 1
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/ir.h"
#include "patina/words.h"

namespace patina::engines {

// The descriptor set of the values of one owner, and the first binding of each kind in it. A kind without a number
// follows the kind before it: buffers, textures, samplers.
struct Places {
    std::uint32_t set = 0;
    std::optional<std::uint32_t> buffers, textures, samplers;
};

// A vertex input that the engine's meshes have.
struct VertexInput {
    std::string semantic;                   // of the library: "positionOS"
    std::string hlsl;                       // its HLSL semantic: "POSITION"
    std::optional<std::uint32_t> location;  // none: the inputs that a pass reads are numbered in order
};

// Variants without a chosen value: their defaults are chosen, or they become keywords of the engine.
enum class Variants { Chosen, Keywords };
// The place of the values that each instance of a draw has: arrays in uniform blocks, or the engine's own text.
enum class Instances { Arrays, Engine };

struct Names {
    std::string owner;                  // who owns `taken` and `prefixes`, in words: "one of Unity's includes"
    std::vector<std::string> taken;     // names that the engine's text declares
    std::vector<std::string> prefixes;  // every name that begins so belongs to the engine
    std::vector<std::string> own;       // names that the written file declares itself
    std::vector<std::string> own_near_properties;  // names that are forbidden to properties, and allowed elsewhere
    std::map<std::string, std::string, std::less<>> instead;  // the engine's names for functions of the library
};

// What an engine may choose from: the languages (languages/languages.cpp) and the file formats (writers/writers.cpp).
struct Printable {
    std::vector<std::string_view> languages, formats;
};

struct Engine {
    std::string name;   // the name of its folder: "vulkan"
    std::string title;  // "Vulkan"
    std::string help;
    std::vector<std::string> languages;  // languages of its shaders
    std::string file;  // format of the file that holds all passes: a writer; empty: one file for each stage
    std::optional<std::uint32_t> passes;  // its own passes, in the library's sources; none: the library's paths
    std::vector<std::string> paths;       // the requested paths that it has own passes for; the first is the default
    std::string_view include;             // text of which its files may need parts
    Variants variants = Variants::Chosen;
    Instances instances = Instances::Arrays;

    std::array<Places, 3> places;                            // by ir::Group; values of included files have none
    std::map<std::string, std::string, std::less<>> blocks;  // the library's name of a block -> the engine's
    std::vector<VertexInput> vertex_inputs;

    ClipDepth clip_depth = ClipDepth::NearToFar;  // of what the camera sees; shadow maps store 0 (near) to 1 (far)
    MatrixOrder matrices = MatrixOrder::Columns;
    UvOrigin uv_origin = UvOrigin::Top;

    // How the engine stores the values of a material, by type; empty: as the shader reads them.
    std::map<std::string, std::string, std::less<>> storage;
    bool shares_samplers = true;      // a sampler can serve several textures; else each texture brings its own
    std::string texture_sizes;        // the ending of the name of a texture's size; empty: there is no such value
    std::uint32_t most_varyings = 0;  // vectors from the vertex stage to the fragment stage
    std::uint32_t guaranteed_block_bytes = 0;  // of a uniform block that every device takes
    std::string varyings_note;                 // which of the engine's own values take some varyings; may be empty
    std::uint32_t most_block_bytes = 0;        // of a uniform block that nearly every device takes
    std::uint32_t most_samplers = 0;           // of a stage; 0: not known
    Names names;

    bool has_own_passes() const { return passes.has_value(); }
    bool is_one_file() const { return !file.empty(); }
    const Places& places_of(ir::Group group) const { return places[static_cast<std::size_t>(group)]; }
    // The path of its own passes for a requested one: the default, unless it has one of that name.
    std::string_view own_path(std::string_view wanted) const;
    // The engine's name of a block of the library.
    std::string_view block_name(std::string_view block) const;
    const VertexInput* vertex_input(std::string_view semantic) const;
    // The stored type of a value of this type: "half4"; empty: the same type.
    std::string_view stored_as(std::string_view type) const;
    // The name of a library function in the engine's files.
    std::string_view function_name(std::string_view function) const;
    // Who declares a name that a property might have, in words; empty if nobody does.
    std::string_view declarer_of(std::string_view name) const;
};

}  // namespace patina::engines

// --- the words of engine.json
namespace patina {

template <>
inline constexpr auto kWords<engines::Variants> = std::to_array<Word<engines::Variants>>({
    {"chosen", engines::Variants::Chosen},
    {"keywords", engines::Variants::Keywords},
});
template <>
inline constexpr auto kWords<engines::Instances> = std::to_array<Word<engines::Instances>>({
    {"arrays", engines::Instances::Arrays},
    {"engine", engines::Instances::Engine},
});

}  // namespace patina

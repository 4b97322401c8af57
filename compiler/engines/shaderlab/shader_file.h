// A whole ShaderLab file for Unity's built-in render pipeline: the properties, the passes with their state, and what
// the passes have in common once at the top. The stages are linked as for any other language.
//
//   targets::Printed file = shader_file({material, linked.lowered, passes, reflection, engine, header});
#pragma once

#include "compiler/languages/print.h"
#include "compiler/link/link_pass.h"
#include "compiler/output/reflect.h"

namespace patina::assemble {

struct ShaderFile {
    const graph::Material& material;
    const graph::Lowered& lowered;
    std::span<const LinkedPass> passes;
    const Reflection& reflection;
    const engines::Engine& engine;
    std::string header;  // of the comment at the top
};

targets::Printed shader_file(const ShaderFile& file);
// What the origins of its lines count: those of each pass, one pass after the other.
std::vector<ir::Origin> origins_of(std::span<const LinkedPass> passes);

// --- shader_properties.cpp
// The lines of the block `Properties`.
std::vector<std::string> shader_properties(const graph::Material& material, const graph::Lowered& lowered,
                                           const Reflection& reflection);
// What can stand between quotes: ShaderLab knows no escapes there.
std::string quoted(std::string_view text);
// What Unity lists the shader as: "Patina/Rust".
std::string listed_name(std::string_view name);
// What a shader can be called: as between quotes, but each part between slashes, which Unity makes menus of, has
// no space at its ends and single ones in it, and is not empty.
std::string shader_name(std::string_view text);
// What can stand in [Header(...)]: letters and digits of every script, with one space for a run of others.
std::string header_words(std::string_view text);
// How a texture is sampled, in the words of Unity's import settings, where it is not as a new asset is: "Wrap Mode:
// Clamp, Filter Mode: Point". Empty: as a new one.
std::string sampler_words(const graph::Property& property);
// The word for a texture's default, where it is a file.
std::string_view default_word(const graph::Property& property);
// What Unity's inspector lists of an enum: [KeywordEnum] so many names, [Enum] so many pairs of name and value.
constexpr std::size_t kMostKeywords = 9, kMostPairs = 7;

// --- check_shader_properties.cpp
// Tells what the shader is called, where that is not the graph's name.
void check_shader_name(const graph::Material& material, Diagnostics& diagnostics);
// Refuses names that Unity's includes declare, and tells what of a property a ShaderLab file cannot say.
void check_shader_properties(const graph::Material& material, const graph::Lowered& lowered,
                             const engines::Engine& engine, Diagnostics& diagnostics);
// Unity before 2021.2 allows so many keywords that are a shader's own.
void check_keywords(const graph::Material& material, const Reflection& reflection, Diagnostics& diagnostics);
// Each texture has its sampler, of which Direct3D 11 has 16 in a stage.
void check_samplers(const graph::Material& material, const Reflection& reflection, Diagnostics& diagnostics);

// --- shader_order.cpp
// In the order of their queues, relative to the material's own passes.
void order_passes(std::vector<LinkedPass>& passes);
// The queue of the whole file: the material's, unless what a pass reads is there later.
int shader_queue(const graph::Material& material, std::span<const LinkedPass> passes);
// Tells which passes Unity draws at another time than their queue says, where that may be seen.
void check_queues(const graph::Material& material, std::span<const LinkedPass> passes, const Reflection& reflection,
                  Diagnostics& diagnostics);

// --- shader_state.cpp
// The lines for what ShaderLab does not take for granted.
std::vector<std::string> shader_state(const Pass& pass);
// "Transparent+1"
std::string queue_word(int queue);

// --- object_space.cpp
// Whether the pass computes with an object's own space, or with where the object is, and not just what it makes of the
// mesh in the world.
bool knows_object(const LinkedPass& pass);

// --- shader_passes.cpp
// The text of one pass: what both of its stages declare, each thing once.
struct PassText {
    struct Declaration {
        targets::Piece::Kind kind{};
        std::string name, text;
        std::vector<targets::PrintedLine> lines{};  // counted from 0
        bool is_own = false;                        // no other pass has it: it stands in the pass (shader_shared.cpp)
    };
    std::vector<Declaration> declarations;  // what is read stands before what reads it; the entry functions last
    std::vector<ir::StageText> texts;       // what both stages and the foreign functions that they call ask for
};
// `taken`: names that mean something else outside of the pass.
PassText pass_text(const LinkedPass& pass, const engines::Engine& engine, const std::vector<std::string>& taken);

// What the file calls the pass.
std::string_view name_of(const LinkedPass& pass);

// Whether the text reads a name, other than in a comment on a line of its own.
bool mentions(std::string_view text, std::string_view name);

// --- shader_shared.cpp
// The passes, in which a name means the same wherever it is not the pass's own.
std::vector<PassText> pass_texts(std::span<const LinkedPass> linked, const engines::Engine& engine);
// What is not a pass's own, each once, in an order in which everything stands behind what it reads.
std::vector<const PassText::Declaration*> shared_declarations(const std::vector<PassText>& passes);
// The pieces of the include that the passes' text mentions, in their order.
std::vector<std::string_view> needed_pieces_of(std::string_view include, const std::string& text);

}  // namespace patina::assemble

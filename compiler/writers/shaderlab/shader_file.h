// Writes a whole ShaderLab file for Unity's built-in render pipeline: the properties, the passes with their state, and
// the declarations that passes share, once at the top. The stages are linked as for any other language.
//
//   languages::Printed file = shader_file({material, linked.lowered, passes, reflection, engine, header});
#pragma once

#include "compiler/languages/print.h"
#include "compiler/link/link_pass.h"
#include "compiler/output/reflect.h"

namespace patina::writers::shaderlab {

using link::LinkedPass;
using link::Varyings;
using link::varyings_of;

struct SamplerUse;

struct ShaderFile {
    const resolve::Material& material;
    const lower::Lowered& lowered;
    std::span<const LinkedPass> passes;
    const Reflection& reflection;
    const engines::Engine& engine;
    std::string listed_as;  // the name under which Unity lists it
    std::string header;     // text of the comment at the top
};

languages::Printed shader_file(const ShaderFile& file);
// The origins that the file's lines refer to: those of each pass, one pass after the other, its fragment stage first.
std::vector<ir::Origin> origins_of(std::span<const LinkedPass> passes);

// --- shader_properties.cpp
// The lines of the block `Properties`.
std::vector<std::string> shader_properties(const resolve::Material& material, const lower::Lowered& lowered);
// Text without the characters that cannot be written between quotes: ShaderLab has no escapes there.
std::string quoted(std::string_view text);
// The name under which Unity lists the shader: "Patina/Rust".
std::string listed_name(std::string_view name);
// A valid name of a shader: as between quotes, but each part between slashes, of which Unity makes menus, is trimmed,
// has single spaces, and is not empty.
std::string shader_name(std::string_view text);
// Valid words for [Header(...)]: letters and digits of every script, with one space for a run of other characters.
std::string header_words(std::string_view text);
// How a texture is sampled, in the words of Unity's import settings, if a new asset is sampled differently: "Wrap Mode:
// Clamp, Filter Mode: Point". Empty otherwise.
std::string sampler_words(const format::Property& property);
// True if the asset needs Unity's texture type "Normal map". Unity keeps two channels of such a file, so a swizzle
// needs a plain texture.
bool is_unity_normal_map(const format::Property& property);
// The word for a texture's default if that is a file.
std::string_view default_word(const format::Property& property);
// The method of Unity's class Material that sets a property for which ShaderLab has no type; otherwise empty.
std::string_view script_setter(const format::Property& property);
// The limits of Unity's inspector for an enum: [KeywordEnum] lists this many names, [Enum] this many pairs of name and
// value.
constexpr std::size_t kMostKeywords = 9, kMostPairs = 7;

// --- check_shader_properties.cpp
// Reports the shader's name if it differs from the graph's.
void check_shader_name(const resolve::Material& material, resolve::Session& session);
// Refuses names that Unity's includes declare, and reports what a ShaderLab file cannot express about a property.
void check_shader_properties(const resolve::Material& material, const lower::Lowered& lowered,
                             resolve::Session& session);
// Reports too many keywords: Unity before 2021.2 limits those that belong to one shader.
void check_keywords(const resolve::Material& material, const Reflection& reflection, Diagnostics& diagnostics);
// Reports textures that share a sampler (share_samplers.h), and passes that still have too many.
void check_samplers(std::span<const LinkedPass> passes, const engines::Engine& engine, Diagnostics& diagnostics);

// --- shader_order.cpp
// Sorts the passes by their queues, relative to the material's own passes, and lets those that can share a vertex
// stage.
void order_passes(std::vector<LinkedPass>& passes);
// The queue of the whole file: the material's, unless a pass reads something that is available only later.
int shader_queue(const resolve::Material& material, std::span<const LinkedPass> passes);
// Reports passes that Unity draws at another time than their queue says, if that can be visible.
void check_queues(const resolve::Material& material, std::span<const LinkedPass> passes, const Reflection& reflection,
                  Diagnostics& diagnostics);

// --- shader_state.cpp
// The lines of a pass's state that differ from ShaderLab's defaults, or that a material can change.
std::vector<std::string> shader_state(const Pass& pass, const LinkedPass& linked);
// The properties that hold the state of a material that can change it ("materialOverride"); else none.
std::vector<std::string> state_properties(const Reflection& reflection, std::span<const LinkedPass> passes);
// True if one of them has the name.
bool is_state_property(std::string_view name);
// "Transparent+1"
std::string queue_word(int queue);

// --- fallback.cpp
// True if the shader that Unity falls back to for opaque surfaces draws the pass in the same way: the file need not
// hold it.
bool is_in_fallback(const LinkedPass& pass);
// The word of `FallBack`.
std::string_view fallback_word(const resolve::Material& material, const lower::Lowered& lowered,
                               std::span<const LinkedPass> passes);

// --- object_space.cpp
// True if the pass computes with an object's own space or position, other than to bring the mesh into world space.
bool knows_object(const LinkedPass& pass);

// --- shader_passes.cpp
// The text of one pass: the declarations of both stages, each once.
struct PassText {
    struct Declaration {
        languages::Piece::Kind kind{};
        std::string name, text;
        std::vector<languages::PrintedLine> lines{};  // counted from 0, with origins as origins_of() has them
        bool is_own = false;        // no other pass has it, so it is declared in the pass (shader_shared.cpp)
        bool is_of_vertex = false;  // the vertex function, or the struct that it returns
    };
    std::vector<Declaration> declarations;  // each declaration after those that it reads; the entry functions last
    std::vector<ir::StageText> texts;       // the lines that both stages and the foreign functions that they call need
    // What needs shader model 3.5 (unsigned numbers, texel loads, arrays of textures, sides of faces): the entries, and
    // other functions.
    bool is_modern = false;
    std::vector<std::string> modern_functions{};
    bool shares_vertex = false;  // the vertex function stands before all passes
};
// `samplers`: of all passes (share_samplers.h). `taken`: names that have another meaning outside the pass.
PassText pass_text(const LinkedPass& pass, const engines::Engine& engine, const languages::TakenNames& engine_names,
                   const SamplerUse& samplers, const std::vector<std::string>& taken);
// The names that no declaration of the file may have.
languages::TakenNames taken_names(const engines::Names& names);

// The name of the pass in the file.
std::string_view name_of(const LinkedPass& pass);

// True if the text reads a name, except in a comment on a line of its own.
bool mentions(std::string_view text, std::string_view name);

// --- shader_shared.cpp
// The texts of the passes. A name means the same in all of them, unless it belongs to one pass.
std::vector<PassText> pass_texts(std::span<const LinkedPass> linked, const engines::Engine& engine);
// The declarations that do not belong to one pass, each once and after those that it reads; a shared vertex function
// and its struct come last.
std::vector<const PassText::Declaration*> shared_declarations(const std::vector<PassText>& passes);
// The condition, in the words of the preprocessor, under which programs may declare the vertex function that some
// passes share; empty if all of them do.
std::string_view vertex_condition(const std::vector<PassText>& passes);
// The pieces of the include that the text of the passes mentions, in their order.
std::vector<std::string_view> needed_pieces_of(std::string_view include, const std::string& text);

}  // namespace patina::writers::shaderlab

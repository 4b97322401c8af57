// Prepares a material for drawing: compiles it with the variants that its values select, reads its values, and loads
// its textures. A picture of one material, a world and a trace all prepare their materials here. It opens no device.
//
//   Result compiled = compile_material(compiler, material, compile_options(options));
//   PreparedMaterial made = prepare_material(material, std::move(compiled), options);
//   if (made.ok) fill_blocks(made.compiled.reflection, made.values, scene);
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"
#include "runtime/render/render_options.h"
#include "runtime/scene/world.h"
#include "runtime/values/material_values.h"
#include "runtime/values/textures.h"

namespace patina::runtime {

// What the compiler must know of how a picture is drawn. A caller that needs other texts, or programs, changes the
// result.
CompileOptions compile_options(const RenderOptions& options);
// Asks for the port in place of the surface, drawn by the same passes.
void show_port(CompileOptions& options, std::string port);

// Values may ask for other variants than the graph's own: then the graph is compiled once more, for them.
Result compile_material(const Compiler& compiler, const WorldMaterial& material, CompileOptions options);

struct PreparedMaterial {
    bool ok = false;
    Result compiled{};
    MaterialValues values{};
    LoadedTextures loaded{};                // the material's own
    std::vector<Diagnostic> diagnostics{};  // of its values and textures; those of the compiler are in `compiled`
    std::string error{};                    // what is wrong with a value that no scene file gives
};

// Not ok if `compiled` is not.
PreparedMaterial prepare_material(const WorldMaterial& material, Result compiled, const RenderOptions& options);

}  // namespace patina::runtime

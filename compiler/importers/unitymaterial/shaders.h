// Which shader a material has, by what names it: shaders of Unity by their GUIDs, a shader graph of the project by its
// file, and others by the properties that they seem to have.
#pragma once

#include <string>

#include "compiler/importers/unity/assets.h"
#include "compiler/importers/unitymaterial/material_file.h"

namespace patina::importers::unitymaterial {

enum class Family {
    Standard,      // of the built-in pipeline, and its specular setup
    UniversalLit,  // Lit and Complex Lit
    HighDefinitionLit,
    SimpleLit,
    BakedLit,
    Unlit,         // of the universal pipeline
    UnlitTexture,  // of the built-in pipeline, with fixed render states
    UnlitColor,
    UnlitTransparent,
    UnlitCutout,
    ShaderGraph,
    Unknown
};

struct Shader {
    Family family = Family::Unknown;
    std::string name{};        // "Standard"
    bool is_specular = false;  // Standard's specular setup
    bool is_guessed = false;   // by the names of the properties
    std::string difference{};  // what is uncertain or different; empty: nothing
    std::string graph{};       // the file of a shader graph
};

Shader shader_of(const MaterialFile& material, Assets& assets);

}  // namespace patina::importers::unitymaterial

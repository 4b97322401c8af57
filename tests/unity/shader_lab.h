// A ShaderLab file taken apart, so that its passes can be compiled and drawn without Unity: the programs of its passes,
// over stand-ins for Unity's includes (include/), in which Unity's values are those of the runtime's blocks.
//
//   const ShaderLab file = taken_apart(shader.text);
//   const Shader vertex = stage(file.passes[0], reflection, Stage::Vertex, {"FOG_LINEAR"});
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina::unity {

struct LabPass {
    std::string light_mode;            // "ForwardBase"
    std::string state;                 // the lines between its tags and its program
    std::string program;               // with what all passes begin with
    std::vector<std::string> pragmas;  // "multi_compile_fog"
};
struct ShaderLab {
    std::vector<LabPass> passes;

    const LabPass* pass(const std::string& light_mode) const;
    // The pass with the main light; of unlit files, the one without a mode.
    const LabPass* forward() const;
};
ShaderLab taken_apart(const std::string& text);

// What a material's properties are: the runtime's blocks and registers, so that it can draw; or what the file declares.
enum class Values { OfRuntime, OfFile };

// One stage as HLSL with `main`. `reflection`: of the same material for a path of the runtime, with its blocks and
// textures. `keywords`: what Unity would define.
Shader stage(const LabPass& pass, const Reflection& reflection, Stage stage, const std::vector<std::string>& keywords,
             Values values = Values::OfRuntime);

// What appdata_full is read from, where a runtime draws the pass.
std::vector<VertexInput> appdata_full();

}  // namespace patina::unity

#include "tests/bench/twins.h"

#include <fstream>

#include "patina/cost.h"
#include "patina/validate.h"

namespace patina::bench {
namespace {

Shader read(std::string_view name, Stage stage) {
    Shader shader;
    shader.pass = "forward";
    shader.stage = stage;
    shader.file_name = std::string(name) + (stage == Stage::Vertex ? ".vert.glsl" : ".frag.glsl");
    std::ifstream file("tests/bench/handwritten/" + shader.file_name, std::ios::binary);
    // All loops of the twins are over lights.
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.find("for (") != std::string::npos) shader.light_loops.push_back(number);
        shader.text += line + "\n";
    }
    return shader;
}

}  // namespace

Result compiled(const Twin& twin) {
    static const Compiler compiler;
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = "forward"};
    options.targets = {Target::Glsl};
    return compiler.compile_file(std::string(twin.graph), options);
}

StageTexts stages_of(const Result& result) {
    StageTexts made;
    for (const Shader& shader : result.shaders) (shader.stage == Stage::Vertex ? made.vertex : made.fragment) = shader;
    return made;
}

StageTexts by_hand(const Twin& twin) {
    return {.vertex = read(twin.vertex, Stage::Vertex), .fragment = read(twin.name, Stage::Fragment)};
}

StageCost cost_of(const Shader& shader) {
    const patina::StageCost cost = patina::measure(shader);
    return {.instructions = std::size_t(cost.total().instructions),
            .per_light = std::size_t(cost.per_light.instructions),
            .bytes = shader.text.size()};
}

}  // namespace patina::bench

// One graph, three witnesses: drawn on a Vulkan device through GLSL, the same through HLSL, and run by the CPU
// interpreter from IR that was never folded. A graph reads its inputs from the texture `_Data`, texel by texel and
// exactly, so that nothing about them is known when it is compiled. The tests in this folder use it; it compares
// nothing.
//
//   Bench bench;
//   std::optional<Material> material = bench.compile(text);
//   Inputs inputs{.width = 8, .height = 8, .data = texture_of(texels)};
//   Image glsl = bench.draw(*material, Target::Glsl, inputs), cpu = bench.run(*material, Precision::Double, inputs);
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "patina/interpret.h"
#include "patina/patina.h"
#include "runtime/gpu/renderer.h"
#include "runtime/picture/image.h"

namespace patina::witness {

using runtime::Image;

inline constexpr const char* kData = "_Data";
// A property that declares the texture, and a node that loads the texel at (`column`, `row`), both expressions.
std::string data_property();
std::string load_node(const std::string& id, const std::string& column, const std::string& row);

// Spelled so that it reads back as the same double; only of finite numbers.
std::string literal(double value);

// Floats as they are, of one level, read with `filter` "nearest".
std::shared_ptr<const TextureData> texture_of(const Image& texels);

struct Material {
    Result result;
    std::map<Target, std::vector<std::uint32_t>> vertex, fragment;  // SPIR-V
};

struct Inputs {
    int width = 1, height = 1;
    std::shared_ptr<const TextureData> data{};  // of every texture of the material but these
    std::map<std::string, std::shared_ptr<const TextureData>> textures{};
    float time = 0;
    const runtime::Scene* scene = nullptr;        // what is drawn, size and time included; null: the whole picture
    std::map<std::string, std::string> values{};  // property -> word, as in runtime/values/material_values.h
};

// Opens the device with the validation layer on. Whatever fails becomes a failure of the running test.
class Bench {
public:
    Bench();

    // With `only_cpu` nothing is made for the GPU.
    std::optional<Material> compile(const std::string& text, const std::map<std::string, std::string>& files = {},
                                    bool only_cpu = false);
    // Empty on an error.
    Image draw(const Material& material, Target target, const Inputs& inputs);
    Image run(const Material& material, Precision precision, const Inputs& inputs);

    // Fails the test if the validation layer has said anything.
    void expect_silence() const;
    const Compiler& compiler() const { return compiler_; }

private:
    std::vector<std::uint32_t> spirv(const Result& result, Stage stage, Target target);

    Compiler compiler_;
    std::unique_ptr<runtime::Renderer> renderer_;
    std::map<std::string, std::vector<std::uint32_t>> vertex_stages_;  // by text: most graphs share one
};

}  // namespace patina::witness

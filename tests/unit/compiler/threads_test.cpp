// One compiler, many threads: the library's bodies and models are read when first asked for, by whoever asks first.
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "patina/patina.h"

namespace patina {
namespace {

std::string material(const std::string& model) {
    return R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")" + model + "\" }";
}

std::string texts(const Compiler& compiler, const std::string& model) {
    std::string all;
    for (const Shader& shader : compiler.compile_text("m.graph.json", material(model)).shaders) all += shader.text;
    return all;
}

TEST(Threads, CompileWithOneCompilerAsEachDoesAlone) {
    const std::vector<std::string> models = {"lambert", "gltf",        "disney-principled", "toon",
                                             "phong",   "unity-brdf2", "energy-conserving", "merl"};
    constexpr std::size_t kThreads = 8;
    const Compiler shared;
    std::vector<std::vector<std::string>> made(kThreads);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) {
        threads.emplace_back([&, t] {
            // Each begins elsewhere.
            for (std::size_t i = 0; i < models.size(); ++i)
                made[t].push_back(texts(shared, models[(t + i) % models.size()]));
        });
    }
    for (std::thread& thread : threads) thread.join();
    const Compiler alone;
    for (std::size_t t = 0; t < kThreads; ++t) {
        for (std::size_t i = 0; i < models.size(); ++i) {
            const std::string expected = texts(alone, models[(t + i) % models.size()]);
            EXPECT_FALSE(expected.empty());
            EXPECT_EQ(made[t][i], expected);
        }
    }
}

}  // namespace
}  // namespace patina

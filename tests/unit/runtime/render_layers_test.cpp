// Layers of a picture: the values of nodes, as they are, in channels of their names. An EXR file is read back by
// OpenImageIO.
#include "runtime/render/render_layers.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

constexpr const char* kGraph = R"json({
  "patina": 1, "workflow": "unlit",
  "nodes": [ { "id": "high", "expr": "3.5" }, { "id": "below", "expr": "float3(-2, 0.25, 7)" } ],
  "surface": { "color": "= high * float3(0.25)" }
})json";

class RenderLayers : public testing::Test {
protected:
    RenderLayers() {
        std::string name = (fs::temp_directory_path() / "patina_layers_XXXXXX").string();
        folder = mkdtemp(name.data());
        std::ofstream(folder / "own.graph.json") << kGraph;
        request.graph = (folder / "own.graph.json").string();
        request.options.via = "cpu";
        request.size = 8;
        request.samples = 1;
        request.background = "0.125";
    }
    ~RenderLayers() override { fs::remove_all(folder); }

    const Compiler compiler{};
    RenderMachine machine{};
    fs::path folder{};
    RenderRequest request{};
};

TEST_F(RenderLayers, HoldTheValuesAsTheyAre) {
    const std::vector<std::string> names = {"high", "below"};
    const LayersOutcome made = render_layers(compiler, request, names, machine);
    ASSERT_TRUE(made.drawn.ok) << made.drawn.error;
    const Outcome<std::string> bytes = encode_layers(made.drawn.image, made.layers);
    ASSERT_TRUE(bytes) << bytes.error;
    const fs::path file = folder / "layers.exr";
    std::ofstream(file, std::ios::binary) << bytes.value;

    const auto input = OIIO::ImageInput::open(file.string());
    ASSERT_TRUE(input) << OIIO::geterror();
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> pixels(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    ASSERT_TRUE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
    const auto value = [&](int x, int y, const char* channel) {
        const int index = spec.channelindex(channel);
        EXPECT_GE(index, 0) << channel;
        return pixels[(std::size_t(y) * 8 + std::size_t(x)) * std::size_t(spec.nchannels) + std::size_t(index)];
    };
    EXPECT_EQ(spec.nchannels, 12);
    const std::map<const char*, float> middle = {{"R", 0.875f},      {"A", 1.0f},       {"high.R", 3.5f},
                                                 {"high.B", 3.5f},   {"high.A", 1.0f},  {"below.R", -2.0f},
                                                 {"below.G", 0.25f}, {"below.B", 7.0f}, {"below.A", 1.0f}};
    for (const auto& [channel, expected] : middle) EXPECT_FLOAT_EQ(value(4, 4, channel), expected) << channel;
    // Outside the object: the background of the picture, and nothing in the layers.
    const std::map<const char*, float> corner = {{"R", 0.125f}, {"high.R", 0.0f}, {"high.A", 0.0f}, {"below.B", 0.0f}};
    for (const auto& [channel, expected] : corner) EXPECT_FLOAT_EQ(value(0, 0, channel), expected) << channel;
}

TEST_F(RenderLayers, FailIfOneCannotBeDrawn) {
    const std::vector<std::string> names = {"high", "hihg"};
    const LayersOutcome made = render_layers(compiler, request, names, machine);
    EXPECT_FALSE(made.drawn.ok);
    EXPECT_EQ(std::ranges::count(made.drawn.diagnostics, "dangling-link", &Diagnostic::code), 1);
}

}  // namespace
}  // namespace patina::runtime

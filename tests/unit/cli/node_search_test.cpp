// What people type leads to the node that they mean: `patina nodes --search WORDS`.
#include "compiler/cli/pages/node_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "compiler/cli/pages/search_words.h"

namespace patina::cli {
namespace {

const std::vector<NodeInfo>& nodes() {
    static const Compiler kCompiler;
    return kCompiler.nodes();
}

std::vector<std::string> found_by(std::string_view words) {
    std::vector<std::string> names;
    for (const NodeInfo* node : search_nodes(nodes(), words)) names.push_back(node->name);
    return names;
}

std::string first_of(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, names.size()); ++i) text += names[i] + " ";
    return text;
}

TEST(NodeSearch, FindsWhatIsMeantAmongTheFirstThree) {
    const std::pair<std::string_view, std::string_view> kMeant[] = {
        // names without their humps
        {"oklab", "LinearToOkLab"},
        {"OkLab", "LinearToOkLab"},
        {"oklch", "OkLabToOkLCh"},
        {"rgb to hsv", "RgbToHsv"},
        {"hsv2rgb", "HsvToRgb"},
        {"fbm", "FractalNoise"},
        {"one minus", "OneMinus"},
        // forms of words
        {"posterise", "Posterize"},
        {"posterization", "Posterize"},
        {"tileable noise", "FractalNoiseTiled"},
        {"tileable", "VoronoiTiled"},
        {"saturated", "Saturation"},
        {"rotation", "Rotate"},
        {"normalise", "Normalize"},
        {"hexagon tiles", "HexTiling"},
        {"brick", "Bricks"},
        {"mixing colours", "BlendColors"},
        // words that say nothing about a node
        {"make circle", "Ellipse"},
        {"make a circle", "Ellipse"},
        {"blend two textures by height", "HeightBlend"},
        {"how do I sample a texture", "SampleTexture2D"},
        {"make a normal from a height", "NormalFromHeight"},
        // other names for things
        {"distance field", "SdfCircle"},
        {"stripes", "SquareWave"},
        {"dots", "Ellipse"},
        {"greyscale", "Luminance"},
        {"grayscale", "Luminance"},
        {"black and white", "Luminance"},
        {"desaturate", "Saturation"},
        {"lut", "SampleTexture3D"},
        {"pixelate", "Posterize"},
        {"toon", "Posterize"},
        {"cel shading", "Posterize"},
        {"rim light", "FresnelEffect"},
        {"seamless noise", "FractalNoiseTiled"},
        {"perlin", "GradientNoise"},
        {"iridescent", "FresnelThinFilm"},
        {"luma", "Luminance"},
        {"pan uv", "TilingOffset"},
        {"scroll uv", "TilingOffset"},
        {"turbulence", "FractalNoise"},
        {"cracks", "Worley"},
        {"halftone", "Ellipse"},
        {"zigzag", "TriangleWave"},
        {"world position", "Position"},
        // a node's own name
        {"dot", "Dot"},
        {"distance", "Distance"},
        {"time", "Time"},
        {"round corners", "RoundedRectangle"},
        {"flow map", "FlowFromMap"},
        {"triplanar mapping", "Triplanar"},
    };
    for (const auto& [words, node] : kMeant) {
        const std::vector<std::string> names = found_by(words);
        const auto third = names.begin() + std::min<std::ptrdiff_t>(3, std::ssize(names));
        EXPECT_TRUE(std::find(names.begin(), third, node) != third) << words << ": " << first_of(names);
    }
}

TEST(NodeSearch, PutsANodeOfThisNameFirst) {
    for (const std::string_view name : {"Worley", "Voronoi", "Hue", "Rotate", "Step", "Random", "Noise Sine Wave",
                                        "RgbToHsv", "HsvToRgb", "Srgb To Linear"}) {
        const std::vector<std::string> names = found_by(name);
        ASSERT_FALSE(names.empty()) << name;
        EXPECT_EQ(names.front(), find_named(nodes(), name)->name) << name;
    }
}

TEST(NodeSearch, PutsMoreOfTheWordsFirst) {
    EXPECT_EQ(found_by("value noise tiled").front(), "ValueNoiseTiled");
    EXPECT_EQ(found_by("glass elephant voronoi").front(), "Voronoi");
    EXPECT_TRUE(found_by("elephant").empty());
    EXPECT_TRUE(found_by("").empty());
}

TEST(NodeSearch, FindsWhatIsNoNode) {
    const std::pair<std::string_view, std::string_view> kMeant[] = {{"transpose", "transpose(m)"},
                                                                    {"transpose a matrix", "transpose(m)"},
                                                                    {"determinant", "determinant(m)"},
                                                                    {"sampler state", "sampler"},
                                                                    {"Sub Graph", ".subgraph.json"}};
    for (const auto& [words, text] : kMeant) {
        const std::vector<Hint> hints = search_hints(words, found_by(words).empty());
        ASSERT_EQ(hints.size(), 1u) << words;
        EXPECT_NE(hints.front().text.find(text), std::string::npos) << words << ": " << hints.front().text;
    }
    EXPECT_TRUE(search_hints("checkerboard", true).empty());
    EXPECT_TRUE(search_hints("dots", false).empty());  // DotClamped is more than that
}

TEST(NodeSearch, WordsThatMeanTheSameAreEqual) {
    EXPECT_EQ(stem("posterise"), stem("posterized"));
    EXPECT_EQ(stem("tileable"), stem("tiling"));
    EXPECT_EQ(stem("tiles"), stem("tiled"));
    EXPECT_EQ(stem("mapped"), stem("map"));
    EXPECT_EQ(stem("colours"), stem("color"));
    EXPECT_NE(stem("noise"), stem("nose"));
}

}  // namespace
}  // namespace patina::cli

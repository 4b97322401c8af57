// Pictures, their files and the mip levels made from them.
#include "runtime/picture/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "runtime/picture/picture_bounds.h"
#include "runtime/values/textures.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, gone afterwards.
class ImageFile : public testing::Test {
protected:
    ImageFile() {
        std::string name = (fs::temp_directory_path() / "patina_image_XXXXXX").string();
        folder = mkdtemp(name.data());
    }
    ~ImageFile() override { fs::remove_all(folder); }
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::size_t file_count() const {
        return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder;
};

// Every value of 8 bits, in all channels, alpha included.
Image all_bytes() {
    Image image = make_image(16, 16);
    for (int i = 0; i < 256; i++) {
        std::span<float> pixel = image.at(i % 16, i / 16);
        pixel[0] = float(i) / 255;
        pixel[1] = float(255 - i) / 255;
        pixel[2] = float((i * 7) % 256) / 255;
        pixel[3] = float((i * 13) % 256) / 255;
    }
    return image;
}

// Values of IEC 61966-2-1 worked out in double.
TEST(Srgb, FollowsTheStandard) {
    EXPECT_EQ(srgb_encode(0), 0);
    EXPECT_NEAR(srgb_encode(1), 1, 1e-6);
    EXPECT_NEAR(srgb_encode(0.18f), 1.055 * std::pow(0.18, 1 / 2.4) - 0.055, 1e-6);
    EXPECT_NEAR(srgb_encode(0.002f), 0.02584, 1e-7);
    EXPECT_NEAR(srgb_decode(0.5f), std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(srgb_decode(0.03f), 0.03 / 12.92, 1e-8);
}

TEST(Srgb, SurvivesARoundTrip) {
    for (int i = -300; i <= 300; i++) EXPECT_NEAR(srgb_decode(srgb_encode(i / 100.0f)), i / 100.0f, 1e-5);
}

TEST(Quantized, RoundsAndClamps) {
    Image image = make_image(1, 1, -0.5f, 1.5f, 0.5f, std::numeric_limits<float>::quiet_NaN());
    Image result = quantized(image);
    EXPECT_EQ(result.pixels, (std::vector<float>{0, 1, 128 / 255.0f, 0}));
}

TEST_F(ImageFile, PngKeepsEveryByteAndStraightAlpha) {
    Image image = all_bytes();
    ASSERT_EQ(save_png_as_is(path("a.png"), image), "");
    Outcome<Image> loaded = load_image(path("a.png"));
    ASSERT_TRUE(loaded) << loaded.error;
    EXPECT_EQ(loaded.value.bits, 8);
    ASSERT_EQ(loaded.value.width, 16);
    for (std::size_t i = 0; i < image.pixels.size(); i++)
        ASSERT_NEAR(loaded.value.pixels[i], image.pixels[i], 1e-6) << "at " << i;
}

TEST_F(ImageFile, PngIsEncodedOnce) {
    ASSERT_EQ(save_png(path("a.png"), make_image(2, 2, 0.18f, 1, 0, 0.5f)), "");
    Outcome<Image> loaded = load_image(path("a.png"));
    ASSERT_TRUE(loaded) << loaded.error;
    EXPECT_NEAR(loaded.value.at(1, 1)[0], 118 / 255.0, 1e-6);  // 0.18 is 0.4613... encoded
    EXPECT_EQ(loaded.value.at(1, 1)[1], 1);
    EXPECT_NEAR(loaded.value.at(1, 1)[3], 128 / 255.0, 1e-6);  // alpha is linear
}

TEST_F(ImageFile, FirstRowIsTheTop) {
    Image image = make_image(1, 2, 0, 0, 0);
    image.at(0, 0)[0] = 1;
    ASSERT_EQ(save_png_as_is(path("a.png"), image), "");
    Outcome<Image> loaded = load_image(path("a.png"));
    ASSERT_TRUE(loaded) << loaded.error;
    EXPECT_EQ(loaded.value.at(0, 0)[0], 1);
    EXPECT_EQ(loaded.value.at(0, 1)[0], 0);
}

TEST_F(ImageFile, ExrKeepsFloats) {
    Image image = make_image(3, 2, -1.5f, 1e-6f, 12345.678f, 0.25f);
    ASSERT_EQ(save_image(path("a.exr"), image), "");
    Outcome<Image> loaded = load_image(path("a.exr"));
    ASSERT_TRUE(loaded) << loaded.error;
    EXPECT_EQ(loaded.value.pixels, image.pixels);
    EXPECT_EQ(loaded.value.bits, 32);
}

TEST_F(ImageFile, MissingFileIsAnError) {
    Outcome<Image> loaded = load_image(path("none.png"));
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.error.find("there is no file"), std::string::npos) << loaded.error;
    EXPECT_FALSE(load_image(folder.string()));
}

TEST_F(ImageFile, CorruptFilesAreErrors) {
    std::ofstream(path("text.png")) << "this is no picture";
    std::ofstream(path("empty.png"));
    for (const char* name : {"text.png", "empty.png"}) {
        Outcome<Image> loaded = load_image(path(name));
        ASSERT_FALSE(loaded) << name;
        EXPECT_NE(loaded.error.find(name), std::string::npos) << loaded.error;
    }
    ASSERT_EQ(save_png_as_is(path("cut.png"), all_bytes()), "");
    fs::resize_file(path("cut.png"), fs::file_size(path("cut.png")) / 2);
    EXPECT_FALSE(load_image(path("cut.png")));
}

TEST_F(ImageFile, WritingLeavesNothingBehindWhenItFails) {
    std::ofstream(path("file"));
    EXPECT_NE(save_png(path("file/a.png"), make_image(2, 2)), "");
    EXPECT_NE(save_image(path("a.xyz"), make_image(2, 2)), "");
    EXPECT_EQ(file_count(), 1u);
    fs::remove(path("file"));
    ASSERT_EQ(save_png(path("a.png"), make_image(2, 2)), "");
    EXPECT_EQ(file_count(), 1u);
}

// Somebody else's files stay, whatever they are called.
TEST_F(ImageFile, WritingLeavesOtherFilesAlone) {
    for (const char* name : {"a.part.png", "a.png.part", "a.tmp"}) std::ofstream(path(name)) << "mine";
    ASSERT_EQ(save_png(path("a.png"), make_image(2, 2)), "");
    EXPECT_EQ(file_count(), 4u);
    for (const char* name : {"a.part.png", "a.png.part", "a.tmp"}) EXPECT_EQ(fs::file_size(path(name)), 4u) << name;
}

// A date would show as a difference, even a second later.
TEST_F(ImageFile, APictureHoldsNoDate) {
    const Outcome<std::string> first = encode_exr(all_bytes()), png = encode_png(all_bytes());
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    EXPECT_EQ(first.value, encode_exr(all_bytes()).value);
    EXPECT_EQ(png.value, encode_png(all_bytes()).value);
    EXPECT_FALSE(first.value.empty());
}

TEST(BoxFiltered, AveragesBlocks) {
    Image image = make_image(4, 2, 0, 0, 0, 1);
    image.at(0, 0)[0] = 1;
    image.at(3, 1)[0] = 2;
    Image half = box_filtered(image, 2);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_EQ(half.at(0, 0)[0], 0.25f);
    EXPECT_EQ(half.at(1, 0)[0], 0.5f);
}

TEST(BoxFiltered, TransparentPixelsDoNotColorAnEdge) {
    Image image = make_image(2, 2, 0, 0, 0, 0);
    image.at(0, 0)[0] = image.at(0, 0)[3] = 1;
    Image edge = box_filtered(image, 2);
    EXPECT_EQ(edge.pixels, (std::vector<float>{1, 0, 0, 0.25f}));
}

double mean(const TextureLevel& level, int channel) {
    double sum = 0;
    for (std::size_t i = std::size_t(channel); i < level.texels.size(); i += 4) sum += level.texels[i];
    return sum / (double(level.width) * level.height);
}

TEST(MipChain, EndsAtOneTexelAndKeepsTheMean) {
    Image image = make_image(13, 6);
    for (std::size_t i = 0; i < image.pixels.size(); i++) image.pixels[i] = float((i * 37) % 101) / 100;
    std::vector<TextureLevel> levels = mip_chain(image);
    ASSERT_EQ(levels.size(), 4u);  // 13x6, 6x3, 3x1, 1x1
    EXPECT_EQ(levels[1].width, 6);
    EXPECT_EQ(levels[1].height, 3);
    EXPECT_EQ(levels[3].width * levels[3].height, 1);
    for (const TextureLevel& level : levels)
        for (int c = 0; c < 4; c++) EXPECT_NEAR(mean(level, c), mean(levels[0], c), 1e-5);
}

TEST(MipChain, EvenSizesAverageFourTexels) {
    Image image = make_image(2, 2);
    for (int i = 0; i < 4; i++) image.pixels[4 * std::size_t(i)] = float(1 << i);
    EXPECT_EQ(mip_chain(image)[1].texels[0], 15 / 4.0f);
}

TEST(DefaultTextures, HoldWhatAFileWould) {
    EXPECT_EQ(default_texture("white").pixels, (std::vector<float>{1, 1, 1, 1}));
    EXPECT_EQ(default_texture("black").pixels, (std::vector<float>{0, 0, 0, 1}));
    EXPECT_EQ(default_texture("gray").pixels, (std::vector<float>{0.5f, 0.5f, 0.5f, 1}));
    EXPECT_EQ(default_texture("bump").pixels, (std::vector<float>{0.5f, 0.5f, 1, 1}));
    EXPECT_TRUE(default_texture("grey").pixels.empty());
}

Texture texture(const std::string& name, TextureUsage usage, const std::string& default_value) {
    Texture result;
    result.name = name;
    result.usage = usage;
    result.default_texture = from_word<TextureDefault>(default_value).value_or(TextureDefault::File);
    if (result.default_texture == TextureDefault::File) result.default_file = default_value;
    return result;
}

// IEC 61966-2-1: 0.5 stored is ((0.5 + 0.055) / 1.055)^2.4 of light.
TEST(DefaultTextures, OfColorsAreDecoded) {
    Reflection reflection;
    reflection.textures = {texture("color", TextureUsage::Color, "gray"), texture("data", TextureUsage::Data, "gray"),
                           texture("chosen", TextureUsage::Color, "white")};
    for (const bool exact : {false, true}) {
        const std::vector<LoadedTexture> loaded = load_textures(reflection, "", {{"chosen", "gray"}}, exact).textures;
        ASSERT_EQ(loaded.size(), 3u);
        for (const std::size_t c : {0u, 1u, 2u}) {
            EXPECT_NEAR(loaded[0].data->levels[0].texels[c], 0.2140411, 1e-6);
            EXPECT_EQ(loaded[1].data->levels[0].texels[c], 0.5f);
            EXPECT_NEAR(loaded[2].data->levels[0].texels[c], 0.2140411, 1e-6);
        }
        EXPECT_EQ(loaded[0].data->levels[0].texels[3], 1);
    }
}

TEST_F(ImageFile, ColorTexturesAreDecodedAndDataIsNot) {
    ASSERT_EQ(save_png_as_is(path("t.png"), make_image(4, 4, 0.2f, 0.4f, 0.6f, 0.8f)), "");
    Reflection reflection;
    reflection.textures = {texture("color", TextureUsage::Color, "white"),
                           texture("data", TextureUsage::Data, path("t.png"))};
    reflection.textures[1].default_file = "t.png";
    const std::vector<LoadedTexture> loaded =
        load_textures(reflection, path(""), {{"color", path("t.png")}}, false).textures;
    ASSERT_EQ(loaded.size(), 2u);
    EXPECT_EQ(loaded[0].format, TexelFormat::Srgb8);
    EXPECT_NEAR(loaded[0].data->levels[0].texels[0], std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_NEAR(loaded[0].data->levels[0].texels[3], 0.8, 1e-6);
    EXPECT_EQ(loaded[1].format, TexelFormat::Unorm8);
    EXPECT_NEAR(loaded[1].data->levels[0].texels[0], 0.2, 1e-6);

    const std::vector<LoadedTexture> exact = load_textures(reflection, path(""), {}, true).textures;
    ASSERT_EQ(exact.size(), 2u);
    EXPECT_EQ(exact[1].format, TexelFormat::Float32);
}

TEST_F(ImageFile, EveryTextureThatCannotBeLoadedIsNamed) {
    std::ofstream(path("text.png")) << "no picture";
    ASSERT_EQ(save_png_as_is(path("half.png"), make_image(64, 64, 0.2f)), "");
    std::filesystem::resize_file(path("half.png"), 80);
    Reflection reflection;
    reflection.textures = {
        texture("_A", TextureUsage::Color, "none.png"), texture("_B", TextureUsage::Color, "white"),
        texture("_C", TextureUsage::Data, "text.png"), texture("_D", TextureUsage::Data, "half.png"),
        texture("_E", TextureUsage::Data, "../" + std::filesystem::path(path("")).parent_path().filename().string())};
    const LoadedTextures loaded = load_textures(reflection, path(""), {}, false);
    EXPECT_EQ(loaded.textures.size(), 1u);
    ASSERT_EQ(loaded.errors.size(), 4u);
    EXPECT_EQ(loaded.errors[0].text, "texture '_A': there is no file '" + path("none.png") + "'");
    EXPECT_TRUE(
        loaded.errors[1].text.starts_with("texture '_C': cannot read '" + path("text.png") + "' as an image: "));
    EXPECT_TRUE(
        loaded.errors[2].text.starts_with("texture '_D': cannot read '" + path("half.png") + "' as an image: "));
    EXPECT_TRUE(loaded.errors[3].text.ends_with("it is a folder")) << loaded.errors[3].text;
}

TEST_F(ImageFile, ThePicturesOfAMaterialHaveALimitTogether) {
    ASSERT_EQ(save_png_as_is(path("t.png"), make_image(8, 8, 0.2f)), "");
    Reflection reflection;
    for (const char* name : {"_A", "_B", "_C", "_D", "_E"})
        reflection.textures.push_back(texture(name, TextureUsage::Data, "t.png"));
    limit_pixels(64);
    const LoadedTextures loaded = load_textures(reflection, path(""), {}, false);
    limit_pixels(kMostPixels);
    EXPECT_EQ(loaded.textures.size(), 4u);
    ASSERT_EQ(loaded.errors.size(), 1u);
    EXPECT_NE(loaded.errors[0].text.find("the pictures of the material have 320 pixels, and the limit is 256 in all"),
              std::string::npos)
        << loaded.errors[0].text;
}

// Each is a text chunk of the PNG: its keyword, a zero byte and its text.
TEST_F(ImageFile, NotesAreTextChunks) {
    const Outcome<std::string> png =
        encode_png_as_is(all_bytes(), {{"Patina Device", "a device"}, {"Patina Driver", "7.1"}});
    ASSERT_TRUE(png) << png.error;
    EXPECT_NE(png.value.find(std::string("tEXtPatina Device\0a device", 25)), std::string::npos);
    std::ofstream(path("noted.png"), std::ios::binary) << png.value;
    const PictureNotes notes = load_notes(path("noted.png"));
    EXPECT_EQ(notes.at("Patina Device"), "a device");
    EXPECT_EQ(notes.at("Patina Driver"), "7.1");
    EXPECT_EQ(quantized(load_image(path("noted.png")).value).pixels, quantized(all_bytes()).pixels);
    EXPECT_TRUE(load_notes(path("none.png")).empty());
    std::ofstream(path("text.png")) << "no picture";
    EXPECT_TRUE(load_notes(path("text.png")).empty());
    EXPECT_EQ(load_notes(path("noted.png")).count("Patina Cost"), 0u);
}

}  // namespace
}  // namespace patina::runtime

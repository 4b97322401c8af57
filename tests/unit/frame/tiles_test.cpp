// How a frame is divided into tiles: numbers alone, nothing is drawn.
#include "runtime/frame/tiles.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "runtime/frame/frame_check.h"

namespace patina::runtime {
namespace {

// A picture of floats and its depth: 16 + 8 bytes a sample, and 16 + 16 for the result.
constexpr std::size_t kBytes = 56;

Frame frame_of(int width, int height, int samples) {
    Frame frame{
        .targets = {{.name = "color", .width = width * samples, .height = height * samples, .is_of_picture = true},
                    {.name = "depth",
                     .format = TargetFormat::Depth,
                     .width = width * samples,
                     .height = height * samples,
                     .is_of_picture = true},
                    {.name = "shadowMap", .format = TargetFormat::Depth, .width = 64, .height = 64}},
        .samples = samples};
    return frame;
}

TEST(Tiles, AreAsLargeAsTheBytesAllow) {
    Frame frame = frame_of(100, 60, 3);
    EXPECT_EQ(target_bytes(frame), kBytes * 300 * 180);
    EXPECT_EQ(tile_side(frame, kBytes * 30 * 30), 30);
    EXPECT_EQ(tile_side(frame, kBytes * 30 * 30 - 1), 24);  // a multiple of 2 and of the samples
    EXPECT_EQ(tile_side(frame, 1), 6);
    // A low picture has wide tiles.
    EXPECT_EQ(tile_side(frame_of(100, 2, 1), kBytes * 40 * 2), 40);
    EXPECT_FALSE(wants_tiles(frame, kBytes * 300 * 180));
    EXPECT_TRUE(wants_tiles(frame, kBytes * 300 * 180 - 1));
    EXPECT_TRUE(wants_tiles(frame_of(kLargestTile + 1, 1, 1), kMostTargetBytes));
    EXPECT_LE(tile_side(frame_of(8192, 8192, 16), kMostTargetBytes), kLargestTile);
}

TEST(Tiles, CoverThePictureOnce) {
    for (const auto& [width, height, samples, side] :
         {std::array{100, 60, 3, 30}, std::array{7, 9, 1, 4}, std::array{5, 5, 4, 16}, std::array{8, 8, 1, 8}}) {
        Frame frame = frame_of(width, height, samples);
        frame.tile = side;
        Image picture = make_image(width, height, 0, 0, 0, 0);
        for (const PixelArea& tile : tiles_of(frame)) {
            EXPECT_EQ(tile.x % samples + tile.y % samples + tile.width % samples, 0);
            EXPECT_EQ(tile.x % 2 + tile.y % 2, 0);
            Image part = make_image(side / samples, side / samples);
            for (float& value : part.pixels) value = 1;
            for (int y = 0; y < tile.height / samples; y++)
                for (int x = 0; x < tile.width / samples; x++)
                    EXPECT_EQ(picture.at(tile.x / samples + x, tile.y / samples + y)[0], 0);
            put_tile(part, tile.x / samples, tile.y / samples, picture);
        }
        for (float value : picture.pixels) EXPECT_EQ(value, 1);
    }
    EXPECT_EQ(tiles_of(frame_of(3, 2, 5)).size(), 1u);
    EXPECT_EQ(tiles_of(frame_of(3, 2, 5))[0].width, 15);
}

TEST(Tiles, ShadowMapsKeepTheirSize) {
    Frame frame = frame_of(100, 60, 1);
    frame.tile = 20;
    EXPECT_EQ(image_size(frame, frame.targets[0]), glm::ivec2(20, 20));
    EXPECT_EQ(image_size(frame, frame.targets[2]), glm::ivec2(64, 64));
    frame.tile = 80;
    EXPECT_EQ(image_size(frame, frame.targets[1]), glm::ivec2(80, 60));
}

TEST(Tiles, ThatDoNotFitTheFrameAreRefused) {
    Frame frame = frame_of(100, 60, 3);
    EXPECT_EQ(frame_error(frame), "");
    frame.tile = 20;
    EXPECT_EQ(frame_error(frame), "the side of a tile must be a multiple of 6 samples, not 20");
    frame.tile = 30;
    EXPECT_EQ(frame_error(frame), "");

    Block block;
    block.name = "Frame";
    Reflection reflection;
    reflection.name = "Glass";
    Pass pass;
    pass.name = "bent";
    pass.targets = {{}};
    pass.reads_elsewhere = true;
    Mesh mesh;
    mesh.indices = {0};
    frame.steps = {FrameStep{.reflection = &reflection, .pass = &pass, .mesh = &mesh, .targets = {0}, .depth = 1}};
    EXPECT_EQ(frame_error(frame),
              "the pass 'bent' of 'Glass' reads the picture at other pixels than its own, which tiles do not have");
    pass.reads_elsewhere = false;
    EXPECT_EQ(frame_error(frame), "the pass 'bent' was compiled without 'tiles'");
    BlockMember tile;
    tile.name = "tile";
    block.members = {tile};
    block.size = 16;
    reflection.blocks = {block};
    frame.steps[0].blocks = {{.name = "Frame", .bytes = std::vector<std::byte>(16)}};
    EXPECT_EQ(frame_error(frame), "");
    const std::vector<BlockBytes> blocks = blocks_at(frame.steps[0], {.x = 30, .y = 60, .width = 30, .height = 24});
    float numbers[4];
    std::memcpy(numbers, blocks[0].bytes.data(), sizeof numbers);
    EXPECT_EQ(std::vector<float>(numbers, numbers + 4), (std::vector<float>{30, 60, 30, 24}));
    frame.shown = 2;
    EXPECT_EQ(frame_error(frame), "the target that a frame in tiles shows is not the picture");
}

}  // namespace
}  // namespace patina::runtime

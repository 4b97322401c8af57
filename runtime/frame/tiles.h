// Tiles of a frame. If the targets of a whole picture would take too much memory, only a part of them exists at a time.
// The frame is drawn again for each tile, and each tile's result is averaged into the picture at once. Targets that do
// not have the picture's size, such as shadow maps, are drawn once, with the first tile. The materials must be compiled
// with the switch `tiles` (nodes/stage/tiles.node.hlsl).
//
//   frame.tile = tile_side(frame, kMostTargetBytes);
//   for (const PixelArea& tile : tiles_of(frame)) draw(step, blocks_at(step, {.x = tile.x, .y = tile.y, ...}));
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/frame/frame.h"
#include "runtime/picture/image.h"

namespace patina::runtime {

// Of the targets that exist at a time. A picture that needs more is drawn in tiles, if it can be.
inline constexpr std::size_t kMostTargetBytes = std::size_t(512) << 20;
// Samples along a side of the targets of a tile: every device takes so many.
inline constexpr int kLargestTile = 4096;
// A picture that cannot be drawn in tiles is refused if it needs more.
inline constexpr std::size_t kMostWholeBytes = std::size_t(8) << 30;
// Samples along a side of a picture that is drawn in tiles.
inline constexpr int kLargestInTiles = 8 * kLargestImage;

// The memory for a tile of this size: its targets, copies of the targets that are read, and its averaged result.
std::size_t target_bytes(const Frame& frame, int width, int height);
// Of all of the picture at once.
std::size_t target_bytes(const Frame& frame);
// The picture's targets would be too many bytes, or too large.
bool wants_tiles(const Frame& frame, std::size_t most);
// The largest Frame::tile that takes no more than `most` bytes, or the smallest that there is.
int tile_side(const Frame& frame, std::size_t most);
// The size of tiles is a multiple of this. So tiles begin at a whole pixel, and no 2 x 2 group of samples, from which
// derivatives are made, is in two tiles.
int tile_step(const Frame& frame);

// The tiles from the top left, row by row; the last ones may be smaller. All of the picture, if Frame::tile is 0.
std::vector<PixelArea> tiles_of(const Frame& frame);
// The size of the target's image: of a tile, or its own.
glm::ivec2 image_size(const Frame& frame, const FrameTarget& target);
// The step draws into targets of the picture, so it is drawn once for each tile.
bool is_of_picture(const Frame& frame, const FrameStep& step);

// What the shaders learn of the tile: the values `tile` and `tileClip`.
struct TilePlace {
    int x = 0, y = 0, width = 0, height = 0;  // of the images of targets, in the picture
    glm::vec2 scale{1}, offset{0};            // of clip space
};
// The step's blocks with these values, if its shaders know them.
std::vector<BlockBytes> blocks_at(const FrameStep& step, const TilePlace& place);

// Empty, or why the frame must be drawn as a whole: "the pass 'x' of 'y' reads ...".
std::string whole_reason(const Frame& frame);
// Empty, or what is wrong with the tiles of the frame, in one sentence.
std::string tile_error(const Frame& frame);

// Takes the averaged samples of a tile into the picture, as far as they lie in it. `x`, `y`: of the picture's pixels.
void put_tile(const Image& part, int x, int y, Image& picture);

}  // namespace patina::runtime

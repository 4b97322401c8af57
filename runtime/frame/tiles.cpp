#include "runtime/frame/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include "runtime/frame/frame_check.h"
#include "runtime/frame/pixel_format.h"

namespace patina::runtime {
namespace {

constexpr std::size_t kFloatPixel = 16;      // four floats
constexpr std::size_t kDepthAndStencil = 8;  // of a pixel, as devices align them

std::size_t bytes_of_pixel(const PixelFormat& format) {
    return format.is_depth ? kDepthAndStencil : format.bytes;
}

// A step may read what it draws into through a copy, and the CPU reads a target as floats.
bool is_read(const Frame& frame, std::size_t target) {
    return std::any_of(frame.steps.begin(), frame.steps.end(), [&](const FrameStep& step) {
        return std::any_of(step.reads.begin(), step.reads.end(),
                           [&](const FrameRead& read) { return read.target == target; });
    });
}

struct TileMember {
    const Block* block = nullptr;
    std::size_t offset = 0;
};

std::vector<TileMember> members_named(const Reflection& reflection, std::string_view name) {
    std::vector<TileMember> found;
    for (const Block& block : reflection.blocks) {
        for (const BlockMember& member : block.members)
            if (!block.is_material && member.name == name) found.push_back({&block, member.offset});
    }
    return found;
}

void write(std::vector<BlockBytes>& blocks, const Reflection& reflection, std::string_view name, glm::vec4 value) {
    const std::array<float, 4> numbers = {value.x, value.y, value.z, value.w};
    for (const TileMember& member : members_named(reflection, name)) {
        for (BlockBytes& block : blocks)
            if (block.name == member.block->name && member.offset + sizeof numbers <= block.bytes.size())
                std::memcpy(&block.bytes[member.offset], numbers.data(), sizeof numbers);
    }
}

}  // namespace

std::size_t target_bytes(const Frame& frame, int width, int height) {
    std::size_t of_pixel = 0;
    for (std::size_t i = 0; i < frame.targets.size(); i++) {
        if (!frame.targets[i].is_of_picture) continue;
        of_pixel += bytes_of_pixel(pixel_format(frame.targets[i].format));
        if (is_read(frame, i)) of_pixel += kFloatPixel;
    }
    of_pixel += bytes_of_pixel(pixel_format(frame.targets[frame.shown].format)) + kFloatPixel;
    return of_pixel * std::size_t(width) * std::size_t(height);
}

std::size_t target_bytes(const Frame& frame) {
    const FrameTarget& picture = frame.targets[frame.shown];
    return target_bytes(frame, picture.width, picture.height);
}

bool wants_tiles(const Frame& frame, std::size_t most) {
    const FrameTarget& picture = frame.targets[frame.shown];
    return std::max(picture.width, picture.height) > kLargestTile || target_bytes(frame) > most;
}

int tile_step(const Frame& frame) {
    return std::lcm(2, frame.samples);
}

int tile_side(const Frame& frame, std::size_t most) {
    const FrameTarget& picture = frame.targets[frame.shown];
    const int step = tile_step(frame), largest = std::max(picture.width, picture.height);
    const auto fits = [&](int side) {
        return target_bytes(frame, std::min(side, picture.width), std::min(side, picture.height)) <= most;
    };
    int low = 1, high = (std::min(largest, kLargestTile) + step - 1) / step;  // in steps
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (fits(middle * step))
            low = middle;
        else
            high = middle - 1;
    }
    return low * step;
}

std::vector<PixelArea> tiles_of(const Frame& frame) {
    const FrameTarget& picture = frame.targets[frame.shown];
    if (frame.tile == 0) return {{.width = picture.width, .height = picture.height}};
    std::vector<PixelArea> tiles;
    for (int y = 0; y < picture.height; y += frame.tile) {
        for (int x = 0; x < picture.width; x += frame.tile)
            tiles.push_back({.x = x,
                             .y = y,
                             .width = std::min(frame.tile, picture.width - x),
                             .height = std::min(frame.tile, picture.height - y)});
    }
    return tiles;
}

glm::ivec2 image_size(const Frame& frame, const FrameTarget& target) {
    if (frame.tile == 0 || !target.is_of_picture) return {target.width, target.height};
    return {std::min(frame.tile, target.width), std::min(frame.tile, target.height)};
}

bool is_of_picture(const Frame& frame, const FrameStep& step) {
    return frame.targets[attachments(step).front()].is_of_picture;
}

std::vector<BlockBytes> blocks_at(const FrameStep& step, const TilePlace& place) {
    std::vector<BlockBytes> blocks = step.blocks;
    write(blocks, *step.reflection, "tile", {place.x, place.y, place.width, place.height});
    write(blocks, *step.reflection, "tileClip", {place.scale, place.offset});
    return blocks;
}

std::string whole_reason(const Frame& frame) {
    for (const FrameStep& step : frame.steps) {
        if (!is_of_picture(frame, step)) {
            for (const FrameRead& read : step.reads)
                if (frame.targets[read.target].is_of_picture)
                    return fmt::format("the pass '{}' of '{}' draws from a light and reads '{}'", step.pass->name,
                                       step.reflection->name, frame.targets[read.target].name);
        } else if (step.pass->reads_elsewhere) {
            return fmt::format("the pass '{}' of '{}' reads the picture at other pixels than its own", step.pass->name,
                               step.reflection->name);
        }
    }
    return "";
}

std::string tile_error(const Frame& frame) {
    if (frame.tile == 0) return "";
    if (frame.tile < 0 || frame.tile % tile_step(frame) != 0)
        return fmt::format("the side of a tile must be a multiple of {} samples, not {}", tile_step(frame), frame.tile);
    if (!frame.targets[frame.shown].is_of_picture) return "the target that a frame in tiles shows is not the picture";
    if (std::string reason = whole_reason(frame); !reason.empty()) return reason + ", which tiles do not have";
    for (const FrameStep& step : frame.steps) {
        if (!is_of_picture(frame, step)) continue;
        if (members_named(*step.reflection, "tile").empty())
            return fmt::format("the pass '{}' was compiled without 'tiles'", step.pass->name);
        if (step.area.width != 0) return fmt::format("the pass '{}' draws an area of the picture", step.pass->name);
    }
    return "";
}

void put_tile(const Image& part, int x, int y, Image& picture) {
    const int width = std::min(part.width, picture.width - x), height = std::min(part.height, picture.height - y);
    for (int row = 0; row < height; row++)
        std::copy_n(part.at(0, row).data(), 4 * std::size_t(width), picture.at(x, y + row).data());
}

}  // namespace patina::runtime

// The values behind one pixel of a frame. Draws everything on which the pixel depends, remembers the fragments that
// cover it, and runs the stages of one of them again with a record of every node. It does not name objects; they are
// the world's indices.
//
//   Outcome<PixelTrace> traced = cpu_trace(frame, {.x = 120, .y = 80});
//   if (traced && traced.value.object) print(world.objects[*traced.value.object].name, traced.value.values);
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "patina/interpret.h"
#include "runtime/frame/frame.h"
#include "runtime/outcome.h"

namespace patina::runtime {

struct PixelTrace {
    bool is_covered = false;    // by the traced object; if not, `values` are empty
    bool is_discarded = false;  // every fragment of it was, as in the holes of a cutout; `values` are of the nearest
    bool is_hidden = false;     // something opaque is before it; `values` are what it would have
    std::optional<std::size_t> object{};  // that was traced
    std::size_t instance = 0;             // of the object
    std::string pass{};                   // that was traced
    bool is_extra = false;                // a pass that the material adds
    std::vector<std::size_t> seen{};      // objects that are drawn into the traced sample, the front-most first
    // The traced sample of the pixel: of the samples that show the object, the one nearest to the middle. Samples that
    // are not finite go before the others.
    int sample_x = 0, sample_y = 0;                     // 0 to samples - 1, right and down
    std::vector<TracedValue> values{};                  // of the fragment stage
    std::array<std::vector<TracedValue>, 3> corners{};  // of the vertex stage, at the triangle's corners
    std::array<float, 4> sample_color{};                // what the sample shows, linear
    std::array<float, 4> color{};                       // what the pixel shows: all its samples, averaged
};

struct TraceWish {
    int x = 0, y = 0;                     // from the top left, inside the picture
    std::optional<std::size_t> object{};  // nothing: the front-most one, blended ones among them
    Precision precision = Precision::Float;
};

// Steps that nothing later reads are drawn at that pixel alone.
Outcome<PixelTrace> cpu_trace(const Frame& frame, const TraceWish& wish);

}  // namespace patina::runtime

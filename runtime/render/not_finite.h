// Finds the node that numbers which are not finite come from: the CPU computes a pixel again, and looks at every value.
//
//   if (const std::optional<Cause> cause = cause_at(compiler, world, options, {.x = 3, .y = 5})) blame(warning,
//   *cause);
#pragma once

#include <optional>
#include <string>

#include "runtime/render/render_world.h"

namespace patina::runtime {

// Where such a number is first: what comes after it is not finite because of it.
struct Cause {
    TracedValue value{};
    std::string object{};   // empty: a graph is drawn alone
    bool is_front = false;  // the object is what `patina trace` shows of the pixel
};

// The front-most visible object at the pixel that computes such a number. Nothing if the CPU finds none.
std::optional<Cause> cause_at(const Compiler& compiler, const World& world, const RenderOptions& options,
                              TraceWish wish);
// ": 'share.out' is inf there"
std::string words_of(const Cause& cause);
// Gives a message the node and its place.
void blame(Diagnostic& warning, const Cause& cause);

}  // namespace patina::runtime

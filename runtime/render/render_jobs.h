// Renders on several threads, each with a device of its own.
//
//   render_jobs(cases.size(), jobs, [&](std::size_t i, RenderMachine& machine) { results[i] = run(cases[i], machine);
//   },
//               [&](std::size_t i) { tell(results[i]); });
#pragma once

#include <cstddef>
#include <functional>

#include "runtime/render/render_machine.h"

namespace patina::runtime {

// Does `work` for 0 to `count` - 1, on `jobs` threads; 0: as many as the machine has cores, at most 4. `done` is called
// once for each, in their order and as soon as possible, by one thread at a time.
void render_jobs(std::size_t count, int jobs, const std::function<void(std::size_t, RenderMachine&)>& work,
                 const std::function<void(std::size_t)>& done = {});

}  // namespace patina::runtime

// The room `jobs`: work on several threads. It does not know what the work is.
//
//   in_order(graphs.size(), jobs, [&] { return [&](std::size_t i) { made[i] = make(graphs[i]); }; },
//            [&](std::size_t i) { print(made[i]); });
#pragma once

#include <cstddef>
#include <functional>

namespace patina::runtime {

using Work = std::function<void(std::size_t)>;

// Does the work for 0 to `count` - 1, on `jobs` threads; 0: as many as the machine has cores, at most `most`. Each
// thread calls `make_worker` once and has what it gives for itself. `done` is called once for each, in their order and
// as soon as possible, by one thread at a time. No thread gets further ahead of `done` than some hundred pieces, so
// that what is made and not done stays small. What one of the functions throws is thrown here, when all threads have
// ended; no further piece begins then.
void in_order(std::size_t count, int jobs, const std::function<Work()>& make_worker, const Work& done,
              unsigned most = 256);

}  // namespace patina::runtime

#include "runtime/render/render_jobs.h"

#include <memory>

#include "runtime/jobs/jobs.h"

namespace patina::runtime {

void render_jobs(std::size_t count, int jobs, const std::function<void(std::size_t, RenderMachine&)>& work,
                 const std::function<void(std::size_t)>& done) {
    constexpr unsigned kMostJobs = 4;  // without a wish: each needs a device and its memory
    const auto make_worker = [&]() -> Work {
        return [&work, machine = std::make_shared<RenderMachine>()](std::size_t i) { work(i, *machine); };
    };
    in_order(
        count, jobs, make_worker,
        [&](std::size_t i) {
            if (done) done(i);
        },
        kMostJobs);
}

}  // namespace patina::runtime

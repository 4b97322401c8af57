// The room `seam` is where exceptions end. Inside of the library, functions throw as the standard library does: no
// memory, a thread that cannot be started, a bug in Patina. A public function whose result has diagnostics runs its
// work in guarded(). An exception becomes an error of the result, `out-of-memory` or `internal`, at the file, the node
// and the pass in work.
//
// There may be no memory for the message then: its room is taken before the work begins. If not even that can be had,
// the result is not ok and has no diagnostics.
//
//   return guarded<Result>(path, [&](Trail& trail) {
//       resolve::Session session(...);
//       const TrailGuard guard(trail, session.diagnostics);   // remembers which node it was
//       ...
//       return result;
//   });
#pragma once

#include <array>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "patina/diagnostic.h"

namespace patina {

// A name, cut to a fixed length, so that storing it allocates nothing.
class ShortName {
public:
    void operator=(std::string_view name);
    std::string_view text() const { return {letters_.data(), size_}; }

private:
    std::array<char, 120> letters_{};
    std::size_t size_ = 0;
};

// What was worked on when the exception came.
struct Trail {
    ShortName node{}, port{};  // as in Diagnostic
    ShortName pass{};
};

// Leaves on the trail what the diagnostics and `pass` say, if an exception passes by. `pass` has a copy of the name:
// what the name belongs to is gone by then.
class TrailGuard {
public:
    TrailGuard(Trail& trail, const Diagnostics& diagnostics, const ShortName* pass = nullptr)
        : trail_(trail), diagnostics_(diagnostics), pass_(pass) {}
    ~TrailGuard();
    TrailGuard(const TrailGuard&) = delete;

private:
    Trail& trail_;
    const Diagnostics& diagnostics_;
    const ShortName* pass_;
    int exceptions_ = std::uncaught_exceptions();
};

// The error of an exception, with its room.
class Unexpected {
public:
    explicit Unexpected(std::string_view file);
    // The error for the exception that is being handled: one diagnostic. It allocates nothing, and is called once.
    std::vector<Diagnostic> describe(const Trail& trail);

private:
    std::vector<Diagnostic> room_;
};

// Runs `work`, which returns a Result. `file` names what is worked on; empty: nothing does. `prepare` is given the
// result of a failure before the work begins.
template <class Result, class Work, class Prepare>
Result guarded(std::string_view file, const Work& work, const Prepare& prepare) {
    Result failed;
    try {
        prepare(failed);
        Unexpected unexpected(file);
        Trail trail;
        try {
            return work(trail);
        } catch (...) {
            failed.diagnostics = unexpected.describe(trail);
        }
    } catch (...) {  // there was no room for an error
    }
    return failed;
}
template <class Result, class Work>
Result guarded(std::string_view file, const Work& work) {
    return guarded<Result>(file, work, [](Result&) {});
}

}  // namespace patina

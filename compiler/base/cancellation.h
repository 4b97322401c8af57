// Asks the program that called the library whether the work should go on (Limits::cancelled). All work that can take
// long counts its steps here: a JSON value that is read, an instruction that is made, a statement that is printed. A
// step takes some microseconds at most, so a question each kStepsPerQuestion steps comes several times in 100 ms. Steps
// are counted, and no clock is read, so the same work always asks at the same steps.
//
// Cancelled work ends with an exception, Stopped, because a half-finished reader, IR pass or printer has no useful
// result. Only the function that began the call catches it (resolve::until_stopped()).
//
// A Cancellation belongs to the thread that made it, while it exists: a thread works for one call at a time. Where
// there is none, a step does nothing. Values that all compilations share, such as a library's file, are made under a
// Cancellation that never asks. So a cancelled call never leaves such a value half made.
//
//   const Cancellation cancellation(options.limits.cancelled);
//   for (const Function& function : functions) Cancellation::step(function.insts.size());
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace patina {

// The end of a call's work: the program has cancelled it, or an error that was reported ends it.
struct Stopped {
    std::string why{};         // what the program's function has thrown
    bool is_reported = false;  // there is an error that says why
};

// How large what a call makes may become. A few lines of a node file can become millions of instructions, by nested
// loops that are written out, or by calls of calls. All modules of one compilation count together.
struct Growth {
    std::size_t most;      // Limits::instructions
    std::size_t made = 0;  // so far
};

class Cancellation {
public:
    static constexpr std::size_t kStepsPerQuestion = 2048;

    // Never asks.
    Cancellation() : Cancellation(nobody()) {}
    // `asked` must live as long.
    explicit Cancellation(const std::function<bool()>& asked) : asked_(asked), outer_(current_) { current_ = this; }
    ~Cancellation() { current_ = outer_; }
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;

    static void step(std::size_t steps = 1) {
        if (Cancellation* const one = current_; one && (one->since_ += steps) >= kStepsPerQuestion) one->ask();
    }
    // Asks now. True, with the reason if there is one, if the work is to end.
    bool is_cancelled(std::string& why);

private:
    static const std::function<bool()>& nobody();
    void ask();

    static constinit thread_local Cancellation* current_;

    const std::function<bool()>& asked_;
    Cancellation* outer_;
    std::size_t since_ = 0;  // steps since the last question
};

}  // namespace patina

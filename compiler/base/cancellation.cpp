#include "compiler/base/cancellation.h"

#include <exception>

namespace patina {

constinit thread_local Cancellation* Cancellation::current_ = nullptr;

const std::function<bool()>& Cancellation::nobody() {
    static const std::function<bool()> kNobody;
    return kNobody;
}

// A function that fails also ends the work.
bool Cancellation::is_cancelled(std::string& why) {
    since_ = 0;
    try {
        return asked_ && asked_();
    } catch (const std::exception& exception) {
        why = exception.what();
    } catch (...) {
        why = "the program's function failed";
    }
    return true;
}

void Cancellation::ask() {
    Stopped stopped;
    if (is_cancelled(stopped.why)) throw stopped;
}

}  // namespace patina

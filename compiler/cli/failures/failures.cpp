#include "compiler/cli/failures/failures.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <new>
#include <system_error>

namespace patina::cli {
namespace {

// Cut to a fixed length, because there may be no memory for it.
thread_local std::array<char, 512> t_file{};
thread_local std::size_t t_file_size = 0;

struct Failure {
    Complaint what = Complaint::Internal;
    Exit exit = Exit::Mistake;
    const char* why = "an unknown exception";  // as long as the exception
};

// std::system_error also is what std::filesystem throws, with the names of the files.
Failure failure_of(const std::exception& exception) {
    if (dynamic_cast<const std::bad_alloc*>(&exception))
        return {.what = Complaint::OutOfMemory, .exit = Exit::Machine, .why = ""};
    if (dynamic_cast<const std::system_error*>(&exception))
        return {.what = Complaint::SystemRefuses, .exit = Exit::Machine, .why = exception.what()};
    return {.why = exception.what()};
}

// Of the exception that is being handled. `why` is as long as it.
Failure current_failure() noexcept {
    try {
        throw;
    } catch (const std::exception& exception) {
        return failure_of(exception);
    } catch (...) {
        return {};
    }
}

}  // namespace

void work_on_file(std::string_view path) noexcept {
    t_file_size = path.copy(t_file.data(), t_file.size());
}

Unexpected describe_exception(std::string_view file) {
    const Failure failure = current_failure();
    Unexpected made{.error = complaint(failure.what, {failure.why}), .exit = failure.exit};
    made.error.file = file;
    return made;
}

Exit report_exception(const Console& console, std::string_view file) noexcept {
    const Failure failure = current_failure();
    try {
        const Unexpected unexpected =
            describe_exception(file.empty() ? std::string_view(t_file.data(), t_file_size) : file);
        report(console, {&unexpected.error, 1});
    } catch (...) {
        const std::string_view code = code_of(failure.what);
        std::fprintf(stderr, "patina: there is not enough memory [%.*s]\n", static_cast<int>(code.size()), code.data());
    }
    ask_for_exit(failure.exit);
    return failure.exit;
}

}  // namespace patina::cli

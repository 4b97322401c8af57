// What a command says of an exception, and the exit code that it gives: no exception ends a program without a message.
// Lack of memory, and other refusals of the system, are no faults of the input; everything else is a bug in Patina.
//
//   for (const std::string& graph : graphs)   // what is thrown for one does not stop the others
//       exit = worse(exit, guarded(console, graph, [&] { return write(graph); }));
#pragma once

#include <string_view>

#include "compiler/cli/console.h"

namespace patina::cli {

// The file that this thread works on now, for an exception that somebody else reports.
void work_on_file(std::string_view path) noexcept;

// The error for the exception that is being handled, and the exit code.
struct Unexpected {
    Diagnostic error{};
    Exit exit = Exit::Mistake;
};
Unexpected describe_exception(std::string_view file);

// Reports the exception that is being handled. `file`: the file in work; empty: the file of work_on_file(). If there is
// no memory for a message with a place, it is one without. run() ends the program with the exit code, or a greater one.
Exit report_exception(const Console& console, std::string_view file = {}) noexcept;

// Works on one of several files. An exception is reported for the file, and the exit code is Wrong. So the work on the
// other files continues.
template <class Work>
Exit guarded(const Console& console, std::string_view file, const Work& work) {
    work_on_file(file);
    try {
        return work();
    } catch (...) {
        report_exception(console, file);
        return Exit::Wrong;
    }
}

}  // namespace patina::cli

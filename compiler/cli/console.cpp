#include "compiler/cli/console.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "compiler/cli/failures/failures.h"

namespace patina::cli {
namespace {

constexpr std::string_view kClearLine = "\r\033[K";

std::atomic<Exit> exit_asked_for = Exit::Ok;

bool is_terminal(int descriptor) {
    const char* terminal = std::getenv("TERM");
    return isatty(descriptor) && terminal && std::string_view(terminal) != "dumb";
}

bool shows_colors(int descriptor) {
    const char* no_color = std::getenv("NO_COLOR");
    return is_terminal(descriptor) && !(no_color && *no_color);
}

void write(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);
}

}  // namespace

Exit worse(Exit a, Exit b) {
    return static_cast<Exit>(std::max(static_cast<int>(a), static_cast<int>(b)));
}

Console open_console() {
    return {.error_colors = shows_colors(STDERR_FILENO),
            .output_colors = shows_colors(STDOUT_FILENO),
            .progress = is_terminal(STDERR_FILENO)};
}

bool report(const Console& console, std::span<const Diagnostic> diagnostics) {
    bool any_error = false;
    for (const Diagnostic& diagnostic : diagnostics) {
        const bool is_error = diagnostic.severity == Severity::Error;
        any_error |= is_error;
        if (diagnostic.code == code_of(Complaint::OutOfMemory)) ask_for_exit(Exit::Machine);
        if (diagnostic.code == code_of(Complaint::Internal)) ask_for_exit(Exit::Mistake);
        if (console.quiet && !is_error) continue;
        if (console.json) {
            print(to_json(diagnostic));
            print("\n");
            continue;
        }
        end_progress(console);
        std::string text = to_text(diagnostic, console.error_colors);
        if (!text.ends_with('\n')) text += '\n';
        write(stderr, text);
    }
    return any_error;
}

Exit exit_of_reports() {
    return exit_asked_for;
}

void ask_for_exit(Exit exit) noexcept {
    exit_asked_for = worse(exit_asked_for, exit);
}

void complain(const Console& console, Complaint what, std::initializer_list<std::string_view> words) {
    const Diagnostic diagnostic = complaint(what, words);
    report(console, {&diagnostic, 1});
}

bool is_mixed(const Console& console, bool prints, std::string_view what) {
    if (!console.json || !prints) return false;
    complain(console, Complaint::MixedOutput, {what});
    return true;
}

void say(const Console& console, std::string_view line) {
    if (console.quiet || console.json) return;
    end_progress(console);
    print(line);
    print("\n");
}

void remark(const Console& console, std::string_view line) {
    if (console.quiet || console.json) return;
    end_progress(console);
    std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
}

void print(std::string_view text) {
    write(stdout, text);
}

bool output_failed() {
    return std::fflush(stdout) != 0 || std::ferror(stdout);
}

std::string heading(const Console& console, std::string_view text) {
    if (!console.output_colors) return std::string(text);
    return "\033[1m" + std::string(text) + "\033[0m";
}

void show_progress(const Console& console, std::size_t index, std::size_t count, std::string_view item) {
    work_on_file(item);
    if (!console.progress || console.quiet || console.json || count < 2) return;
    constexpr std::size_t kWidth = 20;
    const std::size_t full = std::min(index * kWidth / count, kWidth);
    std::string line(kClearLine);
    line += '[' + std::string(full, '#') + std::string(kWidth - full, '-') + "] ";
    line += std::to_string(index + 1) + '/' + std::to_string(count) + ' ' + std::string(item);
    write(stderr, line);
    std::fflush(stderr);
}

void show_share(const Console& console, double share, std::string_view item) {
    if (!console.progress || console.quiet || console.json) return;
    write(stderr, std::string(kClearLine) + std::string(item) + ' ' + std::to_string(int(100 * share)) + '%');
    std::fflush(stderr);
}

void end_progress(const Console& console) {
    if (!console.progress || console.quiet || console.json) return;
    // If both streams show on one terminal, what was printed to stdout before must appear before.
    std::fflush(stdout);
    write(stderr, kClearLine);
    std::fflush(stderr);
}

}  // namespace patina::cli

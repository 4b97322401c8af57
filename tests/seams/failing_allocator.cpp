// Is loaded before a program's libraries, and lets one of its allocations fail, or all from one on: the
// PATINA_FAIL_AT-th after `main` has begun. With PATINA_FAIL_ALL=1, all after it, too. PATINA_COUNT_TO names a file
// that gets the number of allocations.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<bool> counts = false;
std::atomic<long> counted = 0;
long failing = -1;
bool all_fail = false;

bool fails() {
    if (!counts) return false;
    const long now = ++counted;
    return failing > 0 && (all_fail ? now >= failing : now == failing);
}

template <class Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void write_count() {
    const char* path = std::getenv("PATINA_COUNT_TO");
    if (!path) return;
    char text[32];
    const int size = std::snprintf(text, sizeof text, "%ld\n", counted.load());
    const int file = ::open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || ::write(file, text, static_cast<std::size_t>(size)) < 0) std::abort();
    ::close(file);
}

using Main = int(int, char**, char**);
Main* own_main = nullptr;

int counting_main(int argc, char** argv, char** environment) {
    const char* at = std::getenv("PATINA_FAIL_AT");
    const char* all = std::getenv("PATINA_FAIL_ALL");
    failing = at ? std::atol(at) : -1;
    all_fail = all && std::strcmp(all, "1") == 0;
    counts = true;
    const int exit = own_main(argc, argv, environment);
    counts = false;
    write_count();
    return exit;
}

}  // namespace

extern "C" {

// patina's operator new calls these.
void* mi_malloc(std::size_t size) {
    static auto* const real = next<void*(std::size_t)>("mi_malloc");
    return fails() ? nullptr : real(size);
}
void* mi_malloc_aligned(std::size_t size, std::size_t align) {
    static auto* const real = next<void*(std::size_t, std::size_t)>("mi_malloc_aligned");
    return fails() ? nullptr : real(size, align);
}

int __libc_start_main(Main* main, int argc, char** argv, void (*begin)(), void (*end)(), void (*end_of_linker)(),
                      void* stack) {
    static auto* const real =
        next<int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*)>("__libc_start_main");
    own_main = main;
    return real(counting_main, argc, argv, begin, end, end_of_linker, stack);
}

}  // extern "C"

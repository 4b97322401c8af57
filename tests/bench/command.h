// Runs patina as a process of its own.
#pragma once

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cstddef>
#include <string>
#include <vector>

extern char** environ;

namespace patina::bench {

struct CommandRun {
    bool ok = false;
    std::size_t most_bytes = 0;  // of memory that it had at once
};

// From the start of the process to its end.
inline CommandRun run_patina(std::vector<std::string> words) {
    words.insert(words.begin(), PATINA_COMMAND);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    int status = -1;
    rusage usage{};
    if (posix_spawn(&child, PATINA_COMMAND, nullptr, nullptr, arguments.data(), environ) == 0)
        wait4(child, &status, 0, &usage);
    return {.ok = status == 0, .most_bytes = std::size_t(usage.ru_maxrss) * 1024};
}

}  // namespace patina::bench

#include "runtime/files/leftovers.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <set>

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = ".patina-";
constexpr std::chrono::hours kOld{1};

std::string process() {
    return std::string(kBegin) + std::to_string(::getpid()) + "-";
}

// ".patina-4711-18f3a2c0b1d2e3f4-"
std::string run() {
    static const auto begin = std::uint64_t(std::chrono::system_clock::now().time_since_epoch().count());
    char digits[16];
    return process() + std::string(digits, std::to_chars(digits, digits + sizeof digits, begin, 16).ptr) + "-";
}

bool is_number(std::string_view text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    return !text.empty() && text.find_first_not_of(kDigits) == text.npos;
}

bool is_first_look(const std::string& folder) {
    static std::mutex mutex;
    static std::set<std::string> seen;
    const std::lock_guard guard(mutex);
    return seen.insert(folder).second;
}

}  // namespace

std::string temporary_name(unsigned number) {
    return run() + std::to_string(number);
}

bool is_temporary_of_another(std::string_view name) {
    if (!name.starts_with(kBegin)) return false;
    const std::string_view numbers = name.substr(kBegin.size());
    const std::size_t first = numbers.find('-'), last = numbers.rfind('-');
    if (first == numbers.npos || !is_number(numbers.substr(0, first)) || !is_number(numbers.substr(last + 1)))
        return false;
    if (first == last) return !name.starts_with(process());
    return is_number(numbers.substr(first + 1, last - first - 1)) && !name.starts_with(run());
}

void remove_leftovers(const std::string& folder, bool is_locked) {
    if (!is_first_look(folder)) return;
    std::error_code failure;
    const fs::file_time_type oldest = fs::file_time_type::clock::now() - kOld;
    for (fs::directory_iterator at(folder, failure); !failure && at != fs::directory_iterator();
         at.increment(failure)) {
        if (!is_temporary_of_another(at->path().filename().native())) continue;
        std::error_code gone;
        const bool is_file = fs::is_regular_file(at->symlink_status(gone));
        const fs::file_time_type written = at->last_write_time(gone);
        if (!gone && is_file && (is_locked || written < oldest)) fs::remove(at->path(), gone);
    }
}

}  // namespace patina::runtime

// What the library can be asked for, each with a text that says all of its answer. A test does each without memory.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "failing_new.h"
#include "patina/patina.h"

namespace patina::testing {

// When which allocation fails.
struct Plan {
    long nth = kNever;
    Failing how = Failing::Once;
    long counted = 0;  // of the call
};

struct Answer {
    std::string text{};  // all of it
    bool has_error = false;
    std::vector<Diagnostic> diagnostics{};
    bool is_without_memory = false;  // it says that there is not enough memory
    std::string escaped{};           // an exception that should have ended inside
};

struct Work {
    std::string name;
    // Calls the library once, by the plan.
    std::function<Answer(const Compiler&, Plan&)> run;
};

// Calls what may fail. Nothing if std::bad_alloc came out of it.
template <class Call>
auto within(Plan& plan, const Call& call) -> std::optional<decltype(call())> {
    fail_at(plan.nth, plan.how);
    try {
        std::optional<decltype(call())> result(call());
        plan.counted = stop_failing();
        return result;
    } catch (const std::bad_alloc&) {
        plan.counted = stop_failing();
        return std::nullopt;
    }
}

// Functions whose results have diagnostics: no exception leaves them.
std::vector<Work> works_with_results();
// Functions that give plain values, and may throw std::bad_alloc.
std::vector<Work> works_with_values();
// The functions of patina_c.h: none throws.
std::vector<Work> works_in_c();

}  // namespace patina::testing

// An operator new that fails when a test says so. All forms of it are replaced in the program that links this.
//
//   fail_at(1000, Failing::Once);   // counts from here; the 1000th fails
//   call();
//   long count = stop_failing();
#pragma once

namespace patina::testing {

enum class Failing {
    Once,     // this one alone
    FromHere  // this one and all after it
};

constexpr long kNever = -1;

// Counts allocations from now on. `nth`: the one that fails, from 1; or kNever.
void fail_at(long nth, Failing how);
// Nothing fails any more. Returns how many allocations have been counted.
long stop_failing();

}  // namespace patina::testing

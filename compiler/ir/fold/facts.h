// Facts about a value that are known without computing it: its range, and whether it is a unit vector. Facts are found
// by looking a few operands back, each time that they are asked for.
//
//   range_of({module, function}, saturated)            // 0 to 1, and never NaN
//   is_unit({module, function}, normalized)            // true
//   range_of({module, function, true}, parameter)      // what all callers pass
#pragma once

#include <limits>

#include "compiler/ir/ir.h"

namespace patina::ir {

struct FactsOf {
    const Module& module;
    const Function& function;
    // Also look at the arguments that callers pass, and at what callees return. The function must be one of the
    // module's, and all of them must be finished.
    bool across_calls = false;
};

// Of all components. The bounds hold for every result of a correctly rounded operation.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool may_be_nan = true;

    bool is_finite() const;
};
Range range_of(const FactsOf& facts, Value value);

// True if the value has length 1 but for rounding, or is NaN.
bool is_unit(const FactsOf& facts, Value value);

// The same for the result of a function, without facts about the functions that it calls.
bool returns_unit(const Module& module, const Function& function);

}  // namespace patina::ir

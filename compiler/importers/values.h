// Values of imported graphs, from lists of numbers and from JSON.
#pragma once

#include <ranges>

#include "compiler/json/json.h"
#include "patina/graph_builder.h"

namespace patina::importers {

// Of floats with the fewest digits that are these floats.
template <std::ranges::range Numbers>
GraphValue list_of(const Numbers& values) {
    return GraphValue::list({std::ranges::begin(values), std::ranges::end(values)});
}

// The value that JSON has, with numbers as floats; of null, 0.
GraphValue value_of(const json::Json& json);

}  // namespace patina::importers

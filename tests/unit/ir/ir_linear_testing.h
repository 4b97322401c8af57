// What tests of linear parts share: running functions, and the struct that most of them take.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/linear/linear_part.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {

using interpret::Flat;
using Numbers = std::vector<double>;

inline const Param kXyz{"x", kFloat3, Rate::Pixel}, kK{"k", kFloat3, Rate::Pixel};
inline const Seed kFirst = Seed::of_member(0, 0);

inline Numbers evaluate(const Module& module, FunctionId f, const std::vector<Flat>& arguments) {
    return interpret::run(module, f, {arguments, arguments, arguments, arguments}, {}, Precision::Double).lanes[2];
}

inline FunctionId push(Module& module, Function function) {
    module.functions.push_back(std::move(function));
    EXPECT_EQ(verify(module), "");
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

inline void expect_near(const Numbers& got, const Numbers& wanted, const std::string& text) {
    ASSERT_EQ(got.size(), wanted.size()) << text;
    for (std::size_t i = 0; i < got.size(); i++)
        EXPECT_NEAR(got[i], wanted[i], 1e-9 * std::max(1.0, std::abs(wanted[i]))) << text << "\ncomponent " << i;
}

inline Value numbers(Builder& b, const Numbers& components) {
    const Type type = components.size() == 1 ? kFloat : kFloat.with_width(static_cast<unsigned>(components.size()));
    return b.constant(type, components);
}

// Surface { float3 color, float roughness, float3 normal }; its color is x.
inline Type surface(Module& module) {
    if (module.structs.empty())
        module.structs.push_back({"Surface", {{"color", kFloat3}, {"roughness", kFloat}, {"normal", kFloat3}}});
    return Type::structure(0);
}

inline Value blamed(Builder& b, const std::function<Value()>& make) {
    b.set_origin({1});
    const Value value = make();
    b.set_origin({0});
    return value;
}

inline void add_origins(Module& module) {
    module.origins = {{.label = "", .id = "innocent", .span = {}}, {.label = "", .id = "culprit", .span = {}}};
}

}  // namespace patina::ir

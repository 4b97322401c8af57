// All passes keep the meaning of random modules, as the interpreter sees it, and stay linear on modules that are made
// to explode.
#include <cmath>
#include <random>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/dump.h"
#include "compiler/ir/passes/passes.h"
#include "tests/unit/ir/ir_testing.h"

namespace patina::ir {
namespace {

// --- meaning

// Random modules of calls, branches, loops and structs, from ops that are exact: every witness must agree to the bit.
class RandomModule {
public:
    explicit RandomModule(unsigned seed) : random_(seed) {
        for (std::uint32_t k = 0; k < kKeywords; k++) {
            const std::string name = "_K" + std::to_string(k);
            module.keywords.push_back({.value = static_cast<double>(seed >> k & 1)});
            module.globals.push_back({.name = name, .type = kBool});
            module.globals.back().keyword = k;
        }
        for (std::uint32_t k = 0; k < 4; k++) {
            module.structs.push_back({"Triple", {{"a", kFloat}, {"b", kFloat}, {"c", kFloat}}});
            const bool returns_struct = k < 3 && pick(2) == 0;
            std::vector<Param> params(1 + pick(3), kX);
            const Type result = returns_struct ? Type::structure(k) : kFloat;
            if (k < 3 && k > 0 && pick(2) == 0) params.push_back({"t", Type::structure(k - 1), Rate::Pixel});
            const FunctionId made = add(
                module, "f" + std::to_string(k), params, result,
                [&](Builder& b) {
                    visible_.clear();
                    for (std::uint32_t i = 0; i < params.size(); i++)
                        visible_.push_back(params[i].type == kFloat ? b.param(i) : b.extract(b.param(i), pick(3)));
                    statements(b, 6, 0);
                    if (!returns_struct) return any();
                    const std::vector<Value> parts = {any(), any(), any()};
                    return b.construct(result, parts);
                },
                false);
            callable_.push_back(made);
        }
        set_entry(module, callable_.back());
    }
    Module module;

private:
    std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    Value any() { return visible_[pick(static_cast<std::uint32_t>(visible_.size()))]; }

    void statements(Builder& b, int n, int depth) {
        for (int k = 0; k < n; k++) {
            const std::uint32_t kind = pick(12);
            if (kind == 0 && depth < 3) {
                branch(b, depth);
            } else if (kind == 1 && depth < 3) {
                loop(b, depth);
            } else if (kind == 2 && !callable_.empty()) {
                call(b);
            } else if (kind == 6 && !callable_.empty()) {
                work_for_keywords(b);
            } else if (kind == 4 || kind == 5) {
                visible_.push_back(chosen_by_keyword(b));
            } else if (kind == 3) {
                static constexpr double kNumbers[] = {0, 1, -1, 0.5, 2, 3};
                visible_.push_back(b.constant(kFloat, {kNumbers[pick(6)]}));
            } else {
                arithmetic(b);
            }
        }
    }

    Value keyword(Builder& b) {
        const Value k = b.emit(Op::Global, kBool, {}, pick(kKeywords));
        return pick(3) == 0 ? b.emit(Op::Not, {k}) : k;
    }
    Value chosen_by_keyword(Builder& b) {
        Value condition = keyword(b);
        if (pick(4) == 0) condition = b.emit(pick(2) == 0 ? Op::And : Op::Or, {condition, keyword(b)});
        const Value x = any(), y = any();
        return b.emit(Op::Select, kFloat, {condition, x, y});
    }

    // Work that sides of several choices need, and nothing else.
    void work_for_keywords(Builder& b) {
        call(b);
        const Value work = visible_.back();
        visible_.pop_back();
        for (int k = 0; k < 2; k++) {
            const Value other = any();
            const Value condition = keyword(b);
            visible_.push_back(pick(2) == 0 ? b.emit(Op::Select, kFloat, {condition, work, other})
                                            : b.emit(Op::Select, kFloat, {condition, other, work}));
        }
        visible_.push_back(b.emit(Op::Add, {visible_[visible_.size() - 2], visible_.back()}));
    }

    void arithmetic(Builder& b) {
        static constexpr Op kBinary[] = {Op::Add, Op::Sub, Op::Mul, Op::Min, Op::Max};
        static constexpr Op kUnary[] = {Op::Neg, Op::Abs, Op::Floor, Op::Saturate};
        const Value x = any(), y = any();
        if (pick(3) == 0) {
            visible_.push_back(b.emit(kUnary[pick(4)], {x}));
        } else if (pick(4) == 0) {
            visible_.push_back(b.emit(Op::Select, kFloat, {b.emit(Op::Less, {x, y}), x, y}));
        } else if (pick(4) == 0) {
            const std::vector<Value> parts = {x, y, any()};
            const Value v = b.construct(kFloat3, parts);
            const std::vector<unsigned> components = {pick(3), pick(3)};
            visible_.push_back(b.extract(b.swizzle(v, components), pick(2)));
        } else {
            visible_.push_back(b.emit(kBinary[pick(5)], {x, y}));
        }
    }

    Value condition(Builder& b) {
        if (pick(4) == 0) return b.constant(kBool, {static_cast<double>(pick(2))});
        const Value x = any(), y = any();
        return b.emit(Op::Less, {x, y});
    }

    void branch(Builder& b, int depth) {
        const Value structure = b.begin_if(condition(b));
        const std::size_t before = visible_.size();
        std::vector<Value> values[2];
        for (int side = 0; side < 2; side++) {
            if (side == 1) b.begin_else();
            statements(b, static_cast<int>(pick(4)), depth + 1);
            values[side] = {any(), any()};
            visible_.resize(before);
        }
        b.end_if(values[0], values[1]);
        for (std::uint32_t i = 0; i < 2; i++) visible_.push_back(b.result(structure, i));
    }

    void loop(Builder& b, int depth) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {static_cast<double>(pick(4))});
        const std::vector<Value> initial = {any(), any()};
        const Value structure = b.begin_for(begin, end, initial, pick(2) == 0);
        const std::size_t before = visible_.size();
        visible_.push_back(b.loop_carried(0));
        visible_.push_back(b.loop_carried(1));
        visible_.push_back(b.convert(b.loop_index(), Scalar::Float));
        statements(b, 1 + static_cast<int>(pick(5)), depth + 1);
        // Saturated, so that sums do not run away to infinity, where min and max of NaN begin to differ.
        const Value next = b.emit(Op::Saturate, {any()});
        const Value other = pick(2) == 0 ? b.loop_carried(1) : any();
        b.end_for(std::vector{next, other});
        visible_.resize(before);
        for (std::uint32_t i = 0; i < 2; i++) visible_.push_back(b.result(structure, i));
    }

    void call(Builder& b) {
        const FunctionId callee = callable_[pick(static_cast<std::uint32_t>(callable_.size()))];
        std::vector<Value> args;
        for (const Param& param : module[callee].params) {
            const std::vector<Value> parts = {any(), any(), any()};
            args.push_back(param.type == kFloat ? parts[0] : b.construct(param.type, parts));
        }
        Value made = b.call(callee, args);
        if (b.type(made) == kFloat) return visible_.push_back(made);
        if (pick(2) == 0) made = b.emit(Op::Insert, b.type(made), {made, any()}, pick(3));
        visible_.push_back(b.extract(made, pick(3)));
    }

    static constexpr std::uint32_t kKeywords = 3;
    std::mt19937 random_;
    std::vector<FunctionId> callable_;
    std::vector<Value> visible_;
};

// `used`: which of the inputs the stage still has.
interpret::QuadResult run(const Module& module, const std::vector<std::array<double, 4>>& inputs,
                          const std::vector<std::uint32_t>& used) {
    std::array<std::vector<interpret::Flat>, 4> arguments;
    for (std::size_t lane = 0; lane < 4; lane++) {
        for (const std::uint32_t input : used) arguments[lane].push_back({inputs[input][lane]});
    }
    return interpret::run(module, module.stage.entry, arguments, {}, Precision::Float);
}

// Each input's location is its first place among the params, whatever pruning leaves.
std::vector<std::uint32_t> inputs_of(const Module& module) {
    std::vector<std::uint32_t> used;
    for (const StageVariable& variable : module.stage.inputs) used.push_back(variable.location);
    return used;
}

Module drop_members_of_entry(Module module) {
    const FunctionId entry = module.stage.entry;
    return drop_members(std::move(module), std::span(&entry, 1), {});
}

struct NamedPass {
    const char* name;
    Module (*run)(Module);
};
constexpr NamedPass kPasses[] = {{"prune", prune},
                                 {"specialise", specialise},
                                 {"inline_calls", inline_calls},
                                 {"schedule", schedule},
                                 {"drop_members", drop_members_of_entry},
                                 {"branch_on_keywords", branch_on_keywords},
                                 {"settle_params", settle_params},
                                 {"drop_needless", drop_needless},
                                 {"reuse_values", reuse_values},
                                 {"tidy", tidy}};

TEST(Passes, KeepTheMeaningOfRandomModules) {
    for (unsigned seed = 0; seed < 400; seed++) {
        RandomModule source(seed);
        for (std::uint32_t i = 0; i < source.module.stage.inputs.size(); i++)
            source.module.stage.inputs[i].location = i;
        ASSERT_EQ(verify(source.module), "");
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> real(-2, 2);
        std::vector<std::array<double, 4>> inputs(3);
        for (auto& input : inputs) {
            for (double& lane : input) lane = static_cast<double>(static_cast<float>(real(random)));
        }
        const interpret::QuadResult expected = run(source.module, inputs, inputs_of(source.module));
        for (const NamedPass& pass : kPasses) {
            const Module made = pass.run(source.module);
            ASSERT_EQ(verify(made), "") << pass.name << " of seed " << seed;
            const interpret::QuadResult result = run(made, inputs, inputs_of(made));
            for (std::size_t lane = 0; lane < 4; lane++) {
                const double a = expected.lanes[lane][0], b = result.lanes[lane][0];
                ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
                    << a << " became " << b << " by " << pass.name << " of seed " << seed << "\n"
                    << dump(source.module) << "\n"
                    << dump(made);
            }
        }
    }
}

// --- size; tests/bench shows that the time grows with it

TEST(Passes, KeepLongChainsAndLadders) {
    for (const bool is_ladder : {false, true}) {
        Module module;
        const FunctionId main = add(
            module, "main", {kX}, kFloat,
            [&](Builder& b) {
                Value value = b.param(0);
                for (int i = 0; i < 10000; i++) {
                    value = is_ladder ? b.emit(Op::Mul, {value, value})
                                      : b.emit(Op::Add, {value, b.constant(kFloat, {i + 1.0})});
                }
                return value;
            },
            false);
        set_entry(module, main);
        module = tidy(std::move(module));
        EXPECT_EQ(count(module.functions[0], is_ladder ? Op::Mul : Op::Add), 10000u);
    }
}

// Each function calls the one before twice: spelled out, or specialised, they would be 2^60 instructions.
TEST(Passes, DoNotExplode) {
    Module module;
    FunctionId last = add_switch(module);
    for (int k = 0; k < 60; k++) {
        last = add(module, "g" + std::to_string(k), {kX, {"mode", kInt, Rate::Uniform}}, kFloat, [&](Builder& b) {
            // No two of the calls have the same mode.
            const Value one = b.constant(kInt, {1}), two = b.constant(kInt, {2});
            const Value same = b.emit(Op::Mul, {b.param(1), two}), next = b.emit(Op::Add, {same, one});
            const Value a = b.call(last, std::vector{b.param(0), next}),
                        c = b.call(last, std::vector{b.param(0), same});
            const Value is_one = b.emit(Op::Equal, {same, one});
            return b.emit(Op::Select, kFloat, {is_one, a, b.emit(Op::Mul, {a, c})});
        });
        module[last].always_inline = k > 20;
    }
    const FunctionId main = add(module, "main", {kX}, kFloat, [&](Builder& b) {
        return b.call(last, std::vector{b.param(0), b.constant(kInt, {0})});
    });
    set_entry(module, main);
    const Module tidied = checked(tidy(std::move(module)));
    std::size_t size = 0;
    for (const Function& function : tidied.functions) size += function.insts.size();
    EXPECT_LT(size, 1u << 20);
}

// Each function calls the one before inside of a branch: spelled out, branches would stand as deep as there are
// functions.
Module nested_calls(int depth) {
    Module module;
    FunctionId last = add(module, "f", {kX}, kFloat, [](Builder& b) { return long_chain(b, b.param(0)); });
    for (int k = 0; k < depth; k++) {
        last = add(module, "g" + std::to_string(k), {kX}, kFloat, [&](Builder& b) {
            const Value x = b.param(0), limit = b.constant(kFloat, {k + 1.0});
            const Value branch = b.begin_if(b.emit(Op::Less, {x, limit}));
            const Value called = b.call(last, std::vector{x});
            b.begin_else();
            b.end_if(std::vector{called}, std::vector{limit});
            return b.result(branch, 0);
        });
        module[last].always_inline = true;
    }
    set_entry(module, last);
    return module;
}

TEST(Passes, DoNotNestWithoutEnd) {
    const Module module = checked(tidy(nested_calls(250)));
    std::size_t deepest = 0;
    for (const Function& function : module.functions) deepest = std::max(deepest, function.blocks.size() / 2);
    EXPECT_GT(deepest, 100u);
    EXPECT_LE(deepest, 200u);
    checked(tidy(nested_calls(5000)));
}

}  // namespace
}  // namespace patina::ir

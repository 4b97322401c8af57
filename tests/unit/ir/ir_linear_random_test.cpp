// Linear parts of random functions: f(x) - f(0) says what they must be.
#include <cmath>
#include <random>

#include "tests/unit/ir/ir_linear_testing.h"

namespace patina::ir {
namespace {

// Functions of a struct { float3 x, float k } and a float3, of ops that are mostly linear. They call one another.
class RandomFunctions {
public:
    explicit RandomFunctions(unsigned seed, bool fold) : random_(seed) {
        module.structs.push_back({"Pair", {{"x", kFloat3}, {"k", kFloat3}}});
        for (int n = 0; n < 3; n++) {
            visible_.clear();
            const std::vector<Param> params = {{"pair", Type::structure(0), Rate::Pixel}, kK};
            last = add(
                module, "f" + std::to_string(n), params, kFloat3,
                [&](Builder& b) {
                    visible_ = {b.extract(b.param(0), 0), b.extract(b.param(0), 1), b.param(1)};
                    statements(b, 7, 0);
                    return b.emit(Op::Add, {any(), any()});
                },
                fold);
            callable_.push_back(last);
        }
    }
    Module module;
    FunctionId last;

private:
    std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
    // Half of all values are late ones, which depend on more.
    Value any() {
        const auto n = static_cast<std::uint32_t>(visible_.size());
        return visible_[pick(2) == 0 ? pick(n) : n - 1 - pick(std::min(n, 3u))];
    }
    // One of the first values or of their kind: more likely to be independent of x.
    Value factor(Builder& b) { return pick(3) == 0 ? any() : b.emit(Op::Sin, {visible_[1 + pick(2)]}); }

    void statements(Builder& b, int n, int depth) {
        for (int i = 0; i < n; i++) {
            const std::uint32_t kind = pick(12);
            if (kind == 0 && depth < 2) {
                branch(b, depth);
            } else if (kind == 1 && depth < 2) {
                loop(b, depth);
            } else if (kind == 2 && !callable_.empty()) {
                const Value pair = b.construct(Type::structure(0), std::vector{any(), factor(b)});
                visible_.push_back(b.call(callable_[pick(static_cast<std::uint32_t>(callable_.size()))],
                                          std::vector{pair, factor(b)}));
            } else {
                visible_.push_back(arithmetic(b));
            }
        }
    }

    Value arithmetic(Builder& b) {
        const Value x = any();
        switch (pick(12)) {
            case 0: return b.emit(Op::Neg, {x});
            case 1: return b.emit(Op::Sub, {x, any()});
            case 2: return b.emit(Op::Mul, {factor(b), x});
            case 3: return b.emit(Op::Div, {x, b.emit(Op::Exp, {factor(b)})});
            case 4: return b.swizzle(x, std::vector{pick(3), pick(3), pick(3)});
            case 5: return b.splat(b.emit(Op::Dot, {x, factor(b)}), 3);
            case 6: return b.emit(Op::Cross, {factor(b), x});
            case 7: return b.emit(Op::Lerp, {x, any(), factor(b)});
            case 8: return b.emit(Op::Select, {b.emit(Op::Less, {factor(b), factor(b)}), x, any()});
            case 9: return b.emit(Op::Insert, kFloat3, {x, b.extract(any(), pick(3))}, pick(3));
            case 10: return pick(4) == 0 ? b.emit(Op::Max, {x, any()}) : b.emit(Op::Add, {x, any()});
            default:
                return b.construct(
                    kFloat3, std::vector{b.extract(any(), pick(3)), b.swizzle(any(), std::vector{pick(3), pick(3)})});
        }
    }

    void branch(Builder& b, int depth) {
        const Value at = b.extract(factor(b), pick(3));
        const Value structure = b.begin_if(b.emit(Op::Less, {at, numbers(b, {0.3})}));
        const std::size_t before = visible_.size();
        std::vector<Value> values[2];
        for (int side = 0; side < 2; side++) {
            if (side == 1) b.begin_else();
            statements(b, static_cast<int>(pick(3)), depth + 1);
            values[side] = {any(), any(), factor(b)};
            visible_.resize(before);
        }
        b.end_if(values[0], values[1]);
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.result(structure, i));
    }

    void loop(Builder& b, int depth) {
        const Value begin = b.constant(kInt, {0}), end = b.constant(kInt, {static_cast<double>(pick(4))});
        const std::vector<Value> initial = {any(), factor(b), any()};
        const Value structure = b.begin_for(begin, end, initial, pick(2) == 0);
        const std::size_t before = visible_.size();
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.loop_carried(i));
        statements(b, 1 + static_cast<int>(pick(3)), depth + 1);
        const std::vector<Value> next = {any(), factor(b), pick(2) == 0 ? b.loop_carried(2) : any()};
        b.end_for(next);
        visible_.resize(before);
        for (std::uint32_t i = 0; i < 3; i++) visible_.push_back(b.result(structure, i));
    }

    std::mt19937 random_;
    std::vector<Value> visible_;
    std::vector<FunctionId> callable_;
};

Numbers combined(const Numbers& a, const Numbers& b, double factor) {
    Numbers made;
    for (std::size_t i = 0; i < a.size(); i++) made.push_back(a[i] + factor * b[i]);
    return made;
}

TEST(LinearPart, OfRandomFunctionsIsWhatTheyAddToTheirValueAtZero) {
    int affine = 0, diagonal = 0, refused = 0;
    for (unsigned seed = 0; seed < 1500; seed++) {
        const bool fold = seed % 2 == 0;
        RandomFunctions random(seed, fold);
        Module& module = random.module;
        ASSERT_EQ(verify(module), "");
        const LinearOptions options{.componentwise = false, .build = {.fold = fold}};
        const LinearPart made = linear_part(module, random.last, Seed::of_member(0, 0), options);
        const FunctionId rest = push(module, without(module, random.last, Seed::of_member(0, 0), options.build));
        const auto f = [&](FunctionId id, double scale) {
            return evaluate(module, id, {{0.7 * scale, -0.4 * scale, 1.3 * scale, 0.6, -0.2, 0.9}, {0.3, 1.1, -0.8}});
        };
        const Numbers at_zero = f(random.last, 0);
        const std::string text = "seed " + std::to_string(seed) + "\n" + dump(module);
        expect_near(f(rest, 1), at_zero, text);
        if (!made.function) {
            refused++;
            EXPECT_FALSE(made.reason.empty());
            continue;
        }
        affine++;
        const FunctionId linear = push(module, *made.function);
        const double size = std::abs(at_zero[0]) + std::abs(at_zero[1]) + std::abs(at_zero[2]);
        if (!(size < 1e3)) continue;  // differences of large numbers show nothing
        for (const double scale : {1.0, 2.0}) {
            expect_near(f(linear, scale), combined(f(random.last, scale), at_zero, -1), text);
        }
        if (!linear_part(module, random.last, Seed::of_member(0, 0), {.componentwise = true, .build = {}}).function)
            continue;
        diagonal++;
        // The second component of x alone moves the second of the result alone.
        const Numbers one = evaluate(module, linear, {{0, 1, 0, 0.6, -0.2, 0.9}, {0.3, 1.1, -0.8}});
        EXPECT_EQ(one[0], 0) << text;
        EXPECT_EQ(one[2], 0) << text;
        if (HasFailure()) return;
    }
    EXPECT_GT(affine, 300);
    EXPECT_GT(diagonal, 50);
    EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace patina::ir

// Random expressions of the node language over a list of values, and the dice that everything random here is thrown
// with. A part of random_graph.cpp.
//
//   Expressions in(dice, false);
//   in.values = {{"t0", 4, 2}};
//   Value value = in.expression(3, 2);   // a float3, up to two operations deep
#pragma once

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "witness/bench.h"

namespace patina::witness {

inline constexpr double kLargest = 64;  // nothing is allowed to grow beyond

// Marks in generated text: what stands between kBegin, with a class, and kEnd is a value that a GPU computes with an
// error of that class. A rendering of the text either drops the marks or puts noise in their place.
inline constexpr char kBegin = '\1', kEnd = '\2';
// A sum of products may come out as next to zero where it is zero. So may the result of a node, which can be such a
// sum: the Lab colour of a grey is 0 to the CPU and 1.5e-7 to lavapipe, and floor() makes a difference of 1 of that.
// Some nodes are coarse on GPUs.
enum Error : char {
    kArithmetic = 'a',
    kSum = 's',
    kTranscendental = 't',
    kNode = 'n',
    kCoarse = 'c',
    kHalf = 'h',
    kHalfNode = 'm'
};

// A generator of its own: the distributions of the standard library differ between machines.
class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    bool chance(int percent) { return below(100) < percent; }
    // A multiple of 1 / 16.
    double sixteenths(int from, int to) { return (from * 16 + below((to - from) * 16 + 1)) / 16.0; }
    template <class Container>
    auto& pick(Container& from) {
        return from[static_cast<std::size_t>(below(static_cast<int>(std::size(from))))];
    }

private:
    std::mt19937 engine_;
};

// A value that can be read, with how large it may be.
struct Value {
    std::string text{};
    int width = 1;  // of floats; 0: a bool
    double largest = 1;
    std::string node{};  // whose output it is
};

inline std::string type_name(int width) {
    return width == 0 ? "bool" : width == 1 ? "float" : "float" + std::to_string(width);
}

inline constexpr std::string_view kComponents = "xyzw";

// Writes expressions over a list of values.
class Expressions {
public:
    Expressions(Dice& dice, bool half) : dice_(dice), half_(half) {}

    std::vector<Value> values;
    std::vector<std::string> ints;  // int variables and constants that may be read
    // A condition that never holds and reads a texel: a choice asks it, too. Mesa walks a condition of uniforms alone
    // along every way through what it shares, which may take it hours (seed 837). The texel ends the walk at once.
    std::string never{};

    Value expression(int width, int depth) {
        if (width == 0) return {.text = condition(depth), .width = 0};
        if (depth <= 0) return leaf(width);
        Value made = dice_.chance(45) ? operation(width, depth) : function(width, depth);
        if (made.largest > kLargest) made = limited(made);
        return made;
    }

    // A bounded one of the same width; NaN stays NaN.
    Value limited(const Value& value) {
        return {.text = mark(kArithmetic, value.text + " / (1 + abs(" + value.text + ") * 0.25)"),
                .width = value.width,
                .largest = 4};
    }

    std::string mark(Error error, const std::string& text) const {
        const Error of_halves = error == kNode || error == kCoarse ? kHalfNode : kHalf;
        return std::string{kBegin, half_ ? of_halves : error} + text + kEnd;
    }

    Value leaf(int width) {
        if (dice_.chance(12)) return constant(width);
        // What came last is read most: graphs become deep.
        const int count = static_cast<int>(values.size());
        Value value;
        do {
            const int back = std::min(dice_.below(count), dice_.below(count));
            value = values[static_cast<std::size_t>(count - 1 - back)];
        } while (value.width == 0);
        return {.text = swizzled(value, width), .width = width, .largest = value.largest};
    }

private:
    Value constant(int width) {
        if (width == 1) return {.text = "(" + literal(dice_.sixteenths(-2, 2)) + ")", .largest = 2};
        std::string text = type_name(width) + "(";
        for (int i = 0; i < width; ++i) text += (i ? ", " : "") + literal(dice_.sixteenths(-2, 2));
        return {.text = text + ")", .width = width, .largest = 2};
    }

    std::string swizzled(const Value& value, int width) {
        if (value.width == width && (width == 1 || dice_.chance(60))) return value.text;
        if (value.width == 1) return type_name(width) + "(" + value.text + ")";
        std::string text = value.text + ".";
        for (int i = 0; i < width; ++i) text += kComponents[static_cast<std::size_t>(dice_.below(value.width))];
        return text;
    }

    std::string condition(int depth) {
        if (depth > 0 && dice_.chance(25)) {
            const std::string left = condition(depth - 1);
            if (dice_.chance(25)) return "(!" + left + ")";
            return "(" + left + (dice_.chance(50) ? " && " : " || ") + condition(depth - 1) + ")";
        }
        std::vector<Value> bools;
        std::copy_if(values.begin(), values.end(), std::back_inserter(bools),
                     [](const Value& v) { return v.width == 0; });
        if (!bools.empty() && dice_.chance(25)) return dice_.pick(bools).text;
        if (dice_.chance(20)) {
            const int width = 2 + dice_.below(3);
            return std::string(dice_.chance(50) ? "any(" : "all(") + comparison(width, depth) + ")";
        }
        return comparison(1, depth);
    }

    std::string comparison(int width, int depth) {
        static constexpr const char* kSigns[] = {" < ", " <= ", " > ", " >= ", " == ", " != "};
        // Equality of what was computed is luck: rarely.
        const char* sign = kSigns[dice_.below(dice_.chance(90) ? 4 : 6)];
        return "(" + expression(width, depth - 1).text + sign + leaf(width).text + ")";
    }

    Value operation(int width, int depth) {
        const Value left = expression(width, depth - 1);
        if (width > 1 && dice_.chance(10)) return constructed(width, depth);
        const bool scalar_right = width > 1 && dice_.chance(25);
        const Value right = expression(scalar_right ? 1 : width, depth - 1);
        const auto both = [&](const char* sign) { return left.text + sign + right.text; };
        switch (dice_.below(8)) {
            case 0:
            case 1: return {mark(kArithmetic, both(" + ")), width, left.largest + right.largest};
            case 2: return {mark(kArithmetic, both(" - ")), width, left.largest + right.largest};
            case 3:
            case 4: return {mark(kArithmetic, both(" * ")), width, left.largest * right.largest};
            case 5:
                return {mark(kArithmetic, left.text + " / (abs(" + right.text + ") + 0.5)"), width, left.largest * 2};
            case 6: return {"(-" + left.text + ")", width, left.largest};
            default: {
                const bool is_single = width == 1 || !dice_.chance(30);
                std::string test = is_single ? condition(depth - 1) : comparison(width, depth - 1);
                if (is_single && !never.empty()) test = "(" + never + " || " + test + ")";
                const Value other = expression(width, depth - 1);
                return {"(" + test + " ? " + left.text + " : " + other.text + ")", width,
                        std::max(left.largest, other.largest)};
            }
        }
    }

    Value constructed(int width, int depth) {
        const int first = 1 + dice_.below(width - 1);
        const Value a = expression(first, depth - 1), b = expression(width - first, depth - 1);
        return {type_name(width) + "(" + a.text + ", " + b.text + ")", width, std::max(a.largest, b.largest)};
    }

    Value integer(int width, int depth) {
        static constexpr const char* kSigns[] = {" + ", " - ", " * ", " & ", " | ", " ^ "};
        std::string whole = "int(floor(" + expression(1, depth - 1).text + "))";
        if (!ints.empty() && dice_.chance(60)) whole = dice_.pick(ints);
        const std::string text = "float(((" + whole + kSigns[dice_.below(6)] + std::to_string(1 + dice_.below(7)) +
                                 ") & 15) << " + std::to_string(dice_.below(2)) + ")";
        return {width == 1 ? text : type_name(width) + "(" + text + ")", width, 30};
    }

    Value matrix(int width, int depth) {
        std::string rows;
        double largest = 0;
        for (int i = 0; i < width; ++i) {
            const Value row = leaf(width);
            rows += (i ? ", " : "") + row.text;
            largest = std::max(largest, row.largest);
        }
        const std::string size = std::to_string(width);
        std::string m = "float" + size + "x" + size + "(" + rows + ")";
        if (dice_.chance(30)) m = "transpose(" + m + ")";
        const Value v = expression(width, depth - 1);
        const std::string product = dice_.chance(50) ? m + ", " + v.text : v.text + ", " + m;
        return {mark(kSum, "mul(" + product + ")"), width, largest * v.largest * width};
    }

    Value function(int width, int depth) {
        const Value x = expression(width, depth - 1);
        const auto of = [&](const char* name) { return std::string(name) + "(" + x.text + ")"; };
        const auto other = [&] { return expression(width, depth - 1); };
        switch (dice_.below(30)) {
            case 0: return {of("abs"), width, x.largest};
            case 1: return {of("floor"), width, x.largest + 1};
            case 2: return {of("ceil"), width, x.largest + 1};
            case 3: return {of("round"), width, x.largest + 1};
            case 4: return {of("frac"), width, 1};
            case 5: return {of("saturate"), width, 1};
            // Not of zero: frac(tanh(8)) is 0 or 0.9999999, and to both copies with noise a number above zero (seed
            // 327).
            case 6: return {"sign(" + x.text + " + 0.0625)", width, 1};
            case 7: return {mark(kTranscendental, of("sin")), width, 1};
            case 8: return {mark(kTranscendental, of("cos")), width, 1};
            case 9: return {mark(kTranscendental, of("atan")), width, 1.6};
            case 10: return {mark(kTranscendental, of("tanh")), width, 1};
            case 11: return {mark(kArithmetic, "sqrt(abs(" + x.text + "))"), width, std::max(1.0, x.largest)};
            case 12: return {mark(kArithmetic, "rsqrt(abs(" + x.text + ") + 0.25)"), width, 2};
            case 13: return {mark(kTranscendental, "exp2(clamp(" + x.text + ", -4, 4))"), width, 16};
            case 14: return {mark(kTranscendental, "log2(abs(" + x.text + ") + 0.5)"), width, 7};
            case 15: return {mark(kTranscendental, "pow(abs(" + x.text + ") + 0.25, 1.5)"), width, x.largest * 9 + 1};
            case 16: {
                const Value y = other();
                return {"min(" + x.text + ", " + y.text + ")", width, std::max(x.largest, y.largest)};
            }
            case 17: {
                const Value y = other();
                return {"max(" + x.text + ", " + y.text + ")", width, std::max(x.largest, y.largest)};
            }
            case 18: {
                const Value y = other();
                const std::string t = dice_.chance(50) ? "saturate(" + leaf(1).text + ")" : "0.25";
                return {mark(kArithmetic, "lerp(" + x.text + ", " + y.text + ", " + t + ")"), width,
                        std::max(x.largest, y.largest)};
            }
            case 19: return {"clamp(" + x.text + ", -1, 2)", width, 2};
            case 20: return {mark(kArithmetic, "smoothstep(-0.5, 1.5, " + x.text + ")"), width, 1};
            case 21: return {"step(" + leaf(width).text + ", " + x.text + ")", width, 1};
            case 22: {
                const int inner = 2 + dice_.below(3);
                const Value a = expression(inner, depth - 1), b = expression(inner, depth - 1);
                return splat(mark(kSum, "dot(" + a.text + ", " + b.text + ")"), width, a.largest * b.largest * inner);
            }
            case 23: {
                const Value a = expression(2 + dice_.below(3), depth - 1);
                return splat(mark(kArithmetic, "length(" + a.text + ")"), width, a.largest * 2);
            }
            case 24:
                if (width == 1) return {mark(kTranscendental, "atan2(" + x.text + ", 1.5)"), 1, 1.6};
                return {mark(kArithmetic, "normalize(abs(" + x.text + ") + 0.125)"), width, 1};
            case 25:
                if (width != 3) return integer(width, depth);
                return {mark(kSum, "cross(" + x.text + ", " + leaf(3).text + ")"), 3, x.largest * kLargest};
            case 26:
                if (width != 3) return {"trunc(" + x.text + ")", width, x.largest};
                return {mark(kSum, "reflect(" + x.text + ", normalize(abs(" + leaf(3).text + ") + 0.125))"), 3,
                        x.largest * 2};
            case 27: return integer(width, depth);
            case 28:
                if (width == 1) return {mark(kArithmetic, "fmod(" + x.text + ", 1.75)"), 1, 1.75};
                return matrix(width, depth);
            default: return {mark(kArithmetic, x.text + " % 2.5"), width, 2.5};
        }
    }

    static Value splat(const std::string& scalar, int width, double largest) {
        return {width == 1 ? scalar : type_name(width) + "(" + scalar + ")", width, largest};
    }

    Dice& dice_;
    bool half_;
};

}  // namespace patina::witness

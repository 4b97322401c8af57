#include "compiler/ir/fold/fold.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/base/bits.h"
#include "compiler/base/text.h"
#include "compiler/ir/builder.h"

namespace patina::ir {
namespace {

using Numbers = std::span<const double>;

// --- what component-wise ops mean, in double. The result is rounded to its type afterwards. Integers are exact in a
// double, and so are their sums, quotients and comparisons. Other operations on integers are in the table of whole
// numbers.

struct Unary {
    Op op;
    double (*of)(double);
};
constexpr Unary kUnary[] = {
    {Op::Neg, [](double x) { return -x; }},
    {Op::Not, [](double x) { return x == 0 ? 1.0 : 0.0; }},
    {Op::BitNot, [](double x) { return -1 - x; }},
    {Op::Abs, [](double x) { return std::fabs(x); }},
    {Op::Sign, [](double x) { return x > 0   ? 1.0
                                     : x < 0 ? -1.0
                                             : x; }},
    {Op::Floor, [](double x) { return std::floor(x); }},
    {Op::Ceil, [](double x) { return std::ceil(x); }},
    {Op::Round, [](double x) { return std::nearbyint(x); }},  // in the default mode: halves to even
    {Op::Trunc, [](double x) { return std::trunc(x); }},
    {Op::Frac, [](double x) { return x - std::floor(x); }},
    {Op::Saturate, [](double x) { return std::fmin(std::fmax(x, 0.0), 1.0); }},
    {Op::Sqrt, [](double x) { return std::sqrt(x); }},
    {Op::Rsqrt, [](double x) { return 1 / std::sqrt(x); }},
    {Op::Exp, [](double x) { return std::exp(x); }},
    {Op::Exp2, [](double x) { return std::exp2(x); }},
    {Op::Log, [](double x) { return std::log(x); }},
    {Op::Log2, [](double x) { return std::log2(x); }},
    {Op::Sin, [](double x) { return std::sin(x); }},
    {Op::Cos, [](double x) { return std::cos(x); }},
    {Op::Tan, [](double x) { return std::tan(x); }},
    {Op::Asin, [](double x) { return std::asin(x); }},
    {Op::Acos, [](double x) { return std::acos(x); }},
    {Op::Atan, [](double x) { return std::atan(x); }},
    {Op::Sinh, [](double x) { return std::sinh(x); }},
    {Op::Cosh, [](double x) { return std::cosh(x); }},
    {Op::Tanh, [](double x) { return std::tanh(x); }},
    {Op::Radians, [](double x) { return x * (std::numbers::pi / 180); }},
    {Op::Degrees, [](double x) { return x * (180 / std::numbers::pi); }},
    {Op::IsNan, [](double x) { return std::isnan(x) ? 1.0 : 0.0; }},
    {Op::IsInf, [](double x) { return std::isinf(x) ? 1.0 : 0.0; }},
    // A constant does not change from pixel to pixel.
    {Op::Ddx, [](double) { return 0.0; }},
    {Op::Ddy, [](double) { return 0.0; }},
    {Op::Fwidth, [](double) { return 0.0; }},
};

struct Binary {
    Op op;
    double (*of)(double, double);
};
constexpr Binary kBinary[] = {
    {Op::Add, [](double x, double y) { return x + y; }},
    {Op::Sub, [](double x, double y) { return x - y; }},
    {Op::Mul, [](double x, double y) { return x * y; }},
    {Op::Div, [](double x, double y) { return x / y; }},
    {Op::Mod, [](double x, double y) { return std::fmod(x, y); }},
    {Op::Less, [](double x, double y) { return x < y ? 1.0 : 0.0; }},
    {Op::LessEqual, [](double x, double y) { return x <= y ? 1.0 : 0.0; }},
    {Op::Greater, [](double x, double y) { return x > y ? 1.0 : 0.0; }},
    {Op::GreaterEqual, [](double x, double y) { return x >= y ? 1.0 : 0.0; }},
    {Op::Equal, [](double x, double y) { return x == y ? 1.0 : 0.0; }},
    {Op::NotEqual, [](double x, double y) { return x != y ? 1.0 : 0.0; }},
    {Op::And, [](double x, double y) { return x != 0 && y != 0 ? 1.0 : 0.0; }},
    {Op::Or, [](double x, double y) { return x != 0 || y != 0 ? 1.0 : 0.0; }},
    {Op::Min, [](double x, double y) { return std::fmin(x, y); }},
    {Op::Max, [](double x, double y) { return std::fmax(x, y); }},
    {Op::Pow, [](double x, double y) { return std::pow(x, y); }},
    {Op::Atan2, [](double y, double x) { return std::atan2(y, x); }},
    {Op::Step, [](double edge, double x) { return x >= edge ? 1.0 : 0.0; }},
};

double smoothstep(double edge0, double edge1, double x) {
    const double t = std::fmin(std::fmax((x - edge0) / (edge1 - edge0), 0.0), 1.0);
    return t * t * (3 - 2 * t);
}

struct Ternary {
    Op op;
    double (*of)(double, double, double);
};
constexpr Ternary kTernary[] = {
    {Op::Clamp, [](double x, double low, double high) { return std::fmin(std::fmax(x, low), high); }},
    {Op::Lerp, [](double a, double b, double t) { return a + (b - a) * t; }},
    {Op::Smoothstep, smoothstep},
    {Op::Select, [](double c, double x, double y) { return c != 0 ? x : y; }},
};

// Products and bits of whole numbers, of which only the low 32 bits count. Languages do not agree about a shift by 32
// or more, or by a negative number, so these are not folded.
struct Whole {
    Op op;
    std::uint64_t (*of)(std::int64_t, std::int64_t);
    bool is_shift = false;
};
constexpr Whole kWhole[] = {
    {Op::Mul,
     [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y); }},
    {Op::BitAnd, [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x & y); }},
    {Op::BitOr, [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x | y); }},
    {Op::BitXor, [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x ^ y); }},
    {Op::ShiftLeft, [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x) << y; }, true},
    {Op::ShiftRight, [](std::int64_t x, std::int64_t y) { return static_cast<std::uint64_t>(x >> y); }, true},
};

// The rows by op, so that a row is found without a search.
template <class Row, std::size_t N>
constexpr std::array<const Row*, kOpCount> by_op(const Row (&rows)[N]) {
    std::array<const Row*, kOpCount> table{};
    for (const Row& row : rows) table[static_cast<std::size_t>(row.op)] = &row;
    return table;
}
constexpr auto kUnaryOf = by_op(kUnary);
constexpr auto kBinaryOf = by_op(kBinary);
constexpr auto kTernaryOf = by_op(kTernary);
constexpr auto kWholeOf = by_op(kWhole);

// --- rounding

double round_to_half(double value) {
    constexpr double kLargest = 65504, kSmallestNormal = 0x1p-14;
    if (!std::isfinite(value) || value == 0) return value;
    int exponent = 0;
    std::frexp(std::fmax(std::fabs(value), kSmallestNormal), &exponent);
    const double unit = std::ldexp(1.0, exponent - 11);  // 11 bits of significand
    const double rounded = std::nearbyint(value / unit) * unit;
    return std::fabs(rounded) > kLargest ? std::copysign(std::numeric_limits<double>::infinity(), value) : rounded;
}

double wrap(Scalar scalar, std::uint64_t bits) {
    const auto low = static_cast<std::uint32_t>(bits);
    return scalar == Scalar::Int ? static_cast<double>(static_cast<std::int32_t>(low)) : static_cast<double>(low);
}

// As round_to, but overflow becomes infinity; NaN stays.
double rounded(Scalar scalar, double value) {
    switch (scalar) {
        case Scalar::Bool: return value != 0 ? 1 : 0;
        case Scalar::Int:
        case Scalar::Uint:
            if (!(std::fabs(value) < 0x1p62)) return std::numeric_limits<double>::quiet_NaN();
            return wrap(scalar, static_cast<std::uint64_t>(static_cast<std::int64_t>(value)));
        case Scalar::Half: return round_to_half(value);
        case Scalar::Float:
            // To convert a double beyond the range of float is undefined in C++, so the range is checked first. From
            // half a unit above the largest float on, a number rounds up to infinity.
            if (std::fabs(value) >= 0x1.ffffffp127)
                return std::copysign(std::numeric_limits<double>::infinity(), value);
            return static_cast<double>(static_cast<float>(value));
    }
    return value;
}

// The number that the author of a float constant wrote: the decimal number of at most six digits whose nearest float it
// is, if there is one. 1 - 0.8 is 0.2, but 1 minus the float next to 0.8 rounds to 0.19999999.
double as_written(double number) {
    const bool is_exact = number == std::trunc(number) || std::fabs(number) >= 0x1p24;
    if (is_exact) return number;
    const double written = read_number(fmt::format("{:.6g}", number)).value_or(number);
    return static_cast<double>(static_cast<float>(written)) == number ? written : number;
}

// --- shapes: what is not component by component

double dot(Numbers a, Numbers b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); i++) sum += a[i] * b[i];
    return sum;
}

double determinant(Numbers m, unsigned size) {
    if (size == 1) return m[0];
    double sum = 0;
    std::array<double, 9> minor{};
    for (unsigned column = 0; column < size; column++) {
        std::size_t n = 0;
        for (unsigned i = size; i < size * size; i++) {
            if (i % size != column) minor[n++] = m[i];
        }
        const double cofactor = determinant({minor.data(), n}, size - 1);
        sum += (column % 2 == 0 ? 1 : -1) * m[column] * cofactor;
    }
    return sum;
}

void matrix_product(Type a_type, Numbers a, Type b_type, Numbers b, std::vector<double>& out) {
    // A vector on the left is a row, on the right a column.
    const unsigned inner = a_type.is_matrix() ? a_type.cols : a_type.rows;
    const unsigned rows = a_type.is_matrix() ? a_type.rows : 1;
    const unsigned columns = b_type.cols;
    for (unsigned row = 0; row < rows; row++) {
        for (unsigned column = 0; column < columns; column++) {
            double sum = 0;
            for (unsigned k = 0; k < inner; k++) sum += a[row * inner + k] * b[k * columns + column];
            out.push_back(sum);
        }
    }
}

void refract(Numbers incident, Numbers normal, double eta, std::vector<double>& out) {
    const double cosine = dot(normal, incident);
    const double k = 1 - eta * eta * (1 - cosine * cosine);
    for (std::size_t i = 0; i < incident.size(); i++) {
        out.push_back(k < 0 ? 0 : eta * incident[i] - (eta * cosine + std::sqrt(k)) * normal[i]);
    }
}

void construct(Type type, std::span<const Numbers> parts, std::vector<double>& out) {
    for (const Numbers part : parts) out.insert(out.end(), part.begin(), part.end());
    if (out.size() == 1) out.resize(type.components(), out[0]);
}

// Components of a part: one of a vector, a row of a matrix.
unsigned part_size(Type composite) {
    return composite.is_matrix() ? composite.cols : 1;
}

std::uint32_t clamped_index(double index, Type composite) {
    return static_cast<std::uint32_t>(std::clamp(index, 0.0, static_cast<double>(composite.rows - 1)));
}

double bitcast(Scalar from, Scalar to, double value) {
    const std::uint32_t bits = from == Scalar::Float ? bits_as<std::uint32_t>(static_cast<float>(value))
                                                     : static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    return to == Scalar::Float ? static_cast<double>(bits_as<float>(bits)) : wrap(to, bits);
}

// GPUs differ in how they convert a float that an int cannot hold: NaN says that the result is not known.
double convert(Scalar from, Scalar to, double value) {
    const bool is_real = from == Scalar::Float || from == Scalar::Half;
    if (is_real && to == Scalar::Int && !(value > -0x1p31 - 1 && value < 0x1p31)) return std::nan("");
    if (is_real && to == Scalar::Uint && !(value > -1 && value < 0x1p32)) return std::nan("");
    return value;
}

using Operands = std::span<const Numbers>;

bool shape(Op op, Type type, std::span<const Type> types, Operands in, std::uint32_t data, std::vector<double>& out) {
    if (op == Op::Construct) return construct(type, in, out), true;
    if (op == Op::MatMul) return matrix_product(types[0], in[0], types[1], in[1], out), true;
    if (op == Op::Refract) return refract(in[0], in[1], in[2][0], out), true;
    if (op == Op::Dot) return out.push_back(dot(in[0], in[1])), true;
    if (op == Op::Length) return out.push_back(std::sqrt(dot(in[0], in[0]))), true;
    if (op == Op::Determinant) return out.push_back(determinant(in[0], types[0].rows)), true;
    if (op == Op::Extract || op == Op::Index || op == Op::Insert) {
        const unsigned size = part_size(types[0]);
        const std::size_t first = std::size_t{op == Op::Index ? clamped_index(in[1][0], types[0]) : data} * size;
        if (op == Op::Insert) {
            out.assign(in[0].begin(), in[0].end());
            std::copy(in[1].begin(), in[1].end(), out.begin() + static_cast<std::ptrdiff_t>(first));
        } else {
            const Numbers part = in[0].subspan(first, size);
            out.assign(part.begin(), part.end());
        }
        return true;
    }
    for (unsigned i = 0; i < type.components(); i++) {
        const auto at = [&](std::size_t operand) { return in[operand][in[operand].size() == 1 ? 0 : i]; };
        if (op == Op::Swizzle) {
            out.push_back(in[0][data >> (2 * i) & 3u]);
        } else if (op == Op::Convert) {
            out.push_back(convert(types[0].scalar, type.scalar, at(0)));
        } else if (op == Op::Bitcast) {
            out.push_back(bitcast(types[0].scalar, type.scalar, at(0)));
        } else if (op == Op::Transpose) {
            out.push_back(in[0][(i % type.cols) * types[0].cols + i / type.cols]);
        } else if (op == Op::Normalize) {
            out.push_back(in[0][i] / std::sqrt(dot(in[0], in[0])));
        } else if (op == Op::Cross) {
            const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
            out.push_back(in[0][j] * in[1][k] - in[0][k] * in[1][j]);
        } else if (op == Op::Reflect) {
            out.push_back(in[0][i] - 2 * dot(in[0], in[1]) * in[1][i]);
        } else {
            return false;
        }
    }
    return true;
}

bool across(Op op, Operands in, std::vector<double>& out) {
    const auto is_true = [](double c) { return c != 0; };
    if (op == Op::Any) {
        out.push_back(std::any_of(in[0].begin(), in[0].end(), is_true) ? 1 : 0);
    } else if (op == Op::All) {
        out.push_back(std::all_of(in[0].begin(), in[0].end(), is_true) ? 1 : 0);
    } else if (op == Op::Distance) {
        double sum = 0;
        for (std::size_t i = 0; i < in[0].size(); i++) sum += (in[0][i] - in[1][i]) * (in[0][i] - in[1][i]);
        out.push_back(std::sqrt(sum));
    } else {
        return false;
    }
    return true;
}

bool whole_numbers(const Whole& row, Type type, Operands in, std::vector<double>& out) {
    for (unsigned i = 0; i < type.components(); i++) {
        if (row.is_shift && !(in[1][i] >= 0 && in[1][i] < 32)) return false;
        const auto bits = row.of(static_cast<std::int64_t>(in[0][i]), static_cast<std::int64_t>(in[1][i]));
        out.push_back(wrap(type.scalar, bits));
    }
    return true;
}

// False if the op does not work component by component.
bool components(Op op, Type type, Operands in, std::vector<double>& out) {
    const auto row = static_cast<std::size_t>(op);
    if (kWholeOf[row] && type.is_integer()) return whole_numbers(*kWholeOf[row], type, in, out);
    const unsigned count = type.components();
    // A select's condition may be a scalar before a vector.
    const auto at = [&](std::size_t operand, unsigned i) { return in[operand][in[operand].size() == 1 ? 0 : i]; };
    if (kUnaryOf[row]) {
        for (unsigned i = 0; i < count; i++) out.push_back(kUnaryOf[row]->of(at(0, i)));
    } else if (kBinaryOf[row]) {
        for (unsigned i = 0; i < count; i++) out.push_back(kBinaryOf[row]->of(at(0, i), at(1, i)));
    } else if (kTernaryOf[row]) {
        for (unsigned i = 0; i < count; i++) out.push_back(kTernaryOf[row]->of(at(0, i), at(1, i), at(2, i)));
    } else {
        return false;
    }
    return true;
}

}  // namespace

double round_to(Scalar scalar, double value) {
    const double result = rounded(scalar, value);
    return std::isfinite(result) ? result : value;
}

bool evaluate(Op op, Type type, std::span<const Type> types, Operands operands, std::uint32_t data,
              std::vector<double>& out) {
    out.clear();
    if (!type.is_numeric() || operands.empty()) return false;
    if (!components(op, type, operands, out) && !across(op, operands, out) &&
        !shape(op, type, types, operands, data, out)) {
        return false;
    }
    for (double& number : out) number = rounded(type.scalar, number);
    return out.size() == type.components();
}

// A result that would be NaN, infinite or undefined is not folded: the GPU computes it, perhaps differently.
bool fold_constant(Op op, Type type, std::span<const Type> operand_types, Operands operands, std::uint32_t data,
                   std::vector<double>& out) {
    std::vector<std::vector<double>> written(operands.size());
    std::vector<Numbers> in(operands.begin(), operands.end());
    for (std::size_t i = 0; i < in.size(); i++) {
        if (operand_types[i].scalar != Scalar::Float) continue;
        for (const double number : in[i]) written[i].push_back(as_written(number));
        in[i] = written[i];
    }
    return evaluate(op, type, operand_types, in, data, out) &&
           std::all_of(out.begin(), out.end(), [](double number) { return std::isfinite(number); });
}

}  // namespace patina::ir

// Ops over whole vectors and matrices, choices, and derivatives over the quad. Each computes one lane after the other,
// in the precision Real.
#include <algorithm>
#include <cmath>

#include "compiler/interpret/kernels.h"

namespace patina::interpret {
namespace {

using ir::Op;

// One operand in one lane.
template <class Real>
struct Vector {
    const double* first;
    Real operator[](std::size_t component) const { return static_cast<Real>(first[component * kLanes]); }
};
template <class Real>
Vector<Real> operand(const Step& step, const Machine& machine, unsigned which, unsigned lane) {
    return {machine.at(step.from[which]) + lane};
}
double& result(const Step& step, Machine& machine, unsigned component, unsigned lane) {
    return machine.at(step.to + component)[lane];
}

template <class Real>
Real dot(Vector<Real> a, Vector<Real> b, unsigned width) {
    Real sum = 0;
    for (unsigned i = 0; i < width; ++i) sum += a[i] * b[i];
    return sum;
}

template <class Real>
void dot_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane), b = operand<Real>(step, machine, 1, lane);
        result(step, machine, 0, lane) = dot(a, b, step.shapes[0].rows);
    }
}

template <class Real>
void length_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane);
        result(step, machine, 0, lane) = std::sqrt(dot(a, a, step.shapes[0].rows));
    }
}

template <class Real>
void distance_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane), b = operand<Real>(step, machine, 1, lane);
        Real sum = 0;
        for (unsigned i = 0; i < step.shapes[0].rows; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
        result(step, machine, 0, lane) = std::sqrt(sum);
    }
}

template <class Real>
void normalize_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane);
        const Real length = std::sqrt(dot(a, a, step.count));
        for (unsigned i = 0; i < step.count; ++i) result(step, machine, i, lane) = a[i] / length;
    }
}

template <class Real>
void cross_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane), b = operand<Real>(step, machine, 1, lane);
        for (unsigned i = 0; i < 3; ++i) {
            const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
            result(step, machine, i, lane) = a[j] * b[k] - a[k] * b[j];
        }
    }
}

// i - 2 (n.i) n
template <class Real>
void reflect_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto incident = operand<Real>(step, machine, 0, lane), normal = operand<Real>(step, machine, 1, lane);
        const Real twice = 2 * dot(normal, incident, step.count);
        for (unsigned i = 0; i < step.count; ++i) result(step, machine, i, lane) = incident[i] - twice * normal[i];
    }
}

// Snell's law; zero beyond the angle of total reflection.
template <class Real>
void refract_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto incident = operand<Real>(step, machine, 0, lane), normal = operand<Real>(step, machine, 1, lane);
        const Real ratio = operand<Real>(step, machine, 2, lane)[0];
        const Real cosine = dot(normal, incident, step.count);
        const Real k = 1 - ratio * ratio * (1 - cosine * cosine);
        for (unsigned i = 0; i < step.count; ++i) {
            result(step, machine, i, lane) =
                k < 0 ? Real(0) : ratio * incident[i] - (ratio * cosine + std::sqrt(k)) * normal[i];
        }
    }
}

// A vector on the left is a row, on the right a column.
template <class Real>
void product_kernel(const Step& step, Machine& machine) {
    const bool is_row = step.shapes[0].cols == 1;
    const unsigned rows = is_row ? 1 : step.shapes[0].rows;
    const unsigned inner = is_row ? step.shapes[0].rows : step.shapes[0].cols;
    const unsigned columns = step.shapes[1].cols;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<Real>(step, machine, 0, lane), b = operand<Real>(step, machine, 1, lane);
        for (unsigned row = 0; row < rows; ++row) {
            for (unsigned column = 0; column < columns; ++column) {
                Real sum = 0;
                for (unsigned k = 0; k < inner; ++k) sum += a[row * inner + k] * b[k * columns + column];
                result(step, machine, row * columns + column, lane) = sum;
            }
        }
    }
}

void transpose_kernel(const Step& step, Machine& machine) {
    const unsigned rows = step.shapes[0].rows, columns = step.shapes[0].cols;
    for (unsigned i = 0; i < rows * columns; ++i) {
        const unsigned row = i / columns, column = i % columns;
        std::copy_n(machine.at(step.from[0] + i), kLanes, machine.at(step.to + column * rows + row));
    }
}

// Laplace's expansion along the first row that is left; `columns` are those that are left.
template <class Real>
Real expansion(Vector<Real> m, unsigned size, unsigned row, std::array<unsigned, 4> columns) {
    const unsigned left = size - row;
    if (left == 1) return m[row * size + columns[0]];
    Real sum = 0;
    for (unsigned i = 0; i < left; ++i) {
        std::array<unsigned, 4> others{};
        std::copy_if(columns.begin(), columns.begin() + left, others.begin(),
                     [&](unsigned column) { return column != columns[i]; });
        const Real term = m[row * size + columns[i]] * expansion(m, size, row + 1, others);
        sum += i % 2 == 0 ? term : -term;
    }
    return sum;
}

template <class Real>
void determinant_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto m = operand<Real>(step, machine, 0, lane);
        result(step, machine, 0, lane) = expansion(m, step.shapes[0].rows, 0, {0, 1, 2, 3});
    }
}

// Any: is one of them `wanted`?  All: is none of them not `wanted`?
template <bool is_any>
void any_or_all_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto a = operand<double>(step, machine, 0, lane);
        bool found = !is_any;
        for (unsigned i = 0; i < step.shapes[0].rows; ++i) found = is_any ? found || a[i] != 0 : found && a[i] != 0;
        result(step, machine, 0, lane) = found ? 1 : 0;
    }
}

void select_kernel(const Step& step, Machine& machine) {
    const bool one_for_all = step.shapes[0].rows == 1;
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const auto condition = operand<double>(step, machine, 0, lane);
        for (unsigned i = 0; i < step.count; ++i) {
            const unsigned chosen = condition[one_for_all ? 0 : i] != 0 ? 1 : 2;
            result(step, machine, i, lane) = operand<double>(step, machine, chosen, lane)[i];
        }
    }
}

void index_kernel(const Step& step, Machine& machine) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
        const double index = std::clamp(operand<double>(step, machine, 1, lane)[0], 0.0, step.data - 1.0);
        const auto part = static_cast<Slot>(index) * step.count;
        for (unsigned i = 0; i < step.count; ++i) {
            result(step, machine, i, lane) = machine.at(step.from[0] + part + i)[lane];
        }
    }
}

// --- derivatives: lanes 0 1 above 2 3. Fine ones, each row and column of the quad its own, as lavapipe's are.

template <class Real>
Real ddx(const double* lanes, unsigned lane) {
    const unsigned left = lane & ~1u;
    return static_cast<Real>(lanes[left + 1]) - static_cast<Real>(lanes[left]);
}
template <class Real>
Real ddy(const double* lanes, unsigned lane) {
    const unsigned top = lane & 1u;
    return static_cast<Real>(lanes[top + 2]) - static_cast<Real>(lanes[top]);
}

template <class Real, Op op>
void derivative_kernel(const Step& step, Machine& machine) {
    for (unsigned i = 0; i < step.count; ++i) {
        const double* lanes = machine.at(step.from[0] + i);
        for (unsigned lane = 0; lane < kLanes; ++lane) {
            const Real x = ddx<Real>(lanes, lane), y = ddy<Real>(lanes, lane);
            result(step, machine, i, lane) = op == Op::Ddx ? x : op == Op::Ddy ? y : std::fabs(x) + std::fabs(y);
        }
    }
}

struct VectorOp {
    Op op;
    Kernel in_double;
    Kernel in_float;
};
constexpr VectorOp kVectorOps[] = {
    {Op::Select, select_kernel, select_kernel},
    {Op::Index, index_kernel, index_kernel},
    {Op::Any, any_or_all_kernel<true>, any_or_all_kernel<true>},
    {Op::All, any_or_all_kernel<false>, any_or_all_kernel<false>},
    {Op::Dot, dot_kernel<double>, dot_kernel<float>},
    {Op::Length, length_kernel<double>, length_kernel<float>},
    {Op::Distance, distance_kernel<double>, distance_kernel<float>},
    {Op::Normalize, normalize_kernel<double>, normalize_kernel<float>},
    {Op::Cross, cross_kernel<double>, cross_kernel<float>},
    {Op::Reflect, reflect_kernel<double>, reflect_kernel<float>},
    {Op::Refract, refract_kernel<double>, refract_kernel<float>},
    {Op::MatMul, product_kernel<double>, product_kernel<float>},
    {Op::Transpose, transpose_kernel, transpose_kernel},
    {Op::Determinant, determinant_kernel<double>, determinant_kernel<float>},
    {Op::Ddx, derivative_kernel<double, Op::Ddx>, derivative_kernel<float, Op::Ddx>},
    {Op::Ddy, derivative_kernel<double, Op::Ddy>, derivative_kernel<float, Op::Ddy>},
    {Op::Fwidth, derivative_kernel<double, Op::Fwidth>, derivative_kernel<float, Op::Fwidth>},
};

}  // namespace

Kernel vector_kernel(Op op, ir::Scalar scalar, Precision precision) {
    const auto row =
        std::find_if(std::begin(kVectorOps), std::end(kVectorOps), [&](const VectorOp& r) { return r.op == op; });
    if (row == std::end(kVectorOps)) return nullptr;
    return scalar == ir::Scalar::Float && precision == Precision::Float ? row->in_float : row->in_double;
}

}  // namespace patina::interpret

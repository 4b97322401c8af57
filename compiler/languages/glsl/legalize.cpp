#include "compiler/languages/legalize.h"

#include "compiler/languages/glsl/glsl.h"

namespace patina::languages::glsl {

using namespace ir;

namespace {

// && and || take no vectors; & and | take them, as uints.
bool is_logic_of_vectors(const Module&, const Function& function, Value v) {
    return function[v].type.is_vector();
}
Value join_bits(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Inst& inst = copy.from[v];
    const Value x = b.convert(operand(copy, v, 0), Scalar::Uint), y = b.convert(operand(copy, v, 1), Scalar::Uint);
    const Op op = inst.op == Op::And ? Op::BitAnd : Op::BitOr;
    return b.convert(b.emit(op, inst.type.with_scalar(Scalar::Uint), {x, y}), Scalar::Bool);
}

// m[i] is a column in GLSL, so a row cannot be assigned.
bool replaces_row(const Module&, const Function& function, Value v) {
    return function[v].type.is_matrix();
}
Value rebuild_rows(Copy& copy, Value v) {
    Builder& b = copy.to;
    const Inst& inst = copy.from[v];
    std::vector<Value> rows;
    for (std::uint32_t i = 0; i < inst.type.rows; ++i) {
        rows.push_back(i == inst.data ? operand(copy, v, 1) : b.extract(operand(copy, v, 0), i));
    }
    return b.construct(inst.type, rows);
}

constexpr Rule kRules[] = {
    {{Op::And, Op::Or}, is_logic_of_vectors, join_bits},
    {{Op::Insert}, replaces_row, rebuild_rows},
};

}  // namespace

std::optional<Module> legalize(const Module& module) {
    return languages::legalize(module, kRules);
}

}  // namespace patina::languages::glsl

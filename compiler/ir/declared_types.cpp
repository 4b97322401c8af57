#include "compiler/ir/declared_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace patina::ir {
namespace {

struct Context {
    const Module& module;
    const Function& function;
    const Inst& inst;

    std::size_t count() const { return inst.operand_count; }
    Type operand(std::size_t i) const { return function[function.args(inst)[i]].type; }
    std::string name(Type type) const { return module.type_name(type); }
};

std::string expect(const Context& c, Type actual, Type wanted, std::string_view what) {
    return actual == wanted ? "" : fmt::format("{} is a {}, not a {}", what, c.name(actual), c.name(wanted));
}

template <class Row>
std::string leaf(const Context& c, const std::vector<Row>& table, std::string_view what) {
    if (c.inst.data >= table.size()) return fmt::format("there is no {} {}", what, c.inst.data);
    return expect(c, table[c.inst.data].type, c.inst.type, what);
}

std::string constant(const Context& c) {
    if (!c.inst.type.is_numeric()) return "a constant is numeric";
    const std::string error = leaf(c, c.module.constants, "constant");
    if (!error.empty()) return error;
    const Constant& constant = c.module.constants[c.inst.data];
    const bool fits = std::size_t{constant.first} + constant.type.components() <= c.module.numbers.size();
    return fits ? "" : "the constant's numbers are not in the module";
}
std::string param(const Context& c) {
    return leaf(c, c.function.params, "param");
}
std::string global(const Context& c) {
    return leaf(c, c.module.globals, "global");
}
std::string semantic(const Context& c) {
    return leaf(c, c.module.semantics, "semantic");
}

std::string construct_vector(const Context& c) {
    unsigned components = 0;
    for (std::size_t i = 0; i < c.count(); i++) {
        const Type part = c.operand(i);
        if (!part.is_numeric() || part.is_matrix() || part.scalar != c.inst.type.scalar) {
            return fmt::format("a {} is no part of a {}", c.name(part), c.name(c.inst.type));
        }
        components += part.components();
    }
    const bool is_splat = c.count() == 1 && components == 1;
    return is_splat || components == c.inst.type.width()
               ? ""
               : fmt::format("{} components make no {}", components, c.name(c.inst.type));
}

std::string construct(const Context& c) {
    if (c.inst.type.is_vector()) return construct_vector(c);
    const std::uint32_t parts = part_count(c.module, c.inst.type);
    if (parts != c.count() || c.inst.type.is_scalar()) {
        return fmt::format("a {} is made of {} parts, not of {}", c.name(c.inst.type), parts, c.count());
    }
    for (std::uint32_t i = 0; i < parts; i++) {
        const std::string error =
            expect(c, c.operand(i), part_type(c.module, c.inst.type, i), fmt::format("part {}", i));
        if (!error.empty()) return error;
    }
    return "";
}

std::string part(const Context& c, Type actual) {
    const Type composite = c.operand(0);
    if (c.inst.data >= part_count(c.module, composite)) {
        return fmt::format("a {} has no part {}", c.name(composite), c.inst.data);
    }
    return expect(c, actual, part_type(c.module, composite, c.inst.data), "the part");
}
std::string extract(const Context& c) {
    return part(c, c.inst.type);
}

std::string index(const Context& c) {
    const Type whole = c.operand(0);
    if (part_count(c.module, whole) == 0 || whole.kind == Kind::Struct)
        return "only arrays, vectors and matrices are indexed";
    if (!c.operand(1).is_integer() || !c.operand(1).is_scalar()) return "an index is an int or a uint";
    return expect(c, c.inst.type, part_type(c.module, whole, 0), "the element");
}

std::string swizzle(const Context& c) {
    const Type vector = c.operand(0), result = c.inst.type;
    if (!vector.is_vector() || !result.is_vector() || vector.scalar != result.scalar)
        return "a swizzle takes a vector and gives one";
    for (unsigned i = 0; i < result.width(); i++) {
        if ((c.inst.data >> (2 * i) & 3u) >= vector.width())
            return fmt::format("a {} has no such component", c.name(vector));
    }
    return "";
}

std::string convert(const Context& c) {
    const Type from = c.operand(0);
    const bool fits =
        from.is_numeric() && c.inst.type.is_numeric() && from.with_scalar(c.inst.type.scalar) == c.inst.type;
    return fits ? "" : fmt::format("a {} does not convert to a {}", c.name(from), c.name(c.inst.type));
}

std::string bitcast(const Context& c) {
    const auto is_word = [](Type t) { return t.is_integer() || (t.is_floating() && t.scalar == Scalar::Float); };
    const std::string error = convert(c);
    return error.empty() && !(is_word(c.operand(0)) && is_word(c.inst.type)) ? "only float, int and uint have 32 bits"
                                                                             : error;
}

std::string call(const Context& c) {
    if (c.inst.data >= c.module.functions.size()) return fmt::format("there is no function {}", c.inst.data);
    const Function& callee = c.module.functions[c.inst.data];
    if (&callee >= &c.function) return fmt::format("'{}' does not come before its caller", callee.name);
    if (callee.params.size() != c.count()) {
        return fmt::format("'{}' takes {} arguments, not {}", callee.name, callee.params.size(), c.count());
    }
    for (std::size_t i = 0; i < c.count(); i++) {
        const std::string error =
            expect(c, c.operand(i), callee.params[i].type, fmt::format("argument '{}'", callee.params[i].name));
        if (!error.empty()) return error;
    }
    return expect(c, c.inst.type, callee.result, "the result");
}

std::string texture_size(const Context& c) {
    const bool is_flat = c.operand(0).kind == Kind::Texture2D || c.operand(0).kind == Kind::TextureCube;
    if (!is_flat || c.operand(1) != kInt) return "textureSize takes a texture of two sides or a cube, and an int";
    return expect(c, c.inst.type, Type::vector(Scalar::Int, 2), "the result");
}

struct Rule {
    Op op;
    std::string (*error)(const Context&);
};
constexpr Rule kRules[] = {
    {Op::Constant, constant},   {Op::Param, param},     {Op::Global, global},   {Op::Semantic, semantic},
    {Op::Construct, construct}, {Op::Extract, extract}, {Op::Swizzle, swizzle}, {Op::Index, index},
    {Op::Convert, convert},     {Op::Bitcast, bitcast}, {Op::Call, call},       {Op::TextureSize, texture_size},
};

}  // namespace

std::string declared_type_error(const Module& module, const Function& function, const Inst& inst) {
    const Context context{module, function, inst};
    if (inst.op == Op::Insert) return part(context, context.operand(1));
    const auto rule =
        std::find_if(std::begin(kRules), std::end(kRules), [&](const Rule& r) { return r.op == inst.op; });
    return rule == std::end(kRules) ? "" : rule->error(context);
}

bool is_possible(const Module& module, Type type) {
    switch (type.kind) {
        case Kind::Numeric:
            if (type.rows < 1 || type.rows > 4 || type.cols < 1 || type.cols > 4) return false;
            return type.cols == 1 || (type.rows > 1 && type.is_floating());
        case Kind::Array: return type.ref < module.arrays.size() && module.arrays[type.ref].count > 0;
        case Kind::Struct: return type.ref < module.structs.size();
        case Kind::Void:
        case Kind::Texture2D:
        case Kind::TextureCube:
        case Kind::Texture2DArray:
        case Kind::Texture3D:
        case Kind::Sampler: return true;
        case Kind::Error: return false;
    }
    return false;
}

}  // namespace patina::ir

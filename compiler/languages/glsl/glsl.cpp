#include "compiler/languages/glsl/glsl.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/spelling.h"
#include "compiler/ir/fold/facts.h"
#include "compiler/languages/body.h"
#include "compiler/languages/literals.h"

namespace patina::languages::glsl {

using namespace ir;

namespace {

std::string type_name(Type type) {
    switch (type.kind) {
        case Kind::Texture2D: return "texture2D";
        case Kind::TextureCube: return "textureCube";
        case Kind::Texture2DArray: return "texture2DArray";
        case Kind::Texture3D: return "texture3D";
        case Kind::Sampler: return "sampler";
        case Kind::Numeric: break;
        case Kind::Void:
        case Kind::Array:
        case Kind::Struct:
        case Kind::Error: return {};
    }
    constexpr std::string_view kScalars[] = {"bool", "int", "uint", "float16_t", "float"};
    constexpr std::string_view kPrefixes[] = {"b", "i", "u", "f16", ""};
    const auto scalar = static_cast<std::size_t>(type.scalar);
    if (type.is_scalar()) return std::string(kScalars[scalar]);
    const std::string prefix(kPrefixes[scalar]);
    if (type.is_vector()) return prefix + "vec" + std::to_string(type.rows);
    if (type.rows == type.cols) return prefix + "mat" + std::to_string(type.rows);
    return prefix + "mat" + std::to_string(type.cols) + "x" + std::to_string(type.rows);
}

std::string_view bitcast(Scalar to, Scalar from) {
    if (to == Scalar::Int && from == Scalar::Float) return "floatBitsToInt";
    if (to == Scalar::Uint && from == Scalar::Float) return "floatBitsToUint";
    if (to == Scalar::Float && from == Scalar::Int) return "intBitsToFloat";
    if (to == Scalar::Float && from == Scalar::Uint) return "uintBitsToFloat";
    return {};  // int and uint: a conversion keeps the bits
}

Text splat(Type type, const Text& scalar) {
    return {fmt::format("{}({})", type_name(type), scalar.text), Precedence::Postfix};
}

std::string array_value(const std::string& element_type, std::size_t count, const std::string& elements) {
    return fmt::format("{}[{}]({})", element_type, count, elements);
}

// --- expressions

Text sample(const Body& body, Value v, std::string_view function) {
    std::string sampler = type_name(body[body.arg(v, 0)].type);
    sampler.replace(0, std::string_view("texture").size(), "sampler");  // texture2D, sampler2D
    return {fmt::format("{}({}({}, {}), {})", function, sampler, body.argument(v, 0), body.argument(v, 1),
                        body.arguments(v, 2)),
            Precedence::Postfix};
}

bool is_made_in_place(const Body& body, Value v) {
    return body[v].op == Op::Construct && body[v].type.is_matrix() && !body.is_variable(v) && !body.corner_of(v);
}

// GLSL makes matrices of columns, and the IR of rows, so the same vectors make the transpose.
std::string transpose_of(const Body& body, Value construct) {
    const Type type = body[construct].type;
    return fmt::format("{}({})", type_name(Type::matrix(type.scalar, type.cols, type.rows)), body.arguments(construct));
}

// A matrix of rows, times v, equals v times the matrix with these vectors as columns. So no transpose() is needed.
Text product(const Body& body, Value v) {
    const Value a = body.arg(v, 0), b = body.arg(v, 1);
    std::string left, right;
    if (is_made_in_place(body, a) && body[b].type.is_vector()) {
        left = at_least(Precedence::Multiplicative, body.expression(b));
        right = transpose_of(body, a);
    } else if (is_made_in_place(body, b) && body[a].type.is_vector()) {
        left = transpose_of(body, b);
        right = at_least(Precedence::Unary, body.expression(a));
    } else {
        left = at_least(Precedence::Multiplicative, body.expression(a));
        right = at_least(Precedence::Unary, body.expression(b));
    }
    return {fmt::format("{} * {}", left, right), Precedence::Multiplicative};
}

Text transpose(const Body& body, Value v) {
    const Value matrix = body.arg(v, 0);
    if (is_made_in_place(body, matrix)) return {transpose_of(body, matrix), Precedence::Postfix};
    return {fmt::format("transpose({})", body.argument(v, 0)), Precedence::Postfix};
}

Text select(const Body& body, Value v) {
    if (body[body.arg(v, 0)].type.is_scalar()) return body.ternary(v);
    return {fmt::format("mix({}, {}, {})", body.argument(v, 2), body.argument(v, 1), body.argument(v, 0)),
            Precedence::Postfix};
}

// GLSL has no saturate(). Its clamp() has two limits, of which the lower one may hold anyway.
Text clamp_to_one(const Body& body, Value v) {
    const auto limit = [&](double number) { return literal(body.writer().language, body[v].type.scalar, number).text; };
    if (range_of({body.module(), body.function()}, body.arg(v, 0)).low >= 0)
        return {"min(" + body.argument(v, 0) + ", " + limit(1) + ")", Precedence::Postfix};
    return {"clamp(" + body.argument(v, 0) + ", " + limit(0) + ", " + limit(1) + ")", Precedence::Postfix};
}

Text expression(const Body& body, Value v) {
    const Op op = body[v].op;
    if (op == Op::Saturate) return clamp_to_one(body, v);
    if (op == Op::Select) return select(body, v);
    if (op == Op::MatMul) return product(body, v);
    if (op == Op::Transpose) return transpose(body, v);
    if (op == Op::Sample || op == Op::SampleBias) return sample(body, v, "texture");
    if (op == Op::SampleLevel) return sample(body, v, "textureLod");
    if (op == Op::SampleGrad) return sample(body, v, "textureGrad");
    return {fmt::format("{}({})", op == Op::TexelLoad ? "texelFetch" : "textureSize", body.arguments(v)),
            Precedence::Postfix};
}

bool statement(Body&, Value) {
    return false;
}

// --- declarations

void preamble(Writer& w) {
    w.line(0, "#version 450");
    if (w.reachable.half) w.line(0, "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require");
    if (w.reachable.samplerless) w.line(0, "#extension GL_EXT_samplerless_texture_functions : require");
}

void block(Writer& w, const UniformBlock& block) {
    const auto index = static_cast<std::size_t>(&block - w.module.blocks.data());
    w.line(0, fmt::format("layout(set = {}, binding = {}, std140{}) uniform {}", w.set(block.group, block.place),
                          block.place.binding, block.matrices_by_rows ? ", row_major" : "", w.blocks[index]));
    w.block_body(block);
    w.line(0, "};");
}

void resource(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    w.line(0, fmt::format("layout(set = {}, binding = {}) uniform {};", w.set(global.group, global.place),
                          global.place.binding, w.declaration(global.type, w.globals[id.index])));
}

void keyword(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    const std::optional<std::uint32_t> constant = w.module.keywords[global.keyword].constant_id;
    w.line(0, fmt::format("{}const {} = {};", constant ? fmt::format("layout(constant_id = {}) ", *constant) : "",
                          w.declaration(global.type, w.globals[id.index]), w.keyword_value(global)));
}

std::string_view builtin_name(Builtin builtin) {
    switch (builtin) {
        case Builtin::None: return {};
        case Builtin::Position: return "gl_Position";
        case Builtin::FragCoord: return "gl_FragCoord";
        case Builtin::FrontFacing: return "gl_FrontFacing";
        case Builtin::VertexIndex: return "gl_VertexIndex";
        case Builtin::InstanceIndex: return "gl_InstanceIndex";
    }
    return {};
}

// Attributes are called inName, varyings vName, render targets outName.
std::string declare_variable(Writer& w, const StageVariable& variable, bool is_input) {
    const bool is_vertex = w.module.stage.kind == StageKind::Vertex;
    const std::string_view prefix = is_input != is_vertex ? "v" : is_input ? "in" : "out";
    const std::string name = w.names.declare(joined(prefix, variable.name));
    // Vulkan requires integer inputs of the fragment stage to be flat; elsewhere the word has no effect.
    const bool is_flat = (variable.flat || variable.type.is_integer()) && prefix == "v";
    w.line(0, fmt::format("layout(location = {}) {}{} {};", variable.location, is_flat ? "flat " : "",
                          is_input ? "in" : "out", w.declaration(Writer::stored(variable.type), name)));
    return name;
}

Text input(Writer& w, const StageVariable& variable) {
    const bool is_builtin = variable.builtin != Builtin::None;
    const std::string name =
        is_builtin ? std::string(builtin_name(variable.builtin)) : declare_variable(w, variable, true);
    const bool is_index = variable.builtin == Builtin::VertexIndex || variable.builtin == Builtin::InstanceIndex;
    const Type found = is_index ? kInt : is_builtin ? variable.type : Writer::stored(variable.type);
    if (found == variable.type) return {name};
    return {fmt::format("{}({})", type_name(variable.type), name), Precedence::Postfix};
}

EntryPoint entry_point(Writer& w) {
    EntryPoint entry{.signature = "void main()", .inputs = {}, .outputs = {}, .before_return = {}, .at_return = {}};
    for (const StageVariable& variable : w.module.stage.inputs) entry.inputs.push_back(input(w, variable));
    for (const StageVariable& variable : w.module.stage.outputs) {
        const bool is_builtin = variable.builtin != Builtin::None;
        entry.outputs.push_back(is_builtin ? std::string(builtin_name(variable.builtin))
                                           : declare_variable(w, variable, false));
    }
    return entry;
}

constexpr Language kLanguage = {
    .name = "glsl",
    .spellings = &kSpellings,
    .half_suffix = "hf",
    .matrices_by_columns = true,
    .type_name = type_name,
    .bitcast = bitcast,
    .splat = splat,
    .array_value = array_value,
    .set_word = "",
    .pads_blocks = false,  // std140 says where a member stands
    .row_major = "",
    .constant_array = "const",
    .expression = expression,
    .statement = statement,
    .preamble = preamble,
    .block = block,
    .resource = resource,
    .keyword = keyword,
    .entry_point = entry_point,
};

}  // namespace

Printed print(const Module& module, const PrintOptions& options) {
    return languages::print(module, kLanguage, options);
}

}  // namespace patina::languages::glsl

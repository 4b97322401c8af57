#include "compiler/languages/hlsl/hlsl.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/languages/body.h"

namespace patina::languages::hlsl {

using namespace ir;

namespace {

std::string type_name(Type type) {
    switch (type.kind) {
        case Kind::Texture2D: return "Texture2D";
        case Kind::TextureCube: return "TextureCube";
        case Kind::Texture2DArray: return "Texture2DArray";
        case Kind::Texture3D: return "Texture3D";
        case Kind::Sampler: return "SamplerState";
        case Kind::Numeric: break;
        case Kind::Void:
        case Kind::Array:
        case Kind::Struct:
        case Kind::Error: return {};
    }
    constexpr std::string_view kScalars[] = {"bool", "int", "uint", "half", "float"};
    const std::string scalar(kScalars[static_cast<std::size_t>(type.scalar)]);
    if (type.is_scalar()) return scalar;
    if (type.is_vector()) return scalar + std::to_string(type.rows);
    return scalar + std::to_string(type.rows) + "x" + std::to_string(type.cols);
}

std::string_view bitcast(Scalar to, Scalar) {
    if (to == Scalar::Int) return "asint";
    return to == Scalar::Uint ? "asuint" : "asfloat";
}

// The constructor of a vector takes one number for each component; a scalar is swizzled.
Text splat(Type type, const Text& scalar) {
    const bool is_negative = scalar.text.starts_with('-');
    const char first = scalar.text[is_negative ? 1 : 0];
    const bool is_literal = (first >= '0' && first <= '9' && scalar.precedence >= Precedence::Unary) ||
                            scalar.text == "true" || scalar.text == "false";
    if (!is_literal) {
        return {at_least(Precedence::Postfix, scalar) + "." + std::string(type.width(), 'x'), Precedence::Postfix};
    }
    std::string numbers = scalar.text;
    for (unsigned i = 1; i < type.width(); ++i) numbers += ", " + scalar.text;
    return {fmt::format("{}({})", type_name(type), numbers), Precedence::Postfix};
}

std::string array_value(const std::string&, std::size_t, const std::string& elements) {
    return "{ " + elements + " }";
}

Text expression(const Body& body, Value v) {
    const Op op = body[v].op;
    const std::string texture = at_least(Precedence::Postfix, body.expression(body.arg(v, 0)));
    if (op == Op::TexelLoad) {
        return {fmt::format("{}.Load(int3({}))", texture, body.arguments(v, 1)), Precedence::Postfix};
    }
    const std::string_view method = op == Op::Sample        ? "Sample"
                                    : op == Op::SampleBias  ? "SampleBias"
                                    : op == Op::SampleLevel ? "SampleLevel"
                                                            : "SampleGrad";
    return {fmt::format("{}.{}({})", texture, method, body.arguments(v, 1)), Precedence::Postfix};
}

// GetDimensions() returns a texture's size through out parameters.
bool statement(Body& body, Value v) {
    if (body[v].op != Op::TextureSize) return false;
    const std::string texture = at_least(Precedence::Postfix, body.expression(body.arg(v, 0))),
                      level = body.argument(v, 1);
    const std::string width = body.declare_helper("width"), height = body.declare_helper("height");
    const std::string levels = body.declare_helper("levelCount");
    body.statement(v, fmt::format("uint {}, {}, {};", width, height, levels));
    body.statement(v, fmt::format("{}.GetDimensions({}, {}, {}, {});", texture, level, width, height, levels));
    body.statement(v, fmt::format("{} = int2({}, {});", body.target(v), width, height));
    return true;
}

// --- declarations

void preamble(Writer&) {}

void block(Writer& w, const UniformBlock& block) {
    const auto index = static_cast<std::size_t>(&block - w.module.blocks.data());
    w.line(0, fmt::format("cbuffer {} : register(b{}, {})", w.blocks[index], block.place.slot,
                          w.set(block.group, block.place)));
    w.block_body(block);
    w.line(0, "};");
}

void resource(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    w.line(0, fmt::format("{} : register({}{}, {});", w.declaration(global.type, w.globals[id.index]),
                          global.type.kind == Kind::Sampler ? 's' : 't', global.place.slot,
                          w.set(global.group, global.place)));
}

// A pipeline of Vulkan sets a specialization constant: dxc defines __spirv__ there, and glslang VULKAN. Direct3D has no
// such constants, and a constant that is not static would be a uniform there. So the default is static, and a program
// that compiles the text may define a macro of that name instead.
void keyword(Writer& w, GlobalId id) {
    const Global& global = w.module.globals[id.index];
    const std::string& name = w.globals[id.index];
    const std::optional<std::uint32_t> constant = w.module.keywords[global.keyword].constant_id;
    const std::string value = fmt::format("const {} = {};", w.declaration(global.type, name), w.keyword_value(global));
    if (!constant) return w.line(0, "static " + value);
    w.line(0, "#if defined(__spirv__) || defined(VULKAN)");
    w.line(0, fmt::format("[[vk::constant_id({})]] {}", *constant, value));
    w.line(0, fmt::format("#elif !defined({})", name));
    w.line(0, "static " + value);
    w.line(0, "#endif");
}

// Orders variables by location, then the rasteriser's inputs or outputs, the position last. The front end of glslang
// numbers the variables in this order, so both stages must have the same one.
std::vector<std::size_t> declaration_order(const std::vector<StageVariable>& variables) {
    std::vector<std::size_t> order(variables.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::size_t i) {
        const StageVariable& v = variables[i];
        const bool is_position = v.builtin == Builtin::Position || v.builtin == Builtin::FragCoord;
        return std::pair(v.builtin == Builtin::None ? 0 : is_position ? 2 : 1, v.location);
    };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return order;
}

// Declares a struct of stage variables; returns the members' names by variable.
std::vector<std::string> declare_struct(Writer& w, const std::string& name, const std::vector<StageVariable>& variables,
                                        bool is_input) {
    const bool is_fragment = w.module.stage.kind == StageKind::Fragment;
    std::vector<std::string> members(variables.size());
    Names names;
    w.gap();
    w.line(0, "struct " + name);
    w.line(0, "{");
    std::uint32_t next_location = 0;
    bool is_counted = true;  // each location follows the one before it
    for (std::size_t i : declaration_order(variables)) {
        const StageVariable& v = variables[i];
        members[i] = names.declare(v.name);
        std::string prefix;
        if (v.builtin == Builtin::None) {
            is_counted &= v.location == next_location++;
            if (!is_counted) prefix = fmt::format("[[vk::location({})]] ", v.location);
            if ((v.flat || v.type.is_integer()) && is_input == is_fragment) prefix += "nointerpolation ";
        }
        w.line(1, fmt::format("{}{} : {};", prefix, w.declaration(v.type, members[i]),
                              semantic(v, is_fragment && !is_input)));
    }
    w.line(0, "};");
    return members;
}

EntryPoint entry_point(Writer& w) {
    const StageInterface& stage = w.module.stage;
    const std::string kind = stage.kind == StageKind::Vertex ? "Vertex" : "Fragment";
    EntryPoint entry;
    std::string parameter, result = "void";
    if (!stage.inputs.empty()) {
        const std::string name = w.names.declare(kind + "Input");
        parameter = name + " input";
        for (const std::string& member : declare_struct(w, name, stage.inputs, true))
            entry.inputs.push_back({"input." + member});
    }
    if (!stage.outputs.empty()) {
        result = w.names.declare(kind + "Output");
        for (const std::string& member : declare_struct(w, result, stage.outputs, false)) {
            entry.outputs.push_back("output." + member);
        }
        entry.before_return = result + " output;";
        entry.at_return = "return output;";
    }
    entry.signature = fmt::format("{} main({})", result, parameter);
    return entry;
}

constexpr Language kLanguage = {
    .name = "hlsl",
    .spellings = &kSpellings,
    .half_suffix = "h",
    .matrices_by_columns = false,
    .type_name = type_name,
    .bitcast = bitcast,
    .splat = splat,
    .array_value = array_value,
    .set_word = "space",
    .row_major = "row_major ",
    .constant_array = "static const",
    .expression = expression,
    .statement = statement,
    .preamble = preamble,
    .block = block,
    .resource = resource,
    .keyword = keyword,
    .entry_point = entry_point,
};

}  // namespace

std::string semantic(const StageVariable& variable, bool is_target) {
    if (!variable.semantic.empty()) return variable.semantic;
    switch (variable.builtin) {
        case Builtin::None: return fmt::format("{}{}", is_target ? "SV_Target" : "TEXCOORD", variable.location);
        case Builtin::Position:
        case Builtin::FragCoord: return "SV_Position";
        case Builtin::FrontFacing: return "SV_IsFrontFace";
        case Builtin::VertexIndex: return "SV_VertexID";
        case Builtin::InstanceIndex: return "SV_InstanceID";
    }
    return {};
}

const Language& language() {
    return kLanguage;
}

Printed print(const Module& module, const PrintOptions& options) {
    return languages::print(module, kLanguage, options);
}

}  // namespace patina::languages::hlsl

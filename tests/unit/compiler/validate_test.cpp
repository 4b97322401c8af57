// Everything that the printers write compiles: each operation at each type, in both languages, through glslang and
// spirv-val. And what does not compile is reported where it comes from.
#include "patina/validate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <thread>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"
#include "compiler/languages/print.h"

namespace patina {
namespace {

using namespace ir;
using languages::find_language;

Shader print(const Module& module, Target target) {
    const languages::LanguageInfo* info = find_language(target.language);
    const Module legal = info->legalize(module).value_or(module);
    EXPECT_TRUE(verify(legal).empty()) << verify(legal);
    Shader shader;
    shader.pass = "test";
    shader.stage = module.stage.kind == StageKind::Vertex ? Stage::Vertex : Stage::Fragment;
    shader.target = target;
    shader.file_name = fmt::format("test.{}", info->extension);
    shader.hlsl_shifts = {{.set = 0, .textures = 1, .samplers = 5, .buffers = 0}};
    shader.text = info->print(legal, {.header = "", .plans = nullptr}).text;
    return shader;
}

void expect_valid(const Module& module, const std::string& what) {
    ASSERT_TRUE(verify(module).empty()) << what << "\n" << verify(module);
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const Shader shader = print(module, target);
        const Validated result = validate(shader);
        EXPECT_TRUE(result.ok) << what << "\n" << result.log << "\n" << shader.text;
        EXPECT_FALSE(result.spirv.empty());
    }
}

// A stage float4 main(float4 v, float2 uv), and what tests need to fill it.
struct StageFixture {
    Module module;
    Function function;
    Builder b;
    StageKind kind;

    explicit StageFixture(StageKind kind = StageKind::Fragment) : b(module, function, {.fold = false}), kind(kind) {
        function.name = "main";
        function.params = {{"v", kFloat4}, {"uv", kFloat2}};
        module.structs.push_back({"Outputs", {{"color", kFloat4}}});
        module.globals.push_back(
            {.name = "_Map", .type = Type::of(Kind::Texture2D), .place = {.binding = 1, .slot = 0}, .span = {}});
        module.globals.push_back(
            {.name = "_Sky", .type = Type::of(Kind::TextureCube), .place = {.binding = 2, .slot = 1}, .span = {}});
        module.globals.push_back(
            {.name = "sampler_Map", .type = Type::of(Kind::Sampler), .place = {.binding = 5, .slot = 0}, .span = {}});
    }
    Value global(std::uint32_t index) { return b.emit(Op::Global, module.globals[index].type, {}, index); }

    // A value of the type that depends on the stage's input.
    Value value_of(Type type) {
        if (type.is_matrix()) {
            const Value row = value_of(type.with_width(type.cols));
            return b.construct(type, std::vector<Value>(type.rows, row));
        }
        const unsigned components[] = {0, 1, 2, 3};
        Value v = b.param(0);
        if (type.is_scalar()) {
            v = b.extract(v, 0);
        } else if (type.width() < 4) {
            v = b.swizzle(v, std::span<const unsigned>(components, type.width()));
        }
        return b.convert(v, type.scalar);
    }
    void finish(std::span<const Value> values) {
        Value sum = b.constant(kFloat, {0});
        for (Value v : values) {
            while (!b.type(v).is_scalar()) v = b.extract(v, 0);
            sum = b.emit(Op::Add, {sum, b.convert(v, Scalar::Float)});
        }
        const Value color = b.splat(sum, 4);
        function.result = Type::structure(0);
        b.ret(b.construct(function.result, {&color, 1}));
        module.functions.push_back(function);
        const bool is_vertex = kind == StageKind::Vertex;
        module.stage = {.kind = kind,
                        .entry = {static_cast<std::uint32_t>(module.functions.size() - 1)},
                        .inputs = {{.name = "v", .type = kFloat4, .location = 0, .semantic = "TEXCOORD0"},
                                   {.name = "uv", .type = kFloat2, .location = 1, .semantic = "TEXCOORD1"}},
                        .outputs = {{.name = "color",
                                     .type = kFloat4,
                                     .builtin = is_vertex ? Builtin::Position : Builtin::None,
                                     .semantic = is_vertex ? "SV_Position" : "SV_Target0"}}};
    }
};

// --- operations

std::vector<Type> numeric_types() {
    std::vector<Type> types;
    for (const Scalar scalar : {Scalar::Bool, Scalar::Int, Scalar::Uint, Scalar::Half, Scalar::Float}) {
        for (unsigned width = 1; width <= 4; ++width) types.push_back(Type::vector(scalar, width));
    }
    for (const Scalar scalar : {Scalar::Half, Scalar::Float}) {
        for (unsigned size = 2; size <= 4; ++size) types.push_back(Type::matrix(scalar, size, size));
    }
    return types;
}

// The operand lists of an op around one type; result_type() says which of them fit.
std::vector<std::vector<Type>> operand_lists(Op op, Type type) {
    const int count = info(op).arguments;
    if (op == Op::Insert) return {};  // its operands differ: CompositesAndIndices
    if (op == Op::Refract) return {{type, type, type.with_width(1)}};
    if (op == Op::Select) return {{kBool, type, type}, {type.with_scalar(Scalar::Bool), type, type}};
    if (op == Op::MatMul && type.is_matrix()) {
        const Type vector = type.with_width(type.rows);
        return {{type, type}, {type, vector}, {vector, type}};
    }
    return count > 0 ? std::vector<std::vector<Type>>{std::vector<Type>(static_cast<std::size_t>(count), type)}
                     : std::vector<std::vector<Type>>{};
}

TEST(Validate, EveryOperationAtEveryType) {
    std::size_t tried = 0;
    std::array<bool, kOpCount> seen{};
    for (const Type type : numeric_types()) {
        StageFixture f;
        std::vector<Value> values;
        for (std::size_t i = 0; i < kOpCount; ++i) {
            const Op op = static_cast<Op>(i);
            for (const std::vector<Type>& list : operand_lists(op, type)) {
                const Type result = result_type(op, list);
                if (!result.is_numeric() || (result.is_matrix() && (result.is_bool() || op == Op::Reflect))) continue;
                std::vector<Value> operands;
                for (const Type t : list) operands.push_back(f.value_of(t));
                values.push_back(f.b.emit(op, result, operands));
                seen[i] = true;
                ++tried;
            }
        }
        f.finish(values);
        expect_valid(f.module, "all operations of " + f.module.type_name(type));
    }
    EXPECT_GT(tried, 700u);
    for (const Op op :
         {Op::Add, Op::Mod, Op::Select, Op::Refract, Op::MatMul, Op::Determinant, Op::Fwidth, Op::Any, Op::Cross}) {
        EXPECT_TRUE(seen[static_cast<std::size_t>(op)]) << info(op).text;
    }
}

TEST(Validate, ScalarsInPlaceOfSplats) {
    for (const Scalar scalar : {Scalar::Half, Scalar::Float, Scalar::Int}) {
        StageFixture f;
        const Type type = Type::vector(scalar, 3);
        const Value v = f.value_of(type), s = f.b.splat(f.value_of(type.with_width(1)), 3),
                    two = f.b.splat_constant(type, 2);
        std::vector<Value> values;
        for (const Op op :
             {Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Min, Op::Max, Op::Pow, Op::Step, Op::Less, Op::Equal, Op::Lerp,
              Op::Clamp, Op::Smoothstep, Op::Mod, Op::Atan2, Op::ShiftLeft, Op::BitAnd}) {
            const auto add = [&](std::vector<Value> operands) {
                std::vector<Type> types(operands.size(), type);
                const Type result = result_type(op, types);
                if (!result.is_error()) values.push_back(f.b.emit(op, result, operands));
            };
            if (info(op).arguments == 2) {
                for (const Value scalar_value : {s, two}) {
                    add({v, scalar_value});
                    add({scalar_value, v});
                    add({scalar_value, scalar_value});
                }
            } else {
                add({v, s, two});
                add({s, two, v});
                add({v, v, s});
                add({two, v, v});
            }
        }
        f.finish(values);
        expect_valid(f.module, "splats of " + f.module.type_name(type));
    }
}

TEST(Validate, ConversionsAndBits) {
    StageFixture f;
    std::vector<Value> values;
    for (const Type from : numeric_types()) {
        for (const Scalar to : {Scalar::Bool, Scalar::Int, Scalar::Uint, Scalar::Half, Scalar::Float}) {
            if (!from.is_matrix()) values.push_back(f.b.convert(f.value_of(from), to));
            const bool has_32_bits = to == Scalar::Int || to == Scalar::Uint || to == Scalar::Float;
            const bool from_32_bits = from.is_integer() || from.scalar == Scalar::Float;
            if (has_32_bits && from_32_bits && !from.is_matrix() && from.scalar != to) {
                values.push_back(f.b.emit(Op::Bitcast, from.with_scalar(to), {f.value_of(from)}));
            }
        }
    }
    f.finish(values);
    expect_valid(f.module, "conversions");
}

TEST(Validate, TexturesInBothStages) {
    for (const StageKind kind : {StageKind::Vertex, StageKind::Fragment}) {
        StageFixture f(kind);
        const Value map = f.global(0), sky = f.global(1), sampler = f.global(2), uv = f.b.param(1),
                    half = f.b.constant(kFloat, {0.5});
        const Value direction = f.value_of(kFloat3);
        const Value texel = f.b.convert(uv, Scalar::Int), level = f.b.constant(kInt, {1});
        f.finish(std::vector<Value>{
            f.b.emit(Op::Sample, kFloat4, {map, sampler, uv}),
            f.b.emit(Op::Sample, kFloat4, {sky, sampler, direction}),
            f.b.emit(Op::SampleBias, kFloat4, {map, sampler, uv, half}),
            f.b.emit(Op::SampleLevel, kFloat4, {sky, sampler, direction, half}),
            f.b.emit(Op::SampleGrad, kFloat4, {map, sampler, uv, uv, uv}),
            f.b.emit(Op::SampleGrad, kFloat4, {sky, sampler, direction, direction, direction}),
            f.b.emit(Op::TexelLoad, kFloat4, {map, texel, level}),
            f.b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {map, level}),
            f.b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {map, f.b.constant(kInt, {0})}),
        });
        expect_valid(f.module, kind == StageKind::Vertex ? "vertex" : "fragment");
    }
}

TEST(Validate, ConstantsOfEveryType) {
    StageFixture f;
    std::vector<Value> values;
    const double inf = std::numeric_limits<double>::infinity();
    for (const Type type : numeric_types()) {
        std::vector<double> numbers;
        for (unsigned i = 0; i < type.components(); ++i) numbers.push_back(i % 2);
        values.push_back(f.b.constant(type, numbers));
        values.push_back(f.b.splat_constant(type, 1));
        if (!type.is_floating()) continue;
        for (const double special : {inf, -inf, std::nan(""), -0.0, 1e-30, 65504.0})
            values.push_back(f.b.splat_constant(type, special));
    }
    values.push_back(f.b.constant(kInt, {-2147483648.0}));
    values.push_back(f.b.constant(Type::vector(Scalar::Int, 2), {-2147483648.0, 2147483647.0}));
    values.push_back(f.b.constant(kUint, {4294967295.0}));
    f.finish(values);
    expect_valid(f.module, "constants");
}

TEST(Validate, CompositesAndIndices) {
    StageFixture f;
    std::vector<Value> values;
    const Value index = f.value_of(kInt), unsigned_index = f.value_of(kUint);
    for (const Type type : {kFloat3, Type::matrix(Scalar::Float, 3, 3), Type::vector(Scalar::Half, 2),
                            Type::matrix(Scalar::Float, 2, 2)}) {
        const Value v = f.value_of(type);
        const Type part = part_type(f.module, type, 0);
        values.push_back(f.b.emit(Op::Index, part, {v, index}));
        values.push_back(f.b.emit(Op::Index, part, {v, unsigned_index}));
        values.push_back(f.b.emit(Op::Insert, type, {v, f.value_of(part)}, 1));
        values.push_back(f.b.extract(v, 1));
    }
    f.module.structs.push_back({"Inner", {{"smooth", kFloat}, {"m", Type::matrix(Scalar::Half, 2, 2)}}});
    const Type inner = Type::structure(1), array = f.module.array_of(inner, 2), numbers = f.module.array_of(kFloat3, 2);
    f.module.structs.push_back({"Outer", {{"parts", array}, {"k", numbers}, {"flag", kBool}}});
    const Value parts[] = {f.value_of(kFloat), f.value_of(Type::matrix(Scalar::Half, 2, 2))};
    const Value one = f.b.construct(inner, parts),
                both[] = {one, f.b.emit(Op::Insert, inner, {one, f.b.constant(kFloat, {2})}, 0)};
    const Value vectors[] = {f.value_of(kFloat3), f.b.constant(kFloat3, {1, 2, 3})};
    const Value members[] = {f.b.construct(array, both), f.b.construct(numbers, vectors), f.value_of(kBool)};
    const Value outer = f.b.construct(Type::structure(2), members);
    const Value chosen = f.b.emit(
        Op::Select, Type::structure(2),
        {f.value_of(kBool), outer, f.b.emit(Op::Insert, Type::structure(2), {outer, f.b.constant(kBool, {1})}, 2)});
    values.push_back(f.b.extract(f.b.emit(Op::Index, inner, {f.b.extract(chosen, 0), index}), 0));
    values.push_back(f.b.emit(Op::Index, kFloat3, {f.b.extract(outer, 1), index}));
    values.push_back(f.b.extract(chosen, 2));
    f.finish(values);
    expect_valid(f.module, "composites");
}

TEST(Validate, BuiltinsAndGaps) {
    StageFixture f;
    f.function.params.push_back({"front", kBool});
    f.function.params.push_back({"coord", kFloat4});
    f.function.params.push_back({"id", kInt});
    f.b.emit(Op::DiscardIf, Type::none(), {f.b.param(2)});
    f.finish(std::vector<Value>{f.b.extract(f.b.param(3), 1), f.value_of(kFloat), f.b.param(4)});
    f.module.stage.inputs[1].location = 4;
    f.module.stage.inputs.push_back({.name = "front", .type = kBool, .builtin = Builtin::FrontFacing, .semantic = ""});
    f.module.stage.inputs.push_back({.name = "coord", .type = kFloat4, .builtin = Builtin::FragCoord, .semantic = ""});
    f.module.stage.inputs.push_back({.name = "id", .type = kInt, .location = 6, .semantic = "TEXCOORD6"});
    expect_valid(f.module, "builtins");
    // Both languages must ask for the same locations, because one vertex stage may feed either.
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const std::string text = disassemble(validate(print(f.module, target)).spirv);
        for (const char* location : {"Location 4", "Location 6"})
            EXPECT_NE(text.find(location), std::string::npos) << text;
    }
}

TEST(Validate, BlocksHaveOneLayoutInBothLanguages) {
    StageFixture f;
    const Type array = f.module.array_of(kFloat4, 3), matrix = Type::matrix(Scalar::Float, 4, 4);
    f.module.blocks.push_back({.name = "Material",
                               .size = 176,
                               .members = {{.name = "a", .type = kFloat, .offset = 0},
                                           {.name = "b", .type = kFloat2, .offset = 8, .padding = 1},
                                           {.name = "c", .type = kHalf, .offset = 16},
                                           {.name = "d", .type = kFloat3, .offset = 32, .padding = 3},
                                           {.name = "e", .type = kInt, .offset = 44},
                                           {.name = "f", .type = array, .offset = 48},
                                           {.name = "g", .type = matrix, .offset = 96},
                                           {.name = "h", .type = kBool, .offset = 160}}});
    std::vector<Value> values;
    for (std::uint32_t i = 0; i < 8; ++i) {
        const Type type = f.module.blocks[0].members[i].type;
        f.module.globals.push_back(
            {.name = f.module.blocks[0].members[i].name, .type = type, .block = 0, .member = i, .span = {}});
        values.push_back(f.global(static_cast<std::uint32_t>(f.module.globals.size() - 1)));
    }
    f.finish(values);
    expect_valid(f.module, "blocks");
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const std::string text = disassemble(validate(print(f.module, target)).spirv);
        for (const int offset : {0, 8, 16, 32, 44, 48, 96, 160}) {
            EXPECT_NE(text.find(fmt::format("Offset {}\n", offset)), std::string::npos) << offset << "\n" << text;
        }
    }
}

// --- what does not compile

Shader broken(Target target) {
    Shader shader;
    shader.stage = Stage::Fragment;
    shader.target = target;
    shader.file_name = "broken";
    shader.text = target == Target::Glsl ? "#version 450\nvoid main()\n{\n    float x = nowhere;\n}\n"
                                         : "\nvoid main()\n{\n    float x = nowhere;\n}\n";
    shader.line_map = {{.line = 2, .node = "outer", .file = "a.graph.json", .source_line = 1, .source_text = "{"},
                       {.line = 4,
                        .node = "inner",
                        .file = "a.graph.json",
                        .source_line = 7,
                        .source_column = 3,
                        .source_end_column = 9,
                        .source_text = "the line"},
                       {.line = 5, .node = "", .file = "", .source_text = ""}};
    return shader;
}

TEST(Validate, MessagesLeadBackToTheGraph) {
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const Validated result = validate(broken(target));
        EXPECT_FALSE(result.ok);
        EXPECT_TRUE(result.spirv.empty());
        ASSERT_FALSE(result.diagnostics.empty());
        const Diagnostic& d = result.diagnostics[0];
        EXPECT_EQ(d.severity, Severity::Error);
        EXPECT_EQ(d.code, "downstream-error");
        EXPECT_EQ(d.node, "inner");
        EXPECT_EQ(d.file, "a.graph.json");
        EXPECT_EQ(d.line, 7);
        EXPECT_EQ(d.column, 3);
        EXPECT_EQ(d.end_column, 9);
        EXPECT_EQ(d.source_line, "the line");
        EXPECT_NE(d.message.find("nowhere"), std::string::npos) << d.message;
        ASSERT_EQ(d.notes.size(), 1u);
        EXPECT_NE(d.notes[0].message.find("float x = nowhere;"), std::string::npos) << d.notes[0].message;
        EXPECT_NE(result.log.find("nowhere"), std::string::npos);
    }
}

TEST(Validate, RubbishIsRefused) {
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        for (const std::string& text :
             {std::string(), std::string("\0\xff{", 3), std::string(5000, '('), std::string("ERROR: :")}) {
            Shader shader = broken(target);
            shader.text = text;
            const Validated result = validate(shader);
            EXPECT_FALSE(result.ok);
            EXPECT_FALSE(result.diagnostics.empty());
        }
    }
}

TEST(Validate, ThreadsDoNotDisturbEachOther) {
    StageFixture f;
    f.finish(std::vector<Value>{f.value_of(kFloat)});
    const Shader good = print(f.module, Target::Glsl), bad = broken(Target::Hlsl);
    const std::vector<std::uint32_t> expected = validate(good).spirv;
    std::vector<std::thread> threads;
    std::array<int, 4> right{};
    for (std::size_t i = 0; i < right.size(); ++i) {
        threads.emplace_back([&, i] {
            for (int n = 0; n < 5; ++n) right[i] += validate(good).spirv == expected && !validate(bad).ok;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const int count : right) EXPECT_EQ(count, 5);
}

}  // namespace
}  // namespace patina

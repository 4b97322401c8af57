// Whole stages through the public interface: inputs and outputs by name, bytes of uniform blocks, textures with every
// filter and wrap, and how the level of detail is chosen.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"
#include "compiler/link/program.h"
#include "patina/interpret.h"

using namespace patina;
using namespace patina::ir;

namespace {

using Flat = std::vector<double>;

// A fragment stage with the inputs uv0 and fragCoord, a texture with its sampler, and one output.
struct FragmentStage {
    Program program;
    ir::Module& module;
    Function entry{.name = "main"};
    Builder b;
    Value uv, frag_coord;

    FragmentStage()
        : program{.stages = {{.pass = "forward", .stage = Stage::Fragment, .module = {}}}},
          module(program.stages[0].module),
          b(module, entry, {.fold = false}) {
        entry.params = {{.name = "uv0", .type = kFloat2}, {.name = "fragCoord", .type = kFloat4}};
        module.stage.inputs = {
            {.name = "uv0", .type = kFloat2, .semantic = "TEXCOORD0"},
            {.name = "at", .type = kFloat4, .builtin = Builtin::FragCoord, .semantic = "SV_Position"}};
        module.globals = {
            {.name = "_MainTex", .type = Type::of(Kind::Texture2D), .place = {.set = 1, .slot = 2}, .span = {}},
            {.name = "sampler_MainTex", .type = Type::of(Kind::Sampler), .place = {.set = 1, .slot = 2}, .span = {}}};
        uv = b.param(0);
        frag_coord = b.param(1);
    }

    Value texture() { return b.emit(Op::Global, module.globals[0].type, {}, 0); }
    Value sampler() { return b.emit(Op::Global, module.globals[1].type, {}, 1); }
    Value scalar(double x) { return b.constant(kFloat, {x}); }

    Interpreter finish(Value color, Precision precision = Precision::Double) {
        module.structs.push_back({.name = "Targets", .members = {{"color", b.type(color)}}});
        const Type targets = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
        module.stage.outputs = {{.name = "color", .type = b.type(color), .semantic = "SV_Target0"}};
        entry.result = targets;
        b.ret(b.construct(targets, std::array{color}));
        module.functions.push_back(std::move(entry));
        module.stage.entry = {static_cast<std::uint32_t>(module.functions.size() - 1)};
        EXPECT_EQ(verify(module), "");
        return Interpreter(program, "forward", Stage::Fragment, precision);
    }
};

// A quad whose uv0 begins at (u, v) and grows by the given amounts to the right and down.
QuadInputs quad_at(double u, double v, std::array<double, 2> dx = {}, std::array<double, 2> dy = {}) {
    QuadInputs quad;
    for (std::size_t lane = 0; lane < 4; ++lane) {
        const double x = lane % 2 == 1 ? 1 : 0, y = lane / 2 == 1 ? 1 : 0;
        quad.lanes[lane] = {u + x * dx[0] + y * dy[0], v + x * dx[1] + y * dy[1], 10.5 + x, 20.5 + y, 0.25, 1};
    }
    return quad;
}

TextureLevel level(int width, int height, const std::function<std::array<float, 4>(int, int)>& texel) {
    TextureLevel made{.width = width, .height = height, .texels = {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::array<float, 4> t = texel(x, y);
            made.texels.insert(made.texels.end(), t.begin(), t.end());
        }
    }
    return made;
}

std::shared_ptr<const TextureData> texture(std::vector<TextureLevel> levels, patina::Sampler sampler = {}) {
    return std::make_shared<TextureData>(TextureData{.levels = std::move(levels), .sampler = std::move(sampler)});
}

// 4 x 1 texels of red 1, 2, 4, 8.
std::shared_ptr<const TextureData> powers(Wrap wrap, Filter filter) {
    return texture({level(4, 1,
                          [](int x, int) {
                              return std::array{float(1 << x), 0.0f, 0.0f, 1.0f};
                          })},
                   {.wrap = wrap, .filter = filter});
}

// Every level one colour: its own number in red.
std::shared_ptr<const TextureData> numbered(int size, Filter filter) {
    std::vector<TextureLevel> levels;
    for (int s = size, n = 0; s >= 1; s /= 2, ++n) {
        levels.push_back(level(s, s, [&](int, int) { return std::array{float(n), 0.0f, 0.0f, 1.0f}; }));
    }
    return texture(std::move(levels), {.wrap = Wrap::Repeat, .filter = filter});
}

double red_at_level(std::shared_ptr<const TextureData> data, double u, double v, double lod) {
    FragmentStage stage;
    Interpreter interpreter =
        stage.finish(stage.b.emit(Op::SampleLevel, {stage.texture(), stage.sampler(), stage.uv, stage.scalar(lod)}));
    interpreter.set_texture("_MainTex", std::move(data));
    return interpreter.run(quad_at(u, v)).lanes[0].at(0);
}

}  // namespace

TEST(Interpreter, NamesInputsAndOutputs) {
    FragmentStage stage;
    Interpreter interpreter = stage.finish(stage.b.emit(Op::Add, {stage.frag_coord, stage.frag_coord}));
    ASSERT_EQ(interpreter.inputs().size(), 2u);
    EXPECT_EQ(interpreter.inputs()[0].name, "uv0");
    EXPECT_EQ(interpreter.inputs()[0].components, 2u);
    EXPECT_FALSE(interpreter.inputs()[0].is_builtin);
    EXPECT_EQ(interpreter.inputs()[1].name, "fragCoord");
    EXPECT_TRUE(interpreter.inputs()[1].is_builtin);
    ASSERT_EQ(interpreter.outputs().size(), 1u);
    EXPECT_EQ(interpreter.outputs()[0].name, "color");
    const QuadOutputs out = interpreter.run(quad_at(0, 0));
    EXPECT_EQ(out.lanes[0], (Flat{21, 41, 0.5, 2}));
    EXPECT_EQ(out.lanes[3], (Flat{23, 43, 0.5, 2}));
    EXPECT_EQ(out.discarded, (std::array{false, false, false, false}));
}

TEST(Interpreter, AStageThatIsNotThereGivesNothing) {
    const Program program;
    Interpreter interpreter(program, "forward", Stage::Vertex, Precision::Float);
    interpreter.set_block("Material", {});
    interpreter.set_texture("_MainTex", nullptr);
    EXPECT_TRUE(interpreter.inputs().empty());
    EXPECT_TRUE(interpreter.run({}).lanes[0].empty());
}

TEST(Interpreter, RunsAgainAndAgain) {
    FragmentStage stage;
    Interpreter interpreter = stage.finish(stage.b.emit(Op::Mul, {stage.uv, stage.uv}), Precision::Float);
    EXPECT_EQ(interpreter.run(quad_at(3, 4)).lanes[0], (Flat{9, 16}));
    Interpreter moved = std::move(interpreter);
    EXPECT_EQ(moved.run(quad_at(0.5, 2)).lanes[2], (Flat{0.25, 4}));
    // Inputs are rounded to what the stage could be handed.
    EXPECT_EQ(moved.run(quad_at(16777217, 0)).lanes[0][0], 16777216.0 * 16777216.0);
}

TEST(Interpreter, DiscardMarksALaneAndItGoesOn) {
    FragmentStage stage;
    Builder& b = stage.b;
    const Value u = b.extract(stage.uv, 0);
    b.emit(Op::DiscardIf, Type::none(), {b.emit(Op::Less, {u, stage.scalar(0.5)})});
    Interpreter interpreter = stage.finish(b.emit(Op::Ddx, {u}));
    const QuadOutputs out = interpreter.run(quad_at(0, 0, {1, 0}, {0.25, 0}));
    EXPECT_EQ(out.discarded, (std::array{true, false, true, false}));
    for (const Flat& lane : out.lanes) EXPECT_EQ(lane, Flat{1});
    EXPECT_EQ(interpreter.run(quad_at(1, 0)).discarded, (std::array{false, false, false, false}));
}

// --- uniform blocks

TEST(Interpreter, BlocksAreReadAsStd140) {
    FragmentStage stage;
    ir::Module& module = stage.module;
    const Type matrix = Type::matrix(Scalar::Float, 3, 3), floats = module.array_of(kFloat, 2);
    const Type matrices = module.array_of(Type::matrix(Scalar::Float, 4, 4), 2);
    const std::vector<std::pair<std::uint32_t, Type>> layout = {{0, kFloat3}, {12, kInt},   {16, kUint},    {20, kBool},
                                                                {32, matrix}, {80, floats}, {112, matrices}};
    UniformBlock block{.name = "Material", .size = 240, .members = {}};
    for (const auto& [offset, type] : layout) {
        const auto member = static_cast<std::uint32_t>(block.members.size());
        block.members.push_back({.name = "m", .type = type, .offset = offset});
        module.globals.push_back({.name = "m", .type = type, .block = 0, .member = member, .span = {}});
    }
    module.blocks.push_back(block);

    std::vector<std::byte> bytes(240);
    const auto put = [&](std::size_t offset, auto value) { std::memcpy(bytes.data() + offset, &value, sizeof value); };
    for (int i = 0; i < 3; ++i) put(4 * i, 1.5f + i);
    put(12, std::int32_t{-7});
    put(16, std::uint32_t{4000000000});
    put(20, std::uint32_t{1});
    // The element in row r and column c is 10 r + c.
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) put(32 + 16 * c + 4 * r, float(10 * r + c));
    }
    put(80, 0.25f);
    put(96, 0.75f);
    for (int r = 0; r < 4; ++r) {
        for (int c = 0; c < 4; ++c) put(112 + 64 + 16 * c + 4 * r, float(100 + 10 * r + c));
    }

    Builder& b = stage.b;
    const auto read = [&](std::uint32_t member) { return b.emit(Op::Global, layout[member].second, {}, 2 + member); };
    std::vector<Value> parts = {read(0), read(1), read(2), read(3), read(4), read(5), b.extract(read(6), 1)};
    std::vector<Member> members;
    for (Value part : parts) members.push_back({"m", b.type(part)});
    module.structs.push_back({.name = "All", .members = members});
    Interpreter interpreter = stage.finish(b.construct(Type::structure(0), parts));
    interpreter.set_block("Other", bytes);
    EXPECT_EQ(interpreter.run({}).lanes[0][0], 0);
    interpreter.set_block("Material", bytes);
    const Flat out = interpreter.run({}).lanes[0];
    EXPECT_EQ(Flat(out.begin(), out.begin() + 6), (Flat{1.5, 2.5, 3.5, -7, 4000000000, 1}));
    EXPECT_EQ(Flat(out.begin() + 6, out.begin() + 15), (Flat{0, 1, 2, 10, 11, 12, 20, 21, 22}));
    EXPECT_EQ(Flat(out.begin() + 15, out.begin() + 17), (Flat{0.25, 0.75}));
    EXPECT_EQ(Flat(out.begin() + 17, out.begin() + 23), (Flat{100, 101, 102, 103, 110, 111}));
    // Bytes that are missing read as zero.
    interpreter.set_block("Material", std::span(bytes).first(14));
    EXPECT_EQ(interpreter.run({}).lanes[0][0], 1.5);
    EXPECT_EQ(interpreter.run({}).lanes[0][3], 0);
}

// --- textures

TEST(InterpreterTexture, Wraps) {
    // One step left of the texture, and one to its right.
    const auto outside = [](Wrap wrap) {
        const auto data = powers(wrap, Filter::Nearest);
        return std::pair(red_at_level(data, -0.125, 0.5, 0), red_at_level(data, 1.375, 0.5, 0));
    };
    EXPECT_EQ(outside(Wrap::Repeat), std::pair(8.0, 2.0));
    EXPECT_EQ(outside(Wrap::Clamp), std::pair(1.0, 8.0));
    EXPECT_EQ(outside(Wrap::Mirror), std::pair(1.0, 4.0));
    EXPECT_EQ(red_at_level(powers(Wrap::Mirror, Filter::Nearest), -1.125, 0.5, 0), 8);
    EXPECT_EQ(red_at_level(powers(Wrap::Repeat, Filter::Nearest), 1000.125, 0.5, 0), 1);
    for (double far : {1e30, -1e30, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        const double red = red_at_level(powers(Wrap::Repeat, Filter::Linear), far, far, 0);
        EXPECT_TRUE(red >= 1 && red <= 8) << far;
    }
}

TEST(InterpreterTexture, Filters) {
    EXPECT_EQ(red_at_level(powers(Wrap::Clamp, Filter::Nearest), 0.26, 0.5, 0), 2);
    EXPECT_EQ(red_at_level(powers(Wrap::Clamp, Filter::Linear), 0.125, 0.5, 0), 1);      // the centre of a texel
    EXPECT_EQ(red_at_level(powers(Wrap::Clamp, Filter::Linear), 0.25, 0.5, 0), 1.5);     // the edge of two
    EXPECT_EQ(red_at_level(powers(Wrap::Clamp, Filter::Linear), 0.3125, 0.5, 0), 1.75);  // a quarter of the first
    EXPECT_EQ(red_at_level(powers(Wrap::Clamp, Filter::Linear), 0, 0.5, 0), 1);
    EXPECT_EQ(red_at_level(powers(Wrap::Repeat, Filter::Linear), 0, 0.5, 0), 4.5);
    const auto checker = texture({level(2, 2, [](int x, int y) {
        return std::array{float(10 * y + x), 0.f, 0.f, 1.f};
    })});
    EXPECT_EQ(red_at_level(checker, 0.5, 0.5, 0), 5.5);
    EXPECT_EQ(red_at_level(checker, 0.25, 0.75, 0), 10);
}

TEST(InterpreterTexture, ExplicitLevels) {
    const auto linear = numbered(8, Filter::Linear), nearest = numbered(8, Filter::Nearest);
    EXPECT_EQ(red_at_level(linear, 0.5, 0.5, 1.25), 1.25);
    EXPECT_EQ(red_at_level(linear, 0.5, 0.5, -2), 0);
    EXPECT_EQ(red_at_level(linear, 0.5, 0.5, 99), 3);
    EXPECT_EQ(red_at_level(linear, 0.5, 0.5, std::nan("")), 0);
    EXPECT_EQ(red_at_level(nearest, 0.5, 0.5, 1.4), 1);
    EXPECT_EQ(red_at_level(nearest, 0.5, 0.5, 1.6), 2);
    EXPECT_EQ(red_at_level(nearest, 0.5, 0.5, 99), 3);
}

TEST(InterpreterTexture, TheQuadChoosesTheLevel) {
    const auto red = [](Op op, std::vector<double> more, std::array<double, 2> dx, std::array<double, 2> dy) {
        FragmentStage stage;
        std::vector<Value> args = {stage.texture(), stage.sampler(), stage.uv};
        if (op == Op::SampleGrad) {
            args.push_back(stage.b.constant(kFloat2, {more[0], more[1]}));
            args.push_back(stage.b.constant(kFloat2, {more[2], more[3]}));
        } else if (!more.empty()) {
            args.push_back(stage.scalar(more[0]));
        }
        Interpreter interpreter = stage.finish(stage.b.emit(op, kFloat4, args));
        interpreter.set_texture("_MainTex", numbered(16, Filter::Linear));
        const QuadOutputs out = interpreter.run(quad_at(0.3, 0.6, dx, dy));
        for (const Flat& lane : out.lanes) EXPECT_EQ(lane[0], out.lanes[0][0]);
        return out.lanes[0][0];
    };
    const double texel = 1.0 / 16;
    // log2 of the longer side of the footprint, in texels.
    EXPECT_NEAR(red(Op::Sample, {}, {texel, 0}, {0, texel}), 0, 1e-12);
    EXPECT_NEAR(red(Op::Sample, {}, {4 * texel, 0}, {0, texel}), 2, 1e-12);
    EXPECT_NEAR(red(Op::Sample, {}, {0, texel}, {3 * texel, 4 * texel}), std::log2(5), 1e-12);
    EXPECT_NEAR(red(Op::Sample, {}, {}, {}), 0, 0);
    EXPECT_NEAR(red(Op::SampleBias, {0.5}, {2 * texel, 0}, {0, texel}), 1.5, 1e-12);
    EXPECT_NEAR(red(Op::SampleBias, {-5}, {2 * texel, 0}, {0, texel}), 0, 1e-12);
    EXPECT_NEAR(red(Op::SampleGrad, {0, 8 * texel, texel, 0}, {}, {}), 3, 1e-12);
}

TEST(InterpreterTexture, LoadAndSize) {
    const auto load = [](double x, double y, double lod) {
        FragmentStage stage;
        Builder& b = stage.b;
        const Value at = b.constant(Type::vector(Scalar::Int, 2), {x, y}), lod_value = b.constant(kInt, {lod});
        const Value size = b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {stage.texture(), lod_value});
        const Value texel = b.emit(Op::TexelLoad, {stage.texture(), at, lod_value});
        const Value both =
            b.construct(kFloat4, std::array{b.extract(texel, 0), b.extract(texel, 3), b.convert(size, Scalar::Float)});
        Interpreter interpreter = stage.finish(both);
        interpreter.set_texture("_MainTex", texture({level(4, 2,
                                                           [](int u, int v) {
                                                               return std::array{float(u + 10 * v), 0.f, 0.f, 1.f};
                                                           }),
                                                     level(2, 1, [](int u, int) {
                                                         return std::array{float(100 + u), 0.f, 0.f, 1.f};
                                                     })}));
        return interpreter.run({}).lanes[1];
    };
    EXPECT_EQ(load(3, 1, 0), (Flat{13, 1, 4, 2}));
    EXPECT_EQ(load(1, 0, 1), (Flat{101, 1, 2, 1}));
    EXPECT_EQ(load(4, 0, 0), (Flat{0, 0, 4, 2}));
    EXPECT_EQ(load(0, -1, 0), (Flat{0, 0, 4, 2}));
    EXPECT_EQ(load(0, 0, 2), (Flat{0, 0, 0, 0}));
    EXPECT_EQ(load(0, 0, -1), (Flat{0, 0, 0, 0}));
}

TEST(InterpreterTexture, WhatIsNotBoundIsWhite) {
    FragmentStage stage;
    Builder& b = stage.b;
    const Value size = b.emit(Op::TextureSize, Type::vector(Scalar::Int, 2), {stage.texture(), b.constant(kInt, {0})});
    const Value sampled = b.emit(Op::Sample, {stage.texture(), stage.sampler(), stage.uv});
    const Value sum = b.emit(Op::Add, {b.swizzle(sampled, std::array{0u, 3u}), b.convert(size, Scalar::Float)});
    Interpreter interpreter = stage.finish(sum);
    EXPECT_EQ(interpreter.run(quad_at(0, 0)).lanes[0], (Flat{2, 2}));
    // Data that does not hold its texels is as good as none.
    interpreter.set_texture("_MainTex", texture({{.width = 4, .height = 4, .texels = {1, 2}}}));
    EXPECT_EQ(interpreter.run(quad_at(0, 0)).lanes[0], (Flat{2, 2}));
    interpreter.set_texture("_MainTex", texture({}));
    EXPECT_EQ(interpreter.run(quad_at(0, 0)).lanes[0], (Flat{2, 2}));
}

TEST(InterpreterTexture, AnyTextureMayBeReadByAnySampler) {
    FragmentStage stage;
    stage.module.globals.push_back(
        {.name = "_Mask", .type = Type::of(Kind::Texture2D), .place = {.set = 1, .slot = 3}, .span = {}});
    stage.module.globals.push_back(
        {.name = "sampler_Mask", .type = Type::of(Kind::Sampler), .place = {.set = 1, .slot = 3}, .span = {}});
    Builder& b = stage.b;
    const Value mask_sampler = b.emit(Op::Global, Type::of(Kind::Sampler), {}, 3);
    const auto read = [&](Value sampler) {
        return b.extract(b.emit(Op::SampleLevel, {stage.texture(), sampler, stage.uv, stage.scalar(0)}), 0);
    };
    Interpreter interpreter = stage.finish(b.construct(kFloat2, std::array{read(stage.sampler()), read(mask_sampler)}));
    interpreter.set_texture("_MainTex", powers(Wrap::Repeat, Filter::Nearest));
    interpreter.set_texture("_Mask", powers(Wrap::Clamp, Filter::Nearest));
    EXPECT_EQ(interpreter.run(quad_at(-0.125, 0.5)).lanes[0], (Flat{8, 1}));
}

// --- cubes. Expected texels are worked out from the table in Vulkan's "Cube Map Face Selection".

// Red is 100 for each face, 10 for each row and 1 for each column.
std::shared_ptr<const TextureData> counted_cube(int size, Filter filter) {
    TextureLevel texels{.width = size, .height = size, .texels = {}};
    for (int face = 0; face < 6; ++face) {
        const TextureLevel side = level(size, size, [&](int x, int y) {
            return std::array{float(100 * face + 10 * y + x), 0.0f, 0.0f, 1.0f};
        });
        texels.texels.insert(texels.texels.end(), side.texels.begin(), side.texels.end());
    }
    return std::make_shared<TextureData>(TextureData{.levels = {texels}, .sampler = {.filter = filter}, .layers = 6});
}

std::shared_ptr<const TextureData> numbered_cube(int size, Filter filter) {
    TextureData cube = *numbered(size, filter);
    cube.layers = 6;
    for (TextureLevel& one : cube.levels) {
        const std::vector<float> side = one.texels;
        for (int face = 1; face < 6; ++face) one.texels.insert(one.texels.end(), side.begin(), side.end());
    }
    return std::make_shared<TextureData>(std::move(cube));
}

double red_of_cube(std::shared_ptr<const TextureData> data, std::array<double, 3> direction, double lod = 0) {
    FragmentStage stage;
    stage.module.globals[0].type = Type::of(Kind::TextureCube);
    const Value way = stage.b.constant(kFloat3, {direction[0], direction[1], direction[2]});
    Interpreter interpreter =
        stage.finish(stage.b.emit(Op::SampleLevel, {stage.texture(), stage.sampler(), way, stage.scalar(lod)}));
    interpreter.set_texture("_MainTex", std::move(data));
    return interpreter.run(quad_at(0, 0)).lanes[3].at(0);
}

TEST(InterpreterCube, ADirectionChoosesAFaceAndATexel) {
    const auto cube = counted_cube(4, Filter::Nearest);
    EXPECT_EQ(red_of_cube(cube, {2, -0.5, 1.5}), 20);    // +X: s -z, t -y
    EXPECT_EQ(red_of_cube(cube, {-2, -0.5, 1.5}), 123);  // -X: s z, t -y
    EXPECT_EQ(red_of_cube(cube, {0.5, 2, 1.5}), 232);    // +Y: s x, t z
    EXPECT_EQ(red_of_cube(cube, {0.5, -2, 1.5}), 302);   // -Y: s x, t -z
    EXPECT_EQ(red_of_cube(cube, {0.5, 1.5, 2}), 402);    // +Z: s x, t -y
    EXPECT_EQ(red_of_cube(cube, {0.5, 1.5, -2}), 501);   // -Z: s -x, t -y
    // Of any length, and with one at the very edge.
    EXPECT_EQ(red_of_cube(cube, {2e-6, -0.5e-6, 1.5e-6}), 20);
    EXPECT_EQ(red_of_cube(cube, {0.5e8, 1.5e8, -2e8}), 501);
    // Ties: z wins over y, and y over x.
    EXPECT_EQ(red_of_cube(cube, {1, 1, 1}), 403);
    EXPECT_EQ(red_of_cube(cube, {1, 0.5, 1}), 413);
    EXPECT_EQ(red_of_cube(cube, {1, 1, 0.5}), 233);
    EXPECT_EQ(red_of_cube(cube, {-1, -1, -1}), 533);
}

// Two texels a side: a texel's middle is at 0.5 or -0.5 of the face's half, a quarter of a texel from the edge at 0.75.
TEST(InterpreterCube, FiltersOverItsEdges) {
    const auto cube = counted_cube(2, Filter::Linear);
    EXPECT_EQ(red_of_cube(cube, {0.5, 0.5, 1}), 401);  // the middle of a texel
    EXPECT_EQ(red_of_cube(cube, {0, 0, 1}), 405.5);    // the middle of a face
    EXPECT_EQ(red_of_cube(cube, {1, 0.5, 1}), 200.5);  // half of +Z's (1, 0), half of +X's (0, 0)
    EXPECT_EQ(red_of_cube(cube, {0.75, 0.5, 1}), 0.75 * 401 + 0.25 * 0);
    EXPECT_EQ(red_of_cube(cube, {1, 0.5, 0.75}), 0.75 * 0 + 0.25 * 401);
    // Where the neighbour's rows run the other way: +Y's (1, 0) and +X's (1, 0); -Y's (0, 1) and -Z's (1, 1).
    EXPECT_EQ(red_of_cube(cube, {1, 1, -0.5}), (201 + 1) / 2.0);
    EXPECT_EQ(red_of_cube(cube, {-0.5, -1, -1}), (310 + 511) / 2.0);
    EXPECT_EQ(red_of_cube(cube, {-0.5, -1, -0.75}), 0.75 * 310 + 0.25 * 511);
    // -X's (0, 1) and -Z's (1, 1): the far side of the cube.
    EXPECT_EQ(red_of_cube(cube, {-1, -0.5, -1}), (110 + 511) / 2.0);
}

// Three texels meet at a corner: +Z's (1, 0), +X's (0, 0) and +Y's (1, 1). The fourth is their mean.
TEST(InterpreterCube, FiltersAtItsCorners) {
    const auto cube = counted_cube(2, Filter::Linear);
    const double sum = 401 + 0 + 211;
    EXPECT_NEAR(red_of_cube(cube, {1, 1, 1}), sum / 3, 1e-12);
    // A quarter of a texel from both edges.
    EXPECT_NEAR(red_of_cube(cube, {0.75, 0.75, 1}), 0.5625 * 401 + 0.1875 * (0 + 211) + 0.0625 * sum / 3, 1e-12);
    EXPECT_NEAR(red_of_cube(cube, {1, 0.75, 0.75}), 0.5625 * 0 + 0.1875 * (401 + 211) + 0.0625 * sum / 3, 1e-12);
    // -X's (0, 1), -Y's (0, 1) and -Z's (1, 1).
    EXPECT_NEAR(red_of_cube(cube, {-1, -1, -1}), (110 + 310 + 511) / 3.0, 1e-12);
    // A face of one texel is all corners.
    EXPECT_NEAR(red_of_cube(counted_cube(1, Filter::Linear), {1, 1, 1}), (400 + 0 + 200) / 3.0, 1e-12);
}

TEST(InterpreterCube, Levels) {
    const auto linear = numbered_cube(8, Filter::Linear), nearest = numbered_cube(8, Filter::Nearest);
    EXPECT_EQ(red_of_cube(linear, {1, 2, 3}, 1.25), 1.25);
    EXPECT_EQ(red_of_cube(linear, {1, 2, 3}, -2), 0);
    EXPECT_NEAR(red_of_cube(linear, {1, 2, 3}, 99), 3, 1e-12);
    EXPECT_EQ(red_of_cube(linear, {1, 2, 3}, std::nan("")), 0);
    EXPECT_EQ(red_of_cube(nearest, {1, 2, 3}, 1.4), 1);
    EXPECT_EQ(red_of_cube(nearest, {1, 2, 3}, 1.6), 2);

    // On +Z, 16 texels a side: a step of 1/8 across is one texel. With a depth of 2 the step is half as long there.
    const auto red = [](Op op, double depth, std::array<double, 2> dx, std::array<double, 2> dy) {
        FragmentStage stage;
        Builder& b = stage.b;
        stage.module.globals[0].type = Type::of(Kind::TextureCube);
        const Value way = b.construct(kFloat3, std::array{stage.uv, stage.scalar(depth)});
        std::vector<Value> args = {stage.texture(), stage.sampler(), way};
        if (op == Op::SampleBias) args.push_back(stage.scalar(0.5));
        if (op == Op::SampleGrad) {
            args.push_back(b.constant(kFloat3, {0, 0, dx[0]}));
            args.push_back(b.constant(kFloat3, {dy[0], dy[1], 0}));
        }
        Interpreter interpreter = stage.finish(b.emit(op, kFloat4, args));
        interpreter.set_texture("_MainTex", numbered_cube(16, Filter::Linear));
        return interpreter.run(quad_at(-0.5, 0.125, dx, dy)).lanes[0].at(0);
    };
    const double texel = 0.125;
    EXPECT_NEAR(red(Op::Sample, 1, {texel, 0}, {0, texel}), 0, 1e-12);
    EXPECT_NEAR(red(Op::Sample, 1, {4 * texel, 0}, {0, texel}), 2, 1e-12);
    EXPECT_NEAR(red(Op::Sample, 2, {4 * texel, 0}, {0, texel}), 1, 1e-12);
    EXPECT_NEAR(red(Op::SampleBias, 1, {0, 2 * texel}, {texel, 0}), 1.5, 1e-12);
    EXPECT_NEAR(red(Op::SampleGrad, 1, {0, 0}, {3 * texel, 4 * texel}), std::log2(5), 1e-12);
    // Away by 1/2 of the depth: the place, 4 texels and 1 from the middle, moves towards it by half of that.
    EXPECT_NEAR(red(Op::SampleGrad, 1, {0.5, 0}, {0, 0}), std::log2(std::hypot(2, 0.5)), 1e-12);
}

TEST(InterpreterCube, WhatIsNoCubeIsWhite) {
    EXPECT_EQ(red_of_cube(nullptr, {0, 0, 1}), 1);
    EXPECT_EQ(red_of_cube(numbered(8, Filter::Linear), {0, 0, 1}, 2), 1);
    // And there is nothing in the direction of nothing.
    EXPECT_EQ(red_of_cube(numbered_cube(8, Filter::Linear), {0, 0, 0}, 2), 0);
    EXPECT_EQ(red_of_cube(numbered_cube(8, Filter::Linear), {std::nan(""), 1, 0}, 2), 0);
}

// The language's Texture2D: a struct of texture, sampler and numbers, handed to a function.
TEST(InterpreterTexture, TexturesTravelInStructs) {
    FragmentStage stage;
    ir::Module& module = stage.module;
    module.structs.push_back({.name = "Texture2D",
                              .members = {{"texture", Type::of(Kind::Texture2D)},
                                          {"sampler", Type::of(Kind::Sampler)},
                                          {"texelSize", kFloat4},
                                          {"tiling", kFloat4}}});
    const Type bundle = Type::structure(0);
    Function read{.name = "read", .params = {{.name = "t", .type = bundle}, {.name = "uv", .type = kFloat2}}};
    {
        Builder b(module, read, {.fold = false});
        const Value t = b.param(0), tiling = b.extract(t, 3);
        const Value uv = b.emit(Op::Mul, {b.param(1), b.swizzle(tiling, std::array{0u, 1u})});
        read.result = kFloat4;
        b.ret(b.emit(Op::SampleLevel, {b.extract(t, 0), b.extract(t, 1), uv, b.constant(kFloat, {0})}));
    }
    module.functions.push_back(read);
    Builder& b = stage.b;
    const Value made = b.construct(bundle, std::array{stage.texture(), stage.sampler(), b.splat_constant(kFloat4, 0),
                                                      b.constant(kFloat4, {2, 1, 0, 0})});
    Interpreter interpreter = stage.finish(b.call(FunctionId{0}, std::array{made, stage.uv}));
    interpreter.set_texture("_MainTex", powers(Wrap::Repeat, Filter::Nearest));
    EXPECT_EQ(interpreter.run(quad_at(0.3125, 0.5)).lanes[0], (Flat{4, 0, 0, 1}));
}

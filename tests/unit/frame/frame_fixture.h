// A material whose stages are written by hand twice, as GLSL for the GPU and as IR for the CPU, so that a fault of the
// compiler cannot hide a fault of the runtime. Its vertices are in clip space; its fragment stage writes constants, and
// may add what a target held before to the first of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <span>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"
#include "compiler/link/program.h"
#include "patina/validate.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/gpu/renderer.h"

namespace patina::runtime {

inline std::vector<std::uint32_t> spirv_of(Stage stage, const std::string& text) {
    Shader shader;
    shader.stage = stage;
    shader.text = text;
    Validated validated = validate(shader);
    EXPECT_TRUE(validated.ok) << validated.log;
    return validated.spirv;
}

// Member i of the block Colors is what goes to target i.
inline std::string fragment_text(unsigned outputs, bool reads) {
    std::string text = "#version 450\nlayout(set = 1, binding = 0) uniform Colors { vec4 colors[8]; };\n";
    if (reads)
        text +=
            "layout(set = 2, binding = 0) uniform texture2D earlier;\n"
            "layout(set = 2, binding = 1) uniform sampler sampler_earlier;\n";
    for (unsigned i = 0; i < outputs; i++)
        text += "layout(location = " + std::to_string(i) + ") out vec4 out" + std::to_string(i) + ";\n";
    text += "void main() {\n";
    for (unsigned i = 0; i < outputs; i++)
        text +=
            "out" + std::to_string(i) + " = colors[" + std::to_string(i) + "]" +
            (reads && i == 0 ? " + texelFetch(sampler2D(earlier, sampler_earlier), ivec2(gl_FragCoord.xy), 0)" : "") +
            ";\n";
    return text + "}\n";
}

inline void finish_stage(ir::Module& module, ir::Function& entry, ir::Builder& b,
                         const std::vector<ir::Value>& values) {
    std::vector<ir::Member> members;
    for (ir::Value value : values) members.push_back({"m", b.type(value)});
    if (!values.empty()) {
        module.structs.push_back({.name = "Outputs", .members = members});
        entry.result = ir::Type::structure(0);
        b.ret(b.construct(entry.result, values));
    } else {
        b.ret({});
    }
    module.functions.push_back(std::move(entry));
    module.stage.entry = {0};
    EXPECT_EQ(ir::verify(module), "");
}

inline ir::Module vertex_module() {
    using namespace ir;
    Module module;
    Function entry{.name = "main"};
    entry.params = {{.name = "positionOS", .type = kFloat3}};
    module.stage.inputs = {{.name = "positionOS", .type = kFloat3, .semantic = "POSITION"}};
    module.stage.outputs = {
        {.name = "position", .type = kFloat4, .builtin = Builtin::Position, .semantic = "SV_Position"}};
    Builder b(module, entry, {.fold = false});
    const Value position = b.construct(kFloat4, std::array{b.param(0), b.constant(kFloat, {1})});
    finish_stage(module, entry, b, {position});
    return module;
}

inline ir::Module fragment_module(unsigned outputs, bool reads) {
    using namespace ir;
    Module module;
    Function entry{.name = "main"};
    if (reads) {
        entry.params = {{.name = "at", .type = kFloat4}};
        module.stage.inputs = {
            {.name = "at", .type = kFloat4, .builtin = Builtin::FragCoord, .semantic = "SV_Position"}};
        module.globals = {
            {.name = "earlier", .type = Type::of(Kind::Texture2D), .place = {.set = 2}, .span = {}},
            {.name = "sampler_earlier", .type = Type::of(Kind::Sampler), .place = {.set = 2}, .span = {}}};
    }
    const auto first = std::uint32_t(module.globals.size());
    UniformBlock block{.name = "Colors", .place = {.set = 1}, .size = 128, .members = {}};
    for (std::uint32_t i = 0; i < 8; i++) {
        block.members.push_back({.name = "m", .type = kFloat4, .offset = 16 * i});
        module.globals.push_back({.name = "m", .type = kFloat4, .block = 0, .member = i, .span = {}});
    }
    module.blocks.push_back(block);
    Builder b(module, entry, {.fold = false});
    std::vector<Value> values;
    for (std::uint32_t i = 0; i < outputs; i++) {
        Value value = b.emit(Op::Global, kFloat4, {}, first + i);
        if (reads && i == 0) {
            const Value texture = b.emit(Op::Global, module.globals[0].type, {}, 0);
            const Value texel = b.convert(b.swizzle(b.param(0), std::array{0u, 1u}), Scalar::Int);
            value = b.emit(Op::Add, {value, b.emit(Op::TexelLoad, {texture, texel, b.constant(kInt, {0})})});
        }
        values.push_back(value);
        module.stage.outputs.push_back({.name = "out" + std::to_string(i), .type = kFloat4, .semantic = "SV_Target"});
    }
    finish_stage(module, entry, b, values);
    return module;
}

struct HandMaterial {
    Reflection reflection;
    Program program;
    std::vector<std::uint32_t> vertex, fragment;

    Pass& pass() { return reflection.passes.front(); }
};

// Draws both sides, with every depth passing and none written.
inline HandMaterial hand_material(unsigned outputs, bool reads = false) {
    HandMaterial made;
    Block block;
    block.name = "Colors";
    block.set = 1;
    block.size = 128;
    made.reflection.blocks = {block};
    Pass pass;
    pass.name = "hand";
    pass.cull = Cull::Off;
    pass.depth_test = Compare::Always;
    pass.depth_write = false;
    for (std::uint32_t i = 0; i < outputs; i++)
        pass.targets.push_back({.name = "t" + std::to_string(i), .location = i});
    pass.vertex_inputs = {{"positionOS", ValueType::Float3, 0, ""}};
    if (reads) {
        Texture texture;
        texture.name = "earlier";
        texture.is_material = false;
        texture.set = 2;
        texture.binding = 0;
        texture.sampler_binding = 1;
        made.reflection.textures = {texture};
        pass.textures = {"earlier"};
    }
    made.reflection.passes = {pass};
    made.program.stages = {{.pass = "hand", .stage = Stage::Vertex, .module = vertex_module()},
                           {.pass = "hand", .stage = Stage::Fragment, .module = fragment_module(outputs, reads)}};
    made.vertex = spirv_of(Stage::Vertex, R"(#version 450
        layout(location = 0) in vec3 positionOS;
        void main() { gl_Position = vec4(positionOS, 1); })");
    made.fragment = spirv_of(Stage::Fragment, fragment_text(outputs, reads));
    return made;
}

// A step that fills the block with `colors`.
inline FrameStep hand_step(const HandMaterial& material, const Mesh& mesh, const std::vector<glm::vec4>& colors,
                           std::vector<std::size_t> targets, int depth = -1) {
    BlockBytes block{.name = "Colors", .bytes = std::vector<std::byte>(128)};
    const auto bytes = std::as_bytes(std::span(colors));
    std::copy(bytes.begin(), bytes.end(), block.bytes.begin());
    return {
        .reflection = &material.reflection,
        .pass = &material.reflection.passes.front(),
        .stages = {.vertex_spirv = material.vertex, .fragment_spirv = material.fragment, .program = &material.program},
        .mesh = &mesh,
        .blocks = {block},
        .targets = std::move(targets),
        .depth = depth};
}

// The part of clip space from `left` to `right`, whose depth goes from `near_left` to `near_right`.
inline Mesh clip_quad(float left = -1, float right = 1, float depth_left = 0.5f, float depth_right = 0.5f) {
    Mesh mesh;
    for (float y : {-1.0f, 1.0f}) {
        mesh.vertices.push_back({.position = {left, y, depth_left}, .normal = {}, .tangent = {}, .uv0 = {}});
        mesh.vertices.push_back({.position = {right, y, depth_right}, .normal = {}, .tangent = {}, .uv0 = {}});
    }
    mesh.indices = {0, 1, 3, 0, 3, 2};
    return mesh;
}

}  // namespace patina::runtime

// Materials made by hand: reflections that state passes, with the blocks whose contents tests want to see, and a world
// of small spheres. No shader is compiled: a plan never looks into one.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <deque>

#include "runtime/frame/frame_plan.h"

namespace patina::runtime {

inline BlockMember member(const std::string& name, const std::string& type, std::uint32_t offset,
                          std::uint32_t count = 0) {
    std::uint32_t size = type == "float4x4" ? 64 : type == "float4" ? 16 : 4;
    return {.name = name,
            .type = *from_word<ValueType>(type),
            .offset = offset,
            .size = size * std::max(count, 1u),
            .array_count = count,
            .array_stride = count ? size : 0};
}

inline Reflection reflection_of(std::string path, std::vector<Pass> passes) {
    Reflection reflection;
    reflection.path = std::move(path);
    reflection.passes = std::move(passes);
    auto add_block = [&](const std::string& name, std::uint32_t size, std::vector<BlockMember> members) {
        Block& block = reflection.blocks.emplace_back();
        block.name = name;
        block.size = size;
        block.members = std::move(members);
    };
    add_block("Lights", 800,
              {member("lightCount", "int", 0), member("shadowTexel", "float", 4),
               member("lightPosition", "float4", 16, 16), member("lightCone", "float4", 272, 16),
               member("lightAxis", "float4", 528, 16), member("shadowStrength", "float4", 784)});
    add_block("VertexLights", 272, {member("vertexLightCount", "float", 0), member("lightColor", "float4", 16, 16)});
    add_block("Camera", 80,
              {member("worldToClip", "float4x4", 0), member("shadowBias", "float", 64),
               member("viewIsOrthographic", "float", 68)});
    add_block("Object", 80, {member("objectToWorld", "float4x4", 0), member("lightmapDecode", "float4", 64)});
    add_block("Ambient", 144, {member("ambientSH", "float4", 0, 9)});
    add_block("Material", 16, {});
    reflection.blocks.back().is_material = true;
    return reflection;
}

// A member of a step's blocks as the shader would read it.
inline std::vector<float> value(const FrameStep& step, const std::string& name) {
    for (std::size_t b = 0; b < step.blocks.size(); b++)
        for (const BlockMember& m : step.reflection->blocks[b].members) {
            if (m.name != name) continue;
            std::vector<float> numbers(m.size / 4);
            for (std::size_t i = 0; i < numbers.size(); i++) {
                const std::byte* at = &step.blocks[b].bytes[m.offset + 4 * i];
                std::int32_t whole = 0;
                std::memcpy(&whole, at, 4);
                std::memcpy(&numbers[i], at, 4);
                if (m.type == ValueType::Int) numbers[i] = float(whole);
            }
            return numbers;
        }
    ADD_FAILURE() << "no member " << name;
    return {};
}

// The true indices of the lights that a step sees, slot by slot.
inline std::vector<int> lights_seen(const FrameStep& step) {
    std::vector<int> lights;
    for (int i = 0; i < int(value(step, "lightCount")[0]); i++)
        lights.push_back(int(value(step, "lightCone")[std::size_t(4 * i + 2)]));
    return lights;
}

// A world that grows as a test says what is in it.
struct Stage {
    World world{};
    std::deque<Reflection> reflections{};
    std::vector<DrawnMaterial> materials{};
    FrameOptions options{};

    // `shaders`: one for each pass; lighting passes with different ones differ, missing ones are equal.
    std::size_t add_material(Reflection reflection, std::map<std::string, std::string> shaders = {}) {
        static std::deque<std::string> texts;
        DrawnMaterial made{.reflection = &reflections.emplace_back(std::move(reflection))};
        for (const Pass& pass : made.reflection->passes)
            made.passes[pass.name] = {.fragment = texts.emplace_back("shader " + shaders[pass.name])};
        materials.push_back(std::move(made));
        world.materials.push_back({.name = "material " + std::to_string(materials.size() - 1)});
        return materials.size() - 1;
    }

    // A ball of radius 1, scaled.
    void add_object(std::size_t material, glm::vec3 position = glm::vec3(0), float scale = 1) {
        glm::mat4 matrix(scale);
        matrix[3] = glm::vec4(position, 1);
        world.objects.push_back({.name = "object " + std::to_string(world.objects.size()),
                                 .mesh = std::make_shared<const Mesh>(make_sphere(1, 12, 6)),
                                 .object_to_world = matrix,
                                 .material = material});
    }

    Frame plan() {
        Outcome<Frame> frame = plan_frame(world, materials, options);
        EXPECT_EQ(frame.error, "");
        return std::move(frame.value);
    }
    std::string error() { return plan_frame(world, materials, options).error; }

    // "forward 0 | forward 1": the pass of each step and the number of the object, or what is drawn instead.
    std::string story(const Frame& frame) const {
        std::string text;
        for (const FrameStep& step : frame.steps) {
            std::string what = step.pass->draws == PassDraws::Fullscreen ? "screen" : "volume";
            for (std::size_t i = 0; i < world.objects.size(); i++)
                if (world.objects[i].mesh.get() == step.mesh) what = std::to_string(i);
            text += (text.empty() ? "" : " | ") + step.pass->name + " " + what;
        }
        return text;
    }
    std::string story() { return story(plan()); }
};

inline Light point_light(glm::vec3 position, float range = 20) {
    return {.kind = LightKind::Point, .position = position, .range = range};
}

inline RenderTarget target_of(const std::string& name, TargetFormat format = TargetFormat::Rgba16F) {
    RenderTarget target;
    target.name = name;
    target.format = format;
    return target;
}

inline Pass forward_pass(int queue = 2000) {
    Pass pass;
    pass.name = "forward";
    pass.queue = queue;
    pass.targets = {target_of("color")};
    pass.blocks = {"Lights", "Camera", "Object", "Ambient", "Material"};
    return pass;
}

// Of the engine, or a target that is read.
inline Texture texture_of(const std::string& name, const std::string& reads = "") {
    Texture texture;
    texture.name = name;
    texture.dimension = TextureDimension::Flat;
    texture.is_material = false;
    texture.reads = reads;
    return texture;
}

using Ints = std::vector<int>;

// The frame's target of that name; null if there is none.
inline const FrameTarget* target(const Frame& frame, const std::string& name) {
    for (const FrameTarget& each : frame.targets)
        if (each.name == name) return &each;
    return nullptr;
}

}  // namespace patina::runtime

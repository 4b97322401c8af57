// Builds the targets and steps of a frame from a plan (frame_plan.h): formats and sizes of targets, the bytes of
// blocks, textures, and the inputs of each step. It owns everything that steps point to.
//
//   FrameBuilder builder(world, materials, options);
//   std::string error = builder.make_targets(used, true);
//   builder.add({.material = 0, .pass = &pass, .mesh = &mesh, .seen = {...}});
//   Frame frame = std::move(builder).frame();
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "runtime/frame/frame_plan.h"
#include "runtime/values/engine_values.h"

namespace patina::runtime {

// The pass draws from lights into their shadow maps.
bool is_shadow_pass(const Pass& pass);

bool reads_texture(const Pass& pass, const Texture& texture);

// A step before its blocks are filled.
struct PlannedStep {
    std::size_t material = 0;
    const Pass* pass = nullptr;
    const Mesh* mesh = nullptr;
    EngineScene seen{};
    std::optional<std::size_t> object{};  // of the world, if one is drawn
    std::size_t first_instance = 0;       // of the object
    PixelArea area{};
    int group = 0;  // the stencil's reference
};

class FrameBuilder {
public:
    FrameBuilder(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options);

    // All targets that passes of these materials draw into or read. The picture's targets have its size, samples
    // included. Those of shadow passes are an atlas. A target is a single texel if nothing casts a shadow, or if a pass
    // reads it and no pass draws into it. Returns what is wrong, or nothing.
    std::string make_targets(std::span<const std::size_t> used, bool has_shadows);

    void add(PlannedStep step);
    const Mesh* keep(Mesh mesh);
    Frame frame() &&;

private:
    struct Kept {
        std::deque<Mesh> meshes{};
        std::deque<std::vector<LoadedTexture>> textures{};
    };

    TargetFormat format_of(const std::string& target, TargetFormat stated) const;
    float farthest_of(const Pass& pass) const;
    std::string add_target(const std::string& material, const Pass& pass, const std::string& name, TargetFormat stated,
                           int atlas_size);
    bool changes_owner(const Stencil& stencil);
    std::optional<std::size_t> find_target(const std::string& name) const;
    std::span<const LoadedTexture> textures_of(const PlannedStep& step);
    bool has_own(const PlannedStep& step, std::string_view texture) const;

    const World& world_;
    std::span<const DrawnMaterial> materials_;
    const FrameOptions& options_;
    Frame frame_{};
    bool shown_has_format_ = false;  // else the first pass that draws into it says which
    enum class StencilOwner { Nobody, Lighting, Materials } stencil_owner_ = StencilOwner::Nobody;
    std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

}  // namespace patina::runtime

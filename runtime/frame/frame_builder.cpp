#include "runtime/frame/frame_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace patina::runtime {
namespace {

constexpr std::string_view kShown = "color";

const LoadedTexture* find_texture(std::span<const LoadedTexture> textures, std::string_view name) {
    auto found = std::find_if(textures.begin(), textures.end(), [&](const auto& t) { return t.name == name; });
    return found == textures.end() ? nullptr : &*found;
}

// The instructions of DecodeHDR (nodes/lighting/ambient.node.hlsl): factor, exponent of alpha, and whether alpha
// counts. The ranges are those of gamma space, 2 and 5, in linear light.
glm::vec4 lightmap_decode(LightmapEncoding encoding) {
    switch (encoding) {
        case LightmapEncoding::Hdr: return {1, 1, 0, 0};
        case LightmapEncoding::Rgbm: return {std::pow(5.0, 2.2), 2.2f, 0, 1};
        case LightmapEncoding::DoubleLdr: return {std::pow(2.0, 2.2), 1, 0, 0};
    }
    return {1, 1, 0, 0};
}

// The probe whose map the engine's texture is; null: it is the surroundings, or something else.
const Probe* probe_of(std::string_view texture, const ProbeChoice& probes) {
    if (texture == "probeMap") return probes.first;
    return texture == "environmentMap" ? probes.second : nullptr;
}

std::shared_ptr<const TextureData> white_texture() {
    static const auto kWhite =
        std::make_shared<const TextureData>(TextureData{.levels = mip_chain(default_texture("white")), .sampler = {}});
    return kWhite;
}

}  // namespace

bool is_shadow_pass(const Pass& pass) {
    return pass.lights == PassLights::Shadowed;
}

bool reads_texture(const Pass& pass, const Texture& texture) {
    return std::find(pass.textures.begin(), pass.textures.end(), texture.name) != pass.textures.end();
}

FrameBuilder::FrameBuilder(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options)
    : world_(world), materials_(materials), options_(options) {
    const Scene& scene = world.view;
    frame_.samples = scene.samples;
    frame_.keep = kept_;
    frame_.targets.push_back({.name = std::string(kShown),
                              .format = format_of(std::string(kShown), TargetFormat::Rgba32F),
                              .width = scene.width * scene.samples,
                              .height = scene.height * scene.samples,
                              .clear = scene.background,
                              .is_of_picture = true});
}

TargetFormat FrameBuilder::format_of(const std::string& target, TargetFormat stated) const {
    if (stated == TargetFormat::Depth) return stated;
    if (options_.exact) return TargetFormat::Rgba32F;
    return target == kShown ? options_.shown_format.value_or(stated) : stated;
}

std::optional<std::size_t> FrameBuilder::find_target(const std::string& name) const {
    for (std::size_t i = 0; i < frame_.targets.size(); i++)
        if (frame_.targets[i].name == name) return i;
    return std::nullopt;
}

// The depth of pixels without geometry. Shadow maps are near to far, for every camera.
float FrameBuilder::farthest_of(const Pass& pass) const {
    return pass.lights == PassLights::Shadowed ? 1.0f : farthest(world_.view.camera.clip_depth);
}

// `atlas_size`: texels along a side, or 0 for a target of the picture's size.
std::string FrameBuilder::add_target(const std::string& material, const Pass& pass, const std::string& name,
                                     TargetFormat stated, int atlas_size) {
    const FrameTarget& picture = frame_.targets.front();
    FrameTarget target{.name = name,
                       .format = format_of(name, stated),
                       .width = atlas_size ? atlas_size : picture.width,
                       .height = atlas_size ? atlas_size : picture.height,
                       .clear = glm::vec4(stated == TargetFormat::Depth ? farthest_of(pass) : 0.0f),
                       .is_of_picture = atlas_size == 0};
    const std::optional<std::size_t> known = find_target(name);
    if (!known) {
        frame_.targets.push_back(std::move(target));
        return "";
    }
    FrameTarget& before = frame_.targets[*known];
    if (&before == &frame_.targets.front() && !shown_has_format_) before.format = target.format;
    shown_has_format_ |= &before == &frame_.targets.front();
    if (before.format != target.format)
        return fmt::format("pass '{}' of the material '{}' draws into the target '{}' as {}, but another pass as {}",
                           pass.name, material, name, to_string(target.format), to_string(before.format));
    if (before.is_of_picture != target.is_of_picture)
        return fmt::format(
            "pass '{}' of the material '{}' and another pass draw into the target '{}', one from a light and one from "
            "the camera",
            pass.name, material, name);
    return "";
}

std::string FrameBuilder::make_targets(std::span<const std::size_t> used, bool has_shadows) {
    for (std::size_t i : used) {
        const std::string& material = world_.materials[i].name;
        for (const Pass& pass : materials_[i].reflection->passes) {
            const int atlas_size = !is_shadow_pass(pass) ? 0 : has_shadows ? options_.shadow_atlas_size : 1;
            for (const RenderTarget& target : pass.targets)
                if (std::string error = add_target(material, pass, target.name, target.format, atlas_size);
                    !error.empty())
                    return error;
            if (pass.depth_target.empty()) continue;
            if (std::string error = add_target(material, pass, pass.depth_target, TargetFormat::Depth, atlas_size);
                !error.empty())
                return error;
        }
    }
    for (std::size_t i : used)
        for (const Texture& texture : materials_[i].reflection->textures)
            if (!texture.reads.empty() && !find_target(texture.reads)) {
                frame_.targets.push_back({.name = texture.reads,
                                          .format = TargetFormat::Depth,
                                          .width = 1,
                                          .height = 1,
                                          .clear = glm::vec4(farthest(world_.view.camera.clip_depth))});
            }
    return "";
}

// Lighting groups and materials share the stencil of a frame: each overwrites the values of the other.
bool FrameBuilder::changes_owner(const Stencil& stencil) {
    if (!stencil.is_used()) return false;
    const StencilOwner owner = stencil.is_of_lighting() ? StencilOwner::Lighting : StencilOwner::Materials;
    const StencilOwner before = std::exchange(stencil_owner_, owner);
    return before != owner && before != StencilOwner::Nobody;
}

// The object itself has a texture of this name.
bool FrameBuilder::has_own(const PlannedStep& step, std::string_view texture) const {
    return step.object && *step.object < options_.object_textures.size() &&
           find_texture(options_.object_textures[*step.object], texture);
}

// The material's textures, and those that the engine binds anew for each object or light.
std::span<const LoadedTexture> FrameBuilder::textures_of(const PlannedStep& step) {
    const DrawnMaterial& material = materials_[step.material];
    std::vector<LoadedTexture> bound;
    for (const Texture& texture : material.reflection->textures) {
        if (texture.is_material || !texture.reads.empty() || !reads_texture(*step.pass, texture)) continue;
        if (const Probe* probe = probe_of(texture.name, step.seen.probes))
            bound.push_back(
                {.name = texture.name, .data = probe->environment->map(), .dimension = TextureDimension::Cube});
        if (texture.dimension != TextureDimension::Flat) continue;
        const Light* cookie = texture.name == "lightCookie" ? cookie_light(step.seen.lights) : nullptr;
        if (has_own(step, texture.name))
            bound.push_back(*find_texture(options_.object_textures[*step.object], texture.name));
        else if (cookie)
            bound.push_back({.name = texture.name, .data = cookie->cookie});
        else if (!find_texture(material.textures, texture.name))
            bound.push_back({.name = texture.name, .data = white_texture()});
    }
    if (bound.empty()) return material.textures;
    const std::size_t count = bound.size();
    for (const LoadedTexture& texture : material.textures)
        if (!find_texture(std::span(bound).first(count), texture.name)) bound.push_back(texture);
    return kept_->textures.emplace_back(std::move(bound));
}

void FrameBuilder::add(PlannedStep planned) {
    const DrawnMaterial& material = materials_[planned.material];
    const Pass& pass = *planned.pass;
    // A missing lightmap gives no light, regardless of the bound texture.
    planned.seen.lightmap_decode = has_own(planned, "lightmapTexture")
                                       ? lightmap_decode(world_.objects[*planned.object].lightmap_encoding)
                                       : glm::vec4(0, 1, 0, 0);

    FrameStep step{.reflection = material.reflection,
                   .pass = &pass,
                   .stages = material.passes.at(pass.name).stages,
                   .mesh = planned.mesh,
                   .instances = std::uint32_t(std::max<std::size_t>(planned.seen.instances.size(), 1)),
                   .blocks = fill_blocks(*material.reflection, material.values, planned.seen),
                   .constants = constants_of(*material.reflection, material.values),
                   .textures = textures_of(planned),
                   .samplers = material.values.samplers,
                   .area = planned.area,
                   .object = planned.object,
                   .first_instance = planned.first_instance};
    for (const std::vector<SeenLight>* lights : {&planned.seen.lights, &planned.seen.vertex_lights})
        for (const SeenLight& light : *lights) step.lights.push_back(light.index);
    step.stencil_reference =
        static_cast<std::uint8_t>(pass.stencil.is_of_lighting() ? planned.group : pass.stencil.value);
    step.clears_stencil = changes_owner(pass.stencil);
    for (const RenderTarget& target : pass.targets) step.targets.push_back(*find_target(target.name));
    if (!pass.depth_target.empty()) step.depth = static_cast<int>(*find_target(pass.depth_target));
    for (const Texture& texture : material.reflection->textures)
        if (!texture.reads.empty() && reads_texture(pass, texture))
            step.reads.push_back({.texture = texture.name, .target = *find_target(texture.reads)});
    frame_.steps.push_back(std::move(step));
}

const Mesh* FrameBuilder::keep(Mesh mesh) {
    return &kept_->meshes.emplace_back(std::move(mesh));
}

Frame FrameBuilder::frame() && {
    return std::move(frame_);
}

}  // namespace patina::runtime

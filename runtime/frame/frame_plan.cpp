#include "runtime/frame/frame_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>

#include "runtime/frame/frame_builder.h"
#include "runtime/frame/lighting_groups.h"
#include "runtime/frame/plan_check.h"
#include "runtime/lights/light_split.h"
#include "runtime/lights/light_volume.h"
#include "runtime/lights/probe_choice.h"

namespace patina::runtime {
namespace {

constexpr int kFirstBlendedQueue = 2500;  // as in Unity: AlphaTest is 2450, Transparent 3000

// In the order in which they are drawn. Before, After: passes that a material adds, on either side of the opaque ones.
enum class Phase { Before, Wanted, OtherPath, After, Readers, Blended };

using Passes = std::vector<const Pass*>;

const Pass* find_pass(const Passes& passes, const std::string& name) {
    auto found = std::find_if(passes.begin(), passes.end(), [&](const Pass* pass) { return pass->name == name; });
    return found == passes.end() ? nullptr : *found;
}

// What is drawn together: the passes of the path, and each that the material adds.
std::vector<Passes> groups_of(const Reflection& reflection) {
    std::vector<Passes> groups(1);
    for (const Pass& pass : reflection.passes)
        if (!pass.is_extra) groups.front().push_back(&pass);
    for (const Pass& pass : reflection.passes)
        if (pass.is_extra) groups.push_back({&pass});
    return groups;
}

// Draws objects as the camera sees them.
bool shows_objects(const Pass& pass) {
    return pass.draws == PassDraws::Objects && !is_shadow_pass(pass);
}

bool is_blended(const Passes& passes) {
    return std::any_of(passes.begin(), passes.end(),
                       [](const Pass* pass) { return shows_objects(*pass) && pass->queue >= kFirstBlendedQueue; });
}

// A pass reads the previous content of its own targets.
bool reads_own_targets(const Passes& passes, const std::vector<Texture>& textures) {
    auto draws_into = [](const Pass& pass, const std::string& target) {
        return pass.depth_target == target || std::any_of(pass.targets.begin(), pass.targets.end(),
                                                          [&](const RenderTarget& t) { return t.name == target; });
    };
    for (const Pass* pass : passes)
        for (const Texture& texture : textures)
            if (shows_objects(*pass) && !texture.reads.empty() && reads_texture(*pass, texture) &&
                draws_into(*pass, texture.reads))
                return true;
    return false;
}

const Mesh& screen_mesh() {
    static const Mesh kScreen = make_fullscreen();
    return kScreen;
}

struct PlannedObject {
    std::size_t index = 0;  // in the world
    Passes passes{};        // one of groups_of()
    bool is_extra = false;  // which a material adds
    glm::mat4 object_to_world{1};
    std::vector<SeenInstance> instances{};  // that are drawn at once
    std::size_t first_instance = 0;         // of the object
    Sphere bounds{};
    LightSplit split{};
};

class Planner {
public:
    Planner(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options)
        : world_(world),
          scene_(world.view),
          materials_(materials),
          options_(options),
          view_(camera_view(world.view)),
          groups_(materials),
          builder_(world, materials, options) {}

    Outcome<Frame> plan() {
        place_objects();
        find_shadow_maps();
        if (error_.empty()) error_ = builder_.make_targets(used_, !shadow_maps_.empty());
        if (error_.empty()) {
            draw_background();
            draw_shadow_maps();
            draw_added(Phase::Before);
            for (Phase phase : {Phase::Wanted, Phase::OtherPath}) draw_opaque(phase);
            draw_added(Phase::After);
            draw_opaque(Phase::Readers);
            draw_blended();
        }
        if (!error_.empty()) return Failure{error_};
        return std::move(builder_).frame();
    }

private:
    using Objects = std::vector<const PlannedObject*>;

    const Reflection& reflection_of(std::size_t material) const { return *materials_[material].reflection; }
    std::size_t material_of(const PlannedObject& object) const { return world_.objects[object.index].material; }
    const Reflection& reflection_of(const PlannedObject& object) const { return reflection_of(material_of(object)); }

    std::vector<std::vector<SeenInstance>> draws_of(std::size_t object) const;
    void place_objects();
    void find_shadow_maps();
    void draw_background();
    void draw_shadow_maps();
    void draw_opaque(Phase phase);
    void draw_added(Phase phase);
    void draw_blended();

    Phase phase_of(const PlannedObject& object) const;
    Objects objects_in(Phase phase) const;
    std::vector<std::size_t> materials_of(const Objects& objects) const;
    std::vector<std::string> pass_order(Objects objects) const;
    std::vector<std::size_t> lights_for(const Pass& pass, const PlannedObject* object) const;
    EngineScene seen_with(const std::vector<std::size_t>& lights) const;
    void draw_object(const PlannedObject& object, const Pass& pass, Phase phase);
    void draw_lighting(const std::vector<std::size_t>& materials, const std::string& name, Phase phase);
    void draw_volume(PlannedStep step, const Light& light);
    int group_of(Phase phase, std::size_t material);

    const World& world_;
    const Scene& scene_;
    std::span<const DrawnMaterial> materials_;
    const FrameOptions& options_;
    View view_;
    LightingGroups groups_;
    FrameBuilder builder_;
    std::vector<PlannedObject> objects_{};
    std::vector<std::size_t> used_{};  // materials, in the world's order
    std::vector<ShadowView> shadow_maps_{};
    std::vector<std::size_t> shadow_lights_{};  // of each map
    std::vector<int> shadow_map_of_{};          // of each light; -1: none
    const Mesh* view_mesh_ = nullptr;           // for volumes that would be clipped
    std::set<std::string> drawn_{};             // full-screen passes, by group or by what they do
    std::string error_{};
};

// The instances of an object, by draw: as many at once as its material takes.
std::vector<std::vector<SeenInstance>> Planner::draws_of(std::size_t object) const {
    const WorldObject& shape = world_.objects[object];
    const std::size_t most = std::max<std::size_t>(reflection_of(shape.material).most_instances, 1);
    std::vector<std::vector<SeenInstance>> draws;
    if (shape.instances.empty()) draws.push_back({SeenInstance{.object_to_world = shape.object_to_world}});
    for (std::size_t i = 0; i < shape.instances.size(); i++) {
        SeenInstance instance{.object_to_world = shape.instances[i].object_to_world};
        if (object < options_.instance_values.size() && i < options_.instance_values[object].size())
            instance.values = &options_.instance_values[object][i];
        if (i % most == 0) draws.emplace_back();
        draws.back().push_back(instance);
    }
    return draws;
}

void Planner::place_objects() {
    std::set<std::size_t> used;
    for (std::size_t i = 0; i < world_.objects.size(); i++) {
        const WorldObject& object = world_.objects[i];
        const Reflection& reflection = reflection_of(object.material);
        std::size_t first_instance = 0;
        for (const std::vector<SeenInstance>& together : draws_of(i)) {
            for (Passes& passes : groups_of(reflection)) {
                const bool is_extra = !passes.empty() && passes.front()->is_extra;
                const std::optional<Bounds>& drawn = is_extra ? passes.front()->bounds : reflection.bounds;
                std::vector<Sphere> spheres;
                for (const SeenInstance& instance : together)
                    spheres.push_back(world_bounds(*object.mesh, instance.object_to_world, drawn));
                Sphere bounds = spheres.size() == 1 ? spheres.front() : bounds_of(spheres);
                LightSplit split = split_lights(scene_.lights, bounds, world_.pixel_light_count);
                objects_.push_back({.index = i,
                                    .passes = std::move(passes),
                                    .is_extra = is_extra,
                                    .object_to_world = together.front().object_to_world,
                                    .instances = together,
                                    .first_instance = first_instance,
                                    .bounds = bounds,
                                    .split = std::move(split)});
            }
            first_instance += together.size();
        }
        used.insert(object.material);
    }
    if (options_.background) used.insert(*options_.background);
    used_.assign(used.begin(), used.end());
}

void Planner::find_shadow_maps() {
    shadow_map_of_.assign(scene_.lights.size(), -1);
    std::vector<ShadowObject> objects;
    bool has_casters = false;
    for (const PlannedObject& planned : objects_) {
        if (planned.is_extra) continue;
        const Reflection& reflection = reflection_of(planned);
        const WorldObject& object = world_.objects[planned.index];
        for (const SeenInstance& instance : planned.instances) {
            objects.push_back({.mesh = object.mesh.get(),
                               .object_to_world = instance.object_to_world,
                               .casts = std::any_of(reflection.passes.begin(), reflection.passes.end(), is_shadow_pass),
                               .moves_vertices = reflection.moves_vertices,
                               .bounds = reflection.bounds});
            has_casters |= objects.back().casts;
        }
    }
    if (!has_casters) return;
    for (std::size_t i = 0; i < scene_.lights.size(); i++) {
        const Light& light = scene_.lights[i];
        if (!light.shadow.casts) continue;
        if (light.kind == LightKind::Point) {
            error_ = fmt::format(
                "light {} is a point light, which has no shadow map: only directional lights and spots do", i);
            return;
        }
        if (shadow_maps_.size() == kMostShadowMaps) {
            error_ = fmt::format("more than {} lights cast shadows", kMostShadowMaps);
            return;
        }
        shadow_map_of_[i] = static_cast<int>(shadow_maps_.size());
        ShadowTile tile{.number = shadow_map_of_[i], .atlas_size = options_.shadow_atlas_size};
        shadow_maps_.push_back(
            light.kind == LightKind::Spot
                ? spot_shadow(light, tile)
                : directional_shadow(light, objects, view_, scene_.mixed_lighting.shadow_distance, tile));
        shadow_lights_.push_back(i);
    }
}

void Planner::draw_background() {
    if (!options_.background) return;
    for (const Pass& pass : reflection_of(*options_.background).passes)
        builder_.add({.material = *options_.background, .pass = &pass, .mesh = &screen_mesh(), .seen = seen_with({})});
}

void Planner::draw_shadow_maps() {
    Objects all;
    for (const PlannedObject& object : objects_) all.push_back(&object);
    for (const std::string& name : pass_order(all)) {
        for (std::size_t map = 0; map < shadow_maps_.size(); map++) {
            const std::size_t light = shadow_lights_[map];
            for (const PlannedObject& object : objects_) {
                const Pass* pass = find_pass(object.passes, name);
                if (!pass || !is_shadow_pass(*pass)) continue;
                if (attenuation_within(scene_.lights[light], object.bounds) <= 0) continue;
                EngineScene seen = seen_with({light});
                seen.view = shadow_maps_[map].view;
                seen.object_to_world = object.object_to_world;
                seen.instances = object.instances;
                builder_.add({.material = material_of(object),
                              .pass = pass,
                              .mesh = world_.objects[object.index].mesh.get(),
                              .seen = std::move(seen),
                              .object = object.index,
                              .area = shadow_maps_[map].area});
            }
        }
    }
}

Phase Planner::phase_of(const PlannedObject& object) const {
    const Reflection& reflection = reflection_of(object);
    if (is_blended(object.passes)) return Phase::Blended;
    if (reads_own_targets(object.passes, reflection.textures)) return Phase::Readers;
    if (object.is_extra) {
        const auto own = std::find_if(reflection.passes.begin(), reflection.passes.end(), shows_objects);
        const bool is_before = own != reflection.passes.end() && object.passes.front()->queue < own->queue;
        return is_before ? Phase::Before : Phase::After;
    }
    return options_.path.empty() || reflection.path == options_.path ? Phase::Wanted : Phase::OtherPath;
}

Planner::Objects Planner::objects_in(Phase phase) const {
    Objects chosen;
    for (const PlannedObject& object : objects_)
        if (phase_of(object) == phase) chosen.push_back(&object);
    return chosen;
}

// Of whose passes some may draw no objects.
std::vector<std::size_t> Planner::materials_of(const Objects& objects) const {
    std::set<std::size_t> materials;
    for (const PlannedObject* object : objects)
        if (!object->is_extra) materials.insert(material_of(*object));
    return {materials.begin(), materials.end()};
}

// Names of all passes, each after the passes that come before it in its material.
std::vector<std::string> Planner::pass_order(Objects objects) const {
    std::stable_sort(objects.begin(), objects.end(),
                     [&](const auto* a, const auto* b) { return material_of(*a) < material_of(*b); });
    std::vector<std::string> order;
    std::set<const Pass*> known;  // the first of each group
    for (const PlannedObject* object : objects) {
        if (object->passes.empty() || !known.insert(object->passes.front()).second) continue;
        std::size_t next = 0;
        for (const Pass* pass : object->passes) {
            auto found = std::find(order.begin(), order.end(), pass->name);
            if (found == order.end()) found = order.insert(order.begin() + std::ptrdiff_t(next), pass->name);
            next = std::max(next, std::size_t(found - order.begin()) + 1);
        }
    }
    return order;
}

// In the order of their slots. `object`: null where none is drawn.
std::vector<std::size_t> Planner::lights_for(const Pass& pass, const PlannedObject* object) const {
    if (pass.lights == PassLights::Further && object) return object->split.further;
    const std::optional<std::size_t> main = main_light(scene_.lights);
    auto is_wanted = [&](std::size_t i) {
        const bool is_directional = scene_.lights[i].kind == LightKind::Directional;
        switch (pass.lights) {
            case PassLights::All: return true;
            case PassLights::Main:
            case PassLights::MainOnly: return i == main;
            case PassLights::Further: return i != main;
            case PassLights::Directional: return is_directional;
            case PassLights::Local: return !is_directional;
            case PassLights::Shadowed:
            case PassLights::None: return false;
        }
        return false;
    };
    std::vector<std::size_t> chosen;
    for (std::size_t i : light_order(scene_.lights)) {
        if (!is_wanted(i)) continue;
        const bool skips_far_ones = object && pass.each == PassEach::Light;
        if (skips_far_ones && attenuation_within(scene_.lights[i], object->bounds) <= 0) continue;
        chosen.push_back(i);
    }
    return chosen;
}

EngineScene Planner::seen_with(const std::vector<std::size_t>& lights) const {
    EngineScene seen{.scene = &scene_,
                     .view = view_,
                     .ambient = scene_.ambient,
                     .shadow_maps = shadow_maps_,
                     .shadow_atlas_size = shadow_maps_.empty() ? 1 : options_.shadow_atlas_size};
    for (std::size_t i : lights)
        seen.lights.push_back({.light = &scene_.lights[i], .index = i, .shadow_map = shadow_map_of_[i]});
    return seen;
}

int Planner::group_of(Phase phase, std::size_t material) {
    std::optional<int> number = groups_.number(static_cast<int>(phase), material);
    if (!number && error_.empty())
        error_ = fmt::format("the materials need more than {} different lighting passes", kMostLightingGroups);
    return number.value_or(0);
}

void Planner::draw_object(const PlannedObject& object, const Pass& pass, Phase phase) {
    const WorldObject& shape = world_.objects[object.index];
    auto add = [&](const std::vector<std::size_t>& lights) {
        EngineScene seen = seen_with(lights);
        seen.object_to_world = object.object_to_world;
        seen.instances = object.instances;
        seen.probes = choose_probes(scene_.probes, object.bounds.center);
        if (pass.lights == PassLights::Main) {
            for (std::size_t i : object.split.vertex)
                seen.vertex_lights.push_back({.light = &scene_.lights[i], .index = i});
            for (std::size_t i : object.split.sh) add_light(seen.ambient, scene_.lights[i], object.bounds);
        }
        builder_.add({.material = shape.material,
                      .pass = &pass,
                      .mesh = shape.mesh.get(),
                      .seen = std::move(seen),
                      .object = object.index,
                      .first_instance = object.first_instance,
                      .group = pass.stencil.is_of_lighting() ? group_of(phase, shape.material) : 0});
    };
    const std::vector<std::size_t> lights = lights_for(pass, &object);
    if (pass.each == PassEach::Once) return add(lights);
    for (std::size_t light : lights) add({light});
}

void Planner::draw_volume(PlannedStep step, const Light& light) {
    const LightVolume volume = light_volume(light);
    const bool covers_all = is_clipped(volume, view_);
    if (covers_all && !view_mesh_) view_mesh_ = builder_.keep(view_volume(view_));
    step.mesh = covers_all ? view_mesh_ : volume.mesh;
    step.seen.object_to_world = covers_all ? glm::mat4(1) : volume.object_to_world;
    builder_.add(std::move(step));
}

// The pass of this name where it draws no object: once for each group of the materials.
void Planner::draw_lighting(const std::vector<std::size_t>& materials, const std::string& name, Phase phase) {
    for (std::size_t material : materials) {
        const std::vector<Pass>& passes = reflection_of(material).passes;
        const auto pass = std::find_if(passes.begin(), passes.end(), [&](const Pass& p) { return p.name == name; });
        if (pass == passes.end() || pass->draws == PassDraws::Objects) continue;
        const int group = is_masked(*pass) ? group_of(phase, material) : 0;
        const std::string key =
            group ? fmt::format("{}\n{}", name, group) : "\n" + lighting_key(materials_, material, *pass);
        if (!drawn_.insert(key).second) continue;

        PlannedStep step{.material = material, .pass = &*pass, .mesh = &screen_mesh(), .group = group};
        const std::vector<std::size_t> lights = lights_for(*pass, nullptr);
        if (pass->each == PassEach::Once && pass->draws == PassDraws::Fullscreen) {
            step.seen = seen_with(lights);
            builder_.add(std::move(step));
            continue;
        }
        for (std::size_t light : lights) {
            step.seen = seen_with({light});
            if (pass->draws == PassDraws::LightVolumes)
                draw_volume(step, scene_.lights[light]);
            else
                builder_.add(step);
        }
    }
}

void Planner::draw_opaque(Phase phase) {
    const Objects objects = objects_in(phase);
    const std::vector<std::size_t> materials = materials_of(objects);
    for (const std::string& name : pass_order(objects)) {
        std::vector<std::pair<const PlannedObject*, const Pass*>> draws;
        for (const PlannedObject* object : objects)
            if (const Pass* pass = find_pass(object->passes, name); pass && shows_objects(*pass))
                draws.emplace_back(object, pass);
        std::stable_sort(draws.begin(), draws.end(),
                         [](const auto& a, const auto& b) { return a.second->queue < b.second->queue; });
        for (const auto& [object, pass] : draws) draw_object(*object, *pass, phase);
        draw_lighting(materials, name, phase);
    }
}

void Planner::draw_added(Phase phase) {
    Objects objects = objects_in(phase);
    const auto queue_of = [](const PlannedObject* object) { return object->passes.front()->queue; };
    std::stable_sort(objects.begin(), objects.end(),
                     [&](const auto* a, const auto* b) { return queue_of(a) < queue_of(b); });
    for (const PlannedObject* object : objects) draw_object(*object, *object->passes.front(), phase);
}

void Planner::draw_blended() {
    struct Draw {
        const PlannedObject* object = nullptr;
        int queue = 0;
        float distance = 0;
    };
    std::vector<Draw> draws;
    const Objects objects = objects_in(Phase::Blended);
    for (const PlannedObject* object : objects) {
        const Passes& passes = object->passes;
        const auto shown =
            std::find_if(passes.begin(), passes.end(), [](const Pass* pass) { return shows_objects(*pass); });
        const glm::vec3 way = object->bounds.center - view_.position;
        const float distance = view_.is_parallel ? glm::dot(way, view_.forward) : glm::length(way);
        draws.push_back({.object = object, .queue = (*shown)->queue, .distance = distance});
    }
    std::stable_sort(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return a.queue != b.queue ? a.queue < b.queue : a.distance > b.distance;
    });
    for (const Draw& draw : draws)
        for (const Pass* pass : draw.object->passes)
            if (shows_objects(*pass)) draw_object(*draw.object, *pass, Phase::Blended);

    const std::vector<std::size_t> materials = materials_of(objects);
    for (const std::string& name : pass_order(objects)) draw_lighting(materials, name, Phase::Blended);
}

}  // namespace

std::string path_for(const Camera& camera, const Reflection& reflection) {
    const bool is_parallel = camera.orthographic_height || camera.clip_space;
    for (const Pass& pass : reflection.passes)
        if (is_parallel && pass.camera == PassCamera::Perspective) return pass.fallback;
    return reflection.path;
}

Outcome<Frame> plan_frame(const World& world, std::span<const DrawnMaterial> materials, const FrameOptions& options) {
    if (std::string error = plan_error(world, materials, options); !error.empty()) return Failure{error};
    return Planner(world, materials, options).plan();
}

}  // namespace patina::runtime

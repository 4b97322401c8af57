#include "runtime/scene/world_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "patina/complaints.h"
#include "runtime/gltf/gltf_model.h"
#include "runtime/picture/mip_chain.h"
#include "runtime/scene/named_mesh.h"
#include "runtime/scene/scene_text.h"
#include "runtime/scene/view.h"

namespace patina::runtime {
namespace {

glm::vec3 vector(const SceneVector& v) {
    return {float(v[0]), float(v[1]), float(v[2])};
}

std::optional<glm::vec3> vector(const std::optional<SceneVector>& v) {
    return v ? std::optional(vector(*v)) : std::nullopt;
}

std::optional<float> number(std::optional<double> value) {
    return value ? std::optional(float(*value)) : std::nullopt;
}

// --- the view

Camera make_camera(const SceneCamera& camera) {
    return {.position = vector(camera.position),
            .target = vector(camera.target),
            .up = vector(camera.up),
            .fov = float(camera.fov),
            .orthographic_height = number(camera.orthographic),
            .near_plane = float(camera.near_plane),
            .far_plane = float(camera.far_plane)};
}

// The file's own numbers, as a mask is: nothing is decoded. A directional light repeats it, a spot light ends with it.
Outcome<std::shared_ptr<const TextureData>> load_cookie(const SceneLight& light) {
    Outcome<Image> image = load_image(light.cookie.path);
    if (!image) return Failure{std::move(image.error)};
    TextureData data{.levels = mip_chain(std::move(image.value)), .sampler = {}};
    data.sampler.wrap = light.type == LightKind::Directional ? Wrap::Repeat : Wrap::Clamp;
    return std::make_shared<const TextureData>(std::move(data));
}

Diagnostic cut_shadow(const SceneLight& light, float outer) {
    const Diagnostic said = complaint(Complaint::CutShadow, {fmt::format("{}", kWidestSpot), fmt::format("{}", outer)});
    Diagnostic diagnostic = diagnostic_at(light.place, said.code, said.message);
    diagnostic.severity = Severity::Warning;
    return diagnostic;
}

Light make_light(const SceneLight& light, WorldFile& file) {
    // However short or long: its largest component becomes 1 first, which the square of a length can take.
    const glm::dvec3 given(light.direction[0], light.direction[1], light.direction[2]);
    const glm::dvec3 sizes = glm::abs(given);
    const glm::dvec3 direction = given / std::max({sizes.x, sizes.y, sizes.z});
    Light made{.kind = light.type,
               .position = vector(light.position),
               .direction = glm::vec3(glm::normalize(direction)),
               .color = vector(light.color) * float(light.intensity),
               .range = float(light.range),
               .importance = light.render_mode,
               .cookie_size = float(light.cookie_size)};
    if (light.type == LightKind::Spot) set_cone(made, number(light.inner), number(light.outer));
    if (light.shadow) {
        made.shadow = {.casts = true,
                       .strength = float(light.shadow->strength),
                       .bias = float(light.shadow->bias),
                       .normal_bias = float(light.shadow->normal_bias)};
        if (made.kind == LightKind::Spot && made.outer_angle > kWidestSpot)
            file.diagnostics.push_back(cut_shadow(light, made.outer_angle));
    }
    if (light.cookie.path.empty()) return made;
    Outcome<std::shared_ptr<const TextureData>> cookie = load_cookie(light);
    if (cookie) {
        made.cookie = std::move(cookie.value);
        file.dependencies.push_back(light.cookie.path);
    } else {
        file.diagnostics.push_back(
            diagnostic_at(light.cookie.place, std::string(code_of(Complaint::BadTexture)), cookie.error));
    }
    return made;
}

// A picture that cannot be loaded is reported at its name, and null.
std::shared_ptr<const Environment> load_picture(const ScenePicture& picture, const EnvironmentProgress& progress,
                                                WorldFile& file) {
    Outcome<std::shared_ptr<const Environment>> loaded = load_environment(
        {.path = picture.file.path, .rotation = picture.rotation, .intensity = picture.intensity}, progress);
    if (!loaded) {
        file.diagnostics.push_back(
            diagnostic_at(picture.file.place, std::string(code_of(Complaint::BadEnvironment)), loaded.error));
        return nullptr;
    }
    file.dependencies.push_back(picture.file.path);
    return std::move(loaded.value);
}

void load_probes(const SceneFile& scene, const EnvironmentProgress& progress, WorldFile& file) {
    for (const SceneProbe& probe : scene.probes) {
        file.world.view.probes.push_back({.environment = load_picture(probe.picture, progress, file),
                                          .position = vector(probe.position),
                                          .box_min = vector(probe.box_min),
                                          .box_max = vector(probe.box_max),
                                          .blend = float(probe.blend),
                                          .is_box_projected = probe.box_projection,
                                          .importance = probe.importance});
    }
}

void set_surroundings(Scene& view, const SceneFile& scene) {
    if (!scene.picture && scene.environment == SceneEnvironment::Studio) view.environment = studio_environment();
    const bool has_picture_ambient = scene.picture && view.environment && !scene.has_studio_ambient;
    view.ambient = scene.ambient         ? ambient_of(vector(scene.ambient->sky), vector(scene.ambient->horizon),
                                                      vector(scene.ambient->ground))
                   : has_picture_ambient ? view.environment->ambient()
                                         : studio_environment()->ambient();
    if (scene.fog) {
        view.fog = {.mode = scene.fog->mode,
                    .color = vector(scene.fog->color),
                    .density = float(scene.fog->density),
                    .start = float(scene.fog->start),
                    .end = float(scene.fog->end)};
    }
    view.mixed_lighting = {.mode = scene.mixed_lighting.mode,
                           .shadow_color = vector(scene.mixed_lighting.shadow_color),
                           .shadow_distance = number(scene.mixed_lighting.shadow_distance),
                           .shadow_fade = number(scene.mixed_lighting.shadow_fade)};
    view.backdrop = scene.backdrop;
    view.is_default_background = !scene.background && scene.backdrop == SceneBackdrop::Color;
    if (scene.background) {
        const std::array<double, 4>& color = *scene.background;
        view.background = {float(color[0]), float(color[1]), float(color[2]), float(color[3])};
    }
}

// --- objects

template <class Placed>
glm::dmat4 make_transform(const Placed& object) {
    const auto turned = [](glm::dmat4 matrix, double degrees, glm::dvec3 axis) {
        return glm::rotate(matrix, glm::radians(degrees), axis);
    };
    const auto exact = [](const SceneVector& v) { return glm::dvec3(v[0], v[1], v[2]); };
    // Read from the bottom: scaled, turned about z, x and y, moved.
    glm::dmat4 matrix = glm::translate(glm::dmat4(1), exact(object.position));
    matrix = turned(matrix, object.rotation[1], {0, 1, 0});
    matrix = turned(matrix, object.rotation[0], {1, 0, 0});
    matrix = turned(matrix, object.rotation[2], {0, 0, 1});
    return glm::scale(matrix, exact(object.scale));
}

// `place`: of the mesh in the object.
std::vector<WorldInstance> make_instances(const SceneObject& object, const glm::mat4& place) {
    std::vector<WorldInstance> instances;
    const glm::dmat4 object_to_world = make_transform(object);
    for (const SceneInstance& instance : object.instances) {
        WorldInstance& made = instances.emplace_back();
        made.object_to_world = glm::mat4(object_to_world * make_transform(instance)) * place;
        made.set = instance.set;
        for (const SceneValue& value : instance.set) made.overrides[value.property] = value.words;
    }
    return instances;
}

// A mesh, and where a model's file puts it.
struct PlacedMesh {
    std::shared_ptr<const Mesh> mesh{};
    glm::mat4 place{1};
};

// One mesh for all objects that are alike. A file is read once.
class Meshes {
public:
    Outcome<PlacedMesh> get(const SceneObject& object, WorldFile& file) {
        const std::string name = path_of(object);
        const std::size_t sharp = name.find('#');
        if (is_model_name(name) && !object.segments) {
            const std::string path = name.substr(0, sharp), node = sharp == name.npos ? "" : name.substr(sharp + 1);
            const Outcome<GltfModel>& model = model_at(path, file);
            if (!model) return Failure{model.error};
            if (const ModelPart* part = find_part(model.value, node))
                return PlacedMesh{.mesh = part->mesh, .place = part->object_to_world};
            return get(name, 0, [&] { return mesh_of(model.value, path, node); });
        }
        const int segments = object.segments.value_or(0);
        return get(name, segments, [&] { return mesh_named(name, segments); });
    }

private:
    // A file is named relative to the scene.
    static std::string path_of(const SceneObject& object) {
        const std::filesystem::path path(object.mesh);
        if (!is_model_name(object.mesh) || path.is_absolute()) return object.mesh;
        return (std::filesystem::path(object.mesh_location.file).parent_path() / path).lexically_normal().string();
    }

    const Outcome<GltfModel>& model_at(const std::string& path, WorldFile& file) {
        const auto found = models_.find(path);
        if (found != models_.end()) return found->second;
        file.dependencies.push_back(path);
        return models_.emplace(path, read_model(path)).first->second;
    }

    template <class Make>
    Outcome<PlacedMesh> get(const std::string& name, int segments, const Make& make) {
        const auto found = made_.find({name, segments});
        if (found != made_.end()) return found->second;
        Outcome<Mesh> mesh = make();
        const Outcome<PlacedMesh> placed =
            mesh ? Outcome<PlacedMesh>({.mesh = std::make_shared<const Mesh>(std::move(mesh.value))})
                 : Outcome<PlacedMesh>(Failure{mesh.error});
        return made_.emplace(std::pair(name, segments), placed).first->second;
    }

    std::map<std::pair<std::string, int>, Outcome<PlacedMesh>> made_;
    std::map<std::string, Outcome<GltfModel>> models_;
};

Diagnostic unknown_mesh(const SceneObject& object) {
    Diagnostic diagnostic =
        diagnostic_at(object.mesh_location, "unknown-name", "there is no mesh '" + object.mesh + "'");
    Diagnostic& note = diagnostic.notes.emplace_back();
    note.severity = Severity::Note;
    note.message = suggestion(object.mesh, {mesh_names().begin(), mesh_names().end()});
    return diagnostic;
}

}  // namespace

WorldFile make_world(const SceneFile& scene, const EnvironmentProgress& progress) {
    WorldFile file;
    World& world = file.world;
    world.view.camera = make_camera(scene.camera);
    for (const SceneLight& light : scene.lights) world.view.lights.push_back(make_light(light, file));
    if (scene.picture) {
        world.view.environment = load_picture(*scene.picture, progress, file);
        world.view.picture_intensity = float(scene.picture->intensity);
    }
    load_probes(scene, progress, file);
    set_surroundings(world.view, scene);
    world.view.time = float(scene.time);
    world.pixel_light_count = scene.pixel_light_count;
    for (const SceneMaterial& material : scene.materials) {
        WorldMaterial& made = world.materials.emplace_back();
        made.name = material.name;
        made.graph = material.graph.path;
        made.place = material.place;
        made.set = material.set;
        for (const SceneValue& value : material.set) made.overrides[value.property] = value.words;
    }
    Meshes meshes;
    for (const SceneObject& object : scene.objects) {
        const Outcome<PlacedMesh> mesh = meshes.get(object, file);
        if (!mesh)
            file.diagnostics.push_back(is_model_name(object.mesh)
                                           ? diagnostic_at(object.mesh_location, "cannot-read", mesh.error)
                                           : unknown_mesh(object));
        world.objects.push_back({.name = object.id,
                                 .mesh = mesh.value.mesh,
                                 .object_to_world = glm::mat4(make_transform(object)) * mesh.value.place,
                                 .instances = make_instances(object, mesh.value.place),
                                 .material = object.material,
                                 .lightmap = object.lightmap.path,
                                 .lightmap_encoding = object.lightmap_encoding,
                                 .shadow_mask = object.shadow_mask.path,
                                 .lightmap_place = object.lightmap.place,
                                 .shadow_mask_place = object.shadow_mask.place});
    }
    file.ok = std::none_of(file.diagnostics.begin(), file.diagnostics.end(),
                           [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
    return file;
}

WorldFile read_world(const Compiler& compiler, const std::string& path, const CompileOptions& options,
                     const EnvironmentProgress& progress) {
    SceneResult read = compiler.read_scene(path, options);
    read.dependencies.insert(read.dependencies.end(), read.missing.begin(), read.missing.end());
    if (!read.ok) {
        return {.diagnostics = std::move(read.diagnostics), .dependencies = std::move(read.dependencies)};
    }
    WorldFile file = make_world(read.scene, progress);
    file.diagnostics.insert(file.diagnostics.begin(), read.diagnostics.begin(), read.diagnostics.end());
    file.dependencies.insert(file.dependencies.begin(), read.dependencies.begin(), read.dependencies.end());
    return file;
}

}  // namespace patina::runtime

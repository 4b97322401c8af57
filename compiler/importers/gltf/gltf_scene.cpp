#include "compiler/importers/gltf/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "compiler/base/text.h"
#include "compiler/importers/gltf/own_names.h"
#include "compiler/importers/values.h"
#include "patina/scene.h"
#include "runtime/mesh/framing.h"

namespace patina::importers::gltf {
namespace {

using runtime::GltfModel;
using runtime::ModelCamera;
using runtime::ModelLight;
using runtime::ModelPart;

// What a scene's keys take (compiler/format).
constexpr float kFarthest = 1e6f, kFarthestEnd = 1e7f, kBrightest = 1e6f, kNarrowest = 1, kWidest = 170;
constexpr float kNearest = 1e-4f, kLeastHeight = 1e-3f;
constexpr float kPi = std::numbers::pi_v<float>;

// Rounding errors of a product of matrices are no part of a position.
constexpr int kDecimals = 6;
GraphValue rounded(float value, int decimals) {
    const double unit = std::pow(10.0, decimals);
    return std::round(static_cast<double>(value) * unit) / unit + 0.0;  // 0, not -0
}
GraphValue vector(const glm::vec3& v, int decimals = kDecimals) {
    return GraphValue::list({rounded(v.x, decimals), rounded(v.y, decimals), rounded(v.z, decimals)});
}

// The sphere that holds all that is drawn.
struct Extent {
    glm::vec3 middle{0};
    float radius = 0;
};
Extent extent_of(const GltfModel& model) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    const auto for_all = [&](const auto& take) {
        for (const ModelPart& part : model.parts) {
            for (const runtime::Vertex& vertex : part.mesh->vertices)
                take(glm::vec3(part.object_to_world * glm::vec4(vertex.position, 1)));
        }
    };
    for_all([&](const glm::vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    });
    if (!(low.x <= high.x)) return {};
    Extent made{.middle = (low + high) / 2.0f};
    for_all([&](const glm::vec3& point) { made.radius = std::max(made.radius, glm::length(point - made.middle)); });
    return made;
}

glm::vec3 forward_of(const glm::mat4& place) {
    return -glm::normalize(glm::vec3(place[2]));
}

// What is up for a camera that is turned about its view; nothing for one that is upright.
std::optional<glm::vec3> roll_of(const ModelCamera& camera) {
    const glm::vec3 forward = forward_of(camera.camera_to_world), up(0, 1, 0);
    const glm::vec3 own = glm::normalize(glm::vec3(camera.camera_to_world[1]));
    const glm::vec3 side = glm::cross(forward, glm::length(glm::cross(forward, up)) > 1e-6f ? up : glm::vec3(0, 0, -1));
    const bool is_upright =
        std::abs(glm::dot(side, own)) < 1e-5f * glm::length(side) && glm::dot(glm::cross(side, forward), own) > 0;
    return is_upright ? std::nullopt : std::optional(own);
}

// What is seen from where. `decimals`: as many as a view needs.
struct View {
    glm::vec3 position{0}, target{0};
    float near_plane = 0, far_plane = 0;
    int decimals = kDecimals;
};
constexpr float kFramedFov = 30;

// From a place before the model, if the file has no camera.
View framed(const Extent& extent) {
    const runtime::Framing framing = runtime::framing_of(extent.middle, extent.radius, kFramedFov);
    // Three digits of the distance are enough for a view.
    const float distance = glm::length(framing.position - framing.target);
    const bool has_distance = distance > 0 && std::isfinite(distance);
    return {.position = framing.position,
            .target = framing.target,
            .near_plane = framing.near_plane,
            .far_plane = framing.far_plane,
            .decimals = has_distance ? 3 - static_cast<int>(std::floor(std::log10(distance))) : kDecimals};
}

View view_of(const Extent& extent, const ModelCamera* camera) {
    if (!camera) return framed(extent);
    const glm::vec3 position(camera->camera_to_world[3]), forward = forward_of(camera->camera_to_world);
    // The target is as far as the model, so that a person who moves the camera turns around it.
    const float distance = std::max(glm::dot(extent.middle - position, forward), 1.0f);
    View view{.position = position, .target = position + forward * distance};
    // The float nearest to 0.0001 is less than that.
    view.near_plane = std::clamp(camera->near_plane, std::nextafter(kNearest, 1.0f), kFarthest);
    // Without an end of its own the view ends behind the model.
    const float behind = 2 * (glm::length(extent.middle - position) + extent.radius);
    view.far_plane = camera->far_plane > view.near_plane ? camera->far_plane : std::max(behind, 2 * view.near_plane);
    view.far_plane = std::min(view.far_plane, kFarthestEnd);
    return view;
}

GraphValue camera_value(const Extent& extent, const ModelCamera* camera) {
    const View view = view_of(extent, camera);
    GraphMembers members = {{"position", vector(view.position, view.decimals)},
                            {"target", vector(view.target, view.decimals)}};
    if (!camera) {
        members.push_back({"fov", kFramedFov});
        members.push_back({"near", rounded(view.near_plane, view.decimals + 1)});
        members.push_back({"far", rounded(view.far_plane, view.decimals - 1)});
        return GraphValue::object(members);
    }
    if (const std::optional<glm::vec3> up = roll_of(*camera)) members.push_back({"up", vector(*up)});
    if (camera->is_orthographic)
        members.push_back({"orthographic", std::clamp(camera->height, std::nextafter(kLeastHeight, 1.0f), kFarthest)});
    else
        members.push_back({"fov", rounded(std::clamp(camera->fov, kNarrowest, kWidest), 4)});
    members.push_back({"near", view.near_plane});
    members.push_back({"far", view.far_plane});
    return GraphValue::object(members);
}

// glTF's units are lux and candela; a scene's light is the radiance of a white diffuse surface: E / pi.
GraphValue light_value(const ModelLight& light, const Extent& extent) {
    const glm::vec3 position(light.light_to_world[3]), forward = forward_of(light.light_to_world);
    const bool is_directional = light.kind == ModelLight::Kind::Directional;
    GraphMembers members;
    switch (light.kind) {
        case ModelLight::Kind::Directional: members.push_back({"type", "directional"}); break;
        case ModelLight::Kind::Point: members.push_back({"type", "point"}); break;
        case ModelLight::Kind::Spot: members.push_back({"type", "spot"}); break;
    }
    if (!is_directional) members.push_back({"position", vector(position)});
    if (light.kind != ModelLight::Kind::Point)
        members.push_back({"direction", vector(is_directional ? -forward : forward)});
    if (light.color != glm::vec3(1)) members.push_back({"color", vector(light.color)});
    members.push_back({"intensity", std::min(light.intensity / kPi, kBrightest)});
    if (!is_directional) {
        const float endless = std::max(1000.0f, 100 * extent.radius);
        members.push_back({"range", std::clamp(light.range > 0 ? light.range : endless, 1e-3f, kFarthest)});
    }
    if (light.kind == ModelLight::Kind::Spot) {
        const float outer = std::clamp(light.outer_angle, 0.1f, 90.0f);
        members.push_back({"inner", rounded(std::clamp(light.inner_angle, 0.0f, std::min(outer, 89.0f)), 4)});
        members.push_back({"outer", rounded(outer, 4)});
    }
    return GraphValue::object(members);
}

// A word for an object: "Blue glass" is "Blue_glass".
std::string word_of(std::string_view name) {
    std::string word;
    for (const char letter : name) word += is_identifier(std::string("_") + letter) ? letter : '_';
    return is_identifier(word) ? word : "_" + word;
}

// How a scene names nodes: by their numbers if their names say something else, too.
std::vector<std::string> node_names(const GltfModel& model) {
    std::map<std::string_view, std::size_t> counts;
    for (const runtime::ModelNode& node : model.nodes) ++counts[node.name];
    std::vector<std::string> made;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const std::string& name = model.nodes[i].name;
        made.push_back(counts[name] == 1 && name.find('/') == name.npos ? name : fmt::format("node {}", i));
    }
    return made;
}

}  // namespace

std::string scene_text(const Context& context, const GltfModel& model, const SceneWish& wish) {
    const Extent extent = extent_of(model);
    GraphMembers members = {{"name", wish.name}, {"camera", camera_value(extent, wish.camera)}};
    if (model.lights.empty() && !wish.is_lit) {
        members.push_back(
            {"//", "The file has no lights: the default ones. In the light of a picture, leave them out."});
        members.push_back({"lights", default_lights()});
    } else if (!model.lights.empty()) {
        std::vector<GraphValue> lights;
        for (const ModelLight& light : model.lights) {
            if (lights.size() < kMostSceneLights) lights.push_back(light_value(light, extent));
        }
        members.push_back({"lights", GraphValue::list(std::move(lights))});
    }
    std::set<std::size_t> used(wish.materials.begin(), wish.materials.end());
    std::vector<GraphValue> materials, objects;
    std::map<std::size_t, std::string> names;
    OwnNames words('_');
    for (const std::size_t material : used) {
        const std::string& graph = wish.graphs[material];
        const std::string& name = names[material] = words.own(word_of(graph));
        materials.push_back(GraphValue::object({{"name", name}, {"graph", graph + ".graph.json"}}));
    }
    const std::string file = reference_to(context, context.path);
    const std::vector<std::string> nodes = node_names(model);
    OwnNames ids('_');
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
        const ModelPart& part = model.parts[i];
        const std::string mesh = fmt::format("{}#{}/{}", file, nodes[part.node_index], part.primitive);
        objects.push_back(GraphValue::object(
            {{"id", ids.own(word_of(part.node))}, {"mesh", mesh}, {"material", names[wish.materials[i]]}}));
    }
    if (!materials.empty()) members.push_back({"materials", GraphValue::list(std::move(materials))});
    if (!objects.empty()) members.push_back({"objects", GraphValue::list(std::move(objects))});
    return write_scene(members);
}

std::string scene_mistake(const GltfModel& model, const ModelCamera* camera) {
    const auto is_far = [](const glm::vec3& place) {
        return !(std::abs(place.x) <= kFarthest && std::abs(place.y) <= kFarthest && std::abs(place.z) <= kFarthest);
    };
    const View view = view_of(extent_of(model), camera);
    if (is_far(view.position) || is_far(view.target))
        return fmt::format(
            "the camera {} more than {:.0f} away from the origin, which no scene can say: scale the model",
            camera ? "is or looks" : "that sees all of it is", kFarthest);
    if (view.near_plane < kNearest || view.far_plane < kLeastHeight || view.far_plane > kFarthestEnd)
        return fmt::format("the view would be {:g} to {:g} deep, and a scene's is {:g} to {:g}: scale the model",
                           view.near_plane, view.far_plane, 1e-4, kFarthestEnd);
    for (const ModelLight& light : model.lights)
        if (light.kind != ModelLight::Kind::Directional && is_far(glm::vec3(light.light_to_world[3])))
            return fmt::format(
                "the light at the node '{}' is more than {:.0f} away from the origin, which no scene can "
                "say: scale the model",
                light.node, kFarthest);
    return {};
}

const ModelCamera* find_camera(const GltfModel& model, const std::string& name) {
    for (const ModelCamera& camera : model.cameras) {
        if (name.empty() || camera.node == name || camera.name == name) return &camera;
    }
    return nullptr;
}

void report_view(const Context& context, const GltfModel& model, const ModelCamera* camera) {
    for (const ModelCamera& each : model.cameras) {
        Object from = element(context, "cameras", each.index);
        const bool is_seen = &each == camera;
        const Remark::Kind kind = is_seen ? Remark::Kind::Taken : Remark::Kind::LeftOut;
        context.report.add(kind, from.path(),
                           is_seen ? fmt::format("the camera of the scene, at the node '{}'", each.node)
                                   : fmt::format("a scene has one camera; 'patina render MODEL --camera \"{}\"' draws "
                                                 "through this one",
                                                 each.node),
                           from.json());
        if (!is_seen) continue;
        Object lens = from.child(each.is_orthographic ? "orthographic" : "perspective");
        lens.changed("aspectRatio", "the picture's width and height decide");
        lens.changed("xmag", "the picture's width and height decide");
        if (each.far_plane == 0) lens.changed("znear", "with an end of the view behind the model: the file has none");
        if (!each.is_orthographic && (each.fov < kNarrowest || each.fov > kWidest))
            lens.changed("yfov", fmt::format("between {} and {} degrees", kNarrowest, kWidest));
    }
    for (std::size_t i = 0; i < model.lights.size(); ++i) {
        const ModelLight& light = model.lights[i];
        const Json* list = context.root.find("extensions")->find("KHR_lights_punctual")->find("lights");
        Object from(context.report, &list->elements[light.index],
                    fmt::format("extensions.KHR_lights_punctual.lights[{}]", light.index));
        if (i >= kMostSceneLights) {
            context.report.add(Remark::Kind::LeftOut, from.path(),
                               fmt::format("a scene has at most {} lights", kMostSceneLights), from.json());
            continue;
        }
        context.report.add(Remark::Kind::Taken, from.path(),
                           fmt::format("lights[{}] of the scene, at the node '{}'; intensity over pi", i, light.node),
                           from.json());
        if (light.kind == ModelLight::Kind::Directional) continue;
        if (light.range > 0)
            from.changed("range", "the same range, towards which light fades by the square of glTF's window");
        else
            context.report.add(Remark::Kind::Changed, from.path(), "a range, which a scene's light needs, far outside",
                               from.json());
        if (light.intensity / kPi > kBrightest) from.changed("intensity", "the brightest light of a scene");
    }
}

}  // namespace patina::importers::gltf

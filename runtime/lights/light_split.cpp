#include "runtime/lights/light_split.h"

#include <algorithm>
#include <cmath>

namespace patina::runtime {
namespace {

// Rec. 709.
float luminance(glm::vec3 color) {
    return glm::dot(color, glm::vec3(0.2126729f, 0.7151522f, 0.0721750f));
}

// distanceAttenuation() of nodes/stage/lights.node.hlsl.
float distance_attenuation(float distance, float range) {
    if (distance >= range) return 0;
    float squared = distance * distance, ratio = squared / (range * range);
    float window = 1 - ratio * ratio;
    return window * window / std::max(squared, 0.0001f);
}

// `angle`: radians from the spot's axis.
float cone_attenuation(const Light& light, float angle) {
    float inner = std::cos(glm::radians(light.inner_angle)), outer = std::cos(glm::radians(light.outer_angle));
    float share = std::clamp((std::cos(angle) - outer) / std::max(inner - outer, 0.001f), 0.0f, 1.0f);
    return share * share;
}

// Radians between the spot's axis and the way to a point; on the axis where the point is the spot itself.
float angle_to(const Light& light, glm::vec3 point) {
    glm::vec3 way = point - light.position;
    if (way == glm::vec3(0)) return 0;
    return std::acos(std::clamp(glm::dot(glm::normalize(way), glm::normalize(light.direction)), -1.0f, 1.0f));
}

}  // namespace

std::optional<std::size_t> main_light(std::span<const Light> lights) {
    std::optional<std::size_t> brightest;
    for (std::size_t i = 0; i < lights.size(); i++) {
        const Light& light = lights[i];
        if (light.kind != LightKind::Directional) continue;
        if (!brightest || luminance(light.color) > luminance(lights[*brightest].color)) brightest = i;
    }
    return brightest;
}

std::vector<std::size_t> light_order(std::span<const Light> lights) {
    std::vector<std::size_t> order(lights.size());
    for (std::size_t i = 0; i < order.size(); i++) order[i] = i;
    std::optional<std::size_t> main = main_light(lights);
    auto group = [&](std::size_t i) { return i == main ? 0 : lights[i].kind == LightKind::Directional ? 1 : 2; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return group(a) < group(b); });
    return order;
}

float attenuation_within(const Light& light, const Sphere& sphere) {
    if (light.kind == LightKind::Directional) return 1;
    float distance = glm::distance(light.position, sphere.center);
    float attenuation = distance_attenuation(std::max(distance - sphere.radius, 0.0f), light.range);
    if (light.kind == LightKind::Point || distance <= sphere.radius) return attenuation;
    // Seen from the spot the sphere is a disc of this angular radius.
    float half = std::asin(sphere.radius / distance);
    return attenuation * cone_attenuation(light, std::max(angle_to(light, sphere.center) - half, 0.0f));
}

LightSplit split_lights(std::span<const Light> lights, const Sphere& object, int pixel_light_count) {
    LightSplit split{.main = main_light(lights)};

    struct Candidate {
        std::size_t light = 0;
        float brightness = 0;
    };
    std::vector<Candidate> candidates;
    int left = pixel_light_count - (split.main ? 1 : 0);  // for those that are neither main nor important
    for (std::size_t i = 0; i < lights.size(); i++) {
        float attenuation = attenuation_within(lights[i], object);
        if (i == split.main || attenuation <= 0) continue;
        candidates.push_back({.light = i, .brightness = luminance(lights[i].color) * attenuation});
        if (lights[i].importance == LightImportance::Important) left--;
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.brightness > b.brightness; });

    for (const Candidate& candidate : candidates) {
        const Light& light = lights[candidate.light];
        bool is_per_pixel =
            light.importance == LightImportance::Important || (light.importance == LightImportance::Auto && left-- > 0);
        bool is_per_vertex = light.kind == LightKind::Point && split.vertex.size() < kMostVertexLights;
        (is_per_pixel ? split.further : is_per_vertex ? split.vertex : split.sh).push_back(candidate.light);
    }
    return split;
}

void add_light(SphericalHarmonics& sum, const Light& light, const Sphere& object) {
    if (light.kind == LightKind::Directional) {
        add_light(sum, glm::normalize(light.direction), light.color);
        return;
    }
    glm::vec3 way = light.position - object.center;
    float distance = glm::length(way);
    float attenuation = distance_attenuation(std::max(distance, object.radius), light.range);
    if (light.kind == LightKind::Spot) attenuation *= cone_attenuation(light, angle_to(light, object.center));
    if (attenuation <= 0) return;
    SphericalHarmonics added;
    add_light(added, distance > 0 ? way / distance : glm::vec3(0, 1, 0), light.color * attenuation);
    // In the very middle it comes from no side: its mean alone counts.
    for (std::size_t i = 0; i < (distance > 0 ? added.coefficients.size() : 1); i++)
        sum.coefficients[i] += added.coefficients[i];
}

}  // namespace patina::runtime

#include "runtime/engine_values.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

namespace patina::runtime {
namespace {

EngineValue scalar(double value) {
    return {1, {value}};
}

EngineValue vectors(std::initializer_list<glm::vec3> values) {
    EngineValue result{3, {}};
    for (const glm::vec3& v : values) result.numbers.insert(result.numbers.end(), {v.x, v.y, v.z});
    return result;
}

EngineValue matrix(const glm::mat4& m) {
    EngineValue result{4, {}};
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) result.numbers.push_back(m[column][row]);
    return result;
}

void append(EngineValue& value, glm::vec3 xyz, double w) {
    value.numbers.insert(value.numbers.end(), {xyz.x, xyz.y, xyz.z, w});
}

void add_lights(std::map<std::string, EngineValue>& values, std::vector<Light> lights) {
    // A material graph's own light semantics mean the first light: let that be the sun where there is one.
    std::stable_partition(lights.begin(), lights.end(),
                          [](const Light& light) { return light.kind == LightKind::Directional; });
    if (lights.size() > kMostLights) lights.resize(kMostLights);

    EngineValue position{4, {}}, color{4, {}}, axis{4, {}}, cone{4, {}};
    for (const Light& light : lights) {
        glm::vec3 direction = glm::normalize(light.direction);
        bool is_directional = light.kind == LightKind::Directional;
        bool is_spot = light.kind == LightKind::Spot;
        append(position, is_directional ? direction : light.position, is_directional ? 0 : is_spot ? 2 : 1);
        append(color, light.color, light.range);
        append(axis, is_spot ? direction : glm::vec3(0, 0, -1), 0);
        double inner = std::cos(glm::radians(light.inner_angle)), outer = std::cos(glm::radians(light.outer_angle));
        append(cone, {float(inner), float(outer), 0}, 0);
    }
    values["light_count"] = scalar(double(lights.size()));
    values["light_position"] = position;
    values["light_color"] = color;
    values["light_axis"] = axis;
    values["light_cone"] = cone;
}

}  // namespace

std::map<std::string, EngineValue> engine_values(const Scene& scene) {
    const Camera& camera = scene.camera;
    glm::mat4 view = world_to_view(camera);
    glm::mat4 projection = view_to_clip(camera, float(scene.width) / float(scene.height));

    std::map<std::string, EngineValue> values;
    values["world_to_clip"] = matrix(projection * view);
    values["world_to_view"] = matrix(view);
    values["camera_position_ws"] = vectors({camera.position});
    values["camera_forward_ws"] = vectors({glm::normalize(camera.target - camera.position)});
    values["view_is_orthographic"] = scalar(camera.orthographic_height || camera.clip_space ? 1 : 0);
    values["object_to_world"] = matrix(scene.object_to_world);
    values["world_to_object"] = matrix(glm::inverse(scene.object_to_world));
    values["time"] = scalar(scene.time);
    values["screen_size"] = {2, {double(scene.width) * scene.samples, double(scene.height) * scene.samples}};
    add_lights(values, scene.lights);

    EngineValue ambient{4, {}};
    for (const glm::vec3& coefficient : scene.ambient.coefficients) append(ambient, coefficient, 0);
    values["ambient_sh"] = ambient;
    return values;
}

}  // namespace patina::runtime

// The room `scene`: scenes and worlds as plain data, and the words and files that describe them. It does not compile
// materials, and does not know how they are drawn.
//
// The scene of one material: mesh, camera, lights, ambient light, time and the size of the picture. It is plain data
// with useful defaults, and knows no material. scene_text.h reads its parts from the words of the command line.
//
//   Scene scene = default_scene("sphere");
//   scene.lights = {{.color = glm::vec3(2)}};
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "patina/interpret.h"
#include "patina/words.h"
#include "runtime/lighting/environment.h"
#include "runtime/mesh/mesh.h"

namespace patina::runtime {

struct Camera {
    glm::vec3 position{0, 0, 4};
    glm::vec3 target{0};
    glm::vec3 up{0, 1, 0};                       // what is up in the picture; any length but 0; along the view, -z is
    float fov = 30;                              // degrees, vertical
    std::optional<float> orthographic_height{};  // world units; set: parallel projection
    bool clip_space = false;                     // positions are clip space already; all matrices are identity
    float near_plane = 0.05f, far_plane = 100;
    ClipDepth clip_depth = ClipDepth::NearToFar;  // that its shaders expect (Reflection::clip_depth)
};

struct LightShadow {
    bool casts = false;
    float strength = 1;        // 0 to 1: how dark
    float bias = 0.05f;        // metres along the light's direction
    float normal_bias = 0.4f;  // texels of the shadow map that a surface is shrunk by, along its normal
};

struct Light {
    LightKind kind = LightKind::Directional;
    glm::vec3 position{0, 2, 2};        // point and spot
    glm::vec3 direction{-0.5, 0.7, 1};  // directional: towards the light. Spot: where it points. Any length but 0
    glm::vec3 color{1};                 // linear, times intensity; E / pi: what a white Lambert surface sends out
    float range = 10;                   // metres; no light beyond
    float inner_angle = 20, outer_angle = 30;  // degrees from a spot's axis: full light within, none outside
    LightImportance importance = LightImportance::Auto;
    LightShadow shadow{};
    std::shared_ptr<const TextureData> cookie{};  // what the light shines through: its red; null: nothing
    float cookie_size = 10;  // metres that a directional light's cookie spans; a spot's fills its cone
};

struct Fog {
    FogMode mode = FogMode::None;
    glm::vec3 color{0.5f};      // linear
    float density = 0.05f;      // exponential: per metre
    float start = 5, end = 50;  // linear: metres
};

struct MixedLighting {
    LightMixing mode = LightMixing::ShadowMask;
    glm::vec3 shadow_color{0};               // subtractive: linear; no shadow darkens a lightmap below it
    std::optional<float> shadow_distance{};  // metres along the camera's axis; no real-time shadow beyond
    std::optional<float> shadow_fade{};      // metres before it over which they fade; nothing: a fifth of it
};

// What objects near it reflect, instead of the environment.
struct Probe {
    std::shared_ptr<const Environment> environment{};  // never null
    glm::vec3 position{0};                             // where it was taken
    glm::vec3 box_min{-1}, box_max{1};
    float blend = 0;               // metres outside of the box over which it fades
    bool is_box_projected = true;  // what it shows is at the walls of the box, not far away
    int importance = 1;
};

inline constexpr std::size_t kMostLights = 16;
inline constexpr float kMostDegrees = 1e5f, kMostIntensity = 1e6f;  // of an environment's rotation, and its factor

// A number of seconds that a shader's float can hold.
bool is_time(double seconds);

struct Scene {
    Mesh mesh{};
    glm::mat4 object_to_world{1};
    Camera camera{};
    std::vector<Light> lights{};                       // at most kMostLights
    SphericalHarmonics ambient{};                      // what is around, for diffuse light
    std::shared_ptr<const Environment> environment{};  // the same for mirrors; null: what `ambient` says
    std::optional<float> picture_intensity{};          // if `environment` is a picture: how much brighter than it
    std::vector<Probe> probes{};
    Fog fog{};
    MixedLighting mixed_lighting{};
    float time = 0;  // seconds
    int width = 512, height = 512;
    int samples = 1;                                // per pixel along each axis: 4 averages 16
    glm::vec4 background{0.03f, 0.03f, 0.032f, 1};  // linear
    SceneBackdrop backdrop = SceneBackdrop::Color;  // else it hides the colour
    // Nobody asked for this background. If there is a picture of the surroundings, materials that read the picture
    // behind them show it.
    bool is_default_background = false;
};

// The studio that `patina render` uses: a key light from the upper left front, a weak cool fill, a rim, the studio
// environment, and a camera that frames the mesh. An unknown mesh name gives a scene without triangles: ask
// mesh_names() first.
Scene default_scene(std::string_view mesh);
std::vector<Light> default_lights();
Camera default_camera(std::string_view mesh);

// Width by height pixels of one quad, straight from clip space, unlit, one sample a pixel, on transparent black.
Scene fullscreen_scene(int width, int height);

// The exposure, in stops, for surroundings from a picture that are the only light: a white matt surface stays below
// white in every direction. The picture's intensity still makes it brighter. 0 for other light.
double exposure_for(const Scene& scene);

glm::mat4 world_to_view(const Camera& camera);
// Right-handed view space, clip space with y up and depth 0 (near) to 1 (far).
glm::mat4 view_to_clip(const Camera& camera, float aspect);

}  // namespace patina::runtime

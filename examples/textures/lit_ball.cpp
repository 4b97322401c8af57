// A picture of a lit ball, as a matcap wants it: a mirroring ball in a studio with two soft boxes, seen from far away.
#include <algorithm>
#include <cmath>

#include "examples/textures/noise.h"
#include "examples/textures/sets.h"

namespace textures {
namespace {

// 1 inside a box of the given half size around the origin, soft over `blur`.
float box(float x, float y, float half_x, float half_y, float blur) {
    const float distance = std::max(std::abs(x) - half_x, std::abs(y) - half_y);
    return 1 - smoothstep(-blur, blur, distance);
}

// What the studio sends out towards the ball from direction (x, y, z): y up, z to the viewer.
Color studio(float x, float y, float z) {
    const Color floor = {0.20f, 0.18f, 0.17f, 1}, wall = {0.42f, 0.44f, 0.48f, 1}, ceiling = {0.60f, 0.64f, 0.70f, 1};
    Color light = mix(floor, wall, smoothstep(-0.45f, 0.1f, y));
    light = mix(light, ceiling, smoothstep(0.2f, 0.9f, y));
    light = scaled(light, 0.85f + 0.15f * z);
    // A large box at the upper left, and a narrow warm one at the right.
    const float key = y > 0.05f ? box(x / y + 0.75f, z / y - 0.55f, 0.5f, 0.4f, 0.08f) : 0.0f;
    const float fill = x > 0.05f ? box(y / x - 0.1f, z / x - 0.1f, 0.7f, 0.16f, 0.06f) : 0.0f;
    light = mix(light, {1, 1, 1, 1}, 0.95f * key);
    return mix(light, {1.0f, 0.87f, 0.70f, 1}, 0.7f * fill);
}

}  // namespace

Set lit_ball() {
    Picture ball(kSize / 2);
    ball.fill([](float u, float v) {
        float x = 2 * u - 1, y = 1 - 2 * v;
        // Beyond the outline the outline goes on, so that no filter finds a seam.
        const float reach = std::max(1.0f, std::sqrt(x * x + y * y) / 0.995f);
        x /= reach;
        y /= reach;
        const float z = std::sqrt(std::max(1 - x * x - y * y, 0.0f));
        return studio(2 * z * x, 2 * z * y, 2 * z * z - 1);
    });
    return {{"lit_ball", 3, ball}};
}

}  // namespace textures

// What surrounds a surface: camera, object, light, and what was drawn before.

// Values of the camera that no semantic gives.
float2 CameraPlanes() {
    return clipPlanes;
}
float CameraIsOrthographic() {
    return viewIsOrthographic;
}
// Width and height in metres of what an orthographic camera sees: clip space is two units wide. Zero in perspective.
float2 OrthographicSize() {
    float across = length(worldToClip[0].xyz);
    float upwards = length(worldToClip[1].xyz);
    return 2 * viewIsOrthographic / float2(across, upwards);
}

/// The camera: where it is, where it looks, and what it sees.
///
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 0, float2(0.1, 50), float2(0, 0)) == float3(1, 2, 3)
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 0, float2(0.1, 50), float2(0, 0)).direction == float3(0, 0, -1)
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 1, float2(0.1, 50), float2(4, 3)).orthographic == 1
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 1, float2(0.1, 50), float2(4, 3)).nearPlane == 0.1
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 1, float2(0.1, 50), float2(4, 3)).farPlane == 50
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 1, float2(0.1, 50), float2(4, 3)).width == 4
/// test: Camera(float3(1, 2, 3), float3(0, 0, -1), 1, float2(0.1, 50), float2(4, 3)).height == 3
[node("Input/Camera")]
float3 Camera(
    [hidden] [unit("m")] float3 position = cameraPositionWS,    ///< position in world space
    [hidden] float3 forward = cameraForwardWS,                  ///< where it looks
    [hidden] float isOrthographic = CameraIsOrthographic(),     ///< 1: orthographic
    [hidden] [unit("m")] float2 planes = CameraPlanes(),        ///< distances of the near and the far plane
    [hidden] [unit("m")] float2 view = OrthographicSize(),      ///< size of an orthographic view
    out float3 direction,          ///< where it looks, in world space
    out float orthographic,        ///< 1: orthographic, 0: perspective
    [unit("m")] out float nearPlane,  ///< distance of the near plane
    [unit("m")] out float farPlane,   ///< distance of the far plane
    [unit("m")] out float width,      ///< width of an orthographic view; zero in perspective
    [unit("m")] out float height      ///< height of an orthographic view; zero in perspective
) {
    direction = forward;
    orthographic = isOrthographic;
    nearPlane = planes.x;
    farPlane = planes.y;
    width = view.x;
    height = view.y;
    return position;
}

/// The object's scale: the lengths of its three axes in world space.
///
/// test: ObjectScale(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Object Scale")]
float3 ObjectScale(
    [hidden] float3 scale = objectScale  ///< the lengths
) {
    return scale;
}

/// The direction in which the main directional light shines: from the light. `@light.direction`, to the light, is its opposite.
///
/// test: MainLightDirection(float3(0.6, 0.8, 0)) == float3(-0.6, -0.8, 0)
/// test: MainLightDirection(float3(0, 1, 0)) == float3(0, -1, 0)
[node("Input/Light/Main Light Direction")] [also("SunDirection")]
float3 MainLightDirection(
    [hidden] float3 toLight = light.direction  ///< to the light
) {
    return -toLight;
}

/// The ambient light on surfaces that face up, to the sides and down: the radiance of a white one.
[node("Input/Light/Ambient")] [also("AmbientColor", "SkyColor")]
float3 Ambient(
    out float3 equator,  ///< on walls: the mean of all directions
    out float3 ground    ///< on surfaces that face down
) {
    // The mean of four directions is that of all: the second order of spherical harmonics has no higher frequency.
    float3 alongX = AmbientIrradiance(float3(1, 0, 0)) + AmbientIrradiance(float3(-1, 0, 0));
    float3 alongZ = AmbientIrradiance(float3(0, 0, 1)) + AmbientIrradiance(float3(0, 0, -1));
    equator = (alongX + alongZ) * 0.25;
    ground = AmbientIrradiance(float3(0, -1, 0));
    return AmbientIrradiance(float3(0, 1, 0));
}

/// The light of the environment from the direction that a surface mirrors, blurred by a mip level.
///
/// formula: EnvironmentRadiance(reflect(-view, normal), r), r the roughness of the level: level / 5 = r (1.7 - 0.7 r)
[node("Input/Light/Reflection Probe")]
float3 ReflectionProbe(
    float3 view = viewDirWS,        ///< direction to the viewer, in world space
    float3 normal = normalWS,       ///< unit normal, in world space
    [range(0, 5)] float level = 0  ///< 0: a mirror, 5: the roughest surface
) {
    float roughness = (1.7 - sqrt(2.89 - 2.8 * saturate(level / 5))) / 1.4;
    return EnvironmentRadiance(reflect(-view, normal), roughness);
}

/// Distance of the surface drawn so far, as a fraction of the far plane's: 0 at the camera, 1 at the far plane.
[node("Input/Scene/Scene Depth Linear 01")] [inFloat]
float SceneDepthLinear01(
    float2 uv = screenUV  ///< position on the screen, 0 to 1 from the top left
) {
    return SceneDepth(uv) / clipPlanes.y;
}

/// Depth of the surface drawn so far as a depth buffer holds it: 0 at the near plane, 1 at the far plane.
///
/// formula: f (z - n) / (z (f - n)), z = SceneDepth; orthographic: (z - n) / (f - n)
[node("Input/Scene/Scene Depth Raw")] [inFloat]
float SceneDepthRaw(
    float2 uv = screenUV  ///< position on the screen, 0 to 1 from the top left
) {
    float eye = SceneDepth(uv);
    float share = (eye - clipPlanes.x) / (clipPlanes.y - clipPlanes.x);
    return share * lerp(clipPlanes.y / max(eye, 1e-6), 1, viewIsOrthographic);
}

/// How far the surface drawn so far is behind a point, in metres along the camera's axis.
[node("Input/Scene/Scene Depth Difference")] [inFloat]
float SceneDepthDifference(
    float2 uv = screenUV,                     ///< position on the screen, 0 to 1 from the top left
    [unit("m")] float3 position = positionWS  ///< the point, in world space
) {
    return SceneDepth(uv) - dot(position - cameraPositionWS, cameraForwardWS);
}

/// Fades a transparent surface out where it meets what is behind it: soft particles, foam at a shore.
///
/// formula: saturate(SceneDepthDifference / distance)
/// source: Lorach, "Soft Particles", NVIDIA, 2007
[node("Input/Scene/Depth Fade")] [also("SoftParticles", "DepthBlend")] [range(0, 1)] [inFloat]
float DepthFade(
    [range(0.001, 100)] [unit("m")] float distance = 1,  ///< how far behind the surface fading ends; not zero
    float2 uv = screenUV,                     ///< position on the screen, 0 to 1 from the top left
    [unit("m")] float3 position = positionWS  ///< the point that fades, in world space
) {
    return saturate(SceneDepthDifference(uv, position) / distance);
}

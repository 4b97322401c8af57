// What a depth buffer says: how far away the surface behind a pixel is, and where. Depth is 0 at the near plane and 1 at
// the far plane.

/// How a camera projects.
enum CameraProjection {
    Perspective,  ///< what is far away is small
    Orthographic  ///< sizes do not depend on distance
};

/// Distance from the camera's plane of a depth in the depth buffer.
///
/// formula: perspective: n f / (f - d (f - n)); orthographic: n + d (f - n)
/// source: the inverse of a projection to depths from 0 to 1: d = f (z - n) / (z (f - n)), or (z - n) / (f - n)
/// test: LinearEyeDepth(0, 0.5, 100) == 0.5
/// test: LinearEyeDepth(0.5025125628140703, 0.5, 100) == 1
/// test: LinearEyeDepth(1, 0.5, 100) == 100
/// test: LinearEyeDepth(0.25, 2, 10, Orthographic) == 4
[node("Input/Depth/Linear Eye Depth")]
float LinearEyeDepth(
    [range(0, 1)] float depth,                               ///< of the depth buffer
    [range(0.001, 100)] [unit("m")] float nearPlane = 0.1,  ///< distance of the near plane
    [range(0.1, 10000)] [unit("m")] float farPlane = 100,   ///< distance of the far plane
    const CameraProjection projection = Perspective          ///< the camera's
) {
    if (projection == Orthographic) { return lerp(nearPlane, farPlane, depth); }
    return nearPlane * farPlane / lerp(farPlane, nearPlane, depth);
}

/// The same distance as a share of the far plane's: 1 there, and 0 at the camera.
///
/// formula: z / f, z the distance from the camera's plane
/// source: Unity built-in shaders, Linear01Depth
/// test: Linear01Depth(0, 0.5, 100) == 0.005
/// test: Linear01Depth(0.5025125628140703, 0.5, 100) == 0.01
/// test: Linear01Depth(1, 0.5, 100) == 1
/// test: Linear01Depth(0.25, 2, 10, Orthographic) == 0.4
[node("Input/Depth/Linear 01 Depth")]
float Linear01Depth(
    [range(0, 1)] float depth,                               ///< of the depth buffer
    [range(0.001, 100)] [unit("m")] float nearPlane = 0.1,  ///< distance of the near plane
    [range(0.1, 10000)] [unit("m")] float farPlane = 100,   ///< distance of the far plane
    const CameraProjection projection = Perspective          ///< the camera's
) {
    return LinearEyeDepth(depth, nearPlane, farPlane, projection) / farPlane;
}

/// The point in clip space that a pixel and its depth stand for; its w is 1.
///
/// formula: (2 u - 1, 1 - 2 v, depth, 1)
/// test: ClipFromScreen(float2(0, 0), 0.5) == float4(-1, 1, 0.5, 1)
/// test: ClipFromScreen(float2(0.75, 1), 1) == float4(0.5, -1, 1, 1)
[node("Input/Depth/Clip from Screen")]
float4 ClipFromScreen(
    float2 uv = screenUV,     ///< position on the screen, 0 to 1 from the top left
    [range(0, 1)] float depth  ///< of the depth buffer
) {
    return float4(2 * uv.x - 1, 1 - 2 * uv.y, depth, 1);
}

/// The point in the world that a pixel and its depth stand for. `clipToWorld` is the inverse of the camera's view and
/// projection.
[inFloat]
float3 WorldFromDepth(float2 uv, float depth, float4x4 clipToWorld) {
    float4 pointWS = mul(clipToWorld, ClipFromScreen(uv, depth));
    return pointWS.xyz / pointWS.w;
}

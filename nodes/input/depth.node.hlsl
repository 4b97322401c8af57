// Reading a depth buffer: the distance and the position of the surface behind a pixel. Depth is 0 at the near plane and
// 1 at the far plane.

/// How a camera projects.
enum CameraProjection {
    Perspective,  ///< distant objects look smaller
    Orthographic  ///< sizes do not depend on distance
};

/// Converts a depth of the depth buffer to the distance from the camera's plane.
///
/// formula: perspective: n f / (f - d (f - n)); orthographic: n + d (f - n)
/// source: the inverse of a projection to depths from 0 to 1: d = f (z - n) / (z (f - n)), or (z - n) / (f - n)
/// test: LinearEyeDepth(0, 0.5, 100) == 0.5
/// test: LinearEyeDepth(0.5025125628140703, 0.5, 100) == 1
/// test: LinearEyeDepth(1, 0.5, 100) == 100
/// test: LinearEyeDepth(0.25, 2, 10, Orthographic) == 4
[node("Input/Depth/Linear Eye Depth")]
float LinearEyeDepth(
    [range(0, 1)] float depth,                               ///< depth from the depth buffer
    [range(0.001, 100)] [unit("m")] float nearPlane = 0.1,  ///< distance of the near plane
    [range(0.1, 10000)] [unit("m")] float farPlane = 100,   ///< distance of the far plane
    const CameraProjection projection = Perspective          ///< projection of the camera
) {
    if (projection == Orthographic) { return lerp(nearPlane, farPlane, depth); }
    return nearPlane * farPlane / lerp(farPlane, nearPlane, depth);
}

/// Converts a depth of the depth buffer to a fraction of the far plane's distance: 0 at the camera, 1 at the far plane.
///
/// formula: z / f, z the distance from the camera's plane
/// source: Unity built-in shaders, Linear01Depth
/// test: Linear01Depth(0, 0.5, 100) == 0.005
/// test: Linear01Depth(0.5025125628140703, 0.5, 100) == 0.01
/// test: Linear01Depth(1, 0.5, 100) == 1
/// test: Linear01Depth(0.25, 2, 10, Orthographic) == 0.4
[node("Input/Depth/Linear 01 Depth")]
float Linear01Depth(
    [range(0, 1)] float depth,                               ///< depth from the depth buffer
    [range(0.001, 100)] [unit("m")] float nearPlane = 0.1,  ///< distance of the near plane
    [range(0.1, 10000)] [unit("m")] float farPlane = 100,   ///< distance of the far plane
    const CameraProjection projection = Perspective          ///< projection of the camera
) {
    return LinearEyeDepth(depth, nearPlane, farPlane, projection) / farPlane;
}

/// The position in clip space of a pixel with its depth; w is 1.
///
/// formula: (2 u - 1, 1 - 2 v, z, 1), where z is depth, or 2 depth - 1 in an engine whose clip space begins at -1
/// test: ClipFromScreen(float2(0, 0), 0.5) == float4(-1, 1, 0.5, 1)
/// test: ClipFromScreen(float2(0.75, 1), 1) == float4(0.5, -1, 1, 1)
[node("Input/Depth/Clip from Screen")]
float4 ClipFromScreen(
    float2 uv = screenUV,     ///< position on the screen, 0 to 1 from the top left
    [range(0, 1)] float depth  ///< depth from the depth buffer
) {
    return float4(2 * uv.x - 1, 1 - 2 * uv.y, symmetricDepth ? 2 * depth - 1 : depth, 1);
}

/// The position in world space of a pixel with its depth. `clipToWorld` is the inverse of the camera's view-projection
/// matrix.
[inFloat]
float3 WorldFromDepth(float2 uv, float depth, float4x4 clipToWorld) {
    float4 pointWS = mul(clipToWorld, ClipFromScreen(uv, depth));
    return pointWS.xyz / pointWS.w;
}

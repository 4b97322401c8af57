// The camera and the frame. Clip space is y up, its depth is the engine's; view space looks along -z.

/// Seconds since the start.
/// unit: s
/// block: The frame as a whole. The engine fills it once a frame.
[extern("Frame")] [semantic("uniform")] float time;
/// Size of the picture in pixels.
/// unit: pixels
/// space: screen
[extern("Frame")] [semantic("uniform")] float2 screenSize;

/// World to clip space: view and projection.
/// space: world to clip
/// block: The camera. The engine fills it for each view: of the camera, and of each light that draws a shadow map.
[extern("Camera")] float4x4 worldToClip;
/// World to view space.
/// space: world to view
[extern("Camera")] float4x4 worldToView;
/// Camera position in world space.
/// unit: m
/// space: world
[extern("Camera")] [semantic("uniform")] float3 cameraPositionWS;
/// 1: the view is orthographic, so that it looks along the same direction everywhere; 0: perspective.
[extern("Camera")] float viewIsOrthographic;
/// Direction that the camera looks along in world space, unit.
/// space: world
[extern("Camera")] [semantic("uniform")] float3 cameraForwardWS;

/// In a light's own view: how far everything is moved away from the light.
/// unit: m
[extern("Camera")] float shadowBias;
/// The inverse of worldToClip.
/// space: clip to world
[extern("Camera")] float4x4 clipToWorld;
/// Distances of the near plane (x) and of the far plane (y).
/// unit: m
[extern("Camera")] float2 clipPlanes;
/// In a light's own view: how far a surface is moved inwards, at w = 1.
/// unit: m
[extern("Camera")] float shadowNormalBias;

/// Pixels, textures and texture coordinates of the engine count from the bottom.
[static("uvOrigin", "bottom")] bool uvFromBottom;
/// Depth in clip space is from -1 to 1.
[static("clip", "symmetric")] bool symmetricDepth;

/// Direction from the surface to the camera in world space, unit.
[semantic("pixel")]
float3 viewDirWS(float3 position = positionWS) {
    return normalize(lerp(cameraPositionWS - position, -cameraForwardWS, viewIsOrthographic));
}

/// Position in view space: the camera looks along -z.
[semantic("pixel")]
float3 positionVS(float3 position = positionWS) {
    return mul(worldToView, float4(position, 1)).xyz;
}

/// Normal in view space, unit.
[semantic("pixel")]
float3 normalVS(float3 normal = normalWS) {
    return normalize(mul(worldToView, float4(normal, 0)).xyz);
}

[reads("color")] Texture2D colorTexture;
[reads("depth")] Texture2D depthTexture;

/// The colour drawn so far at a place of the screen, linear. The material is drawn after all that do not read it.
[node("Input/Scene/Scene Color")]
float3 SceneColor(
    float2 uv = screenUV  ///< position on the screen, 0 to 1 from the top left
) {
    return colorTexture.SampleLevel(uv, 0).rgb;
}

/// Distance in metres, along the camera's axis, of the surface drawn so far at a place of the screen.
[node("Input/Scene/Scene Depth")] [also("CameraDepth")] [inFloat]
float SceneDepth(
    float2 uv = screenUV  ///< position on the screen, 0 to 1 from the top left
) {
    float3 behind = WorldFromDepth(uv, depthTexture.SampleLevel(uv, 0).r, clipToWorld);
    return dot(behind - cameraPositionWS, cameraForwardWS);
}

/// The place on the screen at which a point of the world appears.
///
/// The point must be in front of the camera.
[node("Input/Scene/Screen from World")] [inFloat]
float2 ScreenFromWorld(
    [unit("m")] float3 position = positionWS  ///< the point, in world space
) {
    float4 clip = mul(worldToClip, float4(position, 1));
    return float2(0.5, -0.5) * clip.xy / max(clip.w, 1e-6) + 0.5;
}

/// The colour drawn so far behind this pixel, linear. The material is drawn after all that do not read it.
[semantic("pixel")]
float3 sceneColor(float2 uv = screenUV) {
    return SceneColor(uv);
}

/// Distance in metres, along the camera's axis, of the surface drawn so far behind this pixel.
[semantic("pixel")]
float sceneDepth(float2 uv = screenUV) {
    return SceneDepth(uv);
}

/// Position on the screen, 0 to 1 from the top left.
[semantic("pixel")]
float2 screenUV(float4 pixel = fragCoord) {
    float2 uv = pixel.xy / screenSize;
    return uvFromBottom ? float2(uv.x, 1 - uv.y) : uv;
}

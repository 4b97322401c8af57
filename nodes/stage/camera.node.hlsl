// The camera and the frame. Clip space is y up, depth 0 to 1; view space looks along -z.

/// Seconds since the start.
[extern("Frame")] [semantic("uniform")] float time;
/// Size of the picture in pixels.
[extern("Frame")] [semantic("uniform")] float2 screen_size;

[extern("Camera")] float4x4 world_to_clip;
[extern("Camera")] float4x4 world_to_view;
/// Camera position in world space.
[extern("Camera")] [semantic("uniform")] float3 camera_position_ws;
[extern("Camera")] float view_is_orthographic;  // 1 or 0
/// Direction that the camera looks along in world space, unit.
[extern("Camera")] [semantic("uniform")] float3 camera_forward_ws;

[extern("Camera")] float shadow_bias;         // of a light's own view: metres that everything is moved away from it
[extern("Camera")] float4x4 clip_to_world;
[extern("Camera")] float2 clip_planes;        // distances of the near and the far plane, metres
[extern("Camera")] float shadow_normal_bias;  // of a light's own view: metres that a surface is moved inside, for w of clip space 1

/// Direction from the surface to the camera in world space, unit.
[semantic("pixel")]
float3 view_dir_ws(float3 position = position_ws) {
    return normalize(lerp(camera_position_ws - position, -camera_forward_ws, view_is_orthographic));
}

/// Position in view space: the camera looks along -z.
[semantic("pixel")]
float3 position_vs(float3 position = position_ws) {
    return mul(world_to_view, float4(position, 1)).xyz;
}

/// Normal in view space, unit.
[semantic("pixel")]
float3 normal_vs(float3 normal = normal_ws) {
    return normalize(mul(world_to_view, float4(normal, 0)).xyz);
}

[reads("color")] Texture2D color_texture;
[reads("depth")] Texture2D depth_texture;

/// What has been drawn so far at a place of the screen, linear. The material is drawn after all that do not read it.
[node("Input/Scene/Scene Color")]
float3 SceneColor(
    float2 uv = screen_uv  ///< position on the screen, 0 to 1 from the top left
) {
    return color_texture.SampleLevel(uv, 0).rgb;
}

/// Distance in metres, along the camera's axis, of what has been drawn so far at a place of the screen.
[node("Input/Scene/Scene Depth")] [in_float]
float SceneDepth(
    float2 uv = screen_uv  ///< position on the screen, 0 to 1 from the top left
) {
    float3 behind = WorldFromDepth(uv, depth_texture.SampleLevel(uv, 0).r, clip_to_world);
    return dot(behind - camera_position_ws, camera_forward_ws);
}

/// What has been drawn so far behind this pixel, linear. The material is drawn after all that do not read it.
[semantic("pixel")]
float3 scene_color(float2 uv = screen_uv) {
    return SceneColor(uv);
}

/// Distance in metres, along the camera's axis, of what has been drawn so far behind this pixel.
[semantic("pixel")]
float scene_depth(float2 uv = screen_uv) {
    return SceneDepth(uv);
}

/// Position on the screen, 0 to 1 from the top left.
[semantic("pixel")]
float2 screen_uv(float4 pixel = frag_coord) {
    return pixel.xy / screen_size;
}

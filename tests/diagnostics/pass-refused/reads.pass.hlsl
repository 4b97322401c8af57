// Reads a target that nobody draws, and a value of an object where the screen is drawn.
[pass("reads-objects")] [vertex]
float4 objects_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("reads-objects")] [fragment] [lights("none")]
float4 objects_fragment(float2 uv = screen_uv) {
    return gbuffer_diffuse_texture.SampleLevel(uv, 0);
}

[pass("reads-screen")] [vertex]
float4 screen_corner(float3 position = position_os) {
    return float4(position.xy, 0, 1);
}
[pass("reads-screen")] [fragment] [draws("fullscreen")] [lights("none")] [depth("always", "keep")]
float4 screen_fragment(float2 uv = screen_uv, float3 center = object_position_ws) {
    return float4(center, 1) * color_texture.SampleLevel(uv, 0);
}

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment] [draws] [each("light", "once")] [lights()] [camera] [cull] [blend("one")] [depth("less")]
[depth_bias(1)] [depth_target] [stencil("always")] [fallback] [target("color")] [needs] [optional(1)]
float4 mine_fragment() {
    return float4(1);
}

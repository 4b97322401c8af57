[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment] [draws(objects)] [depth_bias("steep", 1)] [draws("objects")] [depth_target("")]
[blend("opaque", "one", "zero")] [blend("fade", "one", "one")] [blend("opaque", "one", "one")]
float4 mine_fragment() {
    return float4(1);
}

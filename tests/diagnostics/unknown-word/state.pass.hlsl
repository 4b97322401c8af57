[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment] [draws("object")] [each("lights")] [lights("mains")] [camera("orthographic")]
[cull("none")] [blend("opake", "one", "zeros")] [depth("lessequal", "read")] [stencil("equals", "replce", "1")]
[fallback("foward")] [target("color", "rgba16")]
float4 mine_fragment() {
    return float4(1);
}

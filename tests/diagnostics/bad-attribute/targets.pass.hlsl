struct Stored {
    [target("first", "rgba8")] float4 first;
    float4 second;
    [target("first", "rgba8")] float4 third;
};

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
Stored mine_fragment(float3 position = position_ws) {
    Stored made; return made;
}

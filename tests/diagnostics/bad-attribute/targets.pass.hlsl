struct Stored {
    [target("first", "rgba8")] float4 first;
    float4 second;
    [target("first", "rgba8")] float4 third;
};

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
Stored mineFragment(float3 position = positionWS) {
    Stored made; return made;
}

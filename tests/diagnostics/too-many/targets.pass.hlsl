struct Stored {
    [target("target0", "rgba8")] float4 value0;
    [target("target1", "rgba8")] float4 value1;
    [target("target2", "rgba8")] float4 value2;
    [target("target3", "rgba8")] float4 value3;
    [target("target4", "rgba8")] float4 value4;
    [target("target5", "rgba8")] float4 value5;
    [target("target6", "rgba8")] float4 value6;
    [target("target7", "rgba8")] float4 value7;
    [target("target8", "rgba8")] float4 value8;
};

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
Stored mineFragment(float3 position = positionWS) {
    Stored made; return made;
}

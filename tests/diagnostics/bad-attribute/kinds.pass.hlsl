[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment] [draws(objects)] [depthBias("steep", 1)] [draws("objects")] [depthTarget("")]
[blend("opaque", "one", "zero")] [blend("fade", "one", "one")] [blend("opaque", "one", "one")]
float4 mineFragment() {
    return float4(1);
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment] [draws] [each("light", "once")] [lights()] [camera] [cull] [blend("one")] [depth("less")]
[depthBias(1)] [depthTarget] [stencil("always")] [fallback] [target("color")] [needs] [optional(1)]
float4 mineFragment() {
    return float4(1);
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    LightSum sum; return float4(added(lightingSurface(), sum), 1);
}
